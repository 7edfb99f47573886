#include "libdem/law_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/curvature.h"
#include "libcontact/laws/elliptical.h"
#include "libdem/parts.h"
#include "shapes/math/cube_root.h"

namespace dem {

using shapes::Kind;

std::size_t map_words(const World& world) {
  if (world.scene.law.map == LawMap::volume) return 1;
  if (world.scene.law.map != LawMap::curvature) return 0;
  const bool round =
      std::all_of(world.shapes.begin(), world.shapes.end(), [](const ShapeEntry& e) { return is_round(e.kind); });
  return round ? 0 : 1;
}

bool measures_depth(const World& world) {
  return world.scene.law.map != LawMap::volume &&
         std::any_of(world.shapes.begin(), world.shapes.end(), [](const ShapeEntry& e) {
           return e.kind == Kind::polyhedron || e.kind == Kind::rounded_polyhedron || e.kind == Kind::polygon;
         });
}

std::size_t record_words(const World& world) {
  const std::size_t of_map = map_words(world);
  const bool fused = world.law.fused() && !world.scene.law.ledger && of_map == 0 && !measures_depth(world);
  return fused ? 0 : world.law.words + of_map + 1;
}

EquivalentOverlap equivalent_overlap(double volume, double section, double radius_eff, bool planar) {
  const double r = radius_eff;
  if (planar) {
    const double x = 0.75 * (volume / (r * r)), overlap = r * shapes::cube_root(0.5 * x * x);
    return {overlap, 2.0 / 3.0 * overlap * (section / volume)};  // (5)
  }
  const double overlap = r * std::sqrt(volume / (std::numbers::pi * r * r * r));
  return {overlap, section / (2 * std::numbers::pi * r * overlap)};  // (4)
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
  const auto* particle = static_cast<const shapes::PotentialParticle*>(body.geometry);
  if (body.kind != Kind::potential_particle || particle == nullptr) return {equivalent, 1};
  // Flattest in the middle of its faces; a ratio of a hundred raises R* by 1.9 (laws/elliptical.h).
  RadiusBound bound{0, 100};
  const auto look = [&](const Vec3d& n) {
    contact::Curvature c;
    if (contact::curvature(body, n, c)) bound.radius = std::max(bound.radius, 1 / std::sqrt(c.least * c.most));
  };
  for (const auto& plane : particle->planes) look(plane.normal);
  for (int i = 0; i < 256; ++i) {  // directions all over the sphere
    const double z = (2 * i + 1) / 256.0 - 1, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    look({r * std::cos(angle), r * std::sin(angle), z});
  }
  return bound;
}

}  // namespace

namespace {

double largest_face(const shapes::Polyhedron& p) {
  double most = 0;
  for (const auto& face : p.faces) {
    const std::uint32_t* loop = p.face_vertices.data() + face.first;
    Vec3d sum{};
    for (std::uint32_t k = 2; k < face.count; ++k)
      sum += cross(p.vertices[loop[k - 1]] - p.vertices[loop[0]], p.vertices[loop[k]] - p.vertices[loop[0]]);
    most = std::max(most, 0.5 * norm(sum));
  }
  return most;
}
double longest_side(const shapes::Polygon& p) {
  double most = 0;
  for (std::uint32_t i = 0; i < p.vertices.size(); ++i)
    most = std::max(most, norm(p.vertices[p.next(i)] - p.vertices[i]));
  return most;
}

// Of shallow overlaps of ellipsoids and ellipses with a flat wall δ_eq = J δ, with the axes' mean over that across.
RadiusBound volume_bound(const ShapeEntry& shape, const Vec3d& size, double equivalent) {
  RadiusBound bound{equivalent, 1};
  const double mean = curvature_bound({.kind = shape.kind, .size = size}, equivalent).radius;
  if (shape.kind == Kind::polyhedron) bound.section = largest_face(*shape.polyhedron) * size.x * size.x;
  if (shape.kind == Kind::polygon) bound.section = longest_side(*shape.polygon) * size.x;
  if (shape.kind == Kind::ellipsoid) bound.gain = std::sqrt(mean / equivalent);
  if (shape.kind == Kind::ellipse) bound.gain = shapes::cube_root(mean / equivalent);
  return bound;
}

// Of a body of this shape and size; `equivalent`: its equivalent radius.
RadiusBound bound_of(const World& world, const ShapeEntry& shape, const Vec3d& size, double equivalent) {
  const LawMap map = world.scene.law.map;
  const bool curved = map == LawMap::curvature && !is_round(shape.kind);
  if (map == LawMap::volume && !is_round(shape.kind)) return volume_bound(shape, size, equivalent);
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

EquivalentOverlap steepest_overlap(const World& world, const RadiusBound& a, const RadiusBound* b, double overlap) {
  const double radius = b == nullptr ? radius_bound(a) : radius_bound(a, *b);
  double section = a.section, gain = a.gain;
  if (b != nullptr) {
    section = std::min(section, b->section);
    gain = std::max(gain, b->gain);
  }
  if (section > 0) return equivalent_overlap(section * overlap, section, radius, measures_area(world));
  return {gain * overlap, gain};
}

EquivalentOverlap monitored_overlap(const World& world, std::size_t k, double overlap) {
  const Contacts& c = world.contacts;
  EquivalentOverlap out{overlap, kept_by_map(world, k)};
  if (!(out.gain > 0)) return {overlap, 1};
  double radius = world.particles.motion[c.index_a[k]].equivalent_radius;
  if (c.key[k].b < wall_base) radius = std::min(radius, world.particles.motion[c.index_b[k]].equivalent_radius);
  // The mean depth V/|S|; shallower ones are as if that deep, with the section that they have.
  const bool area = measures_area(world);
  const double depth = overlap / out.gain * (area ? 2.0 / 3.0 : 0.5), stated = world.scene.run.dt_overlap * radius;
  if (!(depth < stated)) return out;
  const double deeper = std::sqrt(std::max(depth / stated, 0x1p-100));
  if (area) {
    const double root = shapes::cube_root(deeper * deeper);
    return {overlap / (root * root), out.gain * root};
  }
  return {overlap / deeper, out.gain * deeper};
}

}  // namespace dem
