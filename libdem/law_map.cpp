#include "libdem/law_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libcontact/curvature.h"
#include "libcontact/laws/elliptical.h"
#include "libdem/build.h"
#include "libdem/insertion/rain.h"
#include "libdem/parts.h"

namespace dem {

using shapes::Kind;

namespace {

bool flat_faced(Kind k) { return k == Kind::polyhedron || k == Kind::polygon; }
bool planar(Kind k) { return shapes::dimension_of(k) == 2; }

MapVerdict equivalent_verdict(Kind a, Kind b) {
  if (planar(a)) return {Verdict::model, "radius of the disc of equal area; auto: none on prisms"};
  if (a == Kind::sphere && (b == Kind::sphere || b == Kind::plane)) return {Verdict::theory, ""};
  if (a == Kind::sphere && b == Kind::mesh) return {Verdict::theory, "edges of the mesh count as flat"};
  return {Verdict::model, "radius of the sphere of equal volume"};
}

MapVerdict curvature_verdict(Kind a, Kind b) {
  if (flat_faced(a) || flat_faced(b)) return {Verdict::refused, "flat faces and sharp edges have no curvature"};
  if (planar(a)) return {Verdict::model, "as round across the plane as within it"};
  if (a == Kind::rounded_polyhedron || b == Kind::rounded_polyhedron)
    return {Verdict::model, "rounding radius, on faces and edges too"};
  if (b == Kind::mesh) return {Verdict::theory, "edges of the mesh count as flat"};
  return {Verdict::theory, ""};
}

MapVerdict edge_verdict(Kind a, Kind b) {
  const bool edges = flat_faced(a) || flat_faced(b);
  const bool rounded = a == Kind::rounded_polyhedron || b == Kind::rounded_polyhedron;
  if (edges) return {Verdict::model, "edges and corners round, faces as if they were"};
  if (rounded) return {Verdict::model, "rounding radius, on faces and edges too"};
  return equivalent_verdict(a, b);
}

}  // namespace

const char* name_of(LawMap map) {
  switch (map) {
    case LawMap::automatic:
      return "auto";
    case LawMap::equivalent_radius:
      return "equivalent_radius";
    case LawMap::curvature:
      return "curvature";
    case LawMap::edge_radius:
      return "edge_radius";
  }
  return "";
}

MapVerdict map_verdict(LawMap map, Kind a, Kind b) {
  if (b < a) std::swap(a, b);
  if (shapes::is_wall(a)) return {Verdict::refused, "walls do not meet each other"};
  if (planar(a) != planar(b)) return {Verdict::refused, "one is of the plane, one of space"};
  switch (map) {
    case LawMap::curvature:
      // A polygon may be a wall, but kinds do not tell: check_map does.
      return curvature_verdict(a, b);
    case LawMap::edge_radius:
      return edge_verdict(a, b);
    default:
      return equivalent_verdict(a, b);
  }
}

namespace {

// What can meet: a kind, as a body or a wall, and the first thing of the scene that is of it.
struct Party {
  Kind kind;
  bool wall;
  std::string name;
  Where where;
};

std::vector<Party> parties(const World& world) {
  std::vector<Party> list;
  const auto add = [&](Kind kind, bool wall, const std::string& name, const Where& where) {
    const bool known =
        std::any_of(list.begin(), list.end(), [&](const Party& p) { return p.kind == kind && p.wall == wall; });
    if (!known) list.push_back({kind, wall, name, where});
  };
  const auto add_shape = [&](std::uint32_t shape) {
    const ShapeEntry& e = world.shapes[shape];
    const auto spec = std::find_if(world.scene.shapes.begin(), world.scene.shapes.end(),
                                   [&](const ShapeSpec& s) { return s.name == e.family || s.name == e.name; });
    const Where where = spec == world.scene.shapes.end() ? Where{world.scene.path, 0, 0} : spec->where;
    const std::string name = fmt::format("shape \"{}\"", e.name);
    if (e.compound == nullptr) return add(e.kind, false, name, where);
    for (const auto& part : e.compound->parts) add(kind_of(part.kind), false, name, where);
  };
  for (const std::uint32_t shape : world.particles.shape) add_shape(shape);
  for (const Draft& d : coming_bodies(world)) add_shape(d.shape);
  for (const Wall& w : world.walls) add(w.kind, true, fmt::format("wall \"{}\"", w.name), w.motion.where);
  return list;
}

}  // namespace

void check_map(const World& world) {
  const LawMap map = world.scene.law.map;
  const std::vector<Party> list = parties(world);
  for (const Party& a : list)
    for (const Party& b : list) {
      if (a.wall) continue;
      // Of a flat-sided wall of the plane only the body's curvature counts, as with meshes.
      const bool flat_wall = b.wall && b.kind == Kind::polygon && map == LawMap::curvature;
      const MapVerdict v = map_verdict(map, a.kind, flat_wall ? Kind::line : b.kind);
      if (v.verdict != Verdict::refused) continue;
      const Party& at = map == LawMap::curvature && !flat_faced(a.kind) ? b : a;
      input_error(at.where,
                  fmt::format("law.map = \"{}\" is not for {} ({}) against {} ({}): {}; allowed: see dem list "
                              "maps",
                              name_of(map), a.name, shapes::name_of(a.kind), b.name, shapes::name_of(b.kind), v.why));
    }
}

std::size_t map_words(const World& world) {
  if (world.scene.law.map != LawMap::curvature) return 0;
  const bool round =
      std::all_of(world.shapes.begin(), world.shapes.end(), [](const ShapeEntry& e) { return is_round(e.kind); });
  return round ? 0 : 1;
}

double radius_of_curvature(const contact::Body& a, const contact::Body& b, const Vec3d& normal, double equivalent) {
  const auto simple = [](Kind k) { return is_round(k) || shapes::is_wall(k) || k == Kind::polygon; };
  if (simple(a.kind) && simple(b.kind)) return equivalent;
  contact::Curvature of_a, of_b;  // zero: flat, and so are polygons, which are walls here
  const bool found_a = a.kind == Kind::polygon || contact::curvature(a, normal, of_a),
             found_b = b.kind == Kind::polygon || contact::curvature(b, -normal, of_b);
  if (!found_a || !found_b) return equivalent;
  if (b.kind == Kind::polygon) contact::curvature({.kind = Kind::line}, -normal, of_b);
  if (a.kind == Kind::polygon) contact::curvature({.kind = Kind::line}, normal, of_a);
  const contact::RelativeCurvature c = contact::relative_curvature(of_a, of_b);
  if (!(c.radius_eff > 0 && std::isfinite(c.radius_eff))) return equivalent;
  const double factor = contact::elliptical_hertz(c.most / c.least).factor;
  return factor * factor * c.radius_eff;  // (3)
}

namespace {

// R_e of two bodies is at most that of the geometric means G of their radii of curvature, 1/R_e >= 1/G_a + 1/G_b
// (Minkowski's inequality of determinants), and B/A at most the larger of their ratios of curvatures.
RadiusBound curvature_bound(const contact::Body& body, double equivalent) {
  if (body.kind == Kind::ellipsoid) {
    const Vec3d& s = body.size;
    const double most = std::max({s.x, s.y, s.z}), least = std::min({s.x, s.y, s.z});
    const double middle = s.x + s.y + s.z - most - least;
    return {most * (middle / least), (most / least) * (most / least)};
  }
  if (body.kind == Kind::ellipse) {
    const double most = std::max(body.size.x, body.size.y), least = std::min(body.size.x, body.size.y);
    return {most * (most / least), 1};
  }
  if (body.kind == Kind::rounded_polyhedron) return {body.size.y, 1};
  if (body.kind != Kind::potential_particle) return {equivalent, 1};
  // Flattest in the middle of its faces; a ratio of a hundred raises R* by 1.9 (laws/elliptical.h).
  RadiusBound bound{0, 100};
  const auto look = [&](const Vec3d& n) {
    contact::Curvature c;
    if (contact::curvature(body, n, c)) bound.radius = std::max(bound.radius, 1 / std::sqrt(c.least * c.most));
  };
  for (const auto& plane : static_cast<const shapes::PotentialParticle*>(body.geometry)->planes) look(plane.normal);
  for (int i = 0; i < 256; ++i) {  // directions all over the sphere
    const double z = (2 * i + 1) / 256.0 - 1, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    look({r * std::cos(angle), r * std::sin(angle), z});
  }
  return bound;
}

}  // namespace

namespace {

// Of a body of this shape and size; `equivalent`: its equivalent radius.
RadiusBound bound_of(const World& world, const ShapeEntry& shape, const Vec3d& size, double equivalent) {
  const LawMap map = world.scene.law.map;
  const bool curved = map == LawMap::curvature && !is_round(shape.kind);
  if (shape.compound == nullptr) {
    if (curved) return curvature_bound({.kind = shape.kind, .geometry = shape.geometry(), .size = size}, equivalent);
    return {law_radius(world, shape.kind, size, equivalent), 1};
  }
  if (map != LawMap::edge_radius && !curved) return {equivalent, 1};
  RadiusBound bound{0, 1};
  for (const auto& part : shape.compound->parts) {
    const contact::Body body{.kind = kind_of(part.kind), .geometry = part.solid.get(), .size = part.size * size.x};
    const double radius = part.equivalent_radius * size.x;
    const RadiusBound of_part =
        curved ? curvature_bound(body, radius) : RadiusBound{law_radius(world, body.kind, body.size, radius), 1};
    bound.radius = std::max(bound.radius, of_part.radius);
    bound.ratio = std::max(bound.ratio, of_part.ratio);
  }
  return bound;
}

}  // namespace

RadiusBound radius_bound(const World& world, std::size_t i) {
  const Particles& p = world.particles;
  return bound_of(world, world.shapes[p.shape[i]], p.size[i], p.motion[i].equivalent_radius);
}
RadiusBound radius_bound(const World& world, std::uint32_t shape, double scale) {
  const ShapeEntry& e = world.shapes[shape];
  return bound_of(world, e, e.size * scale, e.equivalent_radius * scale);
}

namespace {

double of_ellipse(double ratio) {
  if (!(ratio > 1)) return 1;
  const double factor = contact::elliptical_hertz(ratio).factor;
  return factor * factor;
}

}  // namespace

double radius_bound(const RadiusBound& a, const RadiusBound& b) {
  return a.radius * b.radius / (a.radius + b.radius) * of_ellipse(std::max(a.ratio, b.ratio));
}
double radius_bound(const RadiusBound& a) { return a.radius * of_ellipse(a.ratio); }

}  // namespace dem
