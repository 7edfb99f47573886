// Who is next to whom on a polyhedron, for walks over its surface.
#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/convex.h"
#include "shapes/vertex_lookup.h"

namespace shapes::convex {
namespace {

void add_spokes(Polyhedron& p) {
  // In the loop of the face to the left of the edge v -> u, v comes after the end of the next edge around v.
  struct Turn {
    Polyhedron::Spoke spoke;
    std::uint32_t next;
  };
  std::vector<std::vector<Turn>> around(p.vertices.size());
  for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
    const Polyhedron::Face& face = p.faces[f];
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const auto at = [&](std::uint32_t k) { return p.face_vertices[face.first + k % face.count]; };
      around[at(i)].push_back(
          {{p.vertices[at(i + 1)], at(i + 1), p.face_edges[face.first + i], f}, at(i + face.count - 1)});
    }
  }
  p.first_spoke.assign(1, 0);
  p.spokes.clear();
  for (const auto& turns : around) {
    std::uint32_t to = turns[0].spoke.vertex;
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const auto turn = std::find_if(turns.begin(), turns.end(), [&](const Turn& t) { return t.spoke.vertex == to; });
      p.spokes.push_back(turn->spoke);
      to = turn->next;
    }
    p.first_spoke.push_back(static_cast<std::uint32_t>(p.spokes.size()));
  }
}

// The vertex next below a face is a neighbour of one of the face's own: the body is convex.
void add_rises(Polyhedron& p) {
  std::vector<std::uint32_t> last_face(p.vertices.size(), static_cast<std::uint32_t>(p.faces.size()));
  p.face_rise.clear();
  for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
    const Polyhedron::Face& face = p.faces[f];
    const auto loop = std::span(p.face_vertices).subspan(face.first, face.count);
    for (const std::uint32_t v : loop) last_face[v] = f;
    double highest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : loop)
      for (std::uint32_t k = p.first_spoke[v]; k < p.first_spoke[v + 1]; ++k)
        if (last_face[p.spokes[k].vertex] != f) highest = std::fmax(highest, dot(face.normal, p.spokes[k].to));
    p.face_rise.push_back(face.offset - highest);
  }
}

// A face is convex: it holds the triangle from an edge to any of its points, here the farthest across the edge's
// middle.
void add_tents(Polyhedron& p) {
  p.edge_tent.clear();
  for (const Polyhedron::Edge& edge : p.edges) {
    const Vec3d start = p.vertices[edge.vertex[0]], along = p.vertices[edge.vertex[1]] - start,
                middle = start + 0.5 * along;
    double least = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 2; ++side) {
      const Polyhedron::Face& face = p.faces[edge.face[side]];
      const Vec3d inward = normalized(cross(face.normal, side == 0 ? along : -along));
      for (std::uint32_t i = 0; i < face.count; ++i) {
        const Vec3d& from = p.vertices[p.face_vertices[face.first + i]];
        const Vec3d& to = p.vertices[p.face_vertices[face.first + (i + 1) % face.count]];
        const Vec3d outward = cross(to - from, face.normal);
        if (const double rate = dot(inward, outward); rate > 0)
          least = std::fmin(least, dot(from - middle, outward) / rate);
      }
    }
    least = std::fmax(least, 0.0) * (1 - 0x1p-20);
    p.edge_tent.push_back(4 * (least * least) / dot(along, along));
  }
}

void add_lookup(Polyhedron& p) {
  const std::size_t n = p.vertices.size();
  p.lookup_cells = n <= 64 ? 4 : (n <= 512 ? 8 : 16);
  p.lookup.clear();
  std::uint32_t best = 0;
  for (std::uint32_t patch = 0; patch < 6 * p.lookup_cells * p.lookup_cells; ++patch) {
    const Vec3d d = lookup_direction(patch, p.lookup_cells);
    for (std::uint32_t from = best; from != p.vertices.size();) {
      const std::uint32_t here = from;
      from = static_cast<std::uint32_t>(p.vertices.size());
      for (std::uint32_t k = p.first_spoke[here]; k < p.first_spoke[here + 1]; ++k)
        if (dot(d, p.spokes[k].to) > dot(d, p.vertices[best])) best = from = p.spokes[k].vertex;
    }
    p.lookup.push_back(best);
  }
}

}  // namespace

void add_neighbours(Polyhedron& p) {
  add_spokes(p);
  add_rises(p);
  add_tents(p);
  add_lookup(p);
}

}  // namespace shapes::convex
