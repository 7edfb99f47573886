#include "libcontact/methods/ccd.h"

#include <ccd/ccd.h>
#include <ccd/quat.h>

#include <algorithm>

#include "libcontact/methods/asked_pair.h"

namespace contact {

namespace {

constexpr unsigned long step_limit = 500;  // of those loops of libccd that have a cap
// A portal that is smaller than it need be has a direction of rounding.
constexpr double least_of_expansion = 1e-8, least_of_portal = 1e-6, most_tolerance = 1e-3;

// The pair and the first question of a search.
struct Held {
  AskedPair::Side side;
  Vec3d first;
};

void set(ccd_vec3_t* to, const Vec3d& v) { ccdVec3Set(to, v.x, v.y, v.z); }
void far_point(const void* body, const ccd_vec3_t* n, ccd_vec3_t* point) {
  set(point, AskedPair::farthest(static_cast<const Held*>(body)->side, {n->v[0], n->v[1], n->v[2]}));
}
void inner_point(const void* body, ccd_vec3_t* point) {
  set(point, AskedPair::inside(static_cast<const Held*>(body)->side));
}
void first_question(const void* body, const void*, ccd_vec3_t* direction) {
  set(direction, static_cast<const Held*>(body)->first);
}

double tolerance_of(const ConvexPair& pair, double least) {
  if (!(pair.tolerance > 0)) return least;
  return std::clamp(pair.tolerance * pair.small, least, most_tolerance);
}

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

struct Told {
  bool overlap = false, usable = false;
  double depth = 0, along = 0;  // what it says, and the depth along the direction that it says
  Vec3d normal{}, place{};
};

Told ask(AskedPair& asked, Penetration penetration, double tolerance, const Vec3d& first) {
  const Held a{{&asked, true}, first}, b{{&asked, false}, first};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.first_dir = first_question;
  ccd.support1 = ccd.support2 = far_point;
  ccd.center1 = ccd.center2 = inner_point;
  ccd.max_iterations = step_limit;
  ccd.epa_tolerance = ccd.mpr_tolerance = tolerance;
  Told t;
  ccd_vec3_t direction{}, place{};
  t.overlap = penetration(&a, &b, &ccd, &t.depth, &direction, &place) == 0;
  if (!t.overlap) return t;
  const Vec3d n{direction.v[0], direction.v[1], direction.v[2]};
  t.place = {place.v[0], place.v[1], place.v[2]};
  t.usable = std::abs(norm(n) - 1) < 0x1p-10 && std::isfinite(t.depth) && is_finite(t.place);
  if (!t.usable) return t;
  length_and_direction(n, t.normal);
  t.along = asked.depth_along(t.normal);
  return t;
}

// First questions: across the line of centres, and then along directions without a relation to each other.
constexpr int attempts = 8;
Vec3d first_direction(const ConvexPair& pair, int attempt) {
  constexpr Vec3d oblique[attempts - 1] = {{0.8, 0.36, 0.48}, {-0.3, 0.9, 0.2}, {0.1, -0.5, 0.8}, {0.6, 0.7, -0.4},
                                           {-0.9, -0.1, 0.3}, {0.2, 0.4, 0.9},  {0.5, -0.8, -0.3}};
  Vec3d n = oblique[std::max(attempt - 1, 0)];
  if (const Vec3d across = cross(pair.d, n); attempt == 0 && norm(across) > 0x1p-20 * pair.size) n = across;
  length_and_direction(n, n);
  return n;
}

ConvexMeasure by_expansion(const ConvexPair& pair) {
  AskedPair asked(pair);
  if (!asked.has_finite_answers()) return asked.apart(false);
  const auto error = [](const Told& t) { return std::abs(t.along - t.depth); };
  const double tolerance = tolerance_of(pair, least_of_expansion);
  Told best;
  for (int attempt = 0; attempt < attempts && !asked.given_up(); ++attempt) {
    const Told told = ask(asked, ccdGJKPenetration, tolerance, first_direction(pair, attempt));
    if (!told.overlap && asked.separation() >= -tolerance) return asked.apart(true);
    if (!told.usable || (best.usable && !(error(told) < error(best)))) continue;
    best = told;
    if (error(best) <= AskedPair::agreement * pair.size)
      return asked.as_told(best.normal, best.depth, best.place, true);
  }
  return best.usable ? asked.as_told(best.normal, best.depth, best.place, false) : asked.apart(false);
}

ConvexMeasure by_portal(const ConvexPair& pair) {
  AskedPair asked(pair);
  if (!asked.has_finite_answers()) return asked.apart(false);
  const double tolerance = tolerance_of(pair, least_of_portal);
  const Told told = ask(asked, ccdMPRPenetration, tolerance, {1, 0, 0});
  if (!told.overlap) return asked.apart(asked.separation() >= -tolerance);
  if (!told.usable) return asked.apart(false);
  // The place where the ray leaves A − B is a point of it.
  const bool agreed = told.depth <= told.along + AskedPair::agreement * pair.size;
  return asked.as_told(told.normal, told.depth, told.place, agreed);
}

}  // namespace

Contact CcdGjkEpa::answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, by_expansion);
}

Contact CcdMpr::answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, by_portal);
}

}  // namespace contact
