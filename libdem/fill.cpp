// Bodies that a scene asks for by amount or by table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "libdem/build.h"
#include "libdem/insertion/place.h"
#include "libdem/io/io.h"

namespace dem {
namespace {

std::vector<Draft> drafts(const World& world, const FillSpec& f, const Region& region, const Recipe& recipe,
                          std::uint64_t stream) {
  if (f.count > 0) {
    if (const double room = recipe.least_room(f.count); room > region.size())
      input_error(f.where, fmt::format("fill: the bounding spheres of {} bodies alone are {:.3g} times as large as the "
                                       "region; make it larger or the count smaller",
                                       f.count, room / region.size()));
    return recipe.list(f.count, stream);
  }
  if (f.solid_fraction > 0 || f.mass > 0) {
    const bool mass = f.mass > 0;
    auto list = list_of_amount(recipe, mass ? Amount::mass : Amount::solid,
                               mass ? f.mass : f.solid_fraction * region.size(), region.size(), stream);
    if (!list)
      input_error(f.where,
                  fmt::format("fill: {} = {} needs more bodies than the region holds, or more than {}",
                              mass ? "mass" : "solid_fraction", mass ? f.mass : f.solid_fraction, most_bodies));
    return *std::move(list);
  }
  const std::uint64_t sites = site_count(world, f, region, recipe.largest_radius());
  if (sites == 0) input_error(f.where, "fill: the lattice has no free site in the region");
  return recipe.list(sites, stream);
}

}  // namespace

void add_fill(World& world, const FillSpec& f, std::uint64_t stream) {
  RegionSpec box;
  box.lower = f.lower;
  box.upper = f.upper;
  const Region region = f.region.empty() ? Region(box, dimension_of(world)) : region_of(world, f.region);
  const Recipe recipe(world, f.items, f.where);
  const std::vector<Draft> list = drafts(world, f, region, recipe, stream);
  const std::vector<Place> found = places(world, f, region, recipe, list, stream);
  for (std::size_t i = 0; i < list.size(); ++i) {
    add_particle(world, list[i].shape, list[i].material, list[i].scale, found[i].position, found[i].orientation,
                 f.velocity, {});
    world.particles.species.back() = list[i].species;
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
  static constexpr const char* known[] = {"x",  "y",  "z",     "radius",   "scale",  "qw", "qx",
                                          "qy", "qz", "vx",    "vy",       "vz",     "wx", "wy",
                                          "wz", "id", "shape", "material", "species"};
  for (const std::string& name : table.columns)
    if (std::find(std::begin(known), std::end(known), name) == std::end(known))
      input_error({spec.file, table.header_line, 1}, "column \"" + name + "\" is not known");
  for (const char* name : {"x", "y", "z"})
    if (!has(name)) input_error({spec.file, table.header_line, 1}, std::string("column \"") + name + "\" is missing");
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    const Where here{spec.file, table.lines[r], 1};
    const std::uint32_t s = shape_index(world, has("shape") ? table.cell(r, column["shape"]) : spec.shape, here);
    const std::uint32_t m =
        material_index(world, has("material") ? table.cell(r, column["material"]) : spec.material, here);
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
    if (has("species")) world.particles.species.back() = species_index(world, table.cell(r, column["species"]), here);
  }
}

}  // namespace dem
