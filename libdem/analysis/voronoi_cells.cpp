#include "libdem/analysis/voronoi_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libdem/analysis/single_cell.h"

#ifdef DEM_HAS_VORO
#include <voro++/voro++.hh>
#endif

namespace dem::analysis {

#ifdef DEM_HAS_VORO

namespace {

struct Polygons {  // of one block of the container
  std::vector<Vec3d> points;
  std::vector<std::int32_t> corners, ends;
  std::vector<double> owner;
};

struct Work {
  const CellBox& box;
  const Seeds& seeds;
  double up;  // a power of two: lengths times it are near 1
  std::array<int, 3> blocks{1, 1, 1};
  std::vector<std::uint8_t> left_out;
  std::vector<double> volume;  // per seed, scaled
  std::vector<std::uint32_t> neighbours;
  std::vector<Polygons> polygons;  // per block; empty: not wanted
  // Per seed those that it has faces with, where `track`: faces that are not too small to be seen from both sides.
  std::vector<std::vector<int>> faces;
  bool track = false;
};

std::uint32_t owner_of(const Seeds& seeds, std::size_t i) {
  return seeds.owner.empty() ? static_cast<std::uint32_t>(i) : seeds.owner[i];
}

void put(voro::container& c, int i, const Vec3d& x, double) { c.put(i, x.x, x.y, x.z); }
void put(voro::container_poly& c, int i, const Vec3d& x, double r) { c.put(i, x.x, x.y, x.z, r); }

void add_polygons(Work& w, std::size_t block, std::size_t seed, voro::voronoicell_neighbor& cell, const Vec3d& x) {
  Polygons& out = w.polygons[block];
  std::vector<int> neighbours, loops;
  std::vector<double> points;
  cell.neighbors(neighbours);
  cell.face_vertices(loops);
  cell.vertices(x.x, x.y, x.z, points);
  const std::uint32_t own = owner_of(w.seeds, seed);
  std::vector<std::int32_t> place(points.size() / 3, -1);
  for (std::size_t f = 0, at = 0; f < neighbours.size(); at += static_cast<std::size_t>(loops[at]) + 1, ++f) {
    if (neighbours[f] >= 0 && static_cast<std::size_t>(neighbours[f]) != seed &&
        owner_of(w.seeds, static_cast<std::size_t>(neighbours[f])) == own)
      continue;
    for (int k = loops[at]; k > 0; --k) {  // backwards: counter-clockwise from outside
      const auto v = static_cast<std::size_t>(loops[at + static_cast<std::size_t>(k)]);
      if (place[v] < 0) {
        place[v] = static_cast<std::int32_t>(out.points.size());
        out.points.push_back(Vec3d{points[3 * v], points[3 * v + 1], points[3 * v + 2]} * (1 / w.up));
      }
      out.corners.push_back(place[v]);
    }
    out.ends.push_back(static_cast<std::int32_t>(out.corners.size()));
    out.owner.push_back(own);
  }
}

std::vector<int> faces_of(voro::voronoicell_neighbor& cell) {
  constexpr double seen = 1e-6;  // area, of about 1
  std::vector<int> all, large;
  std::vector<double> areas;
  cell.neighbors(all);
  cell.face_areas(areas);
  for (std::size_t f = 0; f < all.size(); ++f)
    if (all[f] >= 0 && areas[f] > seen) large.push_back(all[f]);
  return large;
}

// Every thread has a container of its own: computing a cell writes to it.
template <class Container>
void compute(Work& w) {
  const std::array<int, 3>& n = w.blocks;
  const int all = n[0] * n[1] * n[2];
  const Vec3d lower = w.up * w.box.lower, upper = w.up * w.box.upper;
#pragma omp parallel
  {
    Container c(lower.x, upper.x, lower.y, upper.y, lower.z, upper.z, n[0], n[1], n[2], w.box.periodic[0],
                w.box.periodic[1], w.box.periodic[2], 8);
    std::vector<voro::wall_plane> walls;
    walls.reserve(w.box.planes.size());
    for (const auto& h : w.box.planes) {
      walls.emplace_back(h.normal.x, h.normal.y, h.normal.z, w.up * h.offset);
      c.add_wall(walls.back());
    }
    for (std::size_t i = 0; i < w.seeds.position.size(); ++i)
      if (w.left_out[i] == 0)
        put(c, static_cast<int>(i), w.up * w.seeds.position[i], w.seeds.radius.empty() ? 0 : w.up * w.seeds.radius[i]);
    voro::voronoicell_neighbor tracked;
    voro::voronoicell plain;
#pragma omp for schedule(dynamic, 8)
    for (int block = 0; block < all; ++block)
      for (int q = 0; q < c.co[block]; ++q) {
        const auto seed = static_cast<std::size_t>(c.id[block][q]);
        if (w.track) {
          if (c.compute_cell(tracked, block, q)) w.faces[seed] = faces_of(tracked);
          continue;
        }
        if (w.polygons.empty() && !w.seeds.owner.empty()) {
          if (c.compute_cell(plain, block, q)) w.volume[seed] = plain.volume();
          continue;
        }
        if (!c.compute_cell(tracked, block, q)) continue;
        w.volume[seed] = tracked.volume();
        std::vector<int> neighbours;
        tracked.neighbors(neighbours);
        w.neighbours[seed] = static_cast<std::uint32_t>(
            std::count_if(neighbours.begin(), neighbours.end(), [](int k) { return k >= 0; }));
        const double* x = c.p[block] + c.ps * q;
        if (!w.polygons.empty()) add_polygons(w, static_cast<std::size_t>(block), seed, tracked, {x[0], x[1], x[2]});
      }
  }
}

// Seeds beyond the box, and those at the place of one before.
void leave_out(const CellBox& box, const Seeds& seeds, Work& w, Cells& cells) {
  const std::size_t n = seeds.position.size();
  w.left_out.assign(n, 0);
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Vec3d& x = seeds.position[i];
    return std::tuple(x.x, x.y, x.z, i);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t k = 1; k < n; ++k)
    if (seeds.position[order[k]] == seeds.position[order[k - 1]]) w.left_out[order[k]] = 1, ++cells.doubled;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = seeds.position[i][static_cast<int>(k)];
      const int axis = static_cast<int>(k);
      if (w.left_out[i] != 0 || box.periodic[k] || (x >= box.lower[axis] && x <= box.upper[axis])) continue;
      w.left_out[i] = 1;
      ++cells.outside;
    }
}

template <class Container>
std::size_t mend(Work& w) {
  w.track = true;
  w.faces.resize(w.seeds.position.size());
  compute<Container>(w);
  const auto knows = [&](std::size_t a, int b) {
    return std::find(w.faces[a].begin(), w.faces[a].end(), b) != w.faces[a].end();
  };
  std::vector<std::size_t> doubtful;
  for (std::size_t i = 0; i < w.faces.size(); ++i)
    for (const int j : w.faces[i])
      if (!knows(static_cast<std::size_t>(j), static_cast<int>(i))) {
        doubtful.push_back(i);
        doubtful.push_back(static_cast<std::size_t>(j));
      }
  std::sort(doubtful.begin(), doubtful.end());
  doubtful.erase(std::unique(doubtful.begin(), doubtful.end()), doubtful.end());
  constexpr std::size_t most = 1000;  // each costs a look at all seeds
  if (doubtful.size() > most) doubtful.resize(most);
  for (const std::size_t i : doubtful)
    w.volume[i] = single_cell_volume(w.box, w.seeds, w.left_out, i) * (w.up * w.up * w.up);
  return doubtful.size();
}

void join(Work& w, Surface& s) {
  Column owner{"owner", "1", {}};
  for (Polygons& p : w.polygons) {
    const auto points = static_cast<std::int32_t>(s.points.size()),
               corners = static_cast<std::int32_t>(s.corners.size());
    s.points.insert(s.points.end(), p.points.begin(), p.points.end());
    for (const std::int32_t c : p.corners) s.corners.push_back(points + c);
    for (const std::int32_t e : p.ends) s.ends.push_back(corners + e);
    owner.values.insert(owner.values.end(), p.owner.begin(), p.owner.end());
    p = {};
  }
  s.columns.push_back(std::move(owner));
}

}  // namespace

bool has_voronoi() { return true; }

Cells cells_of(const CellBox& box, const Seeds& seeds, std::size_t owners, bool surface) {
  constexpr double seeds_per_block = 5.6;  // as Voro++ proposes
  constexpr double unseen = 1e-12;         // of the box
  Cells cells;
  cells.volume.assign(owners, 0.0);
  cells.neighbours.assign(owners, 0);
  const std::size_t n = seeds.position.size();
  if (n == 0) return cells;
  const Vec3d size = box.upper - box.lower;
  const double spacing = std::cbrt(size.x * size.y * size.z / static_cast<double>(n));
  Work w{box, seeds, std::ldexp(1.0, -std::ilogb(spacing)), {}, {}, {}, {}, {}, {}, false};
  for (std::size_t k = 0; k < 3; ++k)
    w.blocks[k] =
        static_cast<int>(std::clamp(size[static_cast<int>(k)] / (spacing * std::cbrt(seeds_per_block)), 1.0, 512.0));
  leave_out(box, seeds, w, cells);
  w.volume.assign(n, 0.0);
  w.neighbours.assign(n, 0);
  if (surface)
    w.polygons.resize(static_cast<std::size_t>(w.blocks[0]) * static_cast<std::size_t>(w.blocks[1]) *
                      static_cast<std::size_t>(w.blocks[2]));
  const bool plain = seeds.radius.empty();
  plain ? compute<voro::container>(w) : compute<voro::container_poly>(w);
  const double whole = box.volume * (w.up * w.up * w.up);
  if (std::fabs(std::accumulate(w.volume.begin(), w.volume.end(), 0.0) / whole - 1) > unseen)
    cells.mended = plain ? mend<voro::container>(w) : mend<voro::container_poly>(w);
  for (std::size_t i = 0; i < n; ++i) {
    cells.volume[owner_of(seeds, i)] += w.volume[i] / (w.up * w.up * w.up);
    if (seeds.owner.empty()) cells.neighbours[i] = w.neighbours[i];
  }
  if (surface) join(w, cells.surface);
  return cells;
}

#else

bool has_voronoi() { return false; }
Cells cells_of(const CellBox&, const Seeds&, std::size_t, bool) {
  throw RunError("Voronoi cells: this program was built without Voro++ (package voro++-dev)");
}

#endif

}  // namespace dem::analysis
