// Bodies and walls of every kind of shape, a millimetre large, and every pair of them that may meet.
#pragma once

#include <string>
#include <vector>

#include "tests/libdem/scenes_planar.h"

namespace dem::samples {

constexpr double size = 1e-3;  // m

struct Sample {
  std::string name;
  shapes::Kind kind;
  std::vector<ShapeSpec> shapes;  // the body, then what it is made of; of a wall none
  WallSpec wall{};
  bool is_wall() const { return shapes.empty(); }
};

inline ShapeSpec regular(const std::string& kind, double circumradius) {
  ShapeSpec s;
  s.name = s.kind = kind;
  s.circumradius = circumradius;
  return s;
}

inline Sample body_of(shapes::Kind kind, ShapeSpec shape, std::vector<ShapeSpec> parts = {}) {
  Sample s{shape.name, kind, {}, {}};
  s.shapes.push_back(std::move(shape));
  for (ShapeSpec& p : parts) s.shapes.push_back(std::move(p));
  return s;
}
inline Sample wall_of(shapes::Kind kind, WallSpec wall) {
  wall.material = "m";
  return {wall.name, kind, {}, std::move(wall)};
}

// All of a kind; a kind that is new to the list does not compile without.
inline std::vector<Sample> of_kind(shapes::Kind kind) {
  using shapes::Kind;
  const double r = size;
  const ShapeSpec brick = scenes::box("box", {2 * r, 1.6 * r, 1.4 * r});
  switch (kind) {
    case Kind::sphere:
      return {body_of(kind, scenes::sphere("sphere", r))};
    case Kind::ellipsoid:
      return {body_of(kind, scenes::ellipsoid("ellipsoid", {1.3 * r, r, 0.8 * r}))};
    case Kind::polyhedron:
      return {body_of(kind, brick), body_of(kind, regular("tetrahedron", 1.5 * r)),
              body_of(kind, regular("icosahedron", 1.1 * r))};
    case Kind::rounded_polyhedron: {
      ShapeSpec s = brick;
      s.name = "rounded box";
      s.rounding = 0.2 * r;
      return {body_of(kind, s)};
    }
    case Kind::potential_particle:
      return {body_of(kind, scenes::potential("potential_particle",
                                              {{1, 0, 0, 0.6 * r},
                                               {-1, 0, 0, 0.6 * r},
                                               {0, 1, 0, 0.8 * r},
                                               {0, -1, 0, 0.8 * r},
                                               {0, 0, 1, r},
                                               {0, 0, -1, r}},
                                              0.3, 0.4 * r, r))};
    case Kind::compound: {
      const ShapeSpec bar = scenes::box("bar", {1.8 * r, 0.7 * r, 0.8 * r}),
                      stub = scenes::box("stub", {0.7 * r, r, 0.8 * r});
      return {body_of(kind, scenes::clump(
                                "clump",
                                {{-0.5 * r, 0, 0, 0.7 * r}, {0.5 * r, 0, 0, 0.6 * r}, {0, 0.5 * r, 0.1 * r, 0.6 * r}})),
              body_of(kind, scenes::union_of("L of boxes", {{"bar", {}, {}}, {"stub", {-0.55 * r, 0.85 * r, 0}, {}}}),
                      {bar, stub})};
    }
    case Kind::disc:
      return {body_of(kind, scenes::disc("disc", r))};
    case Kind::ellipse:
      return {body_of(kind, scenes::ellipse("ellipse", 1.3 * r, 0.8 * r))};
    case Kind::polygon:
      return {
          body_of(kind, scenes::regular_polygon("pentagon", 5, 1.1 * r)),
          body_of(
              kind,
              scenes::polygon(
                  "L of the plane",
                  {{-r, -r, 0}, {r, -r, 0}, {r, -0.2 * r, 0}, {-0.2 * r, -0.2 * r, 0}, {-0.2 * r, r, 0}, {-r, r, 0}}))};
    case Kind::plane:
      return {wall_of(kind, scenes::plane("plane", "m", {}, {0, 0, 1}))};
    case Kind::mesh: {
      WallSpec ridge = scenes::random_floor("mesh with a ridge", "m", 5 * r, 2, 0, 1);
      ridge.vertices = {{-5 * r, -5 * r, -r}, {5 * r, -5 * r, -r}, {-5 * r, 0, 0},
                        {5 * r, 0, 0},        {-5 * r, 5 * r, -r}, {5 * r, 5 * r, -r}};
      ridge.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
      return {wall_of(kind, scenes::random_floor("flat mesh", "m", 5 * r, 2, 0, 1)), wall_of(kind, ridge)};
    }
    case Kind::line:
      return {wall_of(kind, scenes::line("line", {}, {0, 1, 0})),
              wall_of(Kind::polygon,
                      scenes::polyline("polyline", {{-5 * r, -r, 0}, {0, 0, 0}, {5 * r, -0.5 * r, 0}}, 3 * r))};
  }
  return {};
}

struct SamplePair {
  Sample moving, resting;
  bool planar() const { return shapes::dimension_of(moving.kind) == 2; }
  std::string name() const { return moving.name + " - " + resting.name; }
};

// Bodies with each other and themselves, and with the walls of their dimension.
inline std::vector<SamplePair> every_pair() {
  std::vector<Sample> all;
  for (std::size_t k = 0; k < shapes::kind_count; ++k)
    for (Sample& s : of_kind(static_cast<shapes::Kind>(k))) all.push_back(std::move(s));
  std::vector<SamplePair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j)
      if (!all[i].is_wall() && shapes::dimension_of(all[i].kind) == shapes::dimension_of(all[j].kind))
        pairs.push_back({all[i], all[j]});
  return pairs;
}

// The two of a pair that are no walls, far apart, under this law.
inline Scene scene_of(const SamplePair& pair, const LawSpec& law, const MaterialSpec& material) {
  Scene s;
  s.law = law;
  s.materials = {material};
  s.shapes = pair.moving.shapes;
  for (const ShapeSpec& shape : pair.resting.shapes) {
    bool known = false;
    for (const ShapeSpec& t : s.shapes) known = known || t.name == shape.name;
    if (!known) s.shapes.push_back(shape);
  }
  if (pair.planar()) {
    s.dimension = 2;
    s.thickness = 10 * size;
  }
  s.run.steps = 1;
  s.run.dt = 1e-9;
  s.run.dt_auto = false;
  s.run.max_initial_overlap = 1;
  s.run.skin = 8 * size;  // paths are looked for from afar
  s.bodies = {scenes::body(pair.moving.name, "m", pair.planar() ? Vec3d{0, 50 * size, 0} : Vec3d{0, 0, 50 * size})};
  if (pair.resting.is_wall())
    s.walls = {pair.resting.wall};
  else
    s.bodies.push_back(scenes::body(pair.resting.name, "m", {}));
  return s;
}

}  // namespace dem::samples
