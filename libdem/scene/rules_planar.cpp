// Rules of two-dimensional scenes: which shapes and walls they may hold, what gives bodies their mass, and that nothing
// leaves the plane z = 0. Three-dimensional scenes may hold nothing of the plane.
#include <fmt/format.h>

#include <array>

#include "libcontact/laws/list.h"
#include "libdem/laws_of_scene.h"
#include "libdem/scene/reader.h"

namespace dem {

namespace {

constexpr const char* planar_note = "world.dimension = 2 keeps everything in the plane z = 0";

bool is_planar_kind(const std::string& kind) {
  return kind == "disc" || kind == "ellipse" || kind == "polygon" || kind == "regular_polygon" || kind == "line" ||
         kind == "polyline";
}

class PlanarRules {
 public:
  PlanarRules(const Node& root, const Scene& scene, Errors& errors)
      : root_(root), scene_(scene), errors_(errors), planar_(scene.dimension == 2) {}

  void check() {
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) kind("shape", i, scene_.shapes[i].kind);
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i)
      if (scene_.shapes[i].kind == "polygon") outline(i);
    for (std::size_t i = 0; i < scene_.walls.size(); ++i)
      if (const WallSpec& w = scene_.walls[i]; w.kind == "polygon" || w.kind == "polyline")
        corners("wall", i, "vertices", w.vertices, "", w.kind == "polyline" && !w.closed ? 2 : 3);
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) kind("wall", i, scene_.walls[i].kind);
    mass();
    if (!planar_) return;
    if (scene_.periodic.along(2)) wrong("periodic", 0, "axes", "a 2-D scene allows none, x, y, xy");
    for (const char* key : {"lower", "upper"}) components("periodic", 0, key, {2});
    law();
    components("world", 0, "gravity", {2});
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) {
      for (const char* key : {"point", "normal", "velocity", "centre", "amplitude"}) components("wall", i, key, {2});
      if (scene_.walls[i].motion == WallMotion::servo)
        components("wall", i, "axis", {2});
      else
        components("wall", i, "axis", {0, 1});
      for (const auto& row : scene_.walls[i].displacements)
        if (row[3] != 0) wrong("wall", i, "displacements", fmt::format("z must be 0: {}", planar_note));
    }
    for (std::size_t i = 0; i < scene_.fills.size(); ++i) {
      for (const char* key : {"lower", "upper", "velocity"}) components("fill", i, key, {2});
      components("fill", i, "orientation", {1, 2});
    }
    for (std::size_t i = 0; i < scene_.regions.size(); ++i)
      for (const char* key : {"lower", "upper", "centre"}) components("region", i, key, {2});
    for (std::size_t i = 0; i < scene_.rains.size(); ++i) {
      components("rain", i, "velocity", {2});
      components("rain", i, "orientation", {1, 2});
    }
    for (std::size_t i = 0; i < scene_.events.size(); ++i) components("event", i, "gravity", {2});
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      for (const char* key : {"position", "velocity"}) components("body", i, key, {2});
      components("body", i, "spin", {0, 1});
      components("body", i, "orientation", {1, 2});
    }
    for (std::size_t i = 0; i < scene_.outlets.size(); ++i)
      for (const char* key : {"point", "normal", "velocity"}) components("outlet", i, key, {2});
  }

 private:
  const Node* node(const char* table, std::size_t i, const char* key) const {
    const Node* found = root_.get(table);
    if (found && found->kind == Node::Kind::array) found = &found->items[i];
    return found ? found->get(key) : nullptr;
  }
  void wrong(const char* table, std::size_t i, const char* key, const std::string& problem) {
    const Node* value = node(table, i, key);
    const Node* around = root_.get(table);
    const Position at = value ? value->position : around ? around->position : Position{1, 1};
    const std::string path = fmt::format("{}.{}", table, key);
    errors_.add(at, value ? fmt::format("{} = {}: {}", path, to_toml(*value), problem) : path + ": " + problem);
  }

  void kind(const char* table, std::size_t i, const std::string& kind) {
    if (is_planar_kind(kind) == planar_) return;
    const bool shape = std::string(table) == "shape";
    wrong(table, i, "kind",
          planar_ ? fmt::format("a 2-D scene allows {}",
                                shape ? "disc, ellipse, polygon, regular_polygon" : "line, polygon, polyline")
                  : "is for 2-D scenes: set world.dimension = 2");
  }

  void outline(std::size_t i) {
    const ShapeSpec& s = scene_.shapes[i];
    if (s.kind != "polygon") return;
    if (s.vertices.empty() == s.pieces.empty())
      return wrong("shape", i, s.vertices.empty() ? "kind" : "pieces",
                   fmt::format("\"{}\" needs either vertices or pieces", s.name));
    if (s.pieces.empty()) corners("shape", i, "vertices", s.vertices, "");
    for (std::size_t k = 0; k < s.pieces.size(); ++k)
      corners("shape", i, "pieces", s.pieces[k], fmt::format(" of piece {}", k));
  }

  void corners(const char* table, std::size_t i, const char* key, const std::vector<Vec3d>& list, const std::string& of,
               std::size_t least = 3) {
    if (list.size() < least)
      return wrong(table, i, key, fmt::format("at least {} vertices are needed{}, found {}", least, of, list.size()));
    for (std::size_t k = 0; k < list.size(); ++k)
      if (list[k].z != 0)
        return wrong(table, i, key, fmt::format("z of vertex {}{} must be 0: {}", k, of, planar_note));
  }

  void mass() {
    const bool prism = scene_.disc_model == DiscModel::prism;
    if (!planar_) {
      if (node("world", 0, "thickness") || !prism)
        wrong("world", 0, prism ? "thickness" : "disc_model", "is for 2-D scenes: set world.dimension = 2");
      return;
    }
    if (prism && !node("world", 0, "thickness"))
      wrong("world", 0, "thickness", "is missing: 2-D bodies are prisms of this thickness (m)");
    if (!prism && node("world", 0, "thickness"))
      wrong("world", 0, "thickness", "disc_model = \"sphere\" has no thickness");
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i)
      if (!prism && scene_.shapes[i].kind != "disc")
        wrong("shape", i, "kind", "disc_model = \"sphere\" is for discs only");
  }

  void law() {
    if (scene_.disc_model == DiscModel::prism && contact::hertzian(law_names(scene_.law).normal) &&
        scene_.law.map == LawMap::automatic)
      wrong("law", 0, "name",
            "is a law of spheres and the bodies are prisms; allowed: spring_dashpot, or law.map = "
            "\"equivalent_radius\" or another that gives it a radius, or world.disc_model = \"sphere\"");
  }

  // The named entries of a list must vanish.
  void components(const char* table, std::size_t i, const char* key, std::initializer_list<std::size_t> zero) {
    const Node* value = node(table, i, key);
    if (!value || value->kind != Node::Kind::array) return;
    for (const std::size_t k : zero)
      if (k < value->items.size() && value->items[k].as_number() != 0)
        return wrong(table, i, key, fmt::format("entry {} must be 0: {}", k + 1, planar_note));
  }

  const Node& root_;
  const Scene& scene_;
  Errors& errors_;
  bool planar_;
};

}  // namespace

void check_planar_rules(const Node& root, const Scene& scene, Errors& errors) {
  PlanarRules(root, scene, errors).check();
}

}  // namespace dem
