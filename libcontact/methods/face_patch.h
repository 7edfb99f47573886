// Patch of a face axis: what lies of one polyhedron under a face of the other, within the face's outline.
#pragma once

#include "libcontact/methods/patch.h"
#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

// A face of pair.self and the vertex of pair.other farthest below it.
struct FaceOverVertex {
  std::uint32_t face, deepest;
  double gap;    // < 0: height of the vertex
  double reach;  // foot_reach of the vertex
};

// Sets witness points on self (in the face) and other, gap·normal apart, and the patch, in units and in the frame that
// x -> rotation·x + position takes pair.self's to. When the clipped overlap vanishes the patch is the middle of the
// witness points, and they are under the deepest vertex.
void face_patch(const PolyhedronPair& pair, const Mat3d& rotation, const Vec3d& position, const FaceOverVertex& at,
                Vec3d& on_self, Vec3d& on_other, Patch& patch);

}  // namespace contact
