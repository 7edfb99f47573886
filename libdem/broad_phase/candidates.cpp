#include "libdem/broad_phase/candidates.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "libdem/broad_phase/allowance.h"
#include "libdem/broad_phase/levels.h"
#include "libdem/broad_phase/part_candidates.h"
#include "libdem/broad_phase/wall_candidates.h"
#include "libdem/detection.h"
#include "libdem/law_map.h"
#include "libdem/release.h"
#include "libdem/stopwatch.h"
#include "libdem/sweep.h"

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
  const Levels levels(p.motion, world.contacts.allowance, world.cell);
  const std::vector<char> regions = shapes_with_regions(world);
  const auto in_regions = [&](std::size_t i) { return !regions.empty() && regions[p.shape[i]] != 0; };
  const std::size_t block = 256, blocks = (n + block - 1) / block;
  rows.resize(blocks);
#pragma omp parallel num_threads(threads)
  {
    struct Partner {
      std::uint64_t id;
      std::uint32_t index;
    };
    std::vector<Partner> partners;
    std::vector<Candidate> found;
    NearWalls walls(world);
#pragma omp for schedule(dynamic)
    for (std::size_t r = 0; r < blocks; ++r) {
      const std::size_t first = r * block, last = std::min(n, first + block);
      walls.look(first, last);
      found.clear();
      for (std::size_t i = first; i < last; ++i) {
        partners.clear();
        const std::uint64_t id = p.id[i];
        levels.near(i, [&](std::uint32_t j) {
          if (p.id[j] > id) partners.push_back({p.id[j], j});
        });
        std::sort(partners.begin(), partners.end(), [](const Partner& x, const Partner& y) { return x.id < y.id; });
        for (const Partner& partner : partners) {
          const std::uint32_t a = static_cast<std::uint32_t>(i), j = partner.index;
          if (p.kind[i] == shapes::Kind::compound || p.kind[j] == shapes::Kind::compound) {
            part_pairs(world, a, j, found);
            continue;
          }
          const bool swap = p.kind[j] < p.kind[i];
          add_records({{id, partner.id}, swap ? j : a, swap ? a : j}, in_regions(i) || in_regions(j), found);
        }
        walls.add(i, in_regions(i), found);
      }
      rows[r].assign(found.begin(), found.end());  // no longer than it is
    }
  }
}

void index_by_particle(World& world, int threads) {
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
  struct Partner {
    std::uint64_t id;
    std::uint32_t part, part_a, entry;
    auto operator<=>(const Partner&) const = default;
  };
  c.active.resize(c.incidence.size());
  c.active_count.assign(world.particles.count(), 0);
#pragma omp parallel num_threads(threads)
  {
    std::vector<Partner> partners;
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < world.particles.count(); ++i) {
      partners.clear();
      std::uint32_t* list = c.incidence.data() + c.incidence_start[i];
      const std::size_t count = c.incidence_start[i + 1] - c.incidence_start[i];
      for (std::size_t e = 0; e < count; ++e) {
        const Key& key = c.key[list[e] >> 1];
        partners.push_back({key.a == world.particles.id[i] ? key.b : key.a, key.part, key.part_a, list[e]});
      }
      std::sort(partners.begin(), partners.end());
      for (std::size_t e = 0; e < count; ++e) {
        list[e] = partners[e].entry;
        if (c.counts(list[e] >> 1)) c.active[c.incidence_start[i] + c.active_count[i]++] = c.active_entry(list[e]);
      }
    }
  }
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
  const std::vector<std::uint32_t> order = order_in_space(p.motion, world.contacts.allowance, world.cell);
  Particles::each_array(p, [&](auto& array) { permute(array, order); });
}

constexpr std::uint64_t sort_every = 16;  // rebuilds

// There are none yet. Returns whether the kernels of spheres answer all records.
bool fill_bins(World& world) {
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
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
      fresh.smooth = !wall && !regions && detection::is_smooth(a, b, world.scene) && !world.law.lingers &&
                     world.scene.law.map != LawMap::volume;
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
  return all_spheres && !compounds;
}

// The rows as records; rows are freed on the way.
void lay_out(Rows& rows, Contacts& c, int threads) {
  std::vector<std::size_t> start{0};
  for (const auto& r : rows) start.push_back(start.back() + r.size());
  for (auto* v : {&c.index_a, &c.index_b}) {
    release(*v);
    v->resize(start.back());
  }
  c.key.resize(start.back());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t block = 0; block < rows.size(); ++block) {
    std::size_t k = start[block];
    for (const Candidate& record : rows[block]) {
      c.key[k] = record.key;
      c.index_a[k] = record.a;
      c.index_b[k++] = record.b;
    }
    release(rows[block]);
  }
}

// Of each record the one of the same key in the old list, or none. Rows of both lists are sorted.
std::vector<std::uint32_t> origins(const std::vector<Key>& old, const std::vector<Key>& keys, std::uint64_t next_id,
                                   int threads) {
  // Where the rows of the old list begin, by the id of their particle.
  std::vector<std::uint32_t> old_row(next_id, static_cast<std::uint32_t>(old.size()));
  for (std::size_t o = old.size(); o-- > 0;) old_row[old[o].a] = static_cast<std::uint32_t>(o);
  std::vector<std::uint32_t> from(keys.size(), none);
  const std::size_t block = 1024, blocks = (keys.size() + block - 1) / block;
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t part = 0; part < blocks; ++part) {
    const std::size_t first = part * block, last = std::min(keys.size(), first + block);
    std::size_t o = 0;
    for (std::size_t k = first; k < last; ++k) {
      if (k == first || keys[k].a != keys[k - 1].a) o = old_row[keys[k].a];
      while (o < old.size() && old[o].a == keys[k].a && old[o] < keys[k]) ++o;
      if (o < old.size() && old[o] == keys[k]) from[k] = static_cast<std::uint32_t>(o);
    }
  }
  return from;
}

// An array of `width` entries a record for the new records; those that have no origin begin as `fresh`.
template <class T>
void carry(std::vector<T>& v, const std::vector<std::uint32_t>& from, int threads, std::size_t width = 1,
           T fresh = {}) {
  std::vector<T> next(from.size() * width, fresh);
  const std::size_t records = v.empty() || width == 0 ? 0 : from.size();
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t k = 0; k < records; ++k)
    if (from[k] != none) std::copy_n(&v[from[k] * width], width, &next[k * width]);
  v = std::move(next);
}

// What contacts lost that are in the list no more.
void book_unseen(World& world, const std::vector<Key>& old, const std::vector<std::uint32_t>& from) {
  Contacts& c = world.contacts;
  if (c.ledger.empty()) return;
  std::vector<std::uint8_t> carried(old.size());
  for (const std::uint32_t o : from)
    if (o != none) carried[o] = 1;
  for (std::size_t o = 0; o < old.size(); ++o) {
    if (c.touching[o] == 0 || carried[o] != 0) continue;
    contact::close(world.law.loss, world.time_step.dt, c.ledger[o]);
    c.gone.push_back({old[o], c.ledger[o].lost});
  }
}

// Seats for all but the pairs of round bodies, in order of the records, then for those of them that touch; histories
// move there. Round bodies whose contacts resist rolling have two slots as well.
void seat_records(World& world, const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& old_seat,
                  int threads) {
  Contacts& c = world.contacts;
  c.seat.assign(c.count(), 0);
  for (const Bin& bin : c.bins)
    if (bin.round())
      for (const std::uint32_t k : bin.records) c.seat[k] = none;
  std::uint32_t seats = 0;
  for (std::uint32_t& seat : c.seat)
    if (seat != none) seat = seats++;
  c.round_seats = seats;
  c.double_seats = world.law.rolls ? none : seats;
  for (Bin& bin : c.bins) {
    if (!bin.round()) continue;
    for (std::size_t r = 0; r < bin.records.size(); ++r) {
      const std::uint32_t k = bin.records[r];
      if (c.touching[k] == 0) continue;
      c.seat[k] = seats++;
      bin.met.add(k, bin.a_index[r], bin.b_index[r], bin.pair[r], c.seat[k]);
      bin.met.touching.back() |= std::uint32_t(1) << ((bin.met.count - 1) % contact::kernels::chunk_size);
    }
  }
  std::vector<contact::History> old = std::exchange(c.history, {});
  c.history.reserve(seats + seats / 8);
  c.history.resize(seats);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t k = 0; k < c.count(); ++k)
    if (from[k] != none && c.touching[k] != 0) c.history_of(k) = old[old_seat[from[k]]];
  release(old);
  c.slot.reserve(c.first_slot(seats) + seats / 8);
  c.make_seats(seats);
}

// The least that any body has left of its allowance, m.
double least_left(const World& world, int threads) {
  double least = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) num_threads(threads) reduction(min : least)
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    const Vec3d d = world.particles.motion[i].position - world.contacts.reference[i];
    least = std::min(least, world.contacts.allowance[i] - norm(d));
  }
  return least;
}

// Looks only where the ways since it looked last may have taken a body so far.
bool moved(World& world, int threads) {
  Contacts& c = world.contacts;
  c.since_look += c.step_way;
  if (c.since_look < c.look_after) return false;
  const double left = least_left(world, threads);
  c.since_look = 0;
  c.look_after = left * (1 - 0x1p-20);  // what rounds
  return left <= 0;
}

// A wrapped body has not moved by the length of the box, and bodies that follow the cell keep their neighbours: u is by
// how much a body has left that motion. An offset d at the last rebuild is now F d + u_b − u_a, with F the stretch of
// the cell, so no shorter than s |d| − |u_a| − |u_b|, s = the least stretch. A pair that was left out, |d| at least the
// sum of its radii and allowances, is still apart while each body has
//   |u| < s · allowance − (1 − s) · radius
bool moved_in_cell(const World& world) {
  const Cell& cell = world.cell;
  const Contacts& c = world.contacts;
  const double least = std::min({1.0, cell.stretch.x, cell.stretch.y, cell.stretch.z});
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    const Vec3d followed =
        cell.deforms ? cell.centre + scaled(c.reference[i] - cell.centre, cell.stretch) : c.reference[i];
    const Vec3d d = cell.lattice.nearest(world.particles.motion[i].position - followed);
    const double left = least * c.allowance[i] - (1 - least) * world.particles.motion[i].bounding_radius;
    if (!(norm(d) < left)) return true;
  }
  return false;
}

}  // namespace

bool candidates_outdated(World& world, int threads) {
  const Contacts& c = world.contacts;
  if (c.stale || world.scene.run.rebuild_every == 1) return true;
  if (world.scene.run.rebuild_every > 0 && world.step % world.scene.run.rebuild_every == 0) return true;
  if (world.cell.periodic ? moved_in_cell(world) : moved(world, threads)) return true;
  if (!c.reference_orientation.empty() && parts_moved(world)) return true;
  for (const Wall& w : world.walls) {
    const Quatd turn = w.orientation * shapes::conjugate(w.list_orientation);
    const double half_angle_sine = shapes::norm(Vec3d{turn.x, turn.y, turn.z});
    const double moved = shapes::norm(w.position - w.list_position) + 2 * half_angle_sine * w.extent;
    if (moved >= w.allowance || (is_half_space(w.kind) && half_angle_sine > 0)) return true;
  }
  return false;
}

void rebuild_candidates(World& world, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
  c.largest_sum = 0;
  for (const Motion& m : p.motion) c.largest_sum = std::max(c.largest_sum, 2 * m.bounding_radius);
  choose_allowances(world);
  if (world.counters.rebuilds % sort_every == 0) sort_in_space(world);
  for (auto* v : {&c.incidence, &c.active, &c.wall_records}) release(*v);
  c.bins.clear();
  c.groups.clear();
  release(c.slot);
  Rows rows;
  particle_pairs(world, threads, rows);
  const std::vector<Key> old = std::exchange(c.key, {});
  lay_out(rows, c, threads);
  const std::vector<std::uint32_t> from = origins(old, c.key, world.next_id, threads);
  book_unseen(world, old, from);
  const std::size_t total = c.count();
  c.words = record_words(world);
  const std::vector<std::uint32_t> old_seat = std::exchange(c.seat, {});
  carry(c.touching, from, threads);
  carry(c.memory, from, threads, c.words);
  carry(c.ledger, from, threads, world.scene.law.ledger ? 1 : 0);
  std::vector<double> share = std::exchange(c.share, {});  // of those that hold on across a gap
  const bool all_spheres = fill_bins(world);
  seat_records(world, from, old_seat, threads);
  if (!c.share.empty() && !share.empty()) {
    carry(share, from, threads, 1, 1.0);
    c.share = std::move(share);
  }
  carry(c.centre, from, threads, all_spheres ? 0 : 1);  // regions are known again by theirs
  carry(c.cache, from, threads, all_spheres ? 0 : 1);
  index_by_particle(world, threads);
  plan_sweep(world);
  c.reference.resize(p.count());
  for (std::size_t i = 0; i < p.count(); ++i) c.reference[i] = p.motion[i].position;
  c.reference_orientation = has_compounds(world) ? p.orientation : std::vector<Quatd>{};
  c.travel.assign(all_spheres || world.cell.deforms ? 0 : p.count(), 0);
  c.apart_until.assign(all_spheres || world.cell.deforms ? 0 : total, 0);
  c.step_way = c.way = c.since_look = c.look_after = 0;
  c.way_allowed = -1;
  for (Wall& wall : world.walls) {
    wall.list_position = wall.seen_position = wall.position;
    wall.list_orientation = wall.seen_orientation = wall.orientation;
    wall.travel = 0;
  }
  world.cell.stretch = {1, 1, 1};
  c.stale = false;
  ++world.counters.rebuilds;
  world.counters.candidates = total;
  world.times.broad += seconds_since(begin);
}

}  // namespace dem
