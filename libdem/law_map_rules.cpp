// For which pairs of shapes and which laws a map is: the table that dem list maps prints and a scene is checked
// against.
#include <fmt/format.h>

#include <algorithm>

#include "libcontact/laws/list.h"
#include "libcontact/overlap_volume.h"
#include "libdem/build.h"
#include "libdem/insertion/rain.h"
#include "libdem/law_map.h"
#include "libdem/laws_of_scene.h"
#include "libdem/parts.h"

namespace dem {

using shapes::Kind;

namespace {

bool flat_faced(Kind k) { return k == Kind::polyhedron || k == Kind::polygon; }
bool planar(Kind k) { return shapes::dimension_of(k) == 2; }

MapVerdict equivalent_verdict(Kind a, Kind b) {
  if (planar(a)) return {Verdict::model, "radius of the disc of equal area"};
  if (a == Kind::compound || b == Kind::compound)
    return {Verdict::model, "round parts as themselves, flat ones by the volume of the whole"};
  if (a == Kind::sphere && (b == Kind::sphere || b == Kind::plane)) return {Verdict::theory, ""};
  if (a == Kind::sphere && b == Kind::mesh) return {Verdict::theory, "edges of the mesh count as flat"};
  if (a == Kind::polyhedron && (b == Kind::polyhedron || b == Kind::plane || b == Kind::mesh))
    return {Verdict::model, "radius of the sphere of equal volume, on the overlap's depth and along its slope"};
  return {Verdict::model, "radius of the sphere of equal volume"};
}

MapVerdict curvature_verdict(Kind a, Kind b) {
  if (flat_faced(a) || flat_faced(b)) return {Verdict::refused, "flat faces and sharp edges have no curvature"};
  if (a == Kind::compound || b == Kind::compound) return {Verdict::model, "part by part; flat-faced parts refused"};
  if (planar(a)) return {Verdict::model, "as round across the plane as within it"};
  if (a == Kind::rounded_polyhedron || b == Kind::rounded_polyhedron)
    return {Verdict::model, "rounding radius, on faces and edges too"};
  if (b == Kind::mesh) return {Verdict::theory, "edges of the mesh count as flat"};
  return {Verdict::theory, ""};
}

MapVerdict edge_verdict(Kind a, Kind b) {
  const bool edges = flat_faced(a) || flat_faced(b);
  const bool rounded = a == Kind::rounded_polyhedron || b == Kind::rounded_polyhedron;
  if (a == Kind::compound || b == Kind::compound) return {Verdict::model, "part by part, flat ones rounded"};
  if (edges) return {Verdict::model, "edges and corners round, faces as if they were"};
  if (rounded) return {Verdict::model, "rounding radius, on faces and edges too"};
  return equivalent_verdict(a, b);
}

MapVerdict volume_verdict(Kind a, Kind b) {
  if (a == Kind::compound || b == Kind::compound) return {Verdict::refused, "parts of a body overlap"};
  if (b == Kind::mesh) return {Verdict::refused, "a mesh has no inside"};
  if (!contact::has_overlap_volume(a, b)) return {Verdict::refused, "no closed form of the overlap's volume"};
  if (a == Kind::sphere) return {Verdict::theory, "3e-4 below Hertz at an overlap of 1e-3 R"};
  return {Verdict::model, planar(a) ? "as discs of equal area that overlap as much"
                                    : "as spheres of equal volume that overlap as much"};
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
    case LawMap::volume:
      return "volume";
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
    case LawMap::volume:
      return volume_verdict(a, b);
    case LawMap::automatic:
      if (planar(a)) return {Verdict::refused, "prisms are no spheres: for linear laws and disc_model = sphere alone"};
      break;
    case LawMap::equivalent_radius:
      break;
  }
  return equivalent_verdict(a, b);
}

namespace {

bool pulls(const contact::LawModel& law) {
  bool none = false;
  contact::each_law<contact::CohesionLaws>([&](auto cohesion, std::size_t i) {
    none = none || (i == law.cohesion && std::is_same_v<decltype(cohesion), contact::NoCohesion>);
  });
  return !none;
}

}  // namespace

MapVerdict map_verdict(LawMap map, const contact::LawModel& law) {
  const bool plain = law.loss == contact::Loss::none && !law.lingers;
  if (map == LawMap::volume) {
    if (law.lingers) return {Verdict::refused, "holds on across a gap, where there is no volume"};
    if (pulls(law)) return {Verdict::refused, "a pull beside the law is not of the volume"};
    if (!plain) return {Verdict::model, "what it remembers is of the equivalent overlap"};
    if (!law.hertzian) return {Verdict::model, "a pressure of its own over the section: k |S|/(2 pi R*)"};
    return {Verdict::model, "Hertz' potential of spheres as one of the volume"};
  }
  if (!law.hertzian) return {Verdict::theory, "its stiffness is given: a radius enters no elastic force"};
  if (map == LawMap::curvature)
    return plain && !pulls(law)
               ? MapVerdict{Verdict::theory, "the ellipse's force, its contact radius as kn/(2 E*)"}
               : MapVerdict{Verdict::model, "yield, pull-off and memory of a sphere as stiff as the ellipse"};
  return {Verdict::theory, "of spheres; other shapes: see the pairs"};
}

namespace {

Where shape_where(const World& world, const ShapeEntry& e) {
  for (const ShapeSpec& s : world.scene.shapes)
    if (s.name == e.family || s.name == e.name) return s.where;
  return {world.scene.path, 0, 0};
}

// Map `volume` is of whole bodies and of contacts that have an overlap.
void check_volume(const World& world) {
  if (world.scene.law.map != LawMap::volume) return;
  const Where file{world.scene.path, 0, 0};
  if (const MapVerdict v = map_verdict(LawMap::volume, world.law); v.verdict == Verdict::refused)
    input_error(file, fmt::format("law.map = \"volume\" is not for law {}: {}; allowed: see dem list maps",
                                  law_title(world.scene.law), v.why));
  if (world.scene.method != "auto")
    input_error(file,
                fmt::format("law.map = \"volume\" measures the overlap itself: allowed contact.method = \"auto\", "
                            "found \"{}\"",
                            world.scene.method));
  for (const ShapeEntry& e : world.shapes)
    if (e.meets_in_regions())
      input_error(shape_where(world, e),
                  fmt::format("law.map = \"volume\" is not for shape \"{}\" (polygon): it is not "
                              "convex and may overlap in several places",
                              e.name));
  for (const Wall& w : world.walls)
    if (w.meets_in_regions())
      input_error(w.motion.where, fmt::format("law.map = \"volume\" is not for wall \"{}\" (polygon): it is not convex "
                                              "and may be met in several places",
                                              w.name));
}

// What can meet: a kind, as a body or a wall, and the first thing of the scene that is of it.
struct Party {
  Kind kind;
  bool wall;
  std::string name;
  Where where;
  std::size_t bodies = 1;
};

std::vector<Party> parties(const World& world) {
  std::vector<Party> list;
  const auto add = [&](Kind kind, bool wall, const std::string& name, const Where& where) {
    for (Party& p : list)
      if (p.kind == kind && p.wall == wall) return void(++p.bodies);
    list.push_back({kind, wall, name, where});
  };
  const auto add_shape = [&](std::uint32_t shape) {
    const ShapeEntry& e = world.shapes[shape];
    const Where where = shape_where(world, e);
    const std::string name = fmt::format("shape \"{}\"", e.name);
    if (e.compound == nullptr || world.scene.law.map == LawMap::volume) return add(e.kind, false, name, where);
    for (const auto& part : e.compound->parts) add(kind_of(part.kind), false, name, where);
  };
  for (const std::uint32_t shape : world.particles.shape) add_shape(shape);
  for (const Draft& d : coming_bodies(world)) {
    add_shape(d.shape);
    add_shape(d.shape);  // another one of it
  }
  for (const Wall& w : world.walls) add(w.kind, true, fmt::format("wall \"{}\"", w.name), w.motion.where);
  return list;
}

}  // namespace

void check_map(const World& world) {
  const LawMap map = world.scene.law.map;
  if (map == LawMap::automatic) return;  // what needs a radius on prisms, the rules of the scene refuse
  check_volume(world);
  const std::vector<Party> list = parties(world);
  for (const Party& a : list)
    for (const Party& b : list) {
      if (a.wall || (&a == &b && a.bodies < 2)) continue;
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

}  // namespace dem
