#include "libdem/broad_phase/candidates.h"

#include <algorithm>
#include <chrono>
#include <tuple>

#include "libdem/broad_phase/levels.h"
#include "libdem/broad_phase/part_candidates.h"
#include "libdem/broad_phase/wall_candidates.h"
#include "libdem/detection.h"
#include "libdem/law_map.h"

namespace dem {
namespace {

using Rows = std::vector<std::vector<Candidate>>;

// Per shape: its pairs may touch in several regions and have as many records. Empty when there is no such shape.
std::vector<char> shapes_with_regions(const World& world) {
  std::vector<char> marks;
  bool any = false;
  for (const ShapeEntry& s : world.shapes) {
    marks.push_back(s.meets_in_regions() ? 1 : 0);
    any = any || s.meets_in_regions();
  }
  return any ? marks : std::vector<char>{};
}

// The row of a particle: its partners of higher id, in order of id. Rows stand in the order of storage, so that what is
// near in space is near in memory; each thread takes whole blocks of rows.
void particle_pairs(World& world, int threads, Rows& rows) {
  const Particles& p = world.particles;
  const std::size_t n = p.count();
  const Levels levels(p.motion, world.skin, world.cell);
  world.contacts.largest_sum = 2 * levels.largest();
  const std::vector<char> regions = shapes_with_regions(world);
  const auto in_regions = [&](std::size_t i) { return !regions.empty() && regions[p.shape[i]] != 0; };
  const std::size_t block = 256, blocks = (n + block - 1) / block;
  rows.resize(blocks);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t r = 0; r < blocks; ++r) {
    std::vector<std::uint32_t> partners;
    NearWalls walls(world);
    walls.look(r * block, std::min(n, (r + 1) * block));
    for (std::size_t i = r * block; i < std::min(n, (r + 1) * block); ++i) {
      partners.clear();
      const Motion& m = p.motion[i];
      levels.near(i, [&](std::uint32_t j) {
        if (p.id[j] <= p.id[i]) return;
        const Vec3d d = world.cell.lattice.nearest(p.motion[j].position - m.position);
        const double reach = m.bounding_radius + p.motion[j].bounding_radius + world.skin;
        if (dot(d, d) < reach * reach) partners.push_back(j);
      });
      std::sort(partners.begin(), partners.end(), [&](std::uint32_t x, std::uint32_t y) { return p.id[x] < p.id[y]; });
      for (const std::uint32_t j : partners) {
        const auto a = static_cast<std::uint32_t>(i);
        if (p.kind[i] == shapes::Kind::compound || p.kind[j] == shapes::Kind::compound) {
          part_pairs(world, a, j, rows[r]);
          continue;
        }
        const bool swap = p.kind[j] < p.kind[i];
        add_records({{p.id[i], p.id[j]}, swap ? j : a, swap ? a : j}, in_regions(i) || in_regions(j), rows[r]);
      }
      walls.add(i, in_regions(i), rows[r]);
    }
  }
}

void index_by_particle(World& world) {
  Contacts& c = world.contacts;
  c.incidence_start.assign(world.particles.count() + 1, 0);
  c.wall_records.clear();
  for (std::size_t k = 0; k < c.count(); ++k) {
    ++c.incidence_start[c.index_a[k] + 1];
    if (c.key[k].b >= wall_base)
      c.wall_records.push_back(static_cast<std::uint32_t>(k));
    else
      ++c.incidence_start[c.index_b[k] + 1];
  }
  for (std::size_t i = 0; i < world.particles.count(); ++i) c.incidence_start[i + 1] += c.incidence_start[i];
  c.incidence.resize(c.incidence_start.back());
  std::vector<std::uint32_t> next(c.incidence_start.begin(), c.incidence_start.end() - 1);
  for (std::size_t k = 0; k < c.count(); ++k) {
    const auto record = static_cast<std::uint32_t>(2 * k);
    c.incidence[next[c.index_a[k]]++] = record;
    if (c.key[k].b < wall_base) c.incidence[next[c.index_b[k]]++] = record + 1;
  }
  // Sums run in order of the partner's id, walls last.
  const auto partner = [&](std::size_t i, std::uint32_t e) {
    const Key& key = c.key[e >> 1];
    return std::tuple(key.a == world.particles.id[i] ? key.b : key.a, key.part, key.part_a);
  };
  for (std::size_t i = 0; i < world.particles.count(); ++i)
    std::sort(c.incidence.begin() + c.incidence_start[i], c.incidence.begin() + c.incidence_start[i + 1],
              [&](std::uint32_t x, std::uint32_t y) { return partner(i, x) < partner(i, y); });
  c.active.resize(c.incidence.size());
  c.active_count.assign(world.particles.count(), 0);
  for (std::size_t i = 0; i < world.particles.count(); ++i)
    for (std::uint32_t e = c.incidence_start[i]; e < c.incidence_start[i + 1]; ++e)
      if (c.touching[c.incidence[e] >> 1] != 0) c.active[c.incidence_start[i] + c.active_count[i]++] = c.incidence[e];
  std::sort(c.wall_records.begin(), c.wall_records.end(),
            [&](std::uint32_t x, std::uint32_t y) { return c.key[x] < c.key[y]; });
}

template <class T>
void permute(std::vector<T>& v, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted;
  sorted.reserve(v.size());
  for (const std::uint32_t i : order) sorted.push_back(v[i]);
  v = std::move(sorted);
}

// Stores particles cell by cell: what is near in space comes near in memory. Nothing else depends on the order.
void sort_in_space(World& world) {
  Particles& p = world.particles;
  const std::vector<std::uint32_t> order = order_in_space(p.motion, world.skin, world.cell);
  Particles::each_array(p, [&](auto& array) { permute(array, order); });
}

constexpr std::uint64_t sort_every = 16;  // rebuilds

void fill_bins(World& world) {
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
  c.bins.clear();
  std::array<int, 4 * shapes::kind_count * shapes::kind_count> bin_of;
  bin_of.fill(-1);
  const std::vector<char> in_regions = shapes_with_regions(world);
  bool all_spheres = true;
  for (std::size_t k = 0; k < c.count(); ++k) {
    const bool wall = c.key[k].b >= wall_base;
    const shapes::Kind a = p.kind[c.index_a[k]];
    const shapes::Kind b = wall ? world.walls[c.index_b[k]].kind : p.kind[c.index_b[k]];
    if (a == shapes::Kind::compound || b == shapes::Kind::compound) continue;
    const auto of_shape = [&](std::uint32_t i) { return !in_regions.empty() && in_regions[p.shape[i]] != 0; };
    const bool regions =
        of_shape(c.index_a[k]) || (wall ? world.walls[c.index_b[k]].meets_in_regions() : of_shape(c.index_b[k]));
    const std::size_t set = (wall ? 2 : 0) + (regions ? 1 : 0);
    int& bin = bin_of[(set * shapes::kind_count + static_cast<std::size_t>(a)) * shapes::kind_count +
                      static_cast<std::size_t>(b)];
    if (bin < 0) {
      bin = static_cast<int>(c.bins.size());
      const bool closed = detection::closed_form(a, b, world.scene);
      all_spheres = all_spheres && closed;
      Bin fresh;
      fresh.a = a;
      fresh.b = b;
      fresh.query = closed ? nullptr : detection::find(a, b, world.scene);
      fresh.wall = wall;
      fresh.regions = regions;
      fresh.exact = closed || detection::agrees_with_proofs(a, b, world.scene);
      c.bins.push_back(std::move(fresh));
    }
    const std::uint32_t material_b = wall ? world.walls[c.index_b[k]].material : p.material[c.index_b[k]];
    Bin& list = c.bins[static_cast<std::size_t>(bin)];
    list.records.push_back(static_cast<std::uint32_t>(k));
    list.a_index.push_back(c.index_a[k]);
    list.b_index.push_back(c.index_b[k]);
    list.pair.push_back(p.material[c.index_a[k]] * static_cast<std::uint32_t>(world.materials.size()) + material_b);
  }
  for (Bin& list : c.bins)
    for (auto* v : {&list.a_index, &list.b_index, &list.pair}) v->resize(v->size() + 3, v->back());
  const bool compounds = has_compounds(world);
  if (compounds) fill_groups(world);
  c.centre.resize(all_spheres && !compounds ? 0 : c.count());
}

// Room for what the laws remember; the fused kernels need none.
void prepare_memory(World& world) {
  Contacts& c = world.contacts;
  c.words = record_words(world);
  c.memory.assign(c.history.size() * c.words, 0);
  if (world.scene.law.ledger) c.ledger.assign(c.history.size(), {});
}

bool moved(const World& world, double half) {
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    const Vec3d d = world.particles.motion[i].position - world.contacts.reference[i];
    if (dot(d, d) >= half * half) return true;
  }
  return false;
}

// A wrapped body has not moved by the length of the box, and bodies that follow the cell keep their neighbours: u is by
// how much a body has left that motion. An offset d at the last rebuild is now F d + u_b − u_a, with F the stretch of
// the cell, so no shorter than s |d| − |u_a| − |u_b|, s = the least stretch. A pair that was left out, |d| at least the
// sum of its radii + skin, is still apart while
//   2 |u| < s · skin − (1 − s) · sum of radii
bool moved_in_cell(const World& world, double half) {
  const Cell& cell = world.cell;
  const Contacts& c = world.contacts;
  const double least = std::min({1.0, cell.stretch.x, cell.stretch.y, cell.stretch.z});
  if (least < 1) half = 0.5 * (least * world.skin - (1 - least) * c.largest_sum);
  if (!(half > 0)) return true;
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    const Vec3d followed =
        cell.deforms ? cell.centre + scaled(c.reference[i] - cell.centre, cell.stretch) : c.reference[i];
    const Vec3d d = cell.lattice.nearest(world.particles.motion[i].position - followed);
    if (dot(d, d) >= half * half) return true;
  }
  return false;
}

}  // namespace

bool candidates_outdated(const World& world) {
  const Contacts& c = world.contacts;
  if (c.stale || world.scene.run.rebuild_every == 1) return true;
  if (world.scene.run.rebuild_every > 0 && world.step % world.scene.run.rebuild_every == 0) return true;
  const double half = 0.5 * world.skin;
  if (world.cell.periodic ? moved_in_cell(world, half) : moved(world, half)) return true;
  if (!c.reference_orientation.empty() && parts_moved(world, half)) return true;
  for (const Wall& w : world.walls) {
    const Quatd turn = w.orientation * shapes::conjugate(w.list_orientation);
    const double half_angle_sine = shapes::norm(Vec3d{turn.x, turn.y, turn.z});
    const double moved = shapes::norm(w.position - w.list_position) + 2 * half_angle_sine * w.extent;
    if (moved >= half || (is_half_space(w.kind) && half_angle_sine > 0)) return true;
  }
  return false;
}

void rebuild_candidates(World& world, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
  if (world.counters.rebuilds % sort_every == 0) sort_in_space(world);
  Rows rows;
  particle_pairs(world, threads, rows);
  const double largest_sum = c.largest_sum;
  const Contacts old = std::move(c);
  c = {};
  c.largest_sum = largest_sum;
  std::size_t total = 0;
  for (const auto& r : rows) total += r.size();
  // Where the rows of the old list begin, by the id of their particle.
  std::vector<std::uint32_t> old_row(world.next_id, static_cast<std::uint32_t>(old.count()));
  for (std::size_t o = old.count(); o-- > 0;) old_row[old.key[o].a] = static_cast<std::uint32_t>(o);

  c.key.reserve(total);
  c.index_a.reserve(total);
  c.index_b.reserve(total);
  c.history.resize(total);
  c.touching.resize(total);
  c.slot.resize(total);
  prepare_memory(world);
  std::vector<contact::Cache> cache(total);
  std::vector<Vec3d> centre(old.centre.empty() ? 0 : total);  // regions are known again by theirs
  std::vector<std::uint8_t> carried(old.ledger.size());
  std::vector<double> share(old.share.empty() ? 0 : total, 1.0);  // of those that hold on across a gap
  std::size_t k = 0, o = 0;
  for (const auto& block : rows)
    for (const Candidate& record : block) {
      if (k == 0 || record.key.a != c.key.back().a) o = old_row[record.key.a];
      c.key.push_back(record.key);
      c.index_a.push_back(record.a);
      c.index_b.push_back(record.b);
      while (o < old.count() && old.key[o].a == record.key.a && old.key[o] < record.key) ++o;
      if (o < old.count() && old.key[o] == record.key) {
        c.history[k] = old.history[o];
        c.touching[k] = old.touching[o];
        std::copy_n(old.memory.begin() + static_cast<std::ptrdiff_t>(o * old.words), old.words,
                    c.memory.begin() + static_cast<std::ptrdiff_t>(k * c.words));
        if (!old.ledger.empty()) {
          c.ledger[k] = old.ledger[o];
          carried[o] = 1;
        }
        if (!old.share.empty()) share[k] = old.share[o];
        if (!old.cache.empty()) cache[k] = old.cache[o];
        if (!old.centre.empty()) centre[k] = old.centre[o];
      }
      ++k;
    }
  for (o = 0; o < carried.size(); ++o) {
    if (old.touching[o] == 0 || carried[o] != 0) continue;
    contact::Ledger ledger = old.ledger[o];
    contact::close(world.law.loss, world.time_step.dt, ledger);
    c.gone.push_back({old.key[o], ledger.lost});
  }
  fill_bins(world);
  if (!c.share.empty() && !share.empty()) c.share = std::move(share);
  if (!c.centre.empty()) {
    c.cache = std::move(cache);
    if (!centre.empty()) c.centre = std::move(centre);
  }
  index_by_particle(world);
  c.reference.resize(p.count());
  for (std::size_t i = 0; i < p.count(); ++i) c.reference[i] = p.motion[i].position;
  if (has_compounds(world)) c.reference_orientation = p.orientation;
  if (!c.centre.empty() && !world.cell.deforms) {
    c.travel.resize(p.count());
    c.apart_until.resize(total);
  }
  for (Wall& wall : world.walls) {
    wall.list_position = wall.seen_position = wall.position;
    wall.list_orientation = wall.seen_orientation = wall.orientation;
    wall.travel = 0;
  }
  world.cell.stretch = {1, 1, 1};
  c.stale = false;
  ++world.counters.rebuilds;
  world.counters.candidates = total;
  world.times.broad += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dem
