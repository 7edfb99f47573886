// Bodies that a scene asks for by number or by table.
#include <algorithm>
#include <cmath>
#include <map>

#include "libdem/build.h"
#include "libdem/io/io.h"
#include "libdem/random.h"

namespace dem {
namespace {

struct Draft {
  std::uint32_t shape, material;
  double scale;
};

// Largest-remainder shares of `count`, then a shuffle that depends on (seed, stream) alone.
std::vector<Draft> drafts(const World& world, const FillSpec& f, std::uint64_t stream) {
  double weights = 0;
  for (const FillItem& i : f.items) weights += i.weight;
  std::vector<std::pair<double, std::size_t>> rest;
  std::vector<std::uint64_t> number(f.items.size());
  std::uint64_t given = 0;
  for (std::size_t i = 0; i < f.items.size(); ++i) {
    const double exact = static_cast<double>(f.count) * (f.items[i].weight / weights);
    number[i] = static_cast<std::uint64_t>(exact);
    given += number[i];
    rest.emplace_back(static_cast<double>(number[i]) - exact, i);
  }
  std::sort(rest.begin(), rest.end());
  for (std::size_t k = 0; given < f.count; ++k, ++given) ++number[rest[k % rest.size()].second];
  std::vector<Draft> list;
  for (std::size_t i = 0; i < f.items.size(); ++i) {
    const FillItem& item = f.items[i];
    const std::uint32_t s = shape_index(world, item.shape, f.where), m = material_index(world, item.material, f.where);
    for (std::uint64_t k = 0; k < number[i]; ++k) {
      Random random(world.scene.run.seed, 2 * stream, list.size());
      list.push_back({s, m, item.scale_min + (item.scale_max - item.scale_min) * random.uniform()});
    }
  }
  for (std::size_t i = list.size(); i > 1; --i) {
    Random random(world.scene.run.seed, 2 * stream + 1, i);
    std::swap(list[i - 1], list[random.bits() % i]);
  }
  return list;
}

}  // namespace

// A cubic lattice of spacing twice the largest bounding radius, filled from below; each body sits at random within the
// free room of its cell and is turned at random.
void add_fill(World& world, const FillSpec& f, std::uint64_t stream) {
  const std::vector<Draft> list = drafts(world, f, stream);
  double radius = 0;
  for (const Draft& d : list) radius = std::max(radius, d.scale * world.shapes[d.shape].circumradius);
  const double cell = 2 * radius;
  const Vec3d extent = f.upper - f.lower;
  std::uint64_t n[3] = {1, 1, 1}, room = 1;
  const bool planar = world.scene.dimension == 2;
  for (int k = 0; k < (planar ? 2 : 3); ++k)
    room *= n[k] = static_cast<std::uint64_t>(std::max(0.0, std::floor(extent[k] / cell)));
  if (room < list.size())
    input_error(f.where, "fill: " + std::to_string(list.size()) + " bodies asked for, room for " +
                             std::to_string(room) + " of the largest bounding sphere (diameter " +
                             std::to_string(cell) + " m); make the box larger or the count smaller");
  const Vec3d pitch{extent.x / static_cast<double>(n[0]), planar ? cell : extent.y / static_cast<double>(n[1]), cell};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Draft& d = list[i];
    Random random(world.scene.run.seed, (std::uint64_t(1) << 32) + stream, i);
    const double r = d.scale * world.shapes[d.shape].circumradius;
    const std::uint64_t cell_of[3] = {i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
    Vec3d x;
    for (int k = 0; k < (planar ? 2 : 3); ++k)
      x[k] = f.lower[k] + pitch[k] * (static_cast<double>(cell_of[k]) + 0.5) +
             (0.5 * pitch[k] - r) * random.uniform(-1, 1);
    add_particle(world, d.shape, d.material, d.scale, x, planar ? random.turn() : random.rotation(), f.velocity, {});
  }
}

void add_csv(World& world, const CsvSpec& spec) {
  const io::Table table = io::read_csv(spec.file);
  std::map<std::string, std::size_t> column;
  for (std::size_t c = 0; c < table.columns.size(); ++c) column[table.columns[c]] = c;
  const auto has = [&](const char* name) { return column.contains(name); };
  const auto value = [&](std::size_t row, const char* name, double otherwise) {
    return has(name) ? io::number(table, row, column[name]) : otherwise;
  };
  static constexpr const char* known[] = {"x",  "y",  "z",  "radius", "scale", "qw", "qx", "qy",    "qz",
                                          "vx", "vy", "vz", "wx",     "wy",    "wz", "id", "shape", "material"};
  for (const std::string& name : table.columns)
    if (std::find(std::begin(known), std::end(known), name) == std::end(known))
      input_error({spec.file, table.header_line, 1}, "column \"" + name + "\" is not known");
  for (const char* name : {"x", "y", "z"})
    if (!has(name)) input_error({spec.file, table.header_line, 1}, std::string("column \"") + name + "\" is missing");
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const Where here{spec.file, table.lines[r], 1};
    const std::uint32_t s = shape_index(world, has("shape") ? table.rows[r][column["shape"]] : spec.shape, here);
    const std::uint32_t m =
        material_index(world, has("material") ? table.rows[r][column["material"]] : spec.material, here);
    double scale = value(r, "scale", 1);
    if (has("radius")) {
      if (!is_round(world.shapes[s].kind)) input_error(here, "column \"radius\" is for spheres and discs");
      scale = io::number(table, r, column["radius"]) / world.shapes[s].size.x;
    }
    if (!(scale > 0)) input_error(here, "size " + std::to_string(scale) + " is not positive");
    const Quatd q{value(r, "qw", 1), value(r, "qx", 0), value(r, "qy", 0), value(r, "qz", 0)};
    const double norm2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!(norm2 > 0.25 && norm2 < 4)) input_error(here, "the quaternion (qw, qx, qy, qz) is not of unit length");
    if (world.scene.dimension == 2)
      for (const char* name : {"z", "qx", "qy", "vz", "wx", "wy"})
        if (value(r, name, 0) != 0) input_error(here, std::string("column \"") + name + "\" must be 0 in a 2-D scene");
    add_particle(world, s, m, scale, {value(r, "x", 0), value(r, "y", 0), value(r, "z", 0)}, q,
                 {value(r, "vx", 0), value(r, "vy", 0), value(r, "vz", 0)},
                 {value(r, "wx", 0), value(r, "wy", 0), value(r, "wz", 0)});
  }
}

}  // namespace dem
