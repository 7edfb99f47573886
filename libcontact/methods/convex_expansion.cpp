// The expanding polytope of gjk_epa.
#include <utility>

#include "libcontact/methods/convex_search.h"
#include "libcontact/methods/expanding_surface.h"

namespace contact {

void expand(ConvexSearch& search, Simplex t) {
  using Surface = ExpandingSurface<ConvexPair::Corner, 192>;
  if (dot(cross(t.p[2].at - t.p[1].at, t.p[3].at - t.p[1].at), t.p[1].at - t.p[0].at) < 0) std::swap(t.p[2], t.p[3]);
  search.upper = search.rounding();
  Surface surface(search.rounding());
  if (!surface.begin(t.p)) return;
  for (;;) {
    const int i = surface.nearest();
    const Surface::Face& f = surface.face(i);
    const double known = search.lower;
    const ConvexPair::Corner w = search.probe(f.normal);
    if (search.lower > known) {
      search.near = Simplex{};
      search.near.count = 3;
      for (int k = 0; k < 3; ++k) search.near.p[k] = surface.corner(f, k);
    }
    search.upper = -f.distance;
    if (search.closed() || !surface.push(w, i)) break;
  }
  search.upper = -surface.clearance();  // (2)
  search.near.reduce();
}

}  // namespace contact
