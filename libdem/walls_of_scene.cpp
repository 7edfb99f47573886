// Walls of a scene: from their specification to geometry, pose and motion.
#include <cmath>

#include "libdem/build.h"
#include "libdem/io/io.h"
#include "shapes/mesh_build.h"
#include "shapes/mesh_generate.h"
#include "shapes/polygon_band.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace dem {
namespace {

bool has(const std::vector<std::string>& words, const char* word) {
  for (const std::string& w : words)
    if (w == word) return true;
  return false;
}

shapes::Mesh mesh_of(const WallSpec& s) {
  const bool base = !has(s.open, "base"), top = !has(s.open, "top");
  if (s.kind == "panel") return shapes::make_panel(s.corner, s.side_1, s.side_2);
  if (s.kind == "box") {
    shapes::BoxFaces faces;
    const char* const low[] = {"-x", "-y", "-z"};
    const char* const high[] = {"+x", "+y", "+z"};
    for (int k = 0; k < 3; ++k) {
      faces.low[k] = !has(s.open, low[k]);
      faces.high[k] = !has(s.open, high[k]);
    }
    return shapes::make_box_shell(s.lower, s.upper, faces);
  }
  if (s.kind == "cylinder") return shapes::make_frustum(s.base, s.top, s.radius, s.radius, s.segments, base, top);
  if (s.kind == "cone") return shapes::make_frustum(s.base, s.top, s.base_radius, s.top_radius, s.segments, base, top);
  if (s.kind == "drum") return shapes::make_frustum(s.base, s.top, s.radius, s.radius, s.segments, true, true);
  if (s.kind == "die") return shapes::make_die(s.lower, s.upper, s.flange, !has(s.open, "-z"));
  if (s.kind == "v_shell")
    return shapes::make_v_shell(s.base, s.angle, s.radius, s.length, s.segments, !has(s.open, "ends"));
  if (!s.file.empty()) return shapes::mesh_from_file(s.file, s.scale);
  std::vector<std::uint32_t> triangles;
  for (const auto& t : s.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  return shapes::mesh_from_triangles(s.vertices, triangles);
}

// The rows of a motion's CSV file as displacements and turns.
void read_motion(WallSpec& m) {
  const io::Table table = io::read_csv(m.table_file);
  const std::size_t time = io::column(table, "time");
  const std::optional<std::size_t> way[] = {io::find_column(table, "x"), io::find_column(table, "y"),
                                            io::find_column(table, "z")};
  const auto angle = io::find_column(table, "angle");
  if (!way[0] && !way[1] && !way[2] && !angle)
    input_error({m.table_file, table.header_line, 1}, "no motion: give at least one of the columns x, y, z, angle");
  if (table.row_count() == 0) input_error({m.table_file, table.header_line, 1}, "the table of the motion has no rows");
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    const double t = io::number(table, r, time);
    if (r > 0 && !(t > io::number(table, r - 1, time)))
      input_error(table.where(r, time), "time = " + table.cell(r, time) + " does not follow " +
                                            table.cell(r - 1, time) + ": allowed are rising times");
    const auto value = [&](const std::optional<std::size_t>& c) { return c ? io::number(table, r, *c) : 0.0; };
    if (way[0] || way[1] || way[2]) m.displacements.push_back({t, value(way[0]), value(way[1]), value(way[2])});
    if (angle) m.turns.push_back({t, value(angle)});
  }
  if (angle && m.axis == Vec3d{}) input_error(m.where, "wall \"" + m.name + "\" turns: it needs axis and centre (m)");
}

void prepare_servo(Wall& w) {
  const WallSpec& m = w.motion;
  w.push = shapes::normalized(m.axis * (1 / shapes::max_abs(m.axis)));
  double area = m.area;
  if (area == 0 && w.mesh) area = shapes::projected_area(*w.mesh, w.push);
  w.target = m.target_force > 0 ? m.target_force : m.target_pressure * area;
  if (!(w.target > 0))
    input_error(m.where,
                "wall \"" + m.name + "\" has no area along wall.axis: give wall.area (m^2) or target_force (N)");
}

// A polygon of the plane, or the band along a chain, from its vertices in world coordinates; its centroid becomes the
// wall's origin.
void make_polygon(const WallSpec& s, Wall& w) {
  const auto polygon = [&](const std::vector<Vec3d>& vertices) {
    return s.kind == "polyline" ? shapes::band_along(vertices, s.depth, s.closed)
                                : shapes::polygon_from_outline(vertices);
  };
  w.kind = shapes::Kind::polygon;
  w.reference = polygon(s.vertices).centroid;
  std::vector<Vec3d> vertices = s.vertices;
  for (Vec3d& v : vertices) v -= w.reference;
  w.polygon = std::make_shared<const shapes::Polygon>(polygon(vertices));
  w.extent = w.polygon->circumradius;
  std::vector<Vec3d> corners;
  std::vector<std::uint32_t> fans;
  for (const shapes::Polygon::Part& part : w.polygon->parts) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), part.vertices.begin(), part.vertices.end());
    for (std::uint32_t k = first + 2; k < corners.size(); ++k) fans.insert(fans.end(), {first, k - 1, k});
  }
  w.mesh = std::make_shared<const shapes::Mesh>(shapes::mesh_from_triangles(corners, fans));
}

}  // namespace

Wall make_wall(const WallSpec& s, std::uint32_t material) {
  Wall w;
  w.name = s.name;
  w.material = material;
  w.motion = s;
  if (s.kind == "line") {
    w.kind = shapes::Kind::line;
    w.reference = s.point;
    // The shortest turn about z of +y onto the normal (-sin, cos): half-angle formulas without trigonometry.
    const Vec3d n = shapes::normalized(s.normal * (1 / shapes::max_abs(s.normal)));
    w.reference_orientation =
        n.y > -0.5 ? shapes::normalized(Quatd{1 + n.y, 0, 0, -n.x}) : shapes::normalized(Quatd{-n.x, 0, 0, 1 - n.y});
  } else if (s.kind == "plane") {
    w.kind = shapes::Kind::plane;
    w.reference = s.point;
    // Orientation: the shortest turn of +z onto the normal.
    const Vec3d n = shapes::normalized(s.normal * (1 / shapes::max_abs(s.normal)));
    w.reference_orientation =
        n.z > -0.5 ? shapes::normalized(Quatd{1 + n.z, -n.y, n.x, 0}) : shapes::normalized(Quatd{n.y, 1 - n.z, 0, n.x});
    if (n.z <= -0.5 && n.x == 0 && n.y == 0) w.reference_orientation = {0, 1, 0, 0};
  } else if (s.kind == "polygon" || s.kind == "polyline") {
    try {
      make_polygon(s, w);
    } catch (const shapes::Error& error) {
      input_error(s.where, "wall \"" + s.name + "\": " + error.what());
    }
  } else {
    w.kind = shapes::Kind::mesh;
    try {
      w.mesh = std::make_shared<const shapes::Mesh>(mesh_of(s));
    } catch (const shapes::Error& error) {
      input_error(s.where, "wall \"" + s.name + "\": " + error.what());
    }
    if (s.pressure_map) w.load.map.resize(w.mesh->triangles.size() / 3);
    for (const Vec3d& v : w.mesh->vertices) w.extent = std::max(w.extent, shapes::norm(v));
  }
  w.present = s.present;
  w.position = w.list_position = w.reference;
  w.orientation = w.list_orientation = w.reference_orientation;
  if (s.motion == WallMotion::table && !s.table_file.empty()) read_motion(w.motion);
  if (s.motion == WallMotion::servo) prepare_servo(w);
  return w;
}

}  // namespace dem
