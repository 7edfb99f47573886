// The space that belongs to each body: radical cells of the spheres of equal volume, and set-Voronoi cells.
//
//   radical cells     of the bodies' centres and equivalent radii; of equal spheres the plain Voronoi cells. Fast
//   set-Voronoi cell  the points nearer to the body's surface than to any other's: the cells of points on all surfaces,
//                     of each body together. For bodies of every shape and size; the error falls with the number of
//                     points, as their spacing squared where the surfaces are smooth
//                     Where surfaces are nearer than their points are apart, at contacts, cells swap slivers that reach
//                     into the other body: the order is then below 1 (a heap of polygons: 1.3 % at 128 points, 0.5 % at
//                     512), and cells on pictures have spikes there. relative_error has it in
//   local density     volume of the body/volume of its cell
//   error             between n/2 and n points: the difference, root mean square over the bodies, about the error at n
//                     where it falls as 1/n; order: log2 of how much smaller it is than that between n/4 and n/2
//
// Cells end at the domain (periodic along its periodic axes), at plane walls and at the planes of the facets of mesh
// and polygon walls that all bodies are on one side of. In the plane cells are prisms, volumes areas times thickness.
// Source: F. M. Schaller et al., Philos. Mag. 93 (2013) 3993 (set-Voronoi). Accuracy: radical cells 1e-10; the sum of
// either is the domain to 1e-10. Cost: 1e5 spheres 2 s on one core; set-Voronoi 20 us a point, 3e5 points unless told.
// Tests: tests/libdem/analysis_voronoi.cpp.
#pragma once

#include "libdem/analysis/settings.h"
#include "libdem/analysis/voronoi_cells.h"

namespace dem::analysis {

// Where cells end; in the plane a slab as thick as the bodies, and `per_volume` takes its volumes to the snapshot's.
struct Container {
  CellBox box;
  double per_volume = 1;
};
Container container_of(const Snapshot& snapshot);

// One cell per body, volumes in m³ as the snapshot's.
Cells radical_cells(const Snapshot& snapshot, const Container& container, bool surface = false);
Cells set_voronoi_cells(const Snapshot& snapshot, const Container& container, std::size_t points, bool surface = false);

Result report_voronoi(const Snapshot& snapshot, const Settings& settings);
Result report_set_voronoi(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
