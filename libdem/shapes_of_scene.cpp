// Shapes and walls of a scene: from their specification to geometry and mass.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/build.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"

namespace dem {
namespace {

shapes::Polyhedron polyhedron_of(const ShapeSpec& s) {
  using shapes::Platonic;
  constexpr std::pair<const char*, Platonic> solids[] = {{"tetrahedron", Platonic::tetrahedron},
                                                         {"cube", Platonic::cube},
                                                         {"octahedron", Platonic::octahedron},
                                                         {"dodecahedron", Platonic::dodecahedron},
                                                         {"icosahedron", Platonic::icosahedron}};
  if (s.kind == "box") return shapes::make_box(s.extents);
  if (s.kind == "prism") return shapes::make_prism(s.sides, s.circumradius, s.height);
  for (const auto& [name, solid] : solids)
    if (s.kind == name) return shapes::make_platonic(solid, s.circumradius);
  if (!s.file.empty()) return shapes::polyhedron_from_file(s.file, shapes::Frame::principal);
  if (!s.half_spaces.empty()) {
    std::vector<shapes::HalfSpace> planes;
    for (const auto& h : s.half_spaces) planes.push_back({{h[0], h[1], h[2]}, h[3]});
    return shapes::polyhedron_from_half_spaces(planes, shapes::Frame::principal);
  }
  return shapes::polyhedron_from_points(s.vertices, shapes::Frame::principal);
}

// An ellipse of the plane: a prism of the scene's thickness h, m = ρ π a b h, I = m (a² + b²)/4, or (a = b) a sphere
// that moves in the plane. The moment about z stands for all three: nothing turns about another axis.
void make_planar(const Scene& scene, double a, double b, ShapeEntry& e) {
  const double area = std::numbers::pi * (a * b);
  e.size = {a, b, std::min(a, b)};
  e.circumradius = std::max(a, b);
  e.inscribed_radius = std::min(a, b);
  double moment = 0;
  if (scene.disc_model == DiscModel::sphere) {
    e.equivalent_radius = a;
    const auto ball = shapes::mass_properties(shapes::Sphere{a});
    e.volume = ball.volume;
    moment = ball.inertia.row[2].z;
  } else {
    e.equivalent_radius = a == b ? a : std::sqrt(a * b);
    e.volume = area * scene.thickness;
    e.mass_power = 2;
    moment = e.volume * (a * a + b * b) / 4;
  }
  e.inertia = {moment, moment, moment};
}

}  // namespace

ShapeEntry make_shape(const ShapeSpec& s, const Scene& scene) {
  ShapeEntry e;
  e.name = s.name;
  try {
    if (s.kind == "sphere") {
      const shapes::Sphere sphere{s.radius};
      const auto m = shapes::mass_properties(sphere);
      e.kind = shapes::Kind::sphere;
      e.size = {s.radius, s.radius, s.radius};
      e.volume = m.volume;
      e.inertia = {m.inertia.row[0].x, m.inertia.row[1].y, m.inertia.row[2].z};
      e.circumradius = e.inscribed_radius = e.equivalent_radius = s.radius;
    } else if (s.kind == "disc") {
      e.kind = shapes::Kind::disc;
      make_planar(scene, s.radius, s.radius, e);
    } else if (s.kind == "ellipse") {
      e.kind = shapes::Kind::ellipse;
      make_planar(scene, s.semi_axis_a, s.semi_axis_b, e);
    } else if (s.kind == "ellipsoid") {
      const shapes::Ellipsoid ellipsoid{s.semi_axes};
      const auto m = shapes::mass_properties(ellipsoid);
      e.kind = shapes::Kind::ellipsoid;
      e.size = s.semi_axes;
      e.volume = m.volume;
      e.inertia = {m.inertia.row[0].x, m.inertia.row[1].y, m.inertia.row[2].z};
      e.circumradius = shapes::circumradius(ellipsoid);
      e.inscribed_radius = shapes::inscribed_radius(ellipsoid);
      e.equivalent_radius = shapes::equivalent_radius(m.volume);
    } else {
      shapes::Polyhedron p = polyhedron_of(s);
      if (s.diameter > 0) p = shapes::scaled(p, s.diameter / (2 * shapes::equivalent_radius(p.mass.volume)));
      e.kind = shapes::Kind::polyhedron;
      e.size = {1, 1, 1};
      e.volume = p.mass.volume;
      e.inertia = {p.mass.inertia.row[0].x, p.mass.inertia.row[1].y, p.mass.inertia.row[2].z};
      e.circumradius = p.circumradius;
      e.inscribed_radius = p.inscribed_radius;
      e.equivalent_radius = shapes::equivalent_radius(e.volume);
      e.polyhedron = std::make_shared<const shapes::Polyhedron>(std::move(p));
    }
  } catch (const shapes::Error& error) {
    input_error(s.where, "shape \"" + s.name + "\": " + error.what());
  }
  return e;
}

}  // namespace dem
