// Pieces of scenes of the plane, written in code.
#pragma once

#include <string>
#include <vector>

#include "tests/libdem/scenes_in_code.h"

namespace dem::scenes {

inline ShapeSpec disc(const std::string& name, double radius) {
  ShapeSpec s = sphere(name, radius);
  s.kind = "disc";
  return s;
}
inline ShapeSpec ellipse(const std::string& name, double a, double b) {
  ShapeSpec s;
  s.name = name;
  s.kind = "ellipse";
  s.semi_axis_a = a;
  s.semi_axis_b = b;
  return s;
}
inline ShapeSpec polygon(const std::string& name, const std::vector<Vec3d>& corners) {
  ShapeSpec s;
  s.name = name;
  s.kind = "polygon";
  s.vertices = corners;
  return s;
}
inline ShapeSpec pieces(const std::string& name, const std::vector<std::vector<Vec3d>>& outlines) {
  ShapeSpec s = polygon(name, {});
  s.pieces = outlines;
  return s;
}
inline ShapeSpec regular_polygon(const std::string& name, int sides, double circumradius) {
  ShapeSpec s;
  s.name = name;
  s.kind = "regular_polygon";
  s.sides = sides;
  s.circumradius = circumradius;
  return s;
}
inline WallSpec polyline(const std::string& name, const std::vector<Vec3d>& vertices, double depth,
                         bool closed = false) {
  WallSpec w;
  w.name = name;
  w.kind = "polyline";
  w.material = "soft";
  w.vertices = vertices;
  w.depth = depth;
  w.closed = closed;
  return w;
}
inline WallSpec line(const std::string& name, const Vec3d& point, const Vec3d& normal) {
  WallSpec w = plane(name, "soft", point, normal);
  w.kind = "line";
  return w;
}

// Prisms 10 mm thick of "soft", a linear spring of 20 kN/m, under gravity along -y; nothing in it yet.
inline Scene plane_scene(double restitution = 0.4, double friction = 0.4) {
  Scene s;
  s.dimension = 2;
  s.thickness = 0.01;
  s.law.name = LawName::spring_dashpot;
  s.gravity = {0, -9.81, 0};
  s.run.steps = 1000;
  MaterialSpec m = material("soft", 0, 2500, restitution, friction);
  m.stiffness = 2e4;
  s.materials = {m};
  return s;
}

// Every shape of the plane falls and rolls together in a tray with leaning sides: centimetres, 25 times gravity.
inline Scene planar_tray(const std::vector<ShapeSpec>& shapes, std::uint64_t count) {
  Scene s = plane_scene();
  s.gravity = {60, -250, 0};
  s.run.dt_fraction = 0.3;
  s.shapes = shapes;
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0}), line("left", {-0.06, 0, 0}, {1, 0.1, 0}),
             line("right", {0.06, 0, 0}, {-1, 0.3, 0})};
  FillSpec fill;
  fill.lower = {-0.05, 0.001, 0};
  fill.upper = {0.05, 0.12, 0};
  fill.count = count;
  fill.velocity = {1, -4, 0};
  for (const ShapeSpec& shape : s.shapes) fill.items.push_back({shape.name, "soft", 1, 0.6, 0.8});
  s.fills = {fill};
  return s;
}

// The scene in units of length 2^l, mass 2^m and time 2^t times smaller.
inline Scene planar_restated(Scene s, int l, int m, int t) {
  const double length = std::ldexp(1.0, l), mass = std::ldexp(1.0, m), time = std::ldexp(1.0, t);
  s.thickness *= length;
  s.gravity *= length / (time * time);
  for (MaterialSpec& x : s.materials) {
    x.density *= mass / (length * length * length);
    x.stiffness *= mass / (time * time);
  }
  for (ShapeSpec& shape : s.shapes) {
    for (double* x : {&shape.radius, &shape.semi_axis_a, &shape.semi_axis_b, &shape.circumradius}) *x *= length;
    for (Vec3d& v : shape.vertices) v *= length;
    for (auto& piece : shape.pieces)
      for (Vec3d& v : piece) v *= length;
  }
  for (WallSpec& w : s.walls) {
    w.point *= length;
    w.depth *= length;
    w.centre *= length;
    w.velocity *= length / time;
    w.rate *= 1 / time;
    for (Vec3d& v : w.vertices) v *= length;
  }
  for (FillSpec& f : s.fills) {
    f.lower *= length;
    f.upper *= length;
    f.velocity *= length / time;
  }
  for (BodySpec& b : s.bodies) {
    b.position *= length;
    b.velocity *= length / time;
    b.spin *= 1 / time;
  }
  return s;
}

}  // namespace dem::scenes
