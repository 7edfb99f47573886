#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "libdem/analysis/frames.h"
#include "libdem/io/io.h"

namespace dem::analysis {

namespace fs = std::filesystem;

namespace {

class Rows {
 public:
  explicit Rows(const io::Table& table) : t_(table) {}
  std::optional<std::size_t> find(const char* name) const { return io::find_column(t_, name); }
  bool has(std::initializer_list<const char*> names) const {
    for (const char* n : names)
      if (!find(n)) return false;
    return true;
  }
  double value(std::size_t row, const char* name) const { return io::number(t_, row, io::column(t_, name)); }
  Vec3d vector(std::size_t row, const char* x, const char* y, const char* z) const {
    return {value(row, x), value(row, y), value(row, z)};
  }
  Quatd turn(std::size_t row) const {
    const Quatd q{value(row, "qw"), value(row, "qx"), value(row, "qy"), value(row, "qz")};
    if (!(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 0)) wrong(row, "qw", "the quaternion is zero");
    return shapes::normalized(q);
  }
  [[noreturn]] void wrong(std::size_t row, const char* name, const std::string& problem) const {
    input_error(t_.where(row, io::column(t_, name)), problem);
  }
  std::uint64_t id(std::size_t row) const {
    if (!find("id")) return row;
    const double v = value(row, "id");
    if (v < 0 || v >= 0x1p53 || v != std::floor(v)) wrong(row, "id", "allowed whole numbers from 0");
    return static_cast<std::uint64_t>(v);
  }

 private:
  const io::Table& t_;
};

// final.csv beside its scene: the bodies as the scene makes them, at the places of the file.
Snapshot of_a_run(const io::Table& table, const Rows& rows, const fs::path& folder) {
  World world = build_world(load_scene((folder / "scene.toml").string()));
  Snapshot start = snapshot_of(world), s = start;
  s.contacts.clear();
  for (auto* list : {&s.position, &s.velocity, &s.spin, &s.rotation, &s.size}) list->clear();
  for (auto* list : {&s.mass, &s.volume, &s.radius, &s.bounding_radius}) list->clear();
  for (auto* list : {&s.shape, &s.material, &s.species}) list->clear();
  s.id.clear();
  s.orientation.clear();
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    const std::uint64_t id = rows.id(r);
    const auto at = std::lower_bound(start.id.begin(), start.id.end(), id);
    if (at == start.id.end() || *at != id)
      rows.wrong(r, "id",
                 fmt::format("body {} came later than the scene's start, and this file has no sizes; analyse "
                             "the folder of the run",
                             id));
    if (!s.id.empty() && id <= s.id.back()) rows.wrong(r, "id", "ids must rise");
    const auto i = static_cast<std::size_t>(at - start.id.begin());
    s.id.push_back(id);
    s.shape.push_back(start.shape[i]);
    s.material.push_back(start.material[i]);
    s.species.push_back(start.species[i]);
    s.size.push_back(start.size[i]);
    s.mass.push_back(start.mass[i]);
    s.volume.push_back(start.volume[i]);
    s.radius.push_back(start.radius[i]);
    s.bounding_radius.push_back(start.bounding_radius[i]);
    s.position.push_back(rows.vector(r, "x", "y", "z"));
    s.velocity.push_back(rows.vector(r, "vx", "vy", "vz"));
    s.spin.push_back(rows.vector(r, "wx", "wy", "wz"));
    s.rotation.push_back({});
    s.orientation.push_back(rows.turn(r));
  }
  s.step = 0;
  s.time = 0;
  s.elastic.reset();
  s.dissipated.clear();
  s.has_contacts = s.has_forces = s.has_rotation = false;
  s.notes.emplace_back(
      "a table of bodies: time, contacts, motion of walls and of the cell are not known; the record has them");
  return s;
}

}  // namespace

Snapshot read_bodies_csv(const std::string& path, const ForeignOptions& options) {
  const io::Table table = io::read_csv(path);
  const Rows rows(table);
  const fs::path folder = fs::path(path).parent_path();
  const bool radius = rows.find("radius").has_value(), diameter = rows.find("diameter").has_value(),
             axes = rows.has({"a", "b", "c", "qw", "qx", "qy", "qz"});
  if (!radius && !diameter && !axes) {
    if (rows.has({"id", "shape", "qw", "vx", "wx"}) && fs::exists(folder / "scene.toml"))
      return of_a_run(table, rows, folder);
    input_error({path, table.header_line, 1},
                "no sizes of bodies: allowed a column radius or diameter, or a, b, c with qw, qx, qy, qz");
  }
  Snapshot s;
  ForeignBodies bodies;
  s.has_velocity = rows.has({"vx", "vy", "vz"});
  const bool spin = rows.has({"wx", "wy", "wz"}), turn = rows.has({"qw", "qx", "qy", "qz"});
  const char* group = rows.find("species") ? "species" : rows.find("type") ? "type" : "material";
  const std::optional<std::size_t> kind = rows.find(group);
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    ForeignBody b;
    b.id = rows.id(r);
    b.position = rows.vector(r, "x", "y", "z");
    if (s.has_velocity) b.velocity = rows.vector(r, "vx", "vy", "vz");
    if (spin) b.spin = rows.vector(r, "wx", "wy", "wz");
    if (turn) b.orientation = rows.turn(r);
    if (rows.find("mass")) b.mass = rows.value(r, "mass");
    b.species = kind ? table.cell(r, *kind) : "bodies";
    if (axes) {
      b.semi_axes = rows.vector(r, "a", "b", "c");
    } else {
      const double size = radius ? rows.value(r, "radius") : 0.5 * rows.value(r, "diameter");
      b.semi_axes = {size, size, size};
    }
    for (int k = 0; k < 3; ++k)
      if (!(b.semi_axes[k] > 0)) rows.wrong(r, axes ? "a" : radius ? "radius" : "diameter", "allowed: sizes > 0");
    bodies.add(std::move(b));
  }
  if (!s.has_velocity) s.notes.emplace_back("no velocities in the source (vx, vy, vz)");
  if (!spin) s.notes.emplace_back("no spins in the source (wx, wy, wz): taken as zero");
  if (!rows.find("id")) s.notes.emplace_back("no ids in the source: bodies are numbered as they stand");
  bodies.finish(path, options, s);
  return s;
}

}  // namespace dem::analysis
