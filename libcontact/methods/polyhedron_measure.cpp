#include "libcontact/methods/polyhedron_measure.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/sat.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Solid = Placed<shapes::Polyhedron>;

Contact answer(const Solid& a, const Solid& b, const Vec3d& offset, PolyhedronMethod method) {
  double up = 1;
  const PlacedPolyhedra placed = placed_polyhedra(a, b, offset, up);
  if (!(placed.size > 0)) return refused();
  const PolyhedronPair& pair = placed.pair;
  const PolyhedronMeasure m = method(placed);
  const bool usable = m.found && std::abs(dot(m.normal, m.normal) - 1) < 0x1p-40 && std::abs(m.overlap) <= 16 &&
                      dot(m.point, m.point) <= 256;
  if (!usable) {
    Contact c = Sat::query(a, b, offset, {}, nullptr);
    c.handed_over = true;
    return c;
  }
  const Separation at = pair.separation(m.normal);  // (1)
  if (!(std::abs(at.value) <= 8)) return refused();
  const CoreBall core_a = core_ball(*a.shape), core_b = core_ball(*b.shape);
  const Vec3d between =
      pair.offset + pair.other_to_self * (pair.other_scale * core_b.centre) - pair.self_scale * core_a.centre;
  double upper = norm(between) - (pair.self_scale * core_a.radius + pair.other_scale * core_b.radius);  // (3)
  const double in_a = depth_in(*a.shape, pair.self_scale, m.point),
               in_b = depth_in(*b.shape, pair.other_scale, transposed_times(pair.other_to_self, m.point - pair.offset));
  if (in_a >= 0 && in_b >= 0) upper = std::min(upper, -(in_a + in_b));  // (2)
  const double allowance = polyhedron_rounding * placed.size;
  Contact c = smooth_contact(at.value, at.value - allowance, std::max(at.value, upper) + allowance,
                             a.rotation * m.normal, a.rotation * pair.self_vertex(at.on_self),
                             a.rotation * pair.other_vertex(at.on_other), up, m.iterations);
  c.method_overlap = m.overlap * up;
  c.method_normal = c.normal;
  c.method_point = (a.rotation * m.point) * up;
  if (!m.converged) c.status = Status::not_converged;
  return c;
}

}  // namespace

PlacedPolyhedra placed_polyhedra(const Solid& a, const Solid& b, const Vec3d& offset, double& up) {
  const double reach = a.scale * a.shape->circumradius + b.scale * b.shape->circumradius;
  const double extent = max_abs(offset) + reach;
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return {{}, 0};
  const Scale unit = scale_of(extent);
  const Vec3d d = unit.down * offset;
  up = unit.up;
  return {{a.shape,
           b.shape,
           unit.down * a.scale,
           unit.down * b.scale,
           {{transposed_times(b.rotation, a.rotation.column(0)), transposed_times(b.rotation, a.rotation.column(1)),
             transposed_times(b.rotation, a.rotation.column(2))}},
           transposed_times(a.rotation, d)},
          norm(d) + unit.down * reach};
}

double depth_in(const shapes::Polyhedron& p, double scale, const Vec3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& face : p.faces) least = std::min(least, scale * face.offset - dot(face.normal, x));
  return least;
}

Contact by_polyhedron_method(const Solid& a, const Solid& b, const Vec3d& offset, PolyhedronMethod method) {
  if (seen_from_b(offset)) return exchanged(answer(b, a, -offset, method), offset);
  return answer(a, b, offset, method);
}

}  // namespace contact
