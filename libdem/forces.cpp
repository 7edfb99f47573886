#include <algorithm>
#include <bit>
#include <cmath>

#include "libcontact/methods/polygon_regions.h"
#include "libdem/build.h"
#include "libdem/coherence.h"
#include "libdem/force_pass.h"
#include "libdem/forces_polygons.h"
#include "libdem/forces_smooth.h"
#include "libdem/pair_answers.h"
#include "libdem/regions.h"
#include "libdem/sleep.h"

namespace dem {
namespace {

// Always inline, as is what calls it: a function that only fetches has no effect, and calls of it are dropped.
[[gnu::always_inline]] inline void fetch(const Slot& slot) { __builtin_prefetch(&slot); }

class PairPass : public SmoothPass {
 public:
  PairPass(World& world, double dt) : SmoothPass(world, dt), polygons_(world, dt) {}

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
    if (bin.query != nullptr) {
      const std::uint32_t* places = bin.awake.data() + first;
      return polygons_.takes(bin) ? polygons(bin, places, last - first, s) : general(bin, places, last - first, s);
    }
    if (bin.round()) {
      for (; first < last; ++first) t += met_pairs(bin.met, first, s);
      return t;
    }
    for (; first < last; first += chunk_size) {
      const std::size_t n = std::min(chunk_size, last - first);
      t += staged_ ? planes_in_stages(bin, first, n, s) : sphere_planes(bin, first, n, s);
    }
    return t;
  }

  bool in_lanes(const Bin& bin) const { return polygons_.takes(bin); }

 private:
  // A chunk of the pairs of round bodies that have met: lanes across all of them, touching or not; what those that do
  // not touch make of it is thrown away.
  Tally met_pairs(Met& met, std::size_t chunk, Scratch& s) const {
    const std::size_t first = chunk * chunk_size, n = std::min(chunk_size, met.count - first);
    const std::uint32_t *record = &met.record[first], *a = &met.a[first], *b = &met.b[first], *seat = &met.seat[first];
    if (far_) fetch_chunk(met, first + chunk_size);
    if (met.pair_everywhere == none || s.pair_everywhere != met.pair_everywhere) {
      for (std::size_t i = 0; i < n; ++i) load_pair(i, met.pair[first + i], s);
      s.pair_everywhere = n == chunk_size ? met.pair_everywhere : none;
    }
    const std::uint32_t all = lanes_below(n);
    const std::uint32_t was = met.touching[chunk];
    contact::kernels::SphereMeetings now;
    if (staged_) {
      now = met_in_stages(record, a, b, seat, n, was, s);
      each_bit(all & ~now.touching & ~was, [&](std::size_t i) { silence(record[i]); });
    } else {
      const std::uint32_t slot = seat[0] + c_.double_seats, place = s.ring.place(slot);  // those of a chunk follow it
      const contact::kernels::SphereContacts contacts{p_.motion.data(),
                                                      a,
                                                      b,
                                                      seat,
                                                      n,
                                                      lattice_,
                                                      &s.law.pair,
                                                      dt_,
                                                      &world_.law_options,
                                                      c_.history.data(),
                                                      c_.slot.data() + c_.double_seats + place - slot,
                                                      &s.overlap_before};
      now = world_.law.hertzian ? set_.sphere_contacts_hertz(contacts) : set_.sphere_contacts_linear(contacts);
    }
    const std::uint32_t touching = now.touching & all;
    each_bit(touching & now.turned, [&](std::size_t i) { s.through.push_back(record[i]); });
    note_changes(record, touching, was, s);
    met.touching[chunk] = touching;
    return tally_of(n, touching);
  }

  // What the chunk from `first` on will read.
  [[gnu::always_inline]] void fetch_chunk(const Met& met, std::size_t first) const {
    const std::size_t last = std::min(first + chunk_size, met.count);
    for (std::size_t i = first; i < last; ++i) {
      const char *a = reinterpret_cast<const char*>(&p_.motion[met.a[i]]),
                 *b = reinterpret_cast<const char*>(&p_.motion[met.b[i]]);
      __builtin_prefetch(a);
      __builtin_prefetch(a + sizeof(Motion) - 1);
      __builtin_prefetch(b);
      __builtin_prefetch(b + sizeof(Motion) - 1);
      __builtin_prefetch(&c_.history[met.seat[i]], 1);
    }
  }

  // The same for laws that remember more, resist rolling, or hold on across a gap: kernel after kernel over the chunk.
  contact::kernels::SphereMeetings met_in_stages(const std::uint32_t* record, const std::uint32_t* a,
                                                 const std::uint32_t* b, const std::uint32_t* seat, std::size_t n,
                                                 std::uint32_t was, Scratch& s) const {
    LawChunk& l = s.law;
    if (lattice_ != nullptr)
      set_.periodic_gather(p_.motion.data(), a, b, n, *lattice_, s.spheres, l);
    else
      set_.gather_spheres(p_.motion.data(), a, b, n, s.spheres, l);
    set_.load_history(c_.history.data(), seat, n, l);
    contact::kernels::SphereMeetings now = set_.spheres(s.spheres, l, n);
    if (lingers_) now.touching |= was;
    s.overlap_before = l.history_overlap;
    prepare_stages(record, n, s);
    run_law(n, false, s);
    if (lingers_)
      each_bit(now.touching, [&](std::size_t i) {
        if (i < n && over(i, s)) now.touching ^= std::uint32_t(1) << i;
      });
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
    return now;
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

  static Tally tally_of(std::size_t count, std::uint32_t touching) {
    Tally t;
    t.candidates = count;
    t.touching = static_cast<std::size_t>(std::popcount(touching));
    t.by_spheres = count - t.touching;
    return t;
  }
  // Of a chunk's records those that touch now and those that did.
  void note_changes(const std::uint32_t* record, std::uint32_t touching, std::uint32_t was, Scratch& s) const {
    each_bit(touching ^ was, [&](std::size_t i) {
      if ((touching >> i & 1) != 0)
        begin(record[i], s);
      else
        end(record[i], s.overlap_before[i], s);
    });
  }
  Tally sphere_planes(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
    const std::uint32_t* records = &bin.records[first];
    std::uint32_t was = 0;
    for (std::size_t i = 0; i < (count + 7) / 8 * 8; ++i) {
      const std::size_t from = std::min(i, count - 1);
      s.index_a[i] = bin.a_index[first + from];
      s.index_b[i] = bin.b_index[first + from];
      s.seat[i] = c_.seat[records[from]];
      if (i >= count) continue;
      load_pair(i, bin.pair[first + i], s);
      was |= static_cast<std::uint32_t>(c_.touching[records[i]] != 0 ? 1 : 0) << i;
    }
    const contact::kernels::PlaneContacts contacts{
        p_.motion.data(),    planes_.data(),    s.index_a,      s.index_b,        s.seat, count, &s.law.pair, dt_,
        &world_.law_options, c_.history.data(), c_.slot.data(), &s.overlap_before};
    const contact::kernels::SphereMeetings now =
        world_.law.hertzian ? set_.plane_contacts_hertz(contacts) : set_.plane_contacts_linear(contacts);
    const std::uint32_t touching = now.touching & lanes_below(count);
    note_changes(records, touching, was, s);
    return tally_of(count, touching);
  }

  Tally planes_in_stages(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
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
      if (!bin.wall) prefetch_body(b[r]);  // those of its body a are as a rule at hand from the pair before
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
        const std::size_t r = s.entry[i], k = records[r];
        const double gap = answer_regions(s.a[i], s.b[i], s.offset[i], &c_.touching[k], &c_.centre[k], &c_.cache[k],
                                          s.answer + i * step);
        if (gap > 0) keep_apart(bin, any_region(s.answer + i * step) ? r + 1 : r, gap);
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
      contact::Patch across;
      if (apart) across = across_gap(bin.query, over_a_patch(bin), k, s.a[i], s.b[i], s.offset[i], q);
      const contact::Patch& patch = apart ? across : q.patch;
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
    const std::uint32_t a = c_.index_a[k], b = c_.index_b[k];
    const double reach = p_.motion[a].bounding_radius + p_.motion[b].bounding_radius;
    if (!(-q.gap > 0.89 * thinnest_ * reach)) return false;  // nearly all
    return -q.gap > 0.9 * (inscribed_radius(world_, a) + inscribed_radius(world_, b));
  }

  // The overlap of flat faces as the potential of overlap_depth.h has it. False: of round bodies, of a method's own
  // measure, of an overlap of the size of rounding: there the slope of the gap is that of the potential.
  bool measured(const Bin& bin, const contact::Contact& q, const contact::Body& a, const contact::Body& b,
                const Vec3d& offset, contact::OverlapDepth& out) const {
    if (!by_depth_ || !bin.exact) return false;
    out = q.measure;
    return out.depth > 0 || (!bin.regions && contact::overlap_depth(a, b, offset, q.normal, out));
  }

  // Those that go on as they met; what is left over like any other pair.
  Tally polygons(const Bin& bin, const std::uint32_t* places, std::size_t count, Scratch& s) const {
    Tally t;
    std::uint32_t rest[chunk_size];
    const std::size_t asked = in_question(bin, places, count, s, t),
                      left = polygons_.answer(bin, s.entry, asked, rest, s, t),
                      size = bin.regions ? chunk_size / contact::max_regions : chunk_size;
    for (std::size_t i = 0; i < left; i += size) {
      Tally of_rest = general(bin, rest + i, std::min(size, left - i), s);
      of_rest.candidates = 0;
      t += of_rest;
    }
    return t;
  }

  PolygonPass polygons_;

  static bool over_a_patch(const Bin& bin) {
    return bin.a == shapes::Kind::polyhedron || bin.a == shapes::Kind::rounded_polyhedron ||
           bin.a == shapes::Kind::polygon;
  }
};

}  // namespace

struct PairAnswers::Pass : PairPass {
  using PairPass::PairPass;
};
PairAnswers::PairAnswers(World& world, double dt) : pass_(std::make_unique<const Pass>(world, dt)) {}
PairAnswers::~PairAnswers() = default;
Tally PairAnswers::answer(Bin& bin, bool met, std::size_t first, std::size_t last, Scratch& s) const {
  return pass_->answer(bin, met, first, last, s);
}
bool PairAnswers::in_lanes(const Bin& bin) const { return pass_->in_lanes(bin); }

}  // namespace dem
