// The pieces of a VTK frame, one file each. A piece that would be empty is not written.
#pragma once

#include <array>
#include <string>

#include "libdem/world.h"

namespace dem::io {

struct VtkPiece {
  const char* name;                                            // start of its file's name
  bool (*write)(const std::string& path, const World& world);  // false: nothing to write
};

// Spheres and ellipsoids, as bodies and as parts of bodies, as points: id, shape, material, radius (of the sphere of
// equal volume), velocity, spin, quaternion (w, x, y, z), tensor R diag(a, b, c) Rᵀ whose eigenvectors and eigenvalues
// are axes and semi-axes.
bool write_rounds(const std::string& path, const World& world);
// Polyhedra, as bodies and as parts, by their faces (rounded ones as polyhedra inscribed in them), polygons as one cell
// each: per cell particle (its id), shape, material, speed.
bool write_polyhedra(const std::string& path, const World& world);
// Touching contacts as lines from centre to centre, or from the centre to the contact point at a wall: a, b (a wall:
// −1 − its index), force (on a), force_magnitude, tangential, normal, overlap, point.
bool write_contacts(const std::string& path, const World& world);
// Walls as polygons: per cell wall (its index), material; where a wall has a map also pressure, traction (force of the
// bodies per area) and shear (its tangential part), Pa in double, means since the frame before; 0 on walls without.
bool write_walls(const std::string& path, const World& world);
// The periodic box as lines; along axes that are not periodic it ends where the bodies do.
bool write_cell(const std::string& path, const World& world);

inline constexpr std::array<VtkPiece, 5> vtk_pieces{{{"spheres", write_rounds},
                                                     {"polyhedra", write_polyhedra},
                                                     {"contacts", write_contacts},
                                                     {"walls", write_walls},
                                                     {"cell", write_cell}}};

}  // namespace dem::io
