// The expanding polytope of gjk_epa, and the polygon of the plane.
#include <utility>

#include "libcontact/methods/convex_search.h"
#include "libcontact/methods/expanding_outline.h"
#include "libcontact/methods/expanding_surface.h"

namespace contact {

namespace {

// Until the interval is closed, or the surface cannot take one more corner.
template <class Surface>
void grow(ConvexSearch& search, Surface& surface) {
  for (;;) {
    const int i = surface.nearest();
    const auto& f = surface.face(i);
    const double known = search.lower;
    const ConvexPair::Corner w = search.probe(f.normal);
    if (search.lower > known) {
      search.near.count = search.near.full - 1;
      for (int k = 0; k < search.near.count; ++k) search.near.p[k] = surface.corner(f, k);
    }
    search.upper = -f.distance;
    if (search.closed() || !surface.push(w, i)) break;
  }
  search.upper = -surface.clearance();  // (2)
  search.near.reduce();
}

}  // namespace

void expand(ConvexSearch& search, Simplex x) {
  const Vec3d e = x.p[1].at - x.p[0].at, f = x.p[2].at - x.p[0].at;
  search.upper = search.rounding();
  if (x.full == 3) {
    if (e.x * f.y - e.y * f.x < 0) std::swap(x.p[1], x.p[2]);
    ExpandingOutline<ConvexPair::Corner> outline(search.rounding());
    if (outline.begin(x.p)) grow(search, outline);
  } else {
    if (dot(cross(x.p[2].at - x.p[1].at, x.p[3].at - x.p[1].at), e) < 0) std::swap(x.p[2], x.p[3]);
    ExpandingSurface<ConvexPair::Corner, 192> surface(search.rounding());
    if (surface.begin(x.p)) grow(search, surface);
  }
}

}  // namespace contact
