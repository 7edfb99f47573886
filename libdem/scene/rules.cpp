// Rules of a scene that join several keys: what the schema, which sees one key at a time, cannot say.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "libcontact/dispatch.h"
#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/reader.h"

namespace dem {

namespace {

class Rules {
 public:
  Rules(const Node& root, const Scene& scene, Errors& errors) : root_(root), scene_(scene), errors_(errors) {}

  void check() {
    run_length();
    method();
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) shape(i);
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) wall(i);
    for (std::size_t i = 0; i < scene_.fills.size(); ++i) fill(i);
    for (std::size_t i = 0; i < scene_.outlets.size(); ++i) nonzero("outlet", i, "normal", scene_.outlets[i].normal);
    periodic();
    pairs();
    particles();
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) material(i);
    rigid_meetings();
  }

 private:
  // The value of a key of the i-th entry of an array of tables (or of a plain table), or null.
  const Node* node(const char* table, std::size_t i, const char* key) const {
    const Node* found = root_.get(table);
    if (found && found->kind == Node::Kind::array) found = &found->items[i];
    return found && key ? found->get(key) : found;
  }
  void wrong(const char* table, std::size_t i, const char* key, const std::string& problem) {
    const Node* value = node(table, i, key);
    const Node* around = node(table, i, nullptr);
    const Position at = value ? value->position : around ? around->position : Position{1, 1};
    const std::string path = key ? fmt::format("{}.{}", table, key) : table;
    errors_.add(at, value ? fmt::format("{} = {}: {}", path, brief(*value), problem) : path + ": " + problem);
  }
  static std::string brief(const Node& value) {
    const std::string text = to_toml(value);
    return text.size() <= 60 ? text : text.substr(0, 56) + " ...";
  }
  void nonzero(const char* table, std::size_t i, const char* key, const Vec3d& v) {
    if (v == Vec3d{}) wrong(table, i, key, "must not be the zero vector");
  }

  void run_length() {
    const bool time = node("run", 0, "time"), steps = node("run", 0, "steps");
    if (time && steps) wrong("run", 0, "steps", "give run.time or run.steps, not both");
    if (!time && !steps) wrong("run", 0, nullptr, "give run.time (s) or run.steps");
  }

  void method() {
    std::vector<std::string> names{"auto"};
    for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m)
      if (std::find(names.begin(), names.end(), m->name) == names.end()) names.emplace_back(m->name);
    if (std::find(names.begin(), names.end(), scene_.method) == names.end())
      wrong("contact", 0, "method",
            fmt::format("allowed {}{}", fmt::join(names, ", "), suggestion(scene_.method, names)));
  }

  void shape(std::size_t i) {
    const ShapeSpec& s = scene_.shapes[i];
    if (s.kind != "polyhedron") return;
    if ((s.vertices.empty() ? 0 : 1) + (s.half_spaces.empty() ? 0 : 1) + (s.file.empty() ? 0 : 1) != 1)
      wrong("shape", i, nullptr, fmt::format("\"{}\" needs exactly one of vertices, half_spaces and file", s.name));
    if (!s.vertices.empty() && s.vertices.size() < 4)
      wrong("shape", i, "vertices", fmt::format("a solid needs at least 4 points, found {}", s.vertices.size()));
    for (const auto& h : s.half_spaces)
      if (h[0] == 0 && h[1] == 0 && h[2] == 0)
        return wrong("shape", i, "half_spaces", "a normal must not be the zero vector");
    if (is_shipped(shipped_name(s.file)) && s.diameter == 0)
      wrong("shape", i, "file", "a shipped shape has no size of its own: give shape.diameter (m)");
  }

  void wall(std::size_t i) {
    const WallSpec& w = scene_.walls[i];
    if (w.kind != "mesh") nonzero("wall", i, "normal", w.normal);
    if (w.motion == WallMotion::rotation) nonzero("wall", i, "axis", w.axis);
    if (w.motion != WallMotion::fixed && !(w.start < w.stop))
      wrong("wall", i, "stop", fmt::format("allowed wall.stop > wall.start = {}", w.start));
    if (w.kind != "mesh") return;
    const bool listed = !w.vertices.empty() || !w.triangles.empty();
    if (listed == !w.file.empty() || w.vertices.empty() != w.triangles.empty())
      return wrong("wall", i, nullptr, fmt::format("\"{}\" needs either file, or vertices and triangles", w.name));
    for (const auto& t : w.triangles)
      if (const std::uint32_t most = *std::max_element(t.begin(), t.end()); most >= w.vertices.size())
        return wrong("wall", i, "triangles",
                     fmt::format("vertex {} does not exist, there are {} from 0", most, w.vertices.size()));
  }

  void fill(std::size_t i) {
    const FillSpec& f = scene_.fills[i];
    for (int k = 0; k < scene_.dimension; ++k)
      if (!(f.lower[k] < f.upper[k]))
        return wrong(
            "fill", i, "upper",
            fmt::format("allowed fill.upper > fill.lower in x{}", scene_.dimension == 2 ? " and y" : ", y and z"));
  }

  // A box of some length; walls, outlets and fills that are the same for every image.
  void periodic() {
    const PeriodicSpec& box = scene_.periodic;
    const auto crosses = [&](const Vec3d& normal) {
      for (int k = 0; k < 3; ++k)
        if (box.along(k) && normal[k] != 0) return true;
      return false;
    };
    for (int k = 0; k < 3; ++k)
      if (box.along(k) && !(box.lower[k] < box.upper[k]))
        return wrong("periodic", 0, "upper", fmt::format("allowed periodic.upper > periodic.lower in {}", "xyz"[k]));
    if (box.axes == "none") return;
    const std::string zero = fmt::format("allowed: 0 along periodic.axes = \"{}\"", box.axes);
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) {
      const WallSpec& w = scene_.walls[i];
      if (w.kind != "plane")
        wrong("wall", i, "kind", "with periodic.axes only planes are allowed: a mesh has no images");
      if (w.kind == "plane" && crosses(w.normal)) wrong("wall", i, "normal", zero);
      if (w.motion == WallMotion::rotation)
        wrong("wall", i, "motion", "allowed with periodic.axes: fixed, translation, oscillation");
    }
    for (std::size_t i = 0; i < scene_.outlets.size(); ++i)
      if (crosses(scene_.outlets[i].normal)) wrong("outlet", i, "normal", zero);
    for (std::size_t i = 0; i < scene_.fills.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        if (!box.along(k)) continue;
        const FillSpec& f = scene_.fills[i];
        for (const bool low : {true, false})
          if (low ? f.lower[k] < box.lower[k] : f.upper[k] > box.upper[k])
            wrong("fill", i, low ? "lower" : "upper",
                  fmt::format("allowed within the periodic box, {} = {} to {}", "xyz"[k], box.lower[k], box.upper[k]));
      }
  }

  void pairs() {
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t i = 0; i < scene_.pairs.size(); ++i) {
      const auto [low, high] = std::minmax(scene_.pairs[i].a, scene_.pairs[i].b);
      if (!seen.insert({low, high}).second)
        wrong("material_pair", i, "a", fmt::format("the pair {}, {} stands here twice", low, high));
      if (scene_.law.name == LawName::hertz_mindlin && node("material_pair", i, "stiffness"))
        wrong("material_pair", i, "stiffness", "law hertz_mindlin takes the stiffness from young and poisson");
    }
  }

  void particles() {
    if (scene_.fills.empty() && scene_.bodies.empty() && scene_.csv.empty())
      errors_.add({1, 1}, "the scene has no bodies: give a [[fill]], a [[body]] or a [[bodies_csv]]");
    for (const FillSpec& f : scene_.fills)
      for (const FillItem& item : f.items) used_[item.material] += f.count;
    for (const BodySpec& b : scene_.bodies) ++used_[b.material];
    for (const CsvSpec& c : scene_.csv) used_[c.material] += 2;  // the file may hold any number
  }

  void material(std::size_t i) {
    const MaterialSpec& m = scene_.materials[i];
    const bool hertz = scene_.law.name == LawName::hertz_mindlin;
    if (hertz && !m.rigid && m.young == 0)
      wrong("material", i, nullptr, fmt::format("\"{}\" needs young (Pa) for law hertz_mindlin", m.name));
    if (!hertz && !m.rigid && m.stiffness == 0)
      wrong("material", i, nullptr, fmt::format("\"{}\" needs stiffness (N/m) for law spring_dashpot", m.name));
    if (m.density == 0 && used_.contains(m.name))
      wrong("material", i, nullptr, fmt::format("\"{}\" needs density (kg/m^3): bodies are made of it", m.name));
  }

  // Two bodies that are both rigid have no finite contact stiffness.
  void rigid_meetings() {
    std::map<std::string, std::uint64_t> walls;
    for (const WallSpec& w : scene_.walls) ++walls[w.material];
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      const MaterialSpec& m = scene_.materials[i];
      const auto own = used_.find(m.name);
      if (!m.rigid || own == used_.end()) continue;
      for (const MaterialSpec& other : scene_.materials) {
        if (!other.rigid) continue;
        const bool body = &other == &m ? own->second > 1 : used_.contains(other.name);
        if (body || walls.contains(other.name))
          return wrong("material", i, "rigid",
                       fmt::format("\"{}\" and \"{}\" are both rigid and can meet", m.name, other.name));
      }
    }
  }

  const Node& root_;
  const Scene& scene_;
  Errors& errors_;
  std::map<std::string, std::uint64_t> used_;  // material -> bodies made of it
};

}  // namespace

void check_rules(const Node& root, const Scene& scene, Errors& errors) {
  Rules(root, scene, errors).check();
  check_planar_rules(root, scene, errors);
}

}  // namespace dem
