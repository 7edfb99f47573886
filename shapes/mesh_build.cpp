#include "shapes/mesh_build.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include "shapes/convex.h"
#include "shapes/surface_file.h"

namespace shapes {
namespace {

constexpr double weld_tolerance = 1e-12;      // of the mesh's size: vertices this near are one
constexpr double coplanar_tolerance = 1e-10;  // of the mesh's size: out of a facet's plane

using Key = std::pair<std::uint32_t, std::uint32_t>;
using Triangle = std::array<std::uint32_t, 3>;

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t h = 0;
    for (const std::int64_t i : {c.x, c.y, c.z})
      h = (h ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
    return h;
  }
};

// For every vertex, the first vertex that lies within tolerance of it. `vertices` are relative to a corner of their
// box.
std::vector<std::uint32_t> welded(std::span<const Vec3d> vertices, double tolerance) {
  const double cell = 4 * tolerance;
  std::unordered_multimap<Cell, std::uint32_t, CellHash> first_at;
  std::vector<std::uint32_t> weld(vertices.size());
  const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell)); };
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Vec3d& v = vertices[i];
    std::uint32_t match = i;
    for (std::int64_t x = index(v.x - tolerance); x <= index(v.x + tolerance); ++x)
      for (std::int64_t y = index(v.y - tolerance); y <= index(v.y + tolerance); ++y)
        for (std::int64_t z = index(v.z - tolerance); z <= index(v.z + tolerance); ++z) {
          const auto [begin, end] = first_at.equal_range({x, y, z});
          for (auto it = begin; it != end; ++it)
            if (it->second < match && max_abs(vertices[it->second] - v) <= tolerance) match = it->second;
        }
    weld[i] = match;
    if (match == i) first_at.emplace(Cell{index(v.x), index(v.y), index(v.z)}, i);
  }
  return weld;
}

// A mesh at unit size while its facets are found.
struct Builder {
  std::vector<Vec3d> vertices;
  std::vector<Triangle> triangles;
  double size = 0;
  std::vector<Vec3d> area;                          // of each triangle, along its normal
  std::map<Key, std::vector<std::uint32_t>> users;  // undirected edge -> triangles
  std::vector<std::uint32_t> facet_of;              // triangle -> facet

  void check_triangles();
  void find_users();
  void find_facets();
  void add_facets(Mesh& mesh) const;
  void add_edges(Mesh& mesh) const;
  void add_borders(Mesh& mesh) const;
  void add_inner_circle(const Mesh& mesh, Mesh::Facet& facet) const;
};

void Builder::check_triangles() {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    area.push_back(0.5 * convex::accurate_cross(vertices[b] - vertices[a], vertices[c] - vertices[a]));
    const double longest = std::fmax(norm(vertices[b] - vertices[a]),
                                     std::fmax(norm(vertices[c] - vertices[b]), norm(vertices[a] - vertices[c])));
    if (a == b || b == c || c == a || !(2 * convex::safe_norm(area[t]) > weld_tolerance * size * longest))
      throw Error("mesh: triangle " + std::to_string(t) +
                  " has no area; allowed: height above 1e-12 of the mesh's size");
  }
}

void Builder::find_users() {
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      auto& at = users[{std::min(a, b), std::max(a, b)}];
      at.push_back(t);
      if (at.size() > 2)
        throw Error("mesh: triangles " + std::to_string(at[0]) + ", " + std::to_string(at[1]) + ", " +
                    std::to_string(at[2]) + " share one edge; allowed: at most 2 triangles at an edge");
    }
}

// Facets grow from the largest triangle left, whose plane is the most accurate, over neighbours that lie in that plane;
// they are then numbered by their lowest triangle.
void Builder::find_facets() {
  const auto count = static_cast<std::uint32_t>(triangles.size());
  std::vector<std::uint32_t> order(count), seed_of(count, Mesh::none);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return dot(area[a], area[a]) > dot(area[b], area[b]); });
  for (const std::uint32_t seed : order) {
    if (seed_of[seed] != Mesh::none) continue;
    seed_of[seed] = seed;
    const Vec3d n = convex::unit(area[seed]), on_plane = vertices[triangles[seed][0]];
    std::vector<std::uint32_t> stack{seed};
    while (!stack.empty()) {
      const Triangle at = triangles[stack.back()];
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        for (const std::uint32_t next :
             users.at({std::min(at[i], at[(i + 1) % 3]), std::max(at[i], at[(i + 1) % 3])})) {
          const bool coplanar = seed_of[next] == Mesh::none &&
                                std::all_of(triangles[next].begin(), triangles[next].end(), [&](std::uint32_t v) {
                                  return std::fabs(dot(n, vertices[v] - on_plane)) <= coplanar_tolerance * size;
                                });
          if (!coplanar) continue;
          seed_of[next] = seed;
          stack.push_back(next);
        }
    }
  }
  std::vector<std::uint32_t> number(count, Mesh::none);
  std::uint32_t facets = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (number[seed_of[t]] == Mesh::none) number[seed_of[t]] = facets++;
    facet_of.push_back(number[seed_of[t]]);
  }
}

// Normal: sum of the triangles' area vectors; offset: area-weighted mean of their centroids. Triangles are wound about
// it.
void Builder::add_facets(Mesh& mesh) const {
  std::vector<std::vector<std::uint32_t>> members;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (facet_of[t] == members.size()) members.emplace_back();
    members[facet_of[t]].push_back(t);
  }
  for (const auto& triangle : triangles) mesh.triangles.insert(mesh.triangles.end(), triangle.begin(), triangle.end());
  for (const auto& list : members) {
    Mesh::Facet facet{};
    const Vec3d base = vertices[triangles[list[0]][0]];
    Vec3d sum{}, moment{};
    double total = 0;
    facet.lower = facet.upper = base;
    for (const std::uint32_t t : list) {
      const bool flipped = dot(area[t], area[list[0]]) < 0;
      if (flipped) std::swap(mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]);
      sum += flipped ? -area[t] : area[t];
      const double weight = convex::safe_norm(area[t]);
      Vec3d corners{};
      for (const std::uint32_t v : triangles[t]) {
        corners += vertices[v] - base;
        for (int i = 0; i < 3; ++i) {
          facet.lower[i] = std::fmin(facet.lower[i], vertices[v][i]);
          facet.upper[i] = std::fmax(facet.upper[i], vertices[v][i]);
        }
      }
      moment += weight * corners;
      total += 3 * weight;
    }
    facet.normal = convex::unit(sum);
    facet.offset = dot(facet.normal, base) + dot(facet.normal, moment) / total;
    facet.first_triangle = static_cast<std::uint32_t>(mesh.facet_triangles.size());
    facet.triangle_count = static_cast<std::uint32_t>(list.size());
    mesh.facet_triangles.insert(mesh.facet_triangles.end(), list.begin(), list.end());
    mesh.facets.push_back(facet);
  }
}

// Real edges, sorted by owner. Where two edges of the same facets run straight on through a vertex that no other real
// edge meets, they are one: the vertex is a feature of the triangulation only.
void Builder::add_edges(Mesh& mesh) const {
  std::map<Key, Key> real;                             // end points -> facets
  std::map<std::uint32_t, std::vector<Key>> edges_at;  // vertex -> its real edges
  for (const auto& [edge, at] : users) {
    const std::uint32_t f = facet_of[at[0]], g = at.size() == 2 ? facet_of[at[1]] : Mesh::none;
    if (f == g) continue;
    real[edge] = {std::min(f, g), std::max(f, g)};
    edges_at[edge.first].push_back(edge);
    edges_at[edge.second].push_back(edge);
  }
  const auto other_end = [](const Key& e, std::uint32_t v) { return e.first == v ? e.second : e.first; };
  for (const auto& [v, at] : edges_at) {
    if (at.size() != 2 || real.at(at[0]) != real.at(at[1])) continue;
    const std::uint32_t a = other_end(at[0], v), b = other_end(at[1], v);
    const Key joined{std::min(a, b), std::max(a, b)};
    const Vec3d along = vertices[b] - vertices[a], part = vertices[v] - vertices[a];
    const bool between = dot(part, along) > 0 && dot(vertices[b] - vertices[v], along) > 0;
    if (a == b || real.contains(joined) || !between ||
        !(convex::safe_norm(cross(along, part)) <= coplanar_tolerance * size * norm(along)))
      continue;
    const Key old[2] = {at[0], at[1]};
    real[joined] = real.at(old[0]);
    real.erase(old[0]);
    real.erase(old[1]);
    std::replace(edges_at[a].begin(), edges_at[a].end(), old[0], joined);
    std::replace(edges_at[b].begin(), edges_at[b].end(), old[1], joined);
  }
  for (const auto& [edge, facets] : real)
    mesh.edges.push_back({{edge.first, edge.second}, {facets.first, facets.second}, {}});
  std::stable_sort(mesh.edges.begin(), mesh.edges.end(),
                   [](const Mesh::Edge& a, const Mesh::Edge& b) { return a.facet[0] < b.facet[0]; });
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    Mesh::Facet& owner = mesh.facets[mesh.edges[e].facet[0]];
    if (owner.edge_count++ == 0) owner.first_edge = e;
    mesh.facet_edges.push_back(e);
  }
}

// Edges by facet and by vertex, and the directions from an edge into its facets. Triangles are wound about the facet's
// normal, so the inside lies left of the border; the triangle side at the edge's start that runs along the edge tells
// which way the border goes.
void Builder::add_borders(Mesh& mesh) const {
  std::vector<std::vector<std::uint32_t>> of_facet(mesh.facets.size()), at_vertex(vertices.size()),
      around(vertices.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t]) around[v].push_back(t);
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    Mesh::Edge& edge = mesh.edges[e];
    const std::uint32_t start = edge.vertex[0];
    for (const std::uint32_t v : edge.vertex) at_vertex[v].push_back(e);
    const Vec3d along = convex::unit(vertices[edge.vertex[1]] - vertices[start]);
    for (int k = 0; k < 2 && edge.facet[k] != Mesh::none; ++k) {
      of_facet[edge.facet[k]].push_back(e);
      double best = -2, sign = 1;
      for (const std::uint32_t t : around[start]) {
        if (facet_of[t] != edge.facet[k]) continue;
        const std::uint32_t* corner = &mesh.triangles[3 * t];
        const int i = corner[0] == start ? 0 : (corner[1] == start ? 1 : 2);
        const double next = dot(along, convex::unit(vertices[corner[(i + 1) % 3]] - vertices[start]));
        const double previous = dot(along, convex::unit(vertices[corner[(i + 2) % 3]] - vertices[start]));
        if (next > best) best = next, sign = 1;
        if (previous > best) best = previous, sign = -1;
      }
      edge.inward[k] = sign * convex::unit(cross(mesh.facets[edge.facet[k]].normal, along));
    }
  }
  for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
    mesh.facets[f].first_border = static_cast<std::uint32_t>(mesh.facet_borders.size());
    mesh.facets[f].border_count = static_cast<std::uint32_t>(of_facet[f].size());
    mesh.facet_borders.insert(mesh.facet_borders.end(), of_facet[f].begin(), of_facet[f].end());
  }
  mesh.first_vertex_edge.push_back(0);
  for (const auto& list : at_vertex) {
    mesh.vertex_edges.insert(mesh.vertex_edges.end(), list.begin(), list.end());
    mesh.first_vertex_edge.push_back(static_cast<std::uint32_t>(mesh.vertex_edges.size()));
  }
}

// About the centroid, out to the nearest border; none where the centroid lies in no triangle of the facet.
void Builder::add_inner_circle(const Mesh& mesh, Mesh::Facet& facet) const {
  const Vec3d n = facet.normal;
  Vec3d centre{};
  double whole = 0;
  const auto corner = [&](std::uint32_t k, std::size_t i) { return vertices[triangles[mesh.facet_triangles[k]][i]]; };
  for (std::uint32_t k = facet.first_triangle; k < facet.first_triangle + facet.triangle_count; ++k) {
    const double part = norm(area[mesh.facet_triangles[k]]);
    whole += part;
    centre += (part / 3) * (corner(k, 0) + corner(k, 1) + corner(k, 2));
  }
  centre *= 1 / whole;
  bool inside = false;
  for (std::uint32_t k = facet.first_triangle; k < facet.first_triangle + facet.triangle_count && !inside; ++k) {
    const double turn = dot(area[mesh.facet_triangles[k]], n);
    inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d from = corner(k, i), along = corner(k, (i + 1) % 3) - from;
      inside = inside && dot(cross(along, centre - from), n) * turn >= 0;
    }
  }
  const auto in_plane = [&](const Vec3d& v) { return v - dot(v, n) * n; };
  double square = inside ? std::numeric_limits<double>::infinity() : 0;
  for (std::uint32_t k = 0; k < facet.border_count; ++k) {
    const Mesh::Edge& edge = mesh.edges[mesh.facet_borders[facet.first_border + k]];
    const Vec3d from = in_plane(vertices[edge.vertex[0]] - centre),
                along = in_plane(vertices[edge.vertex[1]] - vertices[edge.vertex[0]]);
    const double t = std::clamp(-dot(from, along) / dot(along, along), 0.0, 1.0);
    const Vec3d nearest = from + t * along;
    square = std::min(square, dot(nearest, nearest));
  }
  facet.inner_centre = centre;
  facet.inner_radius = std::isfinite(square) ? std::sqrt(square) : 0;  // a closed surface in one plane has no border
}

// Welds, scales to unit size, drops vertices that no triangle uses.
Builder prepared(std::span<const Vec3d> given, std::span<const std::uint32_t> indices, int& exponent) {
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!convex::finite(given[i]))
      throw Error("mesh: vertex " + std::to_string(i) + " is not finite; allowed: finite numbers");
  if (indices.empty() || indices.size() % 3 != 0)
    throw Error("mesh: " + std::to_string(indices.size()) +
                " indices; allowed: three per triangle, at least one triangle");
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= given.size())
      throw Error("mesh: triangle " + std::to_string(i / 3) + " has vertex index " + std::to_string(indices[i]) +
                  "; allowed: below the number of vertices, " + std::to_string(given.size()));
  const double largest = convex::largest_coordinate(given);
  if (!(largest > 0)) throw Error("mesh: all vertices are at the origin; allowed: triangles with area");
  exponent = convex::exponent_above(largest);

  std::vector<Vec3d> scaled_vertices;
  for (const Vec3d& v : given) scaled_vertices.push_back(convex::times_two_to(v, -exponent));
  Vec3d lower = scaled_vertices[indices[0]], upper = lower;
  for (const std::uint32_t index : indices)
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::fmin(lower[i], scaled_vertices[index][i]);
      upper[i] = std::fmax(upper[i], scaled_vertices[index][i]);
    }
  Builder builder;
  builder.size = max_abs(upper - lower);
  if (!(builder.size > 0)) throw Error("mesh: all vertices coincide; allowed: triangles with area");
  std::vector<Vec3d> used;
  std::vector<std::uint32_t> position(given.size(), Mesh::none), original;
  for (const std::uint32_t index : indices) {
    if (position[index] != Mesh::none) continue;
    position[index] = 0;
  }
  for (std::uint32_t i = 0; i < given.size(); ++i) {
    if (position[i] == Mesh::none) continue;
    position[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(scaled_vertices[i] - lower);
    original.push_back(i);
  }
  const std::vector<std::uint32_t> weld = welded(used, weld_tolerance * builder.size);
  std::vector<std::uint32_t> number(used.size());
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (weld[i] == i) {
      number[i] = static_cast<std::uint32_t>(builder.vertices.size());
      builder.vertices.push_back(scaled_vertices[original[i]]);
    } else {
      number[i] = number[weld[i]];
    }
  }
  for (std::size_t i = 0; i < indices.size(); i += 3)
    builder.triangles.push_back(
        {number[position[indices[i]]], number[position[indices[i + 1]]], number[position[indices[i + 2]]]});
  return builder;
}

}  // namespace

Mesh mesh_from_triangles(std::span<const Vec3d> vertices, std::span<const std::uint32_t> triangles) {
  int exponent = 0;
  Builder builder = prepared(vertices, triangles, exponent);
  builder.check_triangles();
  builder.find_users();
  builder.find_facets();
  Mesh mesh;
  builder.add_facets(mesh);
  builder.add_edges(mesh);
  builder.add_borders(mesh);
  for (Mesh::Facet& f : mesh.facets) builder.add_inner_circle(mesh, f);
  for (const Vec3d& v : builder.vertices) mesh.vertices.push_back(convex::times_two_to(v, exponent));
  for (Mesh::Facet& f : mesh.facets) {
    f.offset = std::ldexp(f.offset, exponent);
    f.lower = convex::times_two_to(f.lower, exponent);
    f.upper = convex::times_two_to(f.upper, exponent);
    f.inner_centre = convex::times_two_to(f.inner_centre, exponent);
    f.inner_radius = std::ldexp(f.inner_radius, exponent);
  }
  return mesh;
}

Mesh mesh_from_file(const std::string& path, double scale) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw Error("mesh scale: " + std::to_string(scale) + "; allowed: finite and > 0");
  Surface s = read_surface(path);
  std::vector<std::uint32_t> triangles;
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const auto& face = s.faces[f];
    Vec3d normal{};
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      normal += cross(s.vertices[face[i]] - s.vertices[face[0]], s.vertices[face[i + 1]] - s.vertices[face[0]]);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Vec3d part =
          cross(s.vertices[face[i]] - s.vertices[face[0]], s.vertices[face[i + 1]] - s.vertices[face[0]]);
      if (!(dot(part, normal) > 0))
        throw Error(path + ": face " + std::to_string(f) +
                    " has no area or is not a convex polygon; allowed: convex polygons or triangles");
      triangles.insert(triangles.end(), {face[0], face[i], face[i + 1]});
    }
  }
  for (Vec3d& v : s.vertices) v *= scale;
  try {
    return mesh_from_triangles(s.vertices, triangles);
  } catch (const Error& e) {
    throw Error(path + ": " + e.what());
  }
}

}  // namespace shapes
