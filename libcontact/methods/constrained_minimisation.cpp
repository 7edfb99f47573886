#include "libcontact/methods/constrained_minimisation.h"

#include "libcontact/methods/half_space_program.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/methods/polyhedron_plane.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// (1) and (2) of a pair; its normal is not set.
PolyhedronMeasure centre_of(const PolyhedronPair& pair, double size, Vec3d& multipliers) {
  PolyhedronMeasure m;
  const HalfSpaceOptimum best = largest_ball(pair, size);
  m.iterations = best.pivots;
  m.found = best.converged;
  m.overlap = best.lower;
  m.point = best.x;
  multipliers = best.normal;
  if (!(m.found && best.lower > 64 * epsilon * size)) return m;  // apart or touching: no inside
  Vec3d centre = best.x;
  int steps = 0;
  m.converged = analytic_centre(pair, centre, steps);
  if (m.converged) m.point = centre;
  m.iterations += steps;
  return m;
}

PolyhedronMeasure measure(const PlacedPolyhedra& placed) {
  Vec3d multipliers;
  PolyhedronMeasure m = centre_of(placed.pair, placed.size, multipliers);
  m.found = m.found && length_and_direction(multipliers, m.normal) > 0x1p-40;
  return m;
}

}  // namespace

Contact ConstrainedMinimisation::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                                       const Vec3d& offset, const Options&, Cache*) {
  return by_polyhedron_method(a, b, offset, measure);
}

Contact ConstrainedMinimisation::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Plane>& b,
                                       const Vec3d& offset, const Options&, Cache*) {
  Contact c = PolyhedronPlane::query(a, b, offset, {.overlap_only = false, .patch = false}, nullptr);
  if (c.status == Status::refused) return c;
  const double reach = a.scale * a.shape->circumradius, extent = max_abs(offset) + reach;
  const Scale unit = scale_of(extent);
  const Vec3d d = unit.down * offset, height = dot(b.normal, d) * b.normal;  // the plane's point nearest to the body
  Mat3d wall;
  Vec3d t1, t2;
  tangent_frame(b.normal, t1, t2);
  wall = transposed(a.rotation) * Mat3d{{{t1.x, t2.x, b.normal.x}, {t1.y, t2.y, b.normal.y}, {t1.z, t2.z, b.normal.z}}};
  const PolyhedronPair pair{a.shape, nullptr, unit.down * a.scale, 1, wall, transposed_times(a.rotation, height)};
  Vec3d multipliers;
  const PolyhedronMeasure m = centre_of(pair, norm(height) + unit.down * reach, multipliers);
  c.iterations = m.iterations;
  if (!m.found || !m.converged) c.status = Status::not_converged;
  if (!m.found) return c;
  c.method_overlap = m.overlap * unit.up;
  c.method_point = (a.rotation * m.point) * unit.up;
  return c;
}

}  // namespace contact
