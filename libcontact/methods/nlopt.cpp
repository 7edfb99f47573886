#include "libcontact/methods/nlopt.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "libcontact/methods/asked_pair.h"
#include "libcontact/methods/nlopt_program.h"
#include "libcontact/methods/sat.h"

namespace contact {

namespace {

using namespace nlopt_program;

constexpr double least_tolerance = 1e-10, most_tolerance = 1e-3;
constexpr double agreement = 1e-6, active = 1e-7;  // of the extent

// In the place of an overlap: the ball touches planes of one body alone, which gives no normal.
constexpr double no_normal = std::numeric_limits<double>::quiet_NaN();

double tolerance_of(const ConvexPair& pair) {
  if (!(pair.tolerance > 0)) return least_tolerance;
  return std::clamp(pair.tolerance * pair.small, least_tolerance, most_tolerance);
}

void add_planes(HalfSpaces& to, const ConvexBody& body, const Vec3d& origin) {
  for (const auto& face : static_cast<const shapes::Polyhedron*>(body.geometry)->faces) {
    const Vec3d n = body.rotation * face.normal;
    to.normal.push_back(n);
    to.offset.push_back(body.scale * face.offset + dot(n, origin));
  }
}

// Σ over a of λ_i a_i; zero when the active normals do not combine to zero.
Vec3d combined_normal(const HalfSpaces& planes, const Optimum& best, double size) {
  std::vector<ConvexPair::Corner> corners;
  for (std::size_t i = 0; i < planes.normal.size(); ++i) {
    const double slack = planes.offset[i] - dot(planes.normal[i], best.x) - best.t;
    if (slack <= active * size) corners.push_back({planes.normal[i], i < planes.of_a ? planes.normal[i] : Vec3d{}});
  }
  // The point of the hull of the normals that is nearest to zero, one of them at a time.
  Simplex s;
  s.p[0] = corners.front();
  s.count = 1;
  for (std::size_t step = 0; s.count < 4 && step < 4 * corners.size(); ++step) {
    const Vec3d v = s.nearest();
    const auto low = std::min_element(corners.begin(), corners.end(),
                                      [&](const auto& p, const auto& q) { return dot(v, p.at) < dot(v, q.at); });
    if (dot(v, v) - dot(v, low->at) <= 1e-12 || norm(v) <= agreement) break;
    s.p[s.count++] = *low;
    s.reduce();
  }
  return s.count == 4 || norm(s.nearest()) <= 1e3 * agreement ? s.on_a() : Vec3d{};
}

ConvexMeasure of_polyhedra(const ConvexPair& pair) {
  ConvexMeasure m;
  m.normal = {0, 0, 1};
  m.upper = std::numeric_limits<double>::infinity();
  HalfSpaces planes;
  add_planes(planes, pair.a, {});
  planes.of_a = planes.normal.size();
  add_planes(planes, pair.b, pair.d);
  const Vec3d start = 0.5 * (pair.a.inner_centre() + (pair.d + pair.b.inner_centre()));
  const Optimum best = largest_ball(planes, start, pair.size, tolerance_of(pair), Algorithm::cobyla);
  m.iterations = best.evaluations;
  if (!(is_finite(best.x) && std::isfinite(best.t))) return m;
  m.point = best.x;
  m.overlap = best.t;
  const Vec3d n = combined_normal(planes, best, pair.size);
  if (!(norm(n) > agreement)) {
    m.overlap = no_normal;
    return m;
  }
  length_and_direction(n, m.normal);
  const double depth = dot(m.normal, pair.support(m.normal).at);
  m.converged =
      best.converged && (best.t < 0 ? depth <= agreement * pair.size : depth >= 2 * best.t - agreement * pair.size);
  return m;
}

Ellipsoid ellipsoid(const ConvexBody& body, const Vec3d& centre) {
  const bool ball = body.kind == shapes::Kind::sphere;
  return {centre, ball ? Vec3d{body.margin, body.margin, body.margin} : body.axes, body.rotation};
}

// How far from x along n the ellipsoid reaches; NaN when the line misses it.
double reach(const Ellipsoid& e, const Vec3d& x, const Vec3d& n) {
  const Vec3d u = in_unit_ball(e, x - e.centre), v = in_unit_ball(e, n);
  const double uv = dot(u, v), vv = dot(v, v);
  return (std::sqrt(uv * uv - vv * (dot(u, u) - 1)) - uv) / vv;
}

ConvexMeasure of_quadrics(const ConvexPair& pair) {
  ConvexMeasure m;
  m.normal = {0, 0, 1};
  m.upper = std::numeric_limits<double>::infinity();
  const Ellipsoid a = ellipsoid(pair.a, {}), b = ellipsoid(pair.b, pair.d);
  const Optimum best = least_equal_potential(a, b, pair.size, tolerance_of(pair));
  m.iterations = best.evaluations;
  const Vec3d slope = gradient(a, best.x);
  if (!(is_finite(best.x) && std::isfinite(best.t) && length_and_direction(slope, m.normal) > 0 &&
        std::abs(norm(m.normal) - 1) < 0x1p-40)) {
    m.normal = {0, 0, 1};
    return m;
  }
  const double depth = dot(m.normal, pair.support(m.normal).at) + pair.margins();
  const double cut = reach(a, best.x, m.normal) + reach(b, best.x, -m.normal);
  m.point = best.x;
  m.overlap = best.t < 0 && std::isfinite(cut) ? cut : depth;
  m.converged = best.converged && (best.t < 0 ? std::isfinite(cut) && depth >= cut - agreement * pair.size
                                              : depth <= agreement * pair.size);
  return m;
}

// What is thrown is that memory is out.
template <ConvexMeasure (*method)(const ConvexPair&)>
ConvexMeasure caught(const ConvexPair& pair) {
  try {
    return method(pair);
  } catch (const std::exception&) {
    ConvexMeasure m;
    m.normal = {0, 0, 1};
    m.upper = std::numeric_limits<double>::infinity();
    return m;
  }
}

}  // namespace

Contact Nlopt::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                     const Options& options, Cache*) {
  Contact c = by_convex_method(convex_body(a), convex_body(b), offset, options, caught<of_polyhedra>);
  if (!std::isnan(c.method_overlap)) return c;
  c = Sat::query(a, b, offset, options, nullptr);
  c.handed_over = true;
  return c;
}

Contact Nlopt::of_ellipsoids(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, caught<of_quadrics>);
}

}  // namespace contact
