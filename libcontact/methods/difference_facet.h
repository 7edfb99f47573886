// Facets of the difference K = A − B of two polyhedra, and the proof that one of them is the nearest to the origin.
//
// A face of K is a face of A less a vertex of B, a vertex of A less a face of B, or an edge of A less an edge of B; its
// outward normal n is an axis of A and B, and minus its distance from the origin is their separation along n. Bodies
// overlap by the distance d of the nearest one: facet_alone.h proves which that is.
// Cost: 20–40 ns, for bodies of any number of faces. Tests: tests/libcontact/poly_proof.cpp.
#pragma once

#include "libcontact/methods/facet_alone.h"
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
  double reach;  // of a face: foot_reach
  Vec3d on_a;    // of edges: the closest point of A's to B's line, within the edge, in A's frame
};

// A pair with what proofs and searches need besides.
struct DifferencePair : PolyhedronPair {
  Vec3d core;          // k, in A's frame
  double core_radius;  // r
  double size;         // L of the pair

  DifferencePair(const PolyhedronPair& pair, double extent) : PolyhedronPair(pair), size(extent) {
    const CoreBall a = core_ball(*self), b = core_ball(*other);
    core = self_scale * a.centre - (other_to_self * (other_scale * b.centre) + offset);
    core_radius = self_scale * a.radius + other_scale * b.radius;
  }
};

// How far within its sides a face of pair.self holds the foot of a point, in pair.self's frame; 0: it does not.
double foot_reach(const PolyhedronPair& pair, std::uint32_t face, const Vec3d& point);

// The axis of a facet of a complete search, whose supports are known.
FacetAxis axis_of(const DifferencePair& pair, const DifferenceFacet& facet);

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
