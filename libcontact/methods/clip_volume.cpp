#include "libcontact/methods/clip_volume.h"

#include "libcontact/methods/convex_overlap.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// In the frame and units of the pair.
ClippedVolume clipped(const PolyhedronPair& pair) {
  const OverlapSums s = convex_overlap(pair);
  ClippedVolume c;
  if (!(s.volume > 0)) return c;
  const Vec3d from_apex = s.first * (1 / s.volume);
  c.volume = s.volume;
  // The sums of both surfaces are opposite; their difference halves the rounding.
  c.surface = 0.5 * (s.surface[0] - s.surface[1]);
  c.moment = 0.5 * (s.moment[0] - s.moment[1]) - cross(from_apex, c.surface);
  c.centroid = s.apex + from_apex;
  return c;
}

PolyhedronMeasure measure(const PlacedPolyhedra& placed) {
  PolyhedronMeasure m;
  const ClippedVolume c = clipped(placed.pair);
  const double area = length_and_direction(c.surface, m.normal);  // (1)
  if (!(c.volume > 0 && area > 0x1p-40 * placed.size * placed.size)) return m;
  m.overlap = c.volume / area;  // (2)
  m.point = c.centroid;
  m.found = true;
  return m;
}

}  // namespace

ClippedVolume clipped_volume(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                             const Vec3d& offset) {
  double up = 1;
  ClippedVolume c;
  const PlacedPolyhedra placed = placed_polyhedra(a, b, offset, up);
  if (!(placed.size > 0)) return c;
  c = clipped(placed.pair);
  return {c.volume * up * up * up, a.rotation * c.surface * (up * up), a.rotation * c.moment * (up * up * up),
          a.rotation * c.centroid * up};
}

Contact ClipVolume::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                          const Options&, Cache*) {
  return by_polyhedron_method(a, b, offset, measure);
}

}  // namespace contact
