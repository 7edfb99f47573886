#include "tests/reference/answer.h"

#include <algorithm>
#include <cmath>

#include "tests/reference/climb.h"
#include "tests/reference/corners.h"

namespace reference {
namespace {

Vec3d rounded(const Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

double unit_of(const Body& a, const Body& b, const Vec3d& offset) {
  const double size = std::max({max_abs(offset), a.circumradius(), b.circumradius()});
  return std::ldexp(1.0, -std::ilogb(size));
}

Real core_separation(const Core<Real>& a, const Core<Real>& b, const Vector& d, const Vector& n) {
  return dot(n, d + b.support(-n) - a.support(n));
}

Answer over_half_space(const Body& a, const Body& b, const Vec3d& offset) {
  const double unit = unit_of(a, a, offset);
  const Vector out = b.rotation().column(b.kind == Kind::line ? 1 : 2);
  const Core<Real> core(a, unit);
  const Real gap = (dot(out, core.support(-out)) - core.ball - Real(unit) * dot(out, exact(offset))) / Real(unit);
  return {gap, gap, -out, 0, true};
}

struct Pair {
  Core<Real> a, b;
  Vector d;
  Directions found;
  Active fa, fb;

  Real value(const Vector& n) const { return core_separation(a, b, d, n); }
};

// Directions that can be the best, in 50 digits.
std::vector<Vector> candidates(const Pair& p) {
  std::vector<Vector> list;
  const Vector z{0, 0, 1};
  const Vector* in_plane = p.a.planar ? &z : nullptr;
  if (p.a.has_corners() && p.b.has_corners()) {
    list = axes_between(p.a, p.b, p.fa, p.fb);
    const Vector w = shortest(p.a, p.b, p.d, p.fa, p.fb);
    list.push_back(dot(w, w) > 0 ? normalized(w) : exact(p.found.starts[0]));
    return list;
  }
  for (const Vec3d& start : p.found.starts) {
    const Vector n = normalized(exact(start));
    list.push_back(n);
    if (!p.a.has_corners() && !p.b.has_corners()) {
      list.push_back(climb({&p.a}, {&p.b}, p.d, n, in_plane));
      continue;
    }
    const bool first = p.a.has_corners();
    const Core<Real>& solid = first ? p.a : p.b;
    const Active& features = first ? p.fa : p.fb;
    const auto with = [&](const Vector& corner, const Vector& from, const Vector* axis) {
      list.push_back(first ? climb({&p.a, &corner}, {&p.b}, p.d, from, axis)
                           : climb({&p.a}, {&p.b, &corner}, p.d, from, axis));
    };
    for (const auto i : features.corners) with(solid.corners[i], n, in_plane);
    if (p.a.planar) continue;
    for (const auto i : features.edges) {
      const Vector& corner = solid.corners[solid.edges[i].first];
      const Vector axis = normalized(solid.corners[solid.edges[i].second] - corner), across = n - dot(n, axis) * axis;
      if (norm(across) > Real("1e-6")) with(corner, normalized(across), &axis);
    }
  }
  for (const auto i : p.fa.loops)
    for (const Vector& n : face_normals(p.a, i)) list.push_back(n);
  for (const auto i : p.fb.loops)
    for (const Vector& n : face_normals(p.b, i)) list.push_back(-n);
  return list;
}

// (2) of the header, one core at least being smooth.
Real residual(const Pair& p, const Vector& n, const Real& f) {
  const Vector xa = p.a.support(n), xb = p.b.support(-n);
  if (p.a.has_corners()) return to_support_set(p.a, p.fa, n, p.d + xb - f * n);
  if (p.b.has_corners()) return to_support_set(p.b, p.fb, -n, xa + f * n - p.d);
  return norm(p.d + xb - xa - f * n);
}

}  // namespace

Real separation(const Body& a, const Body& b, const Vec3d& offset, const Vec3d& n) {
  const double unit = unit_of(a, b, offset);
  const Core<Real> ca(a, unit), cb(b, unit);
  const Vector m = normalized(exact(n));
  return (core_separation(ca, cb, Real(unit) * exact(offset), m) - ca.ball - cb.ball) / Real(unit);
}

Answer answer(const Body& a, const Body& b, const Vec3d& offset) {
  if (b.kind == Kind::plane || b.kind == Kind::line) return over_half_space(a, b, offset);
  const double unit = unit_of(a, b, offset);
  const Core<double> ca(a, unit), cb(b, unit);
  Pair p{Core<Real>(a, unit), Core<Real>(b, unit), Real(unit) * exact(offset), {}, {}, {}};
  const Real rolling = p.a.least_radius + p.b.least_radius;
  // A little less than the radii of curvature, which are rounded.
  const double shrunk = (1 - 1e-12) * static_cast<double>(rolling);
  const Vec3d d = rounded(p.d);
  p.found = search(p.a.planar, 1e-8, [&](const Vec3d& n) { return d + cb.support(-n) - ca.support(n) + shrunk * n; });
  if (p.a.has_corners()) p.fa = active(ca, p.found.cells, 1);
  if (p.b.has_corners()) p.fb = active(cb, p.found.cells, -1);
  Answer best{Real("-1e300"), 0, {}, 0, false};
  for (const Vector& n : candidates(p)) {
    const Real f = p.value(n);
    if (f > best.lower) best.lower = f, best.normal = n;
  }
  const Real f = best.lower;
  if (p.a.has_corners() && p.b.has_corners()) {
    best.upper = f > 0 ? norm(shortest(p.a, p.b, p.d, p.fa, p.fb)) : f;
    best.residual = best.upper - f;
  } else {
    best.residual = residual(p, best.normal, f);
    best.upper = Real(p.found.bound) - Real(shrunk) + Real("1e-13");
    if (rolling + f > 0)
      best.upper = std::min(best.upper, Real(f + best.residual * best.residual / (2 * (rolling + f))));
    if (f > 0) best.upper = std::min(best.upper, Real(sqrt(f * f + best.residual * best.residual)));
  }
  best.upper += Real("1e-45");  // rounding, in units of the extent
  best.matched = best.upper - best.lower < Real("1e-25");
  for (Real* length : {&best.lower, &best.upper}) *length = (*length - p.a.ball - p.b.ball) / Real(unit);
  best.residual /= Real(unit);
  return best;
}

}  // namespace reference
