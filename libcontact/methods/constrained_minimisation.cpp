#include "libcontact/methods/constrained_minimisation.h"

#include "libcontact/methods/half_space_program.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

PolyhedronMeasure measure(const PlacedPolyhedra& placed) {
  PolyhedronMeasure m;
  const HalfSpaceOptimum best = largest_ball(placed.pair, placed.size);
  m.iterations = best.pivots;
  if (!best.converged || !(length_and_direction(best.normal, m.normal) > 0x1p-40)) return m;
  m.found = true;
  m.overlap = best.lower;
  m.point = best.x;
  if (!(best.lower > 64 * epsilon * placed.size)) return m;  // apart or touching: no inside
  Vec3d centre = best.x;
  int steps = 0;
  m.converged = analytic_centre(placed.pair, centre, steps);
  if (m.converged) m.point = centre;
  m.iterations += steps;
  return m;
}

}  // namespace

Contact ConstrainedMinimisation::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                                       const Vec3d& offset, const Options&, Cache*) {
  return by_polyhedron_method(a, b, offset, measure);
}

}  // namespace contact
