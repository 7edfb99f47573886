// Corners of the difference K = A − B of two polyhedra: the farthest along a direction, and the facet that three of
// them lie in. Those of large bodies are found by a walk over neighbouring vertices. Cost of a support point: 20–60 ns.
#pragma once

#include "libcontact/methods/difference_facet.h"

namespace contact {

struct Corner {                                        // a vertex of A less one of B
  static constexpr std::uint32_t inner = 0xffffffffu;  // a and b of a point inside K
  Vec3d at;
  std::uint32_t a, b;
};

// The corner farthest along n, which need not be unit.
Corner support(const PolyhedronPair& pair, const Vec3d& n);

// The facet that three corners span; none when they do not belong to one, or to several.
DifferenceFacet facet_of(const PolyhedronPair& pair, const Corner& u, const Corner& v, const Corner& w);

}  // namespace contact
