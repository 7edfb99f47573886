// Convex polyhedron, canonical: every vertex is extreme, coplanar triangles are merged into one face, every edge joins
// two faces. Vertices are also kept as padded structures of arrays for kernels whose lanes run within a pair, and with
// their neighbours, for walks over the surface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapes/mass.h"
#include "shapes/math/quat.h"

namespace shapes {

// Largest vertex padding: arrays are padded to a multiple of this by repeating vertex 0 (never a new extreme point).
inline constexpr std::size_t polyhedron_padding = 8;

struct Polyhedron {
  static constexpr const char* name = "polyhedron";

  struct Face {
    Vec3d normal;         // unit, outward
    double offset;        // m, normal·x <= offset holds for the body, with equality on the face
    std::uint32_t first;  // its vertex loop: face_vertices[first .. first + count), counter-clockwise from outside
    std::uint32_t count;
  };
  struct Edge {
    std::uint32_t vertex[2];
    std::uint32_t face[2];  // face[0] holds vertex[0] -> vertex[1] in its loop, face[1] the reverse
  };

  std::vector<Vec3d> vertices;
  std::vector<Face> faces;
  std::vector<std::uint32_t> face_vertices;
  std::vector<std::uint32_t> face_edges;  // parallel to face_vertices: the edge from this loop vertex to the next one
  std::vector<Edge> edges;

  struct Spoke {           // an edge as seen from one of its vertices
    Vec3d to;              // where the other one is: a walk reads the spokes of a vertex, one after the other
    std::uint32_t vertex;  // the other one
    std::uint32_t edge;
    std::uint32_t face;  // between this spoke and the next
  };
  std::vector<std::uint32_t> first_spoke;  // of vertex i: spokes[first_spoke[i] .. first_spoke[i + 1]),
  std::vector<Spoke> spokes;               // counter-clockwise from outside
  std::vector<double> face_rise;           // m, how far below the face's plane the next vertex lies
  // Of edge i: both of its faces hold the triangle over it whose sides rise by at least sqrt(edge_tent[i]) from its
  // ends.
  std::vector<double> edge_tent;
  // A vertex that is extreme near each direction: the sphere cut into 6·lookup_cells² patches (vertex_lookup.h).
  std::uint32_t lookup_cells = 0;
  std::vector<std::uint32_t> lookup;

  std::vector<double> vx, vy, vz;      // vertices, padded to a multiple of polyhedron_padding
  std::vector<double> nx, ny, nz, nd;  // face normals and offsets, padded alike (by repeating face 0)

  MassProperties mass;        // in this frame; centre is the origin when the frame is principal
  double circumradius{};      // m, largest |vertex|
  double inscribed_radius{};  // m, smallest face offset (> 0 when the origin is inside)
  double core_radius{};       // m, of the ball about the centre of mass that the faces leave
  Pose frame;                 // x_input = R(frame.orientation) x_body + frame.position
};

enum class Frame {
  as_given,   // keep the coordinates that were given
  principal,  // origin at the centre of mass, axes along the principal axes of inertia (identity when they already are)
};

}  // namespace shapes
