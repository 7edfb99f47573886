#include "libcontact/methods/convex_view.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/analytic.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/sat.h"
#include "libcontact/methods/support_newton.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using shapes::Ellipsoid;
using shapes::Polyhedron;
using shapes::Sphere;

double circumradius(const Placed<Sphere>& s) { return s.radius; }
double circumradius(const Placed<Ellipsoid>& e) { return max_abs(e.semi_axes); }
double circumradius(const Placed<Polyhedron>& p) { return p.scale * p.shape->circumradius; }
bool at_least(const Placed<Sphere>& s, double limit) { return s.radius >= limit; }
bool at_least(const Placed<Ellipsoid>& e, double limit) { return all_at_least(e.semi_axes, limit); }
bool at_least(const Placed<Polyhedron>& p, double limit) { return p.scale >= limit; }

ConvexView view(const Placed<Sphere>& s, double down) { return {{}, nullptr, 1, s.radius * down, Mat3d::identity()}; }
ConvexView view(const Placed<Ellipsoid>& e, double down) { return {e.semi_axes * down, nullptr, 1, 0, e.rotation}; }
ConvexView view(const Placed<Polyhedron>& p, double down) { return {{}, p.shape, p.scale * down, 0, p.rotation}; }

Contact exact(const Placed<Sphere>& a, const Placed<Ellipsoid>& b, const Vec3d& d) {
  return Analytic::query(a, b, d, {}, nullptr);
}
Contact exact(const Placed<Ellipsoid>& a, const Placed<Ellipsoid>& b, const Vec3d& d) {
  return SupportNewton::query(a, b, d, {}, nullptr);
}
Contact exact(const Placed<Polyhedron>& a, const Placed<Polyhedron>& b, const Vec3d& d) {
  return Sat::query(a, b, d, {}, nullptr);
}
template <class A>
Contact exact(const Placed<A>& a, const Placed<Polyhedron>& b, const Vec3d& d) {
  return Features::query(a, b, d, {}, nullptr);
}

template <class A, class B>
Contact answer(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, ConvexMethod method) {
  const double extent = max_abs(offset) + (circumradius(a) + circumradius(b)), limit = smallest_ratio * extent;
  if (!(extent_in_range(extent) && all_at_least(offset, -extent) && at_least(a, limit) && at_least(b, limit)))
    return refused();
  const Scale unit = scale_of(extent);
  ConvexPair pair{view(a, unit.down), view(b, unit.down), offset * unit.down, 0};
  pair.size = norm(pair.d) + unit.down * (circumradius(a) + circumradius(b));
  const ConvexMeasure m = method(pair);
  if (!(m.found && std::abs(dot(m.normal, m.normal) - 1) < 0x1p-40 && dot(m.point, m.point) <= 256)) {
    Contact c = exact(a, b, offset);
    c.handed_over = true;
    return c;
  }
  const Vec3d on_a = pair.a.support(m.normal) + pair.a.margin * m.normal,
              on_b = pair.d + pair.b.support(-m.normal) - pair.b.margin * m.normal;
  const double f = dot(m.normal, on_b - on_a);
  if (!(std::abs(f) <= 16)) return refused();
  const double ball = norm(pair.inside()) - (pair.a.inner_radius() + pair.b.inner_radius());
  const double allowance = polyhedron_rounding * pair.size;
  Contact c = smooth_contact(f, f - allowance, std::max(f, std::min(m.upper, ball)) + allowance, m.normal, on_a, on_b,
                             unit.up, m.iterations);
  c.method_overlap = m.overlap * unit.up;
  c.method_point = m.point * unit.up;
  if (!m.converged) c.status = Status::not_converged;
  return c;
}

}  // namespace

template <class A, class B>
Contact by_convex_method(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, ConvexMethod method) {
  if constexpr (std::is_same_v<A, B>)
    if (seen_from_b(offset)) return exchanged(answer(b, a, -offset, method), offset);
  return answer(a, b, offset, method);
}

template Contact by_convex_method(const Placed<Sphere>&, const Placed<Ellipsoid>&, const Vec3d&, ConvexMethod);
template Contact by_convex_method(const Placed<Sphere>&, const Placed<Polyhedron>&, const Vec3d&, ConvexMethod);
template Contact by_convex_method(const Placed<Ellipsoid>&, const Placed<Ellipsoid>&, const Vec3d&, ConvexMethod);
template Contact by_convex_method(const Placed<Ellipsoid>&, const Placed<Polyhedron>&, const Vec3d&, ConvexMethod);
template Contact by_convex_method(const Placed<Polyhedron>&, const Placed<Polyhedron>&, const Vec3d&, ConvexMethod);

}  // namespace contact
