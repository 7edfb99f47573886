#include "libdem/analysis/voronoi.h"

#include <fmt/format.h>

#include <cmath>

#include "libdem/analysis/cut_solid.h"
#include "libdem/analysis/grid.h"
#include "libdem/analysis/surface_points.h"
#include "libdem/analysis/wall_planes.h"

namespace dem::analysis {

namespace {

constexpr std::size_t most_drawn = 60000;  // cells: polygons of more make files that no viewer likes

bool along_an_axis(const Vec3d& n) { return max_abs(n) > 1 - 1e-12; }

void scale(Cells& cells, double by) {
  for (double& v : cells.volume) v *= by;
}

// The bodies that results speak of: with a cell, centres in the region.
std::vector<std::size_t> chosen(const Snapshot& s, const Settings& settings, const Cells& cells, Result& r) {
  std::vector<std::size_t> list;
  const Grid region(s, region_of(s, settings), {1, 1, 1});
  std::size_t without = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (settings.region && region.index(s.position[i]) == Grid::none) continue;
    if (cells.volume[i] > 0)
      list.push_back(i);
    else
      ++without;
  }
  if (without > 0) r.notes.push_back(fmt::format("{} bodies have no cell: outside the domain, or covered", without));
  return list;
}

Table distribution(const std::vector<double>& density, int bins) {
  Table t{"distribution",
          "Distribution of the local density",
          {{"local_density", "1", {}}, {"bodies", "1", {}}, {"probability_density", "1", {}}}};
  std::vector<double> count(static_cast<std::size_t>(bins));
  double inside = 0;
  for (const double d : density)
    if (d < 1) ++count[static_cast<std::size_t>(d * bins)], ++inside;
  for (int k = 0; k < bins; ++k) {
    const double n = count[static_cast<std::size_t>(k)];
    t.columns[0].values.push_back((k + 0.5) / bins);
    t.columns[1].values.push_back(n);
    t.columns[2].values.push_back(inside > 0 ? n * bins / inside : 0);
  }
  return t;
}

struct Summary {
  std::vector<double> density;  // of the bodies chosen
  Table table;                  // id and place of each, its cell, its local density
};

Summary add_summary(Result& r, const Snapshot& s, const Cells& cells, const std::vector<std::size_t>& list,
                    const Container& container, int bins) {
  Summary out{{},
              {"cells",
               "Cell of each body",
               {{"id", "1", {}},
                {"x", "m", {}},
                {"y", "m", {}},
                {"z", "m", {}},
                {"cell_volume", "m³", {}},
                {"local_density", "1", {}}}}};
  double sum = 0, all = 0, solid = 0, mean = 0, squares = 0, beyond = 0;
  for (const double v : cells.volume) all += v;
  const auto n = static_cast<double>(list.size());
  for (const std::size_t i : list) {
    const double density = s.volume[i] / cells.volume[i];
    out.density.push_back(density);
    sum += cells.volume[i];
    solid += s.volume[i];
    mean += density / n;
    beyond += density >= 1;
    const double row[] = {
        static_cast<double>(s.id[i]), s.position[i].x, s.position[i].y, s.position[i].z, cells.volume[i], density};
    for (std::size_t k = 0; k < out.table.columns.size(); ++k) out.table.columns[k].values.push_back(row[k]);
  }
  for (const double d : out.density) squares += (d - mean) * (d - mean);
  r.add("bodies", "1", n);
  r.add("mean_cell_volume", "m³", sum / n);
  r.add("solid_fraction", "1", solid / sum);
  r.add("mean_local_density", "1", mean);
  r.add("local_density_deviation", "1", list.size() > 1 ? std::sqrt(squares / (n - 1)) : 0);
  const double domain = container.box.volume * container.per_volume;
  r.add("sum_of_cells_over_domain", "1", all / domain);
  if (beyond > 0) r.notes.push_back(fmt::format("{} bodies are larger than their cells: they overlap others", beyond));
  r.tables.push_back(distribution(out.density, bins));
  return out;
}

void add_surface(Result& r, const Snapshot& s, Cells& cells) {
  if (cells.surface.ends.empty()) return;
  Surface surface = std::move(cells.surface);
  surface.name = "cells";
  Column id{"particle", "1", {}}, volume{"cell_volume", "m³", {}}, density{"local_density", "1", {}};
  for (const double owner : surface.columns[0].values) {
    const auto i = static_cast<std::size_t>(owner);
    id.values.push_back(static_cast<double>(s.id[i]));
    volume.values.push_back(cells.volume[i]);
    density.values.push_back(cells.volume[i] > 0 ? s.volume[i] / cells.volume[i] : 0);
  }
  surface.columns = {std::move(id), std::move(volume), std::move(density)};
  r.surfaces.push_back(std::move(surface));
}

// Whether there is nothing to say, with the note that says why.
bool lacks_cells(const Snapshot& s, const Container& container, Result& r) {
  if (s.count() == 0)
    r.notes.emplace_back("no bodies");
  else if (!has_voronoi())
    r.notes.emplace_back("this program was built without Voro++ (package voro++-dev): no cells");
  else if (!(container.box.volume > 0))
    r.notes.emplace_back("the domain has no volume");
  else
    return false;
  return true;
}

bool wants_surface(std::size_t cells, Result& r) {
  if (cells <= most_drawn) return true;
  r.notes.push_back(fmt::format("no file of the cells' faces: more than {} cells or surface points", most_drawn));
  return false;
}

void tell_mended(const Cells& cells, Result& r) {
  if (cells.mended > 0) r.notes.push_back(fmt::format("{} cells of Voro++ were made anew", cells.mended));
}

// Root mean square of the relative difference of two sets of cells.
double difference(const std::vector<std::size_t>& list, const Cells& a, const Cells& b) {
  double squares = 0;
  for (const std::size_t i : list) squares += std::pow(a.volume[i] / b.volume[i] - 1, 2);
  return std::sqrt(squares / static_cast<double>(list.size()));
}

}  // namespace

Container container_of(const Snapshot& s) {
  const Domain domain = domain_of(s);
  Container c{{domain.lower, domain.upper, s.periodic, {}, 0}, 1};
  if (s.dimension == 2) {
    const double slab = mean_diameter(s);
    c.box.lower.z = -0.5 * slab;
    c.box.upper.z = 0.5 * slab;
    c.per_volume = slab > 0 ? s.thickness / slab : 1;
  }
  for (const SnapshotWall& w : s.walls) {
    if (!w.present) continue;
    for (const shapes::HalfSpace& h : planes_of(w, s))
      if (!along_an_axis(h.normal)) c.box.planes.push_back(h);
  }
  CutSolid solid = CutSolid::box(c.box.lower, c.box.upper);
  for (const shapes::HalfSpace& h : c.box.planes) solid.cut(h.normal, h.offset);
  c.box.volume = solid.volume();
  return c;
}

Cells radical_cells(const Snapshot& s, const Container& container, bool surface) {
  Cells cells = cells_of(container.box, {s.position, s.radius, {}}, s.count(), surface);
  scale(cells, container.per_volume);
  return cells;
}

Cells set_voronoi_cells(const Snapshot& s, const Container& container, std::size_t points, bool surface) {
  const SurfacePoints on(s, points);
  Seeds seeds;
  for (std::size_t i = 0; i < s.count(); ++i)
    for (const Vec3d& x : on.of(i)) {
      seeds.position.push_back(x);
      seeds.owner.push_back(static_cast<std::uint32_t>(i));
    }
  Cells cells = cells_of(container.box, seeds, s.count(), surface);
  scale(cells, container.per_volume);
  return cells;
}

Result report_voronoi(const Snapshot& s, const Settings& settings) {
  Result r;
  const Container container = container_of(s);
  if (lacks_cells(s, container, r)) return r;
  Cells cells = radical_cells(s, container, wants_surface(s.count(), r));
  tell_mended(cells, r);
  const std::vector<std::size_t> list = chosen(s, settings, cells, r);
  if (list.empty()) {
    r.notes.emplace_back("no cells in the region");
    return r;
  }
  Summary summary = add_summary(r, s, cells, list, container, settings.bins);
  Column neighbours{"neighbours", "1", {}};
  double faces = 0;
  for (const std::size_t i : list) {
    neighbours.values.push_back(cells.neighbours[i]);
    faces += cells.neighbours[i];
  }
  r.add("mean_neighbours", "1", faces / static_cast<double>(list.size()));
  summary.table.columns.push_back(std::move(neighbours));
  r.tables.push_back(std::move(summary.table));
  r.notes.emplace_back("radical cells of the spheres (in the plane discs) of equal volume");
  add_surface(r, s, cells);
  return r;
}

Result report_set_voronoi(const Snapshot& s, const Settings& settings) {
  constexpr double total = 3e5;  // points, where nobody says how many
  Result r;
  const Container container = container_of(s);
  if (lacks_cells(s, container, r)) return r;
  const double chosen_points = std::clamp(std::floor(total / static_cast<double>(s.count())), 32.0, 256.0);
  const std::size_t points = settings.voronoi_points > 0
                                 ? static_cast<std::size_t>(std::max(16, settings.voronoi_points))
                                 : static_cast<std::size_t>(chosen_points);
  // Faces are drawn of the finest cells that are not too many.
  const auto few = [&](std::size_t n) { return n * s.count() <= most_drawn; };
  const bool fine_drawn = few(points), middle_drawn = !fine_drawn && few(points / 2);
  const bool coarse_drawn = !fine_drawn && !middle_drawn && wants_surface(points / 4 * s.count(), r);
  Cells coarse = set_voronoi_cells(s, container, points / 4, coarse_drawn);
  Cells middle = set_voronoi_cells(s, container, points / 2, middle_drawn);
  Cells cells = set_voronoi_cells(s, container, points, fine_drawn);
  tell_mended(cells, r);
  if (coarse_drawn) cells.surface = std::move(coarse.surface);
  if (middle_drawn) cells.surface = std::move(middle.surface);
  const Cells radical = radical_cells(s, container);
  std::vector<std::size_t> list;
  for (const std::size_t i : chosen(s, settings, cells, r))
    if (coarse.volume[i] > 0 && middle.volume[i] > 0) list.push_back(i);
  if (list.empty()) {
    r.notes.emplace_back("no cells in the region");
    return r;
  }
  Summary summary = add_summary(r, s, cells, list, container, settings.bins);
  const double before = difference(list, coarse, middle), error = difference(list, middle, cells);
  Table convergence{"convergence",
                    "Cells over the number of surface points: difference to half as many, root mean square",
                    {{"points", "1", {}}, {"relative_difference", "1", {}}}};
  for (const auto& [n, value] : {std::pair(points / 2, before), std::pair(points, error)}) {
    convergence.columns[0].values.push_back(static_cast<double>(n));
    convergence.columns[1].values.push_back(value);
  }
  r.add("surface_points", "1", static_cast<double>(points));
  r.add("relative_error", "1", error);
  if (error > 0 && before > 0) r.add("order_of_convergence", "1", std::log2(before / error));
  Column own{"error", "m³", {}}, by_radical{"radical_volume", "m³", {}};
  double squares = 0, counted = 0;
  for (const std::size_t i : list) {
    own.values.push_back(std::fabs(cells.volume[i] - middle.volume[i]));
    by_radical.values.push_back(radical.volume[i]);
    squares += std::pow(radical.volume[i] / cells.volume[i] - 1, 2);
    ++counted;
  }
  r.add("radical_difference", "1", std::sqrt(squares / counted));
  summary.table.columns.push_back(std::move(own));
  summary.table.columns.push_back(std::move(by_radical));
  r.tables.push_back(std::move(convergence));
  r.tables.push_back(std::move(summary.table));
  r.notes.push_back(
      fmt::format("cells of {} points on each surface; relative_error: against half as many; "
                  "radical_difference: of the radical cells, root mean square",
                  points));
  add_surface(r, s, cells);
  return r;
}

}  // namespace dem::analysis
