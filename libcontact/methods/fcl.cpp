#include "libcontact/methods/fcl.h"

// The distance is compiled here, without the assertions of the installed library: bodies that are out of true must not
// end the process, and what comes of them is judged below.
#ifndef NDEBUG
#define NDEBUG
#endif
#include <ccd/ccd.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk_libccd.h>

#include <algorithm>
#include <exception>

#include "libcontact/methods/asked_pair.h"

namespace contact {

namespace {

constexpr unsigned step_limit = 500;
constexpr double least_tolerance = 1e-6, most_tolerance = 1e-3;

Vec3d vector(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

void far_point(const void* side, const ccd_vec3_t* n, ccd_vec3_t* point) {
  const Vec3d p = AskedPair::farthest(*static_cast<const AskedPair::Side*>(side), {n->v[0], n->v[1], n->v[2]});
  for (int i = 0; i < 3; ++i) point->v[i] = p[i];
}

void inner_point(const void* side, ccd_vec3_t* point) {
  const Vec3d p = AskedPair::inside(*static_cast<const AskedPair::Side*>(side));
  for (int i = 0; i < 3; ++i) point->v[i] = p[i];
}

ConvexMeasure measure_or_throw(AskedPair& asked) {
  const ConvexPair& pair = asked.pair();
  const double tolerance =
      pair.tolerance > 0 ? std::clamp(pair.tolerance * pair.small, least_tolerance, most_tolerance) : least_tolerance;
  const double agreement = AskedPair::agreement * pair.size;
  AskedPair::Side a{&asked, true}, b{&asked, false};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = far_point;
  ccd.max_iterations = step_limit;
  ccd.dist_tolerance = tolerance;
  ccd_vec3_t first{}, second{};
  Vec3d n;
  const double distance = fcl::detail::libccd_extension::ccdGJKDist2(&a, &b, &ccd, &first, &second);
  if (!(distance < 0)) {
    const Vec3d p = vector(first), q = vector(second);
    if (!(std::isfinite(distance) && is_finite(p) && is_finite(q))) return asked.apart(false);
    // Touching bodies have no direction of their own.
    if (!(length_and_direction(q - p, n) > 1e-3 * tolerance)) return asked.apart(asked.separation() >= -agreement);
    return asked.as_told(n, -distance, 0.5 * (p + q), std::abs(asked.depth_along(n) + distance) <= agreement);
  }
  double depth = 0;
  fcl::Vector3d place, direction;
  if (!fcl::detail::GJKCollide(&a, far_point, inner_point, &b, far_point, inner_point, step_limit, tolerance, &place,
                               &depth, &direction))
    return asked.apart(std::abs(asked.separation()) <= agreement);
  const Vec3d p{place.x(), place.y(), place.z()}, m{direction.x(), direction.y(), direction.z()};
  if (!(std::abs(norm(m) - 1) < 0x1p-10 && std::isfinite(depth) && is_finite(p))) return asked.apart(false);
  length_and_direction(m, n);
  return asked.as_told(n, depth, p, depth <= asked.depth_along(n) + agreement);
}

ConvexMeasure measure(const ConvexPair& pair) {
  AskedPair asked(pair);
  if (!asked.has_finite_answers()) return asked.apart(false);
  try {
    return measure_or_throw(asked);
  } catch (const std::exception&) {
    return asked.apart(false);
  }
}

}  // namespace

Contact Fcl::answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, measure);
}

}  // namespace contact
