// Rules of [[wall]] that join several keys.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "libdem/scene/rules.h"

namespace dem {

namespace {

void listed_mesh(const RuleContext& c, std::size_t i) {
  const WallSpec& w = c.scene.walls[i];
  const bool listed = !w.vertices.empty() || !w.triangles.empty();
  if (listed == !w.file.empty() || w.vertices.empty() != w.triangles.empty())
    return c.wrong("wall", i, nullptr, fmt::format("\"{}\" needs either file, or vertices and triangles", w.name));
  for (const auto& t : w.triangles)
    if (const std::uint32_t most = *std::max_element(t.begin(), t.end()); most >= w.vertices.size())
      return c.wrong("wall", i, "triangles",
                     fmt::format("vertex {} does not exist, there are {} from 0", most, w.vertices.size()));
}

void generated_mesh(const RuleContext& c, std::size_t i) {
  const WallSpec& w = c.scene.walls[i];
  const std::map<std::string, std::vector<std::string>> faces{{"box", {"-x", "+x", "-y", "+y", "-z", "+z"}},
                                                              {"die", {"-z"}},
                                                              {"cylinder", {"base", "top"}},
                                                              {"cone", {"base", "top"}},
                                                              {"v_shell", {"ends"}}};
  if (const auto own = faces.find(w.kind); own != faces.end())
    for (const std::string& face : w.open)
      if (std::find(own->second.begin(), own->second.end(), face) == own->second.end())
        return c.wrong("wall", i, "open",
                       fmt::format("a {} has no face {}; allowed {}", w.kind, face, fmt::join(own->second, ", ")));
  if (w.kind == "box" || w.kind == "die")
    for (int k = 0; k < 3; ++k)
      if (!(w.lower[k] < w.upper[k]))
        return c.wrong("wall", i, "upper", "allowed wall.upper > wall.lower in x, y and z");
  if (w.kind == "panel") {
    c.nonzero("wall", i, "side_1", w.side_1);
    c.nonzero("wall", i, "side_2", w.side_2);
    const Vec3d a = w.side_1, b = w.side_2;
    const double square = dot(cross(a, b), cross(a, b));
    if (!(square > 1e-20 * dot(a, a) * dot(b, b))) c.wrong("wall", i, "side_2", "must not be parallel to wall.side_1");
  }
  if ((w.kind == "cylinder" || w.kind == "cone" || w.kind == "drum") && w.base == w.top)
    c.wrong("wall", i, "top", "must not be the point wall.base");
  if (w.kind == "cone" && w.base_radius == 0 && w.top_radius == 0)
    c.wrong("wall", i, "top_radius", "one of base_radius and top_radius must be above 0");
  if (w.kind == "v_shell") {
    const double least = w.radius / std::tan(0.5 * w.angle);
    if (!(w.length > least))
      c.wrong(
          "wall", i, "length",
          fmt::format("the arms end inside their joint; allowed wall.length > radius / tan(angle / 2) = {}", least));
  }
}

template <class Rows>
void rising_times(const RuleContext& c, std::size_t i, const char* key, const Rows& rows) {
  for (std::size_t r = 1; r < rows.size(); ++r)
    if (!(rows[r][0] > rows[r - 1][0]))
      return c.wrong("wall", i, key,
                     fmt::format("time {} of row {} does not follow {}: allowed are rising times", rows[r][0], r + 1,
                                 rows[r - 1][0]));
}

void table_motion(const RuleContext& c, std::size_t i) {
  const WallSpec& w = c.scene.walls[i];
  const bool rows = !w.displacements.empty() || !w.turns.empty();
  if (rows == !w.table_file.empty())
    return c.wrong("wall", i, nullptr,
                   fmt::format("\"{}\" needs either table_file, or displacements or turns or both", w.name));
  rising_times(c, i, "displacements", w.displacements);
  rising_times(c, i, "turns", w.turns);
  if (!w.turns.empty() && !c.node("wall", i, "axis"))
    c.wrong("wall", i, nullptr, fmt::format("\"{}\" turns: it needs axis and centre (m)", w.name));
  if (c.node("wall", i, "axis")) c.nonzero("wall", i, "axis", w.axis);
}

void servo_motion(const RuleContext& c, std::size_t i) {
  const WallSpec& w = c.scene.walls[i];
  c.nonzero("wall", i, "axis", w.axis);
  if ((w.target_force > 0) == (w.target_pressure > 0))
    c.wrong("wall", i, nullptr, fmt::format("\"{}\" needs either target_force (N) or target_pressure (Pa)", w.name));
  const bool flat = w.kind == "plane" || w.kind == "line" || w.kind == "polygon" || w.kind == "polyline";
  if (w.target_pressure > 0 && w.area == 0 && flat)
    c.wrong("wall", i, nullptr, fmt::format("\"{}\" needs area (m^2): a {} has none of its own", w.name, w.kind));
  if (w.target_force > 0 && w.area > 0) c.wrong("wall", i, "area", "only goes with wall.target_pressure");
}

}  // namespace

void check_wall_rules(const RuleContext& c, std::size_t i) {
  const WallSpec& w = c.scene.walls[i];
  if (w.kind == "plane" || w.kind == "line") c.nonzero("wall", i, "normal", w.normal);
  if (w.kind == "plane" && w.pressure_map && w.map_cell == 0)
    c.wrong("wall", i, "pressure_map", "of a plane needs map_cell (m), the side of its squares");
  if (w.map_cell > 0 && !w.pressure_map) c.wrong("wall", i, "map_cell", "only goes with wall.pressure_map = true");
  if (w.motion == WallMotion::rotation) c.nonzero("wall", i, "axis", w.axis);
  if (w.motion == WallMotion::table) table_motion(c, i);
  if (w.motion == WallMotion::servo) servo_motion(c, i);
  if (w.motion != WallMotion::fixed && !(w.start < w.stop))
    c.wrong("wall", i, "stop", fmt::format("allowed wall.stop > wall.start = {}", w.start));
  if (w.kind == "mesh")
    listed_mesh(c, i);
  else
    generated_mesh(c, i);
}

}  // namespace dem
