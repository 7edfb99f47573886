// Bodies at their extremes, of any kind that can have them: thin, slivers, of many faces; and their ridges.
#pragma once

#include "tests/reference/samples.h"

namespace extremes {

using reference::Body;
using shapes::Kind;
using shapes::Vec3d;

// The smallest radius or semi-axis; of bodies with faces the circumradius; without end for half-spaces.
double least_size(const Body& b);

// The farthest point along n, from the body's origin.
Vec3d farthest(const Body& b, const Vec3d& n);

// False where the kind has no such body.
bool make_thin(Body& b, double aspect, reference::Source& draw);
bool make_sliver(Body& b, double height, reference::Source& draw);
bool give_faces(Body& b, int count);

// Where two sides of a body of space meet: unit vectors along an edge (a long axis, if it is round) and outward, world
// axes. Of a plane: in it and out of it.
struct Ridge {
  Vec3d along, out;
};
Ridge ridge(const Body& b, reference::Source& draw);

// The rotation that takes the unit vector u to v by the shortest way.
shapes::Quatd aligning(const Vec3d& u, const Vec3d& v);
shapes::Quatd turn_about(const Vec3d& axis, double angle);

}  // namespace extremes
