// Snapshots of bodies of every shape at random places, for tests of analysis; and which points lie in a body, from the
// definitions of the shapes alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "libdem/analysis/snapshot.h"
#include "libdem/random.h"
#include "tests/libdem/scenes_in_code.h"
#include "tests/libdem/scenes_planar.h"

namespace dem::scenes {

inline ShapeSpec rounded(ShapeSpec s, double rounding) {
  s.rounding = rounding;
  return s;
}

// Shapes of space; those of the first `symmetric` of the list are their own image in their centre.
inline std::vector<ShapeSpec> shapes_of_space(std::size_t& symmetric) {
  const Scene parts = bodies_of_parts(0);
  const auto part = [&](const std::string& name) {
    return *std::find_if(parts.shapes.begin(), parts.shapes.end(), [&](const auto& s) { return s.name == name; });
  };
  std::vector<ShapeSpec> list{sphere("ball", 0.005),
                              ellipsoid("egg", {0.004, 0.005, 0.0075}),
                              ellipsoid("needle", {0.001, 0.0015, 0.01}),
                              box("brick", {0.008, 0.01, 0.012}),
                              rounded(box("pillow", {0.006, 0.008, 0.003}), 0.002),
                              potential("lump",
                                        {{1, 0, 0, 0.003},
                                         {-1, 0, 0, 0.003},
                                         {0, 1, 0, 0.004},
                                         {0, -1, 0, 0.004},
                                         {0, 0, 1, 0.005},
                                         {0, 0, -1, 0.005}},
                                        0.3, 0.002, 0.005),
                              part("dumbbell"),
                              part("plus")};
  symmetric = list.size();
  for (const char* name : {"bar", "stub", "cap"}) list.push_back(part(name));  // of which the next ones are made
  for (const char* name : {"wedge", "grain", "clump", "ell", "mushroom"}) list.push_back(part(name));
  list.push_back(potential("tetra", {{1, 1, 1, 0.005}, {1, -1, -1, 0.006}, {-1, 1, -1, 0.005}, {-1, -1, 1, 0.006}}, 0.4,
                           0.002, 0.006));
  list.push_back(union_of("stick", {{"ball", {0.004, 0, 0}, {}}, {"bar", {-0.003, 0, 0}, {}}}));
  ShapeSpec wedge = part("wedge");
  wedge.name = "pebble";
  list.push_back(rounded(wedge, 0.001));
  return list;
}

inline std::vector<ShapeSpec> shapes_of_the_plane() {
  return {disc("coin", 0.005), ellipse("oval", 0.003, 0.007), regular_polygon("hexagon", 6, 0.006),
          polygon("arrow", {{0, 0, 0}, {0.008, 0.004, 0}, {0, 0.012, 0}, {0.003, 0.005, 0}})};
}

// `each` bodies of every shape at random places of the box from 0 to `edge`, turned at random; they may overlap.
inline analysis::Snapshot scattered(const std::vector<ShapeSpec>& list, int dimension, std::size_t each, double edge,
                                    std::uint64_t seed = 1) {
  Scene s;
  s.dimension = dimension;
  s.thickness = 0.25;
  s.run.steps = 1;
  s.materials = {material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = list;
  s.law.map = LawMap::equivalent_radius;
  double at = 0;
  for (const ShapeSpec& shape : list)
    for (std::size_t k = 0; k < each; ++k) s.bodies.push_back(body(shape.name, "soft", {at += 0.1, 0, 0}));
  analysis::Snapshot snapshot = analysis::snapshot_of(build_world(s));
  Random random(seed, 1, 0);
  for (std::size_t i = 0; i < snapshot.count(); ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge), z = random.uniform(0, edge);
    snapshot.position[i] = {x, y, dimension == 2 ? 0 : z};
    const Quatd turned = random.rotation();
    snapshot.orientation[i] = dimension == 2 ? turn({0, 0, 1}, 6 * turned.w) : turned;
  }
  return snapshot;
}

// Of a point of the body frame at scale 1 (ellipsoids: at the body's size).
inline bool holds(const analysis::Snapshot& s, std::size_t i, const Vec3d& x) {
  const ShapeEntry& e = s.shape_of(i);
  const auto in_ellipsoid = [](const Vec3d& y, const Vec3d& a) {
    return y.x * y.x / (a.x * a.x) + y.y * y.y / (a.y * a.y) + y.z * y.z / (a.z * a.z) <= 1;
  };
  const auto in_solid = [](const Vec3d& y, const shapes::Polyhedron& p) {
    return std::all_of(p.faces.begin(), p.faces.end(), [&](const auto& f) { return dot(f.normal, y) <= f.offset; });
  };
  if (e.compound)
    return std::any_of(e.compound->parts.begin(), e.compound->parts.end(), [&](const shapes::Compound::Part& p) {
      const Vec3d y = transposed_times(p.rotation, x - p.centre);
      return p.solid ? in_solid(y, *p.solid) : in_ellipsoid(y, p.size);
    });
  if (e.potential) return level_at(*e.potential, x - e.potential->centre).g <= 1;
  if (e.polygon) {
    bool inside = false;
    const auto& v = e.polygon->vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Vec3d &a = v[k], &b = v[(k + 1) % v.size()];
      if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }
  if (e.polyhedron && e.kind == shapes::Kind::polyhedron) return in_solid(x, *e.polyhedron);
  if (e.polyhedron) {  // rounded: distance from the core by its faces, edges and corners
    if (in_solid(x, *e.polyhedron)) return true;
    const shapes::Polyhedron& p = *e.polyhedron;
    double least = 1e300;
    for (const auto& f : p.faces) {
      const double h = dot(f.normal, x) - f.offset;
      bool over = h >= 0;
      for (std::uint32_t k = 0; k < f.count && over; ++k) {
        const Vec3d &a = p.vertices[p.face_vertices[f.first + k]],
                    &b = p.vertices[p.face_vertices[f.first + (k + 1) % f.count]];
        over = dot(cross(f.normal, b - a), x - a) >= 0;
      }
      if (over) least = std::min(least, h);
    }
    for (const auto& edge : p.edges) {
      const Vec3d &a = p.vertices[edge.vertex[0]], &b = p.vertices[edge.vertex[1]];
      const double t = std::clamp(dot(x - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      least = std::min(least, norm(x - a - t * (b - a)));
    }
    return least <= e.size.y;
  }
  return in_ellipsoid(x, s.size[i]);
}

}  // namespace dem::scenes
