#include "tests/reference/answer.h"

#include <algorithm>
#include <cmath>

#include "tests/reference/climb.h"
#include "tests/reference/corners.h"

namespace reference {
namespace {

double unit_of(const Body& a, const Body& b, const Vec3d& offset) {
  const double size = std::max({max_abs(offset), a.circumradius(), b.circumradius()});
  return std::ldexp(1.0, -std::ilogb(size));
}

template <class T>
T core_separation(const Core<T>& a, const Core<T>& b, const shapes::Vec3<T>& d, const shapes::Vec3<T>& n) {
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
  Core<double> rounded_a, rounded_b;
  Vec3d rounded_d;
  Directions found;
  Active fa, fb;

  Real value(const Vector& n) const { return core_separation(a, b, d, n); }
  double rounded_value(const Vec3d& n) const { return core_separation(rounded_a, rounded_b, rounded_d, n); }
};

// (2) of the header, one core at least being smooth.
Real residual(const Pair& p, const Vector& n, const Real& f) {
  const Vector xa = p.a.support(n), xb = p.b.support(-n);
  if (p.a.has_corners()) return to_support_set(p.a, p.fa, n, p.d + xb - f * n);
  if (p.b.has_corners()) return to_support_set(p.b, p.fb, -n, xa + f * n - p.d);
  return norm(p.d + xb - xa - f * n);
}

// (3) of the header, far below what `matched` asks for: the residual itself is to be small.
bool proven(const Pair& p, const Vector& n, const Real& f) {
  const Real curvature = p.a.least_radius + p.b.least_radius + f;
  return curvature > 0 && residual(p, n, f) < Real("1e-30") * std::min(Real(1), curvature);
}

// Directions that can be the best: what double tells to be worse is dropped before it costs anything in 50 digits.
class Candidates {
 public:
  explicit Candidates(const Pair& p) : p_(p) {}

  void add(const Vector& n) {
    const double f = p_.rounded_value(rounded(n));
    best_ = std::max(best_, f);
    found_.push_back({n, f});
  }
  // From a start uphill, with one corner in place of a body of corners (none: there is no such body), and about an
  // edge; in double, then on from there.
  void climb_from(const Vec3d& start, const std::uint32_t* corner, const std::uint32_t* edge) {
    Hill h{start, 0, corner ? static_cast<int>(*corner) : -1, edge ? static_cast<int>(*edge) : -1};
    const Vec3d z{0, 0, 1};
    Vec3d axis;
    if (edge) {
      const Core<double>& solid = p_.a.has_corners() ? p_.rounded_a : p_.rounded_b;
      axis = normalized(solid.corners[solid.edges[*edge].second] - solid.corners[solid.edges[*edge].first]);
      const Vec3d across = start - dot(start, axis) * axis;
      if (norm(across) < 1e-6) return;
      h.n = normalized(across);
    }
    h.n = uphill(p_.rounded_a, p_.rounded_b, p_.rounded_d, h, h.n, edge ? &axis : p_.a.planar ? &z : nullptr);
    h.f = p_.rounded_value(h.n);
    best_ = std::max(best_, h.f);
    hills_.push_back(h);
  }

  // The best of all in 50 digits; what is proven ends the search.
  void best(Real& f, Vector& n) {
    const auto take = [&](const Vector& m) {
      const Real g = p_.value(m);
      if (g > f) f = g, n = m;
    };
    for (const auto& c : found_)
      if (c.f >= best_ - 1e-12) take(c.n);
    std::sort(hills_.begin(), hills_.end(), [](const Hill& h, const Hill& k) { return h.f > k.f; });
    for (auto h = hills_.begin(); h != hills_.end() && h->f >= best_ - 1e-9; ++h) {
      if (std::any_of(hills_.begin(), h, [&](const Hill& k) { return same(k, *h); })) continue;
      take(climbed(*h));
      if (proven(p_, n, f)) return;
    }
  }

 private:
  struct Found {
    Vector n;
    double f;
  };
  struct Hill {
    Vec3d n;
    double f;
    int corner, edge;
  };

  static bool same(const Hill& a, const Hill& b) {
    return a.corner == b.corner && a.edge == b.edge && norm(a.n - b.n) < 1e-10;
  }

  template <class T>
  static shapes::Vec3<T> uphill(const Core<T>& a, const Core<T>& b, const shapes::Vec3<T>& d, const Hill& h,
                                const shapes::Vec3<T>& n, const shapes::Vec3<T>* axis) {
    Piece<T> pa{&a}, pb{&b};
    if (h.corner >= 0) (a.has_corners() ? pa : pb).corner = &(a.has_corners() ? a : b).corners[std::size_t(h.corner)];
    return climb(pa, pb, d, n, axis);
  }
  Vector climbed(const Hill& h) const {
    const Vector z{0, 0, 1};
    Vector n = normalized(exact(h.n));
    if (h.edge < 0) return uphill(p_.a, p_.b, p_.d, h, n, p_.a.planar ? &z : nullptr);
    const Core<Real>& solid = p_.a.has_corners() ? p_.a : p_.b;
    const auto& edge = solid.edges[std::size_t(h.edge)];
    const Vector axis = normalized(solid.corners[edge.second] - solid.corners[edge.first]);
    return uphill(p_.a, p_.b, p_.d, h, normalized(n - dot(n, axis) * axis), &axis);
  }

  const Pair& p_;
  double best_ = -HUGE_VAL;
  std::vector<Found> found_;
  std::vector<Hill> hills_;
};

// The features that can support in the cells about each start; together all of them.
void best_direction(const Pair& p, Real& f, Vector& n) {
  Candidates list(p);
  for (const Vec3d& start : p.found.starts) list.add(normalized(exact(start)));
  for (const auto i : p.fa.loops)
    for (const Vector& m : face_normals(p.a, i)) list.add(m);
  for (const auto i : p.fb.loops)
    for (const Vector& m : face_normals(p.b, i)) list.add(-m);
  if (p.a.has_corners() && p.b.has_corners()) {
    for (const Vector& m : edge_axes(p.a, p.b, p.fa, p.fb)) list.add(m);
    if (p.found.bound > -1e-12) {
      const Vector w = shortest(p.a, p.b, p.d, p.fa, p.fb);
      if (dot(w, w) > 0) list.add(normalized(w));
    }
  } else if (!p.a.has_corners() && !p.b.has_corners()) {
    for (const Vec3d& start : p.found.starts) list.climb_from(start, nullptr, nullptr);
  } else {
    const Core<double>& solid = p.a.has_corners() ? p.rounded_a : p.rounded_b;
    const Active& features = p.a.has_corners() ? p.fa : p.fb;
    for (const Vec3d& start : p.found.starts) {
      for (const auto& i : features.corners) list.climb_from(start, &i, nullptr);
      if (p.a.planar) continue;
      for (const auto& i : features.edges) list.climb_from(start, &solid.edges[i].first, &i);
    }
  }
  list.best(f, n);
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
  Pair p{Core<Real>(a, unit),
         Core<Real>(b, unit),
         Real(unit) * exact(offset),
         Core<double>(a, unit),
         Core<double>(b, unit),
         {},
         {},
         {},
         {}};
  p.rounded_d = rounded(p.d);
  const Real rolling = p.a.least_radius + p.b.least_radius;
  // A little less than the radii of curvature, which are rounded.
  const double shrunk = (1 - 1e-12) * static_cast<double>(rolling);
  p.found = search(p.a.planar, 1e-8, [&](const Vec3d& n) {
    return p.rounded_d + p.rounded_b.support(-n) - p.rounded_a.support(n) + shrunk * n;
  });
  if (p.a.has_corners()) p.fa = active(p.rounded_a, p.found.cells, 1);
  if (p.b.has_corners()) p.fb = active(p.rounded_b, p.found.cells, -1);
  Answer best{Real("-1e300"), 0, {}, 0, false};
  best_direction(p, best.lower, best.normal);
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
