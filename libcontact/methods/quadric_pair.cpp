#include "libcontact/methods/quadric_pair.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/planar.h"
#include "libcontact/methods/planar_space.h"
#include "libcontact/methods/support_newton.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

double least(const Vec3d& v) { return std::min(v.x, std::min(v.y, v.z)); }

struct Support {
  double height;
  Vec3d x;           // from the body's centre
  double curvature;  // at least the trace of its radii of curvature there
};

Support support(const Vec3d& axes, const Mat3d& rotation, const Vec3d& n) {
  const Vec3d v = scaled(axes, transposed_times(rotation, n));
  const double height = norm(v);
  return {height, rotation * scaled(axes, v * (1 / height)), (dot(axes, axes) - height * height) / height};
}

// σ of (3).
double distance_bound(const Vec3d& axes, const Mat3d& rotation, const Vec3d& y) {
  const double q = quadric_value(axes, rotation, y);
  return q <= 1 ? -(1 - q) * least(axes) : norm(y) * (1 - 1 / q);
}

Placed<shapes::Ellipsoid> solid(const Placed<shapes::Ellipsoid>& e) { return e; }
Placed<shapes::Ellipsoid> solid(const Placed<shapes::Ellipse>& e) { return in_space(e); }
Contact production(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset) {
  return SupportNewton::query(a, b, offset, {}, nullptr);
}
Contact production(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset) {
  return Planar::query(a, b, offset, {}, nullptr);
}

template <class S>
Contact answer(const S& a, const S& b, const Vec3d& offset, QuadricMethod method) {
  const Placed<shapes::Ellipsoid> first = solid(a), second = solid(b);
  const double ra = max_abs(first.semi_axes), rb = max_abs(second.semi_axes);
  const double size = max_abs(offset) + (ra + rb), limit = smallest_ratio * size;
  if (!(extent_in_range(size) && all_at_least(first.semi_axes, limit) && all_at_least(second.semi_axes, limit) &&
        all_at_least(offset, -size)))
    return refused();
  const Scale scale = scale_of(size);
  QuadricPair pair{first.semi_axes * scale.down,
                   second.semi_axes * scale.down,
                   first.rotation,
                   second.rotation,
                   offset * scale.down,
                   0,
                   0,
                   std::is_same_v<S, Placed<shapes::Ellipse>>};
  pair.distance = norm(pair.d);
  pair.extent = pair.distance + (ra + rb) * scale.down;
  QuadricMeasure m;
  if (pair.distance > 0x1p-100) m = method(pair);  // else hardly a direction: of coincident centres there is none
  const auto usable = [](const Vec3d& n) { return std::abs(dot(n, n) - 1) < 0x1p-40; };
  if (m.found && usable(m.normal) && usable(m.own_normal) && std::abs(m.own_overlap) <= largest_extent &&
      dot(m.own_point, m.own_point) <= 256)
    return along_normal(pair, m, scale.up);
  Contact c = production(a, b, offset);
  c.handed_over = true;
  return c;
}

}  // namespace

Vec3d quadric_normal(const Vec3d& axes, const Mat3d& rotation, const Vec3d& y) {
  const Vec3d x = transposed_times(rotation, y);
  Vec3d n;
  const double size = length_and_direction({x.x / axes.x, x.y / axes.y, x.z / axes.z}, n);
  if (!(size > 0)) return {};
  length_and_direction({n.x / axes.x, n.y / axes.y, n.z / axes.z}, n);
  return rotation * n;
}

Contact along_normal(const QuadricPair& pair, const QuadricMeasure& m, double up) {
  const Support a = support(pair.axes_a, pair.rotation_a, m.normal),
                b = support(pair.axes_b, pair.rotation_b, -m.normal);
  const double f = dot(m.normal, pair.d) - (a.height + b.height);  // (1)
  if (!(std::abs(f) <= 16)) return refused();                      // extent is below 4: a rotation that is not finite
  const double ca = least(pair.axes_a), cb = least(pair.axes_b);
  const double curvature_radius = ca * (ca / max_abs(pair.axes_a)) + cb * (cb / max_abs(pair.axes_b));
  const Vec3d point_a = a.x, point_b = pair.d + b.x, middle = 0.5 * (point_a + point_b);
  const auto common = [&](const Vec3d& x) {
    return distance_bound(pair.axes_a, pair.rotation_a, x) + distance_bound(pair.axes_b, pair.rotation_b, x - pair.d);
  };
  double upper = std::min(pair.distance - (ca + cb), std::min(common(m.own_point), common(middle)));  // (3)
  if (const double clear = curvature_radius + f; clear > 0) {
    const Vec3d w = point_b - point_a;
    const double r = norm(w - dot(w, m.normal) * m.normal) + 2 * epsilon * (a.curvature + b.curvature);
    // The root less m, without their cancellation: f + r²/(root + m + f).
    upper = std::min(upper, f + r * (r / (std::sqrt(clear * clear + r * r) + clear)));  // (2)
  }
  const double allowance = rounding(pair.extent);
  Contact c =
      smooth_contact(f, f - allowance, std::max(upper, f) + allowance, m.normal, point_a, point_b, up, m.iterations);
  c.method_overlap = m.own_overlap * up;
  c.method_normal = m.own_normal;
  c.method_point = m.own_point * up;
  if (!m.converged) c.status = Status::not_converged;
  return c;
}

Contact by_quadric_method(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                          const Options&, QuadricMethod method) {
  if (seen_from_b(offset)) return exchanged(answer(b, a, -offset, method), offset);
  return answer(a, b, offset, method);
}

Contact by_quadric_method(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                          const Options&, QuadricMethod method) {
  if (seen_from_b(offset)) return exchanged(answer(b, a, -offset, method), offset);
  return answer(a, b, offset, method);
}

}  // namespace contact
