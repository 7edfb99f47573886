// d of overlap_depth.h for two polyhedra, from the facet of their difference that answers the contact.
#pragma once

#include "libcontact/methods/difference_facet.h"
#include "libcontact/methods/patch.h"

namespace contact {

// Where a pair stands in the world, lengths in its units.
struct PairPlaces {
  const Mat3d &rotation_a, &rotation_b;
  Vec3d offset;  // along world axes
  double size;   // of the smaller body
};

// `axis` of the facet, its value below 0. Of a face's facet its vertex lies farthest below the face. The patch is the
// overlap seen along its vector area, weighted by its length along that. In units and along world axes. False as
// overlap_depth.
bool facet_depth(const PolyhedronPair& pair, const DifferenceFacet& facet, const FacetAxis& axis,
                 const PairPlaces& places, OverlapDepth& out, Patch& patch);

}  // namespace contact
