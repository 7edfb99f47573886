// Walls as planes about a bed: containers that are convex, seen from inside.
#pragma once

#include <vector>

#include "libdem/analysis/snapshot.h"
#include "shapes/polyhedron_build.h"

namespace dem::analysis {

// The planes of a wall, unit normals into the wall, so that the bed has normal·x <= offset: one of a plane or a line;
// of a mesh or a polygon those of its facets. Empty where the centres of the bodies are not all on one side of each.
std::vector<shapes::HalfSpace> planes_of(const SnapshotWall& wall, const Snapshot& snapshot);

// Of the planes of a container those of its side: where six or more run along one direction, as the facets of a
// cylinder or a drum do, the largest such group; else all.
std::vector<shapes::HalfSpace> side_of(const std::vector<shapes::HalfSpace>& planes);

}  // namespace dem::analysis
