// Rules of a scene that join several keys: what the schema, which sees one key at a time, cannot say.
#include "libdem/scene/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "libcontact/dispatch.h"
#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/reader.h"
#include "shapes/potential_particle.h"

namespace dem {

const Node* RuleContext::node(const char* table, std::size_t i, const char* key) const {
  const Node* found = root.get(table);
  if (found && found->kind == Node::Kind::array) found = &found->items[i];
  return found && key ? found->get(key) : found;
}

void RuleContext::wrong(const char* table, std::size_t i, const char* key, const std::string& problem) const {
  const auto brief = [](const Node& value) {
    const std::string text = to_toml(value);
    return text.size() <= 60 ? text : text.substr(0, 56) + " ...";
  };
  const Node* value = node(table, i, key);
  const Node* around = node(table, i, nullptr);
  const Position at = value ? value->position : around ? around->position : Position{1, 1};
  const std::string path = key ? fmt::format("{}.{}", table, key) : table;
  errors.add(at, value ? fmt::format("{} = {}: {}", path, brief(*value), problem) : path + ": " + problem);
}

void RuleContext::nonzero(const char* table, std::size_t i, const char* key, const Vec3d& v) const {
  if (v == Vec3d{}) wrong(table, i, key, "must not be the zero vector");
}

namespace {

class Rules : RuleContext {
 public:
  explicit Rules(const RuleContext& context) : RuleContext(context) {}

  void check() {
    run_length();
    method();
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) shape(i);
    for (std::size_t i = 0; i < scene.walls.size(); ++i) check_wall_rules(*this, i);
    check_insertion_rules(*this);
    check_periodic_rules(*this);
    check_analysis_rules(*this);
    check_law_rules(*this);
    if (!scene.drag.gradient.empty() && scene.drag.gradient.size() != 3)
      wrong("drag", 0, "gradient", fmt::format("allowed three rows, found {}", scene.drag.gradient.size()));
    if (scene.dimension == 2 && scene.drag.velocity.z != 0)
      wrong("drag", 0, "velocity", "allowed: 0 along z in a 2-D scene");
    if (scene.dimension == 2 && scene.drag.gradient.size() == 3 && !(scene.drag.gradient[2] == Vec3d{}))
      wrong("drag", 0, "gradient", "allowed: a third row of zeros in a 2-D scene");
    pairs();
    particles();
    for (std::size_t i = 0; i < scene.materials.size(); ++i) material(i);
    rigid_meetings();
  }

 private:
  void run_length() {
    const bool time = node("run", 0, "time"), steps = node("run", 0, "steps");
    if (time && steps) wrong("run", 0, "steps", "give run.time or run.steps, not both");
    if (!time && !steps) wrong("run", 0, nullptr, "give run.time (s) or run.steps");
  }

  void method() {
    std::vector<std::string> names{"auto"};
    for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m)
      if (std::find(names.begin(), names.end(), m->name) == names.end()) names.emplace_back(m->name);
    if (std::find(names.begin(), names.end(), scene.method) == names.end())
      wrong("contact", 0, "method",
            fmt::format("allowed {}{}", fmt::join(names, ", "), suggestion(scene.method, names)));
    if (scene.method != "auto" && scene.tolerance > 0)
      wrong("contact", 0, "tolerance",
            fmt::format("goes with method = \"auto\" alone, found method = \"{}\"", scene.method));
  }

  void shape(std::size_t i) {
    const ShapeSpec& s = scene.shapes[i];
    if (s.kind == "clump" && s.spheres.empty() == s.spheres_file.empty())
      wrong("shape", i, nullptr, fmt::format("\"{}\" needs exactly one of spheres and spheres_file", s.name));
    for (const auto& ball : s.spheres)
      if (!(ball[3] > 0))
        return wrong("shape", i, "spheres", fmt::format("allowed radius > 0 in [x, y, z, radius], found {}", ball[3]));
    for (const PartSpec& part : s.parts) this->part(i, part);
    for (const auto& h : s.half_spaces)
      if (h[0] == 0 && h[1] == 0 && h[2] == 0)
        return wrong("shape", i, "half_spaces", "a normal must not be the zero vector");
    if (s.kind == "potential_particle") potential(i);
    if (s.kind != "polyhedron") return;
    if ((s.vertices.empty() ? 0 : 1) + (s.half_spaces.empty() ? 0 : 1) + (s.file.empty() ? 0 : 1) != 1)
      wrong("shape", i, nullptr, fmt::format("\"{}\" needs exactly one of vertices, half_spaces and file", s.name));
    if (!s.vertices.empty() && s.vertices.size() < 4)
      wrong("shape", i, "vertices", fmt::format("a solid needs at least 4 points, found {}", s.vertices.size()));
    if (is_shipped(shipped_name(s.file)) && s.diameter == 0)
      wrong("shape", i, "file", "a shipped shape has no size of its own: give shape.diameter (m)");
  }

  // What the builder would refuse as well, with the place in the file.
  void potential(std::size_t i) {
    const ShapeSpec& s = scene.shapes[i];
    if (s.half_spaces.size() > shapes::PotentialParticle::most_planes)
      wrong("shape", i, "half_spaces",
            fmt::format("a potential particle has at most {} planes, found {}", shapes::PotentialParticle::most_planes,
                        s.half_spaces.size()));
    for (const auto& h : s.half_spaces)
      if (!(h[3] > 0))
        return wrong("shape", i, "half_spaces",
                     fmt::format("allowed offset > 0 (the origin lies inside a potential particle), found {}", h[3]));
  }

  // Parts are simple solids: a body of parts is none, and what lives in the plane neither.
  void part(std::size_t i, const PartSpec& part) {
    for (const ShapeSpec& s : scene.shapes) {
      if (s.name != part.shape) continue;
      for (const char* kind : {"clump", "union", "generated", "voronoi", "potential_particle", "disc", "ellipse",
                               "polygon", "regular_polygon"})
        if (s.kind == kind)
          return wrong(
              "shape", i, "parts",
              fmt::format("\"{}\" is of kind {}; allowed: sphere, ellipsoid and solids with flat faces", s.name, kind));
      if (s.rounding > 0)
        return wrong("shape", i, "parts",
                     fmt::format("\"{}\" has shape.rounding; allowed: solids with sharp edges", s.name));
    }
  }

  void pairs() {
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
      const auto [low, high] = std::minmax(scene.pairs[i].a, scene.pairs[i].b);
      if (!seen.insert({low, high}).second)
        wrong("material_pair", i, "a", fmt::format("the pair {}, {} stands here twice", low, high));
    }
  }

  void particles() {
    if (scene.fills.empty() && scene.bodies.empty() && scene.csv.empty() && scene.rains.empty())
      errors.add({1, 1}, "the scene has no bodies: give a [[fill]], a [[body]], a [[bodies_csv]] or a [[rain]]");
    for (const FillSpec& f : scene.fills)
      for (const FillItem& item : f.items) used_[item.material] += f.count > 0 ? f.count : 2;
    for (const RainSpec& r : scene.rains)
      for (const FillItem& item : r.items) used_[item.material] += 2;
    for (const BodySpec& b : scene.bodies) ++used_[b.material];
    for (const CsvSpec& c : scene.csv) used_[c.material] += 2;  // the file may hold any number
  }

  void material(std::size_t i) {
    const MaterialSpec& m = scene.materials[i];
    if (m.density == 0 && used_.contains(m.name))
      wrong("material", i, nullptr, fmt::format("\"{}\" needs density (kg/m^3): bodies are made of it", m.name));
  }

  // Two bodies that are both rigid have no finite contact stiffness.
  void rigid_meetings() {
    std::map<std::string, std::uint64_t> walls;
    for (const WallSpec& w : scene.walls) ++walls[w.material];
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const MaterialSpec& m = scene.materials[i];
      const auto own = used_.find(m.name);
      if (!m.rigid || own == used_.end()) continue;
      for (const MaterialSpec& other : scene.materials) {
        if (!other.rigid) continue;
        const bool body = &other == &m ? own->second > 1 : used_.contains(other.name);
        if (body || walls.contains(other.name))
          return wrong("material", i, "rigid",
                       fmt::format("\"{}\" and \"{}\" are both rigid and can meet", m.name, other.name));
      }
    }
  }

  std::map<std::string, std::uint64_t> used_;  // material -> bodies made of it
};

}  // namespace

void check_rules(const Node& root, const Scene& scene, Errors& errors) {
  Rules({root, scene, errors}).check();
  check_planar_rules(root, scene, errors);
}

}  // namespace dem
