#include "libcontact/methods/expansion.h"

#include "libcontact/methods/expanding_surface.h"

namespace contact {
namespace {

using Surface = ExpandingSurface<Corner>;

}  // namespace

bool expand(const DifferencePair& pair, const Vec3d& inside, const Corner (&portal)[3], DifferenceFacet& facet,
            FacetAxis& axis) {
  Surface surface;
  // The tetrahedron of the inner point and a triangle about the ray from there through the origin.
  if (!surface.begin({{inside, Corner::inner, Corner::inner}, portal[0], portal[1], portal[2]})) return false;
  const double rounding = 16 * epsilon * pair.size;
  for (;;) {
    const int i = surface.nearest();
    const Surface::Face f = surface.face(i);
    const Corner c = support(pair, f.normal);
    if (dot(f.normal, c.at) > f.distance + rounding) {
      if (!surface.push(c, i)) return false;
      continue;
    }
    facet = facet_of(pair, surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2));
    if (prove_nearest(pair, facet, axis, true) != Nearest::proven) return false;
    // A corner as high as the facet belongs to it: the proof has found all others to be farther below than rounding.
    return surface.clear_of(-axis.value + 2 * proof_clearance * pair.size, axis.normal,
                            -axis.value - proof_clearance * pair.size);
  }
}

}  // namespace contact
