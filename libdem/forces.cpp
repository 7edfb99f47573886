#include "libdem/forces.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "libcontact/methods/polygon_regions.h"
#include "libdem/build.h"
#include "libdem/coherence.h"
#include "libdem/contact_checks.h"
#include "libdem/force_pass.h"
#include "libdem/forces_compound.h"
#include "libdem/forces_smooth.h"
#include "libdem/meetings.h"
#include "libdem/regions.h"
#include "libdem/sleep.h"
#include "libdem/walls.h"

namespace dem {
namespace {

// Always inline, as is what calls it: a function that only fetches has no effect, and calls of it are dropped.
[[gnu::always_inline]] inline void fetch(const Slot& slot) { __builtin_prefetch(&slot); }

class PairPass : public SmoothPass {
 public:
  using SmoothPass::SmoothPass;

  // Chunks first … last of the pairs that have met, records of spheres with planes, or awake pairs of other bins.
  Tally answer(Bin& bin, bool met, std::size_t first, std::size_t last, Scratch& s) const {
    Tally t;
    if (bin.smooth && met) {
      for (; first < last; ++first) {
        std::uint32_t rest[chunk_size];
        const std::size_t left = answer_smooth(bin, first, rest, s, t);
        if (left > 0) t += general(bin, rest, left, s);
        for (std::size_t i = 0; i < left; ++i) c_.centre[bin.records[rest[i]]] = {};  // lanes do not keep it
      }
      return t;
    }
    if (bin.query != nullptr) return general(bin, bin.awake.data() + first, last - first, s);
    if (bin.round()) {
      for (; first < last; ++first) t += met_pairs(bin.met, first, s);
      return t;
    }
    for (; first < last; first += chunk_size) t += sphere_planes(bin, first, std::min(chunk_size, last - first), s);
    return t;
  }

 private:
  // A chunk of the pairs of round bodies that have met: lanes across all of them, touching or not; what those that do
  // not touch make of it is thrown away.
  Tally met_pairs(Met& met, std::size_t chunk, Scratch& s) const {
    const std::size_t first = chunk * chunk_size, n = std::min(chunk_size, met.count - first);
    const std::uint32_t *record = &met.record[first], *a = &met.a[first], *b = &met.b[first], *seat = &met.seat[first];
    LawChunk& l = s.law;
    for (std::size_t i = 0; i < n; ++i) load_pair(i, met.pair[first + i], s);
    if (lattice_ != nullptr)
      set_.periodic_gather(p_.motion.data(), a, b, n, *lattice_, s.spheres, l);
    else
      set_.gather_spheres(p_.motion.data(), a, b, n, s.spheres, l);
    set_.load_history(c_.history.data(), seat, n, l);
    const contact::kernels::SphereMeetings now = set_.spheres(s.spheres, l, n);
    const std::uint32_t all = n < chunk_size ? (std::uint32_t(1) << n) - 1 : ~std::uint32_t(0);
    const std::uint32_t was = met.touching[chunk];
    std::uint32_t touching = (now.touching & all) | (lingers_ ? was : 0);
    if (now.turned)
      each_bit(touching, [&](std::size_t i) {
        if (dot(get(l.history_normal, i), get(l.normal, i)) < 0) s.through.push_back(record[i]);
      });
    s.overlap_before = l.history_overlap;
    if (staged_) prepare_stages(record, n, s);
    run_law(n, false, s);
    if (lingers_) each_bit(touching, [&](std::size_t i) { touching ^= over(i, s) ? std::uint32_t(1) << i : 0; });
    set_.sphere_torques(s.spheres, l, n);
    if (world_.law.rolls) {
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3d moment = get(s.work.moment, i), couple = get(l.couple, i);
        put(l.couple, i, couple * l.lever_a[i] + moment);
        put(l.couple_b, i, couple * l.lever_b[i] - moment);
      }
      store_double(seat, n, s);
    } else {
      set_.store_history(l, seat, n, c_.history.data());
      set_.store_slots(l, seat, n, c_.slot.data() + c_.double_seats);
    }
    each_bit(all & ~touching & ~was, [&](std::size_t i) { silence(record[i]); });
    each_bit(touching ^ was, [&](std::size_t i) {
      if ((touching >> i & 1) != 0)
        begin(record[i], s);
      else
        end(record[i], s.overlap_before[i], s);
    });
    met.touching[chunk] = touching;
    Tally t;
    t.candidates = n;
    t.touching = static_cast<std::size_t>(std::popcount(touching));
    t.by_spheres = n - t.touching;
    return t;
  }

  // What laws in stages want beside the rest, and maps.
  void prepare_stages(const std::uint32_t* record, std::size_t n, Scratch& s) const {
    LawChunk& l = s.law;
    std::copy_n(record, n, s.record);
    for (std::size_t i = 0; i < n; ++i) put(l.relative_spin, i, get(s.spheres.spin_a, i) - get(s.spheres.spin_b, i));
    if (!c_.ledger.empty())
      for (std::size_t i = 0; i < n; ++i) {
        s.arm_a[i] = get(l.normal, i) * (s.spheres.radius_a[i] - 0.5 * l.overlap[i]);
        s.arm_b[i] = get(l.normal, i) * (0.5 * l.overlap[i] - s.spheres.radius_b[i]);
      }
    s.gained = by_volume_;
    if (by_volume_) apply_round_volumes(n, s);
  }

  template <class Visit>
  static void each_bit(std::uint32_t bits, Visit visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
  }

  Tally sphere_planes(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
    const std::uint32_t* records = &bin.records[first];
    Tally t;
    std::size_t n = 0;
    LawChunk& l = s.law;
    for (std::size_t r = 0; r < count; ++r) {
      const std::size_t k = records[r];
      const std::uint32_t w = c_.index_b[k];
      const Wall& wall = world_.walls[w];
      const Motion& a = p_.motion[c_.index_a[k]];
      const Vec3d m = walls_[w].normal;
      const double height = dot(m, a.position - wall.position), overlap = a.bounding_radius - height;
      if (!(overlap > 0) && !may_hold(k)) {
        forget(k, s);
        continue;
      }
      const double arm = a.bounding_radius - 0.5 * overlap;
      const Vec3d normal = -m, lever = normal * arm;
      const Vec3d wall_arm = a.position + lever - wall.position;
      put(l.normal, n, normal);
      l.overlap[n] = overlap;
      put(l.velocity, n, a.velocity + cross(a.spin, lever) - wall.velocity - cross(wall.spin, wall_arm));
      l.turn[n] = 0.5 * dot(a.spin + wall.spin, normal);
      l.radius_eff[n] = a.bounding_radius;
      l.mass_eff[n] = 1 / a.inverse_mass;
      put(l.relative_spin, n, a.spin - wall.spin);
      if (by_volume_) apply_round_volume(n, a.bounding_radius, infinity, s);
      load_pair(n, bin.pair[first + r], s);
      s.arm_a[n] = lever;
      s.arm_b[n] = wall_arm;
      begin(k, s);
      s.record[n++] = static_cast<std::uint32_t>(k);
    }
    s.gained = by_volume_;
    finish(n, false, s);
    t.candidates = count;
    t.touching = n;
    t.by_spheres = count - n;
    return t;
  }

  // The pair in place r of a bin is apart by `gap` now: so it stays for a while.
  void keep_apart(const Bin& bin, std::size_t r, double gap) const {
    if (c_.travel.empty()) return;
    const std::uint32_t ib = bin.b_index[r];
    const double radii = p_.motion[bin.a_index[r]].bounding_radius +
                         (bin.wall ? world_.walls[ib].extent : p_.motion[ib].bounding_radius);
    c_.apart_until[bin.records[r]] = apart_until(travels(world_, bin, r), gap, radii);
  }

  // Those of `count` pairs, given by their places in the bin, that need a query, into s.entry: not those that are known
  // to be apart still, nor those whose bounding spheres are. Of the records of one pair it is the first that is asked.
  std::size_t in_question(const Bin& bin, const std::uint32_t* places, std::size_t count, Scratch& s, Tally& t) const {
    const std::size_t step = bin.regions ? contact::max_regions : 1;
    const std::uint32_t *records = bin.records.data(), *a = bin.a_index.data(), *b = bin.b_index.data();
    std::size_t asked = 0, n = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t r = places[i], k = records[r];
      if (!c_.travel.empty() && travels(world_, bin, r) < c_.apart_until[k] && !may_hold(k)) continue;
      prefetch(k);
      s.entry[asked] = static_cast<std::uint32_t>(r);
      s.index_a[asked] = a[r];
      s.index_b[asked++] = bin.wall ? a[r] : b[r];  // a wall has no bounding sphere
    }
    t.candidates = count;
    t.by_displacement = count - asked;
    pad(s.index_a, asked);
    pad(s.index_b, asked);
    if (lattice_ != nullptr)
      set_.periodic_clearance(p_.motion.data(), s.index_a, s.index_b, asked, *lattice_, s.clearance);
    else
      set_.sphere_clearance(p_.motion.data(), s.index_a, s.index_b, asked, s.clearance);
    for (std::size_t i = 0; i < asked; ++i) {
      const std::uint32_t r = s.entry[i];
      const std::size_t k = records[r];
      const Motion& m = p_.motion[a[r]];
      double gap = -1;
      if (is_half_space(bin.b)) {
        gap = dot(walls_[b[r]].normal, m.position - world_.walls[b[r]].position) - m.bounding_radius;
      } else if (s.clearance[i] > 0) {
        const double reach = m.bounding_radius + p_.motion[b[r]].bounding_radius;
        gap = std::sqrt(s.clearance[i] + reach * reach) - reach;
      }
      if (!(gap > 0) || may_hold(k)) {
        s.entry[n++] = r;
        continue;
      }
      for (std::size_t slot = 0; slot < step; ++slot) forget(records[r + slot], s);
      keep_apart(bin, r, gap);
    }
    t.by_spheres = asked - n;
    return n;
  }

  Tally general(const Bin& bin, const std::uint32_t* places, std::size_t count, Scratch& s) const {
    const std::uint32_t* records = bin.records.data();
    const std::size_t step = bin.regions ? contact::max_regions : 1;  // records of a pair
    Tally t;
    const std::size_t pairs = in_question(bin, places, count, s, t);
    for (std::size_t i = 0; i < pairs; ++i) {
      const std::size_t r = s.entry[i], k = records[r];
      const std::uint32_t ia = bin.a_index[r], ib = bin.b_index[r];
      s.a[i] = body_of(ia);
      const Vec3d& x = p_.motion[ia].position;
      if (bin.wall) {
        s.b[i] = walls_[ib].body;
        s.b[i].part = c_.key[k].part;
        s.offset[i] = world_.walls[ib].position - x;
        // The plane's own origin may be far away: its foot below the body serves as well and keeps every digit.
        if (is_half_space(bin.b)) s.offset[i] = walls_[ib].normal * dot(walls_[ib].normal, s.offset[i]);
      } else {
        s.b[i] = body_of(ib);
        s.offset[i] = p_.motion[ib].position - x;
        if (lattice_ != nullptr) s.offset[i] = lattice_->nearest(s.offset[i]);
      }
      s.cache[i] = c_.cache[k];
    }
    if (bin.regions) {
      for (std::size_t i = 0; i < pairs; ++i) {
        const std::size_t k = records[s.entry[i]];
        answer_regions(s.a[i], s.b[i], s.offset[i], &c_.touching[k], &c_.centre[k], s.answer + i * step);
      }
    } else {
      bin.query(pairs, s.a, s.b, s.offset, wanted_, s.cache, s.answer);
    }
    std::size_t n = 0;
    for (std::size_t j = 0; j < pairs * step; ++j) {
      const std::size_t i = j / step, r = s.entry[i] + j % step, k = records[r];
      const contact::Contact& q = s.answer[j];
      if (!bin.regions) c_.cache[k] = s.cache[i];
      const bool refused = q.status == contact::Status::refused;
      if (refused || q.status == contact::Status::not_converged) ++t.not_converged;
      const bool apart = refused || !overlap(q);
      if (apart && (refused || bin.regions || !may_hold(k))) {
        forget(k, s);
        if (bin.regions || !bin.exact || !q.certified || !(q.gap_lower > 0)) continue;
        if (q.iterations == 0 && !(q.gap_upper < infinity)) ++t.by_axis;
        keep_apart(bin, r, q.gap_lower);
        continue;
      }
      if (!q.certified) ++t.uncertified;
      if (q.handed_over) ++t.handed_over;
      contact::OverlapVolume v;
      if (by_volume_ && !measure(k, s.a[i], s.b[i], s.offset[i], q, v, t, s)) continue;
      load_pair(n, bin.pair[r], s);
      const std::uint32_t ia = bin.a_index[r], ib = bin.b_index[r];
      const contact::Patch patch =
          apart ? across_gap(bin.query, over_a_patch(bin), k, s.a[i], s.b[i], s.offset[i], q) : q.patch;
      contact::OverlapDepth d;  // by default what the query says
      if (by_volume_)
        d = {-q.gap, 1, v.normal, v.point, 0};
      else if (apart || !measured(bin, q, s.a[i], s.b[i], s.offset[i], d))
        d = {-q.gap, 1, q.normal, patch.centre, 0};
      const Vec3d& normal = d.normal;
      gather(k, n,
             {ia, ib, bin.wall, d.depth, normal, d.point, patch.spread, s.offset[i], s.a[i].rotation, s.b[i].rotation,
              law_radius(world_, ia), bin.wall ? 0 : law_radius(world_, ib), d.point, d.gain, d.screw},
             s);
      apply_map(k, n, s.a[i], s.b[i], normal, v, s);
      if (passes(bin, k, q)) s.through.push_back(static_cast<std::uint32_t>(k));
      begin(k, s);
      s.record[n++] = static_cast<std::uint32_t>(k);
    }
    t.touching = n;
    s.gained = true;
    finish(n, over_a_patch(bin), s);
    return t;
  }

  // What is read of record k once it has been answered.
  [[gnu::always_inline]] void prefetch(std::size_t k) const {
    __builtin_prefetch(&c_.cache[k], 1);
    __builtin_prefetch(&c_.centre[k], 1);
    __builtin_prefetch(&c_.history_of(k), 1);
    fetch(c_.slot[c_.slot_of(k)]);
    fetch(c_.slot[c_.slot_of_b(k)]);
  }

  // Beyond each other's middle. Sharp edges turn a normal by more than a right angle, regions change places; the slope
  // of the overlap's depth turns round slowly.
  bool passes(const Bin& bin, std::size_t k, const contact::Contact& q) const {
    if (bin.regions) return false;
    if (dot(c_.history_of(k).normal, q.normal) < -0.9) return true;
    if (!by_depth_ || bin.a != shapes::Kind::polyhedron || bin.b != shapes::Kind::polyhedron) return false;
    return -q.gap > 0.9 * (inscribed_radius(world_, c_.index_a[k]) + inscribed_radius(world_, c_.index_b[k]));
  }

  // The overlap of flat faces as the potential of overlap_depth.h has it. False: of round bodies, of a method's own
  // measure, of an overlap of the size of rounding: there the slope of the gap is that of the potential.
  bool measured(const Bin& bin, const contact::Contact& q, const contact::Body& a, const contact::Body& b,
                const Vec3d& offset, contact::OverlapDepth& out) const {
    if (!by_depth_ || !bin.exact) return false;
    out = q.measure;
    return out.depth > 0 || (!bin.regions && contact::overlap_depth(a, b, offset, q.normal, out));
  }

  static bool over_a_patch(const Bin& bin) {
    return bin.a == shapes::Kind::polyhedron || bin.a == shapes::Kind::rounded_polyhedron ||
           bin.a == shapes::Kind::polygon;
  }
};

// Lists the touching records of both bodies of record k anew; the order stays that of the partners.
void relist(Contacts& c, std::uint32_t k) {
  const auto body = [&](std::uint32_t i) {
    const std::uint32_t first = c.incidence_start[i];
    std::uint32_t n = 0;
    for (std::uint32_t e = first; e < c.incidence_start[i + 1]; ++e)
      if (c.touching[c.incidence[e] >> 1] != 0) c.active[first + n++] = c.active_entry(c.incidence[e]);
    c.active_count[i] = n;
  };
  body(c.index_a[k]);
  if (c.key[k].b < wall_base) body(c.index_b[k]);
}

// What the contacts that have ended lost, in the order of their keys.
void book_lost(World& world, const std::vector<Change>& changed) {
  std::vector<Gone>& gone = world.contacts.gone;
  for (const Change& c : changed)
    if (world.contacts.touching[c.record] == 0) gone.push_back({world.contacts.key[c.record], c.lost});
  std::sort(gone.begin(), gone.end(), [](const Gone& x, const Gone& y) { return x.key < y.key; });
  for (const Gone& g : gone)
    for (std::size_t m = 0; m < contact::mechanism_count; ++m) world.balance.lost[m].add(g.lost[m]);
  gone.clear();
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Pairs of a task: as many lanes as a chunk has where kernels run across pairs, less where pairs are dear or have many
// records.
std::size_t task_size(const Bin& bin) {
  if (bin.regions) return chunk_size / contact::max_regions;
  return bin.a == shapes::Kind::ellipsoid || bin.a == shapes::Kind::ellipse ? chunk_size : chunk_size / 2;
}

// What became of the candidates of each bin, and last of the groups.
void book(World& world, const std::vector<Tally>& tally) {
  Counters& n = world.counters;
  for (std::size_t i = 0; i < tally.size(); ++i) {
    Tally t = tally[i];
    if (i + 1 < tally.size()) {
      const Bin& bin = world.contacts.bins[i];
      const std::size_t asleep = bin.records.size() / (bin.regions ? contact::max_regions : 1) - t.candidates;
      t.candidates += asleep;
      // Round pairs are told apart by their spheres in the step that lists the awake, and by their ways after it.
      (bin.round() && world.contacts.way == 0 ? t.by_spheres : t.by_displacement) += asleep;
    }
    if (i + 1 == tally.size()) {
      world.profile.parts += t;
    } else {
      const Bin& bin = world.contacts.bins[i];
      world.profile.pairs[static_cast<std::size_t>(bin.a)][static_cast<std::size_t>(bin.b)] += t;
    }
    n.queries += t.candidates;
    n.contact_steps += t.touching;
    n.not_converged += t.not_converged;
    n.uncertified += t.uncertified;
    n.handed_over += t.handed_over;
  }
}

}  // namespace

void compute_forces(World& world, int threads, double dt) {
  const auto begin = std::chrono::steady_clock::now();
  wake(world);
  const std::vector<Tally> looked = meet(world, threads);
  const PairPass pass(world, dt);
  const CompoundPass compounds(world, dt);
  const bool timed = world.profile.timed;
  Bin* bins = world.contacts.bins.data();
  // Tasks of about ten microseconds, the dear ones first, so that threads end together.
  struct Task {
    Bin* bin;  // null: groups
    bool met;
    std::size_t first, last;
  };
  std::vector<Task> tasks;
  const auto add = [&tasks](Bin& bin, bool met, std::size_t count, std::size_t size) {
    for (std::size_t i = 0; i < count; i += size) tasks.push_back({&bin, met, i, std::min(i + size, count)});
  };
  const std::vector<Group>& groups = world.contacts.groups;
  for (std::size_t first = 0, g = 0, records = 0; g < groups.size(); ++g) {
    records += groups[g].count;
    if (records < chunk_size && g + 1 < groups.size()) continue;
    tasks.push_back({nullptr, false, first, g + 1});
    first = g + 1;
    records = 0;
  }
  for (Bin& b : world.contacts.bins)
    if (b.query != nullptr) add(b, false, b.awake.size(), task_size(b));
  for (Bin& b : world.contacts.bins) {
    if (b.round() || b.smooth) add(b, true, b.met.chunks(), b.smooth ? 4 : 8);
    if (b.query == nullptr && b.wall) add(b, false, b.records.size(), 8 * chunk_size);
  }
  std::vector<Tally> total = looked;
  std::vector<Change> changed;
  std::vector<std::uint32_t> through;
#pragma omp parallel num_threads(threads)
  {
    static thread_local Scratch scratch;
    std::fill(std::begin(scratch.pair), std::end(scratch.pair), ~std::uint32_t(0));
    scratch.tally.assign(world.contacts.bins.size() + 1, {});
#pragma omp for schedule(dynamic, 1)
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Task& task = tasks[i];
      const auto start = timed ? std::chrono::steady_clock::now() : begin;
      Tally mine = task.bin == nullptr ? compounds.answer(task.first, task.last, scratch)
                                       : pass.answer(*task.bin, task.met, task.first, task.last, scratch);
      if (timed) mine.seconds = seconds_since(start);
      scratch.tally[task.bin == nullptr ? total.size() - 1 : static_cast<std::size_t>(task.bin - bins)] += mine;
    }
#pragma omp critical
    {
      for (std::size_t i = 0; i < total.size(); ++i) total[i] += scratch.tally[i];
      changed.insert(changed.end(), scratch.changed.begin(), scratch.changed.end());
      through.insert(through.end(), scratch.through.begin(), scratch.through.end());
      scratch.changed.clear();
      scratch.through.clear();
    }
  }
  for (const Change& c : changed) relist(world.contacts, c.record);
  if (!world.contacts.ledger.empty()) book_lost(world, changed);
  if (dt > 0) {
    check_passages(world, through);
    check_impacts(world, changed);
  }
  book(world, total);
  world.times.query += seconds_since(begin);
}

constexpr std::size_t near_bytes = 8U << 20;  // of slots that the caches near the core hold
constexpr std::size_t bodies_at_once = 256;

void sum_forces(World& world, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  const Contacts& c = world.contacts;
  Particles& p = world.particles;
  const KernelSet& set = contact::kernels::kernels();
  const bool far = c.slot.size() * sizeof(Slot) > near_bytes;
  const contact::kernels::SumLists lists{c.slot.data(), c.active.data(), c.incidence_start.data(),
                                         c.active_count.data()};
  const std::size_t all = p.count();
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t first = 0; first < all; first += bodies_at_once)
    set.sum_slots(lists, first, std::min(all, first + bodies_at_once), far, p.force.data(), p.torque.data());
  for (Wall& w : world.walls) w.force = w.torque = {};
  for (const std::uint32_t k : c.wall_records) {
    if (c.touching[k] == 0) continue;
    Wall& w = world.walls[c.index_b[k]];
    w.force -= c.slot[c.slot_of(k)].force;
    w.torque += c.slot[c.slot_of_b(k)].couple;
  }
  sum_resistance(world);
  world.times.sum += seconds_since(begin);
}

}  // namespace dem
