// Facets of the difference K = A − B of two polyhedra, and the proof that one of them is the nearest to the origin.
//
// A face of K is a face of A less a vertex of B, a vertex of A less a face of B, or an edge of A less an edge of B; its
// outward normal n is an axis of A and B, and minus its distance from the origin is their separation along n. Bodies
// overlap by the distance d of the nearest one. Let the foot d n of the origin lie in a facet F, at least ρ from its
// border, and let K hold a ball of radius r about k (the balls inside A and B). Then, for a direction at an angle θ to
// n,
//
//   h_K(θ) >= d cos θ + ρ sin θ >= d        while tan(θ/2) <= ρ/d                                              (1)
//   h_K(θ) >= k_n cos θ − k_t sin θ + r     k_n along n, k_t across it                                         (2)
//
// F is the nearest facet when (2) is above d wherever (1) is not: a proof from F alone, without a look at any other
// face. Where the next vertices of A and B below F are farther than rounding can bridge, no other facet comes as near,
// and any complete search finds F: the proof may come from wherever it likes and the answer is the same, bit for bit.
// Cost: 20–40 ns, for bodies of any number of faces. Tests: tests/libcontact/poly_proof.cpp.
#pragma once

#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

struct DifferenceFacet {
  enum Kind : std::uint32_t { none, face_of_a, face_of_b, edges };
  Kind kind = none;
  std::uint32_t a = 0, b = 0;  // face, edge or vertex of each
};

struct FacetAxis {
  Vec3d normal;  // unit, from A to B, in A's frame
  double value;  // separation along it
};

// A pair with what proofs and searches need besides.
struct DifferencePair : PolyhedronPair {
  Vec3d core;          // k, in A's frame
  double core_radius;  // r
  double size;         // L of the pair

  DifferencePair(const PolyhedronPair& pair, double size);
};

// The axis of a facet of a complete search, whose supports are known.
FacetAxis axis_of(const DifferencePair& pair, const DifferenceFacet& facet);

// How much farther than the nearest facet every other must be, per size: twice what a complete search may err by.
inline constexpr double proof_clearance = 64 * epsilon;

enum class Nearest {
  proven,     // the nearest, and no other is as near
  elsewhere,  // the foot of the origin is beyond its border
  open        // neither is known
};
// Facets whose indices are out of range, or that are none of K, are `open`. Moves the vertex of a face's facet to the
// lowest one over that face. `axis` is set when proven. `enclosed`: a closed surface within K is known that has nothing
// as near to the origin as this facet but parts of it; this stands for (1) and (2).
Nearest prove_nearest(const DifferencePair& pair, DifferenceFacet& facet, FacetAxis& axis, bool enclosed = false);

}  // namespace contact
