// The facet of the difference K = A − B of two polyhedra by which a ray from inside K through the origin leaves it:
// with a shallow overlap the nearest facet, or next to it.
//
// A triangle of corners of K that the ray passes through is pushed outwards along its normal, one corner at a time,
// until it lies in a facet. Source: Snethen, "XenoCollide", in Game Programming Gems 7 (2008); here the triangle begins
// around the ray, and every facet that it comes to lie in is tried by difference_facet.h at once.
// Cost: 5–15 corners. Tests: tests/libcontact/poly_proof.cpp.
#pragma once

#include "libcontact/methods/difference_corner.h"

namespace contact {

struct Exit {
  enum Kind {
    nearest,  // `facet` is proven to be the nearest
    facet,    // `corner` and `normal` are those of the facet
    apart,    // along `normal` no point of A seems to lie above one of B
    unknown
  } kind = unknown;
  Vec3d normal{};  // not unit
  Corner corner[3]{};
  DifferenceFacet face{};
  FacetAxis axis{};  // of the nearest
};

// `inside` is a point of K's interior, in A's frame.
Exit leave(const DifferencePair& pair, const Vec3d& inside);

}  // namespace contact
