// Shapes and walls of a scene: from their specification to geometry and mass.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/build.h"
#include "shapes/geometry.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "shapes/potential_build.h"

namespace dem {
shapes::Polyhedron polyhedron_of(const ShapeSpec& s, shapes::Frame frame) {
  using shapes::Platonic;
  constexpr std::pair<const char*, Platonic> solids[] = {{"tetrahedron", Platonic::tetrahedron},
                                                         {"cube", Platonic::cube},
                                                         {"octahedron", Platonic::octahedron},
                                                         {"dodecahedron", Platonic::dodecahedron},
                                                         {"icosahedron", Platonic::icosahedron}};
  // Rounding adds to the volume: see core_of_diameter.
  const auto sized = [&](shapes::Polyhedron p) {
    if (!(s.diameter > 0) || s.rounding > 0) return p;
    return shapes::scaled(p, s.diameter / (2 * shapes::equivalent_radius(p.mass.volume)));
  };
  if (s.kind == "box") return shapes::make_box(s.extents);
  if (s.kind == "prism") return shapes::make_prism(s.sides, s.circumradius, s.height);
  for (const auto& [name, solid] : solids)
    if (s.kind == name) return shapes::make_platonic(solid, s.circumradius);
  if (!s.file.empty()) return sized(shapes::polyhedron_from_file(s.file, frame));
  if (!s.half_spaces.empty()) {
    std::vector<shapes::HalfSpace> planes;
    for (const auto& h : s.half_spaces) planes.push_back({{h[0], h[1], h[2]}, h[3]});
    return sized(shapes::polyhedron_from_half_spaces(planes, frame));
  }
  return sized(shapes::polyhedron_from_points(s.vertices, frame));
}

void set_mass_properties(const shapes::MassProperties& m, ShapeEntry& e) {
  e.volume = m.volume;
  e.inertia = {m.inertia.row[0].x, m.inertia.row[1].y, m.inertia.row[2].z};
  e.equivalent_radius = shapes::equivalent_radius(m.volume);
}

void make_sphere(double radius, ShapeEntry& e) {
  e.kind = shapes::Kind::sphere;
  e.size = {radius, radius, radius};
  set_mass_properties(shapes::mass_properties(shapes::Sphere{radius}), e);
  e.circumradius = e.inscribed_radius = e.equivalent_radius = radius;
}

void make_ellipsoid(const Vec3d& semi_axes, ShapeEntry& e) {
  const shapes::Ellipsoid ellipsoid{semi_axes};
  e.kind = shapes::Kind::ellipsoid;
  e.size = semi_axes;
  set_mass_properties(shapes::mass_properties(ellipsoid), e);
  e.circumradius = shapes::circumradius(ellipsoid);
  e.inscribed_radius = shapes::inscribed_radius(ellipsoid);
}

void make_solid(shapes::Polyhedron p, ShapeEntry& e) {
  e.kind = shapes::Kind::polyhedron;
  e.size = {1, 1, 1};
  set_mass_properties(p.mass, e);
  e.circumradius = p.circumradius;
  e.inscribed_radius = p.inscribed_radius;
  e.polyhedron = std::make_shared<const shapes::Polyhedron>(std::move(p));
}

namespace {

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

// What pictures show of a polygon: a prism, thin enough not to hide what lies behind it. A surface to draw only, made
// of vertices and faces.
shapes::Polyhedron prism_of(const shapes::Polygon& p) {
  shapes::Polyhedron solid;
  const auto n = static_cast<std::uint32_t>(p.vertices.size());
  const double half = 0.15 * p.circumradius;
  for (const double z : {-half, half})
    for (const Vec3d& v : p.vertices) solid.vertices.push_back({v.x, v.y, z});
  const auto add = [&](const Vec3d& normal, double offset, const std::vector<std::uint32_t>& loop) {
    solid.faces.push_back({normal, offset, static_cast<std::uint32_t>(solid.face_vertices.size()), 0});
    solid.face_vertices.insert(solid.face_vertices.end(), loop.begin(), loop.end());
    solid.faces.back().count = static_cast<std::uint32_t>(solid.face_vertices.size()) - solid.faces.back().first;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    add(p.normals[i], p.offsets[i], {i, j, n + j, n + i});
  }
  for (const shapes::Polygon::Part& part : p.parts) {
    std::vector<std::uint32_t> top, bottom;
    for (const Vec3d& v : part.vertices) {
      top.push_back(static_cast<std::uint32_t>(solid.vertices.size()));
      bottom.insert(bottom.begin(), top.back() + 1);
      solid.vertices.push_back({v.x, v.y, half});
      solid.vertices.push_back({v.x, v.y, -half});
    }
    add({0, 0, 1}, half, top);
    add({0, 0, -1}, half, bottom);
  }
  solid.circumradius = std::hypot(p.circumradius, half);
  return solid;
}

// A polygon of the plane: a prism of the scene's thickness h, m = ρ A h, I = ρ h ∫|x|² dA about the centroid.
void make_polygon(const ShapeSpec& s, const Scene& scene, ShapeEntry& e) {
  shapes::Polygon p =
      shapes::centred(s.kind == "regular_polygon" ? shapes::make_regular_polygon(s.sides, s.circumradius)
                      : s.pieces.empty()          ? shapes::polygon_from_outline(s.vertices)
                                                  : shapes::polygon_from_pieces(s.pieces));
  e.kind = shapes::Kind::polygon;
  e.size = {1, 1, 1};
  e.circumradius = p.circumradius;
  e.inscribed_radius = p.inscribed_radius;
  // Of a polygon that is not convex 2 A / perimeter, which is the inscribed radius of one whose sides all touch its
  // circle.
  if (!p.convex) e.overlap_radius = 2 * p.area / shapes::perimeter(p);
  e.equivalent_radius = std::sqrt(p.area / std::numbers::pi);
  e.volume = p.area * scene.thickness;
  e.mass_power = 2;
  const double moment = p.second_moment * scene.thickness;
  e.inertia = {moment, moment, moment};
  e.drawing = std::make_shared<const shapes::Polyhedron>(prism_of(p));
  e.polygon = std::make_shared<const shapes::Polygon>(std::move(p));
}

// The core whose rounded body has the volume of a sphere of a diameter: the size of the whole grows with that of the
// core, by the secant rule from both sides.
shapes::Polyhedron core_of_diameter(const shapes::Polyhedron& p, double rounding, double diameter) {
  const double wanted = 0.5 * diameter;
  if (!(rounding < wanted))
    throw shapes::Error("rounding of " + std::to_string(rounding) + " m does not fit into a body of diameter " +
                        std::to_string(diameter) + " m; allowed: rounding < diameter/2");
  const auto excess = [&](double scale) {
    const shapes::RoundedPolyhedron body{shapes::scaled(p, scale), rounding};
    return shapes::equivalent_radius(shapes::mass_properties(body).volume) - wanted;
  };
  // Without its rounding the body is too small at `high` only by what the rounding adds: too large with it.
  double high = wanted / shapes::equivalent_radius(p.mass.volume), low = high * (1 - rounding / wanted) * 0.5;
  double over = excess(high), under = excess(low);
  while (under > 0) under = excess(low *= 0.5);
  for (int i = 0; i < 60 && high - low > 0x1p-50 * high && over != under; ++i) {
    const double secant = low - under * ((high - low) / (over - under));
    const double scale = i % 3 == 2 || !(secant > low && secant < high) ? 0.5 * (low + high) : secant;
    const double at = excess(scale);
    if (at > 0)
      high = scale, over = at;
    else
      low = scale, under = at;
    if (at == 0) break;
  }
  return shapes::scaled(p, low);
}

void make_rounded(shapes::Polyhedron p, const ShapeSpec& s, ShapeEntry& e) {
  if (s.diameter > 0) p = core_of_diameter(p, s.rounding, s.diameter);
  shapes::RoundedPolyhedron body = shapes::make_rounded(p, s.rounding);
  e.kind = shapes::Kind::rounded_polyhedron;
  e.size = {1, s.rounding, 0};
  set_mass_properties(shapes::mass_properties(body), e);
  e.circumradius = shapes::circumradius(body);
  e.inscribed_radius = shapes::inscribed_radius(body);
  e.drawing = std::make_shared<const shapes::Polyhedron>(shapes::drawing_of(body));
  e.polyhedron = std::make_shared<const shapes::Polyhedron>(std::move(body.core));
}

void make_potential(const ShapeSpec& s, ShapeEntry& e) {
  std::vector<shapes::HalfSpace> planes;
  for (const auto& h : s.half_spaces) planes.push_back({{h[0], h[1], h[2]}, h[3]});
  shapes::PotentialParticle body = shapes::make_potential_particle(planes, s.k, s.r, s.R, shapes::Frame::principal);
  if (s.diameter > 0) body = shapes::scaled(body, s.diameter / (2 * shapes::equivalent_radius(body.mass.volume)));
  e.kind = shapes::Kind::potential_particle;
  e.size = {1, 1, 1};
  set_mass_properties(shapes::mass_properties(body), e);
  e.circumradius = shapes::circumradius(body);
  e.inscribed_radius = shapes::inscribed_radius(body);
  e.drawing = std::make_shared<const shapes::Polyhedron>(shapes::drawing_of(body));
  e.potential = std::make_shared<const shapes::PotentialParticle>(std::move(body));
}

ShapeEntry make_shape(const ShapeSpec& s, const Scene& scene) {
  ShapeEntry e;
  e.name = e.family = s.name;
  try {
    if (s.kind == "sphere") {
      make_sphere(s.radius, e);
    } else if (s.kind == "disc") {
      e.kind = shapes::Kind::disc;
      make_planar(scene, s.radius, s.radius, e);
    } else if (s.kind == "ellipse") {
      e.kind = shapes::Kind::ellipse;
      make_planar(scene, s.semi_axis_a, s.semi_axis_b, e);
    } else if (s.kind == "polygon" || s.kind == "regular_polygon") {
      make_polygon(s, scene, e);
    } else if (s.kind == "ellipsoid") {
      make_ellipsoid(s.semi_axes, e);
    } else if (s.kind == "clump" || s.kind == "union") {
      make_body_of_parts(s, scene, e);
    } else if (s.kind == "potential_particle") {
      make_potential(s, e);
    } else if (s.rounding > 0) {
      make_rounded(polyhedron_of(s, shapes::Frame::principal), s, e);
    } else {
      make_solid(polyhedron_of(s, shapes::Frame::principal), e);
    }
  } catch (const shapes::Error& error) {
    input_error(s.where, "shape \"" + s.name + "\": " + error.what());
  }
  if (e.overlap_radius == 0) e.overlap_radius = e.inscribed_radius;
  return e;
}

}  // namespace

std::vector<ShapeEntry> make_shapes(const ShapeSpec& s, const Scene& scene) {
  if (s.kind != "generated" && s.kind != "voronoi") return {make_shape(s, scene)};
  std::vector<ShapeEntry> entries;
  try {
    for (shapes::Polyhedron& p : generated_grains(s, scene)) {
      ShapeEntry& e = entries.emplace_back();
      e.family = s.name;
      e.name = s.name + "#" + std::to_string(entries.size());
      if (s.rounding > 0)
        make_rounded(std::move(p), s, e);
      else
        make_solid(shapes::scaled(p, s.diameter), e);
    }
  } catch (const shapes::Error& error) {
    input_error(s.where, "shape \"" + s.name + "\": " + error.what());
  }
  return entries;
}

}  // namespace dem
