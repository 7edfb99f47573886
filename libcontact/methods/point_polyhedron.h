// Signed distance of a point to a convex polyhedron, and the feature that gives it.
#pragma once

#include <cstdint>

#include "libcontact/export.h"
#include "shapes/polyhedron.h"

namespace contact {

struct SurfacePoint {
  enum class Feature : std::uint8_t { face, edge, vertex };
  double distance;        // negative inside: minus the least distance to a face plane
  shapes::Vec3d outward;  // unit direction in which the distance grows
  Feature feature;
  std::uint32_t index;  // of the face, edge or vertex
  double level;         // largest height over a face plane: a lower bound of the distance
};

// Point x, polyhedron scaled by `scale`, in its body frame; lengths near 1, of which `size` is the largest at hand.
// Exact to 4 eps size, anywhere. A point nearer than that to an edge or vertex, but outside, gets the normal of a face
// beside it. Cost: a product per face inside, or over a face; outside over an edge also one segment per edge that is in
// sight.
CONTACT_API SurfacePoint surface_point(const shapes::Polyhedron& p, double scale, const shapes::Vec3d& x, double size);

// The face plane over which x is highest; lanes run over faces, ties go to the lowest index.
struct FaceHeight {
  double height;
  std::uint32_t index;
};
FaceHeight highest_face(const shapes::Polyhedron& p, double scale, const shapes::Vec3d& x);

// x lies over the face: on the inner side of the plane through each of its edges along the normal.
bool over_face(const shapes::Polyhedron& p, const shapes::Polyhedron::Face& face, double scale, const shapes::Vec3d& x);

}  // namespace contact
