// Candidate pairs and the history of contacts. Records are sorted by (a, b, part); history survives a rebuild of the
// list by merging sorted keys, so what a contact remembers does not depend on when lists were built.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/records.h"
#include "libcontact/laws/law.h"
#include "libcontact/laws/ledger.h"

namespace dem {

using contact::Material;
using contact::PairParameters;
using contact::Slot;
using shapes::Quatd;
using shapes::Vec3d;

// Who touches whom: a is a particle; b a particle (by id) or, above wall_base, a wall; part is b's: the mesh facet or
// the part of a compound; part_a the part of a compound a. A pair that may touch in several regions has
// contact::max_regions records side by side, part is their number.
struct Key {
  std::uint64_t a = 0, b = 0;
  std::uint32_t part = 0, part_a = 0;
  friend auto operator<=>(const Key&, const Key&) = default;
};
inline constexpr std::uint64_t wall_base = std::uint64_t(1) << 63;

struct Change {  // a contact that came or went in a step
  std::uint32_t record;
  double overlap;                                       // m, that it had when it went; 0: it came
  std::array<double, contact::mechanism_count> lost{};  // J, over its time, of law.ledger
};

struct Gone {  // a contact that has ended, and what it lost
  Key key;
  std::array<double, contact::mechanism_count> lost{};  // J
};

inline constexpr std::uint32_t none = ~std::uint32_t(0);
inline constexpr std::size_t near_bytes = 8U << 20;  // that the caches near the core hold

// Pairs that go through lanes from the bodies to the slots, in chunks: what a step looks at. Of round bodies those that
// have met since the list of candidates was made, in the order that their histories have in memory; of smooth ones
// those that touched when the awake were listed. The arrays are filled up to whole chunks with pairs of the list.
struct Met {
  std::vector<std::uint32_t> record, a, b, pair, seat;
  std::vector<std::uint32_t> place;     // in the bin; of smooth bodies
  std::vector<std::uint32_t> touching;  // of round bodies, per chunk: bit i: its pair i touches
  std::size_t count = 0;
  std::uint32_t pair_everywhere = none;  // of materials, where it is one only

  void add(std::uint32_t k, std::uint32_t body_a, std::uint32_t body_b, std::uint32_t materials, std::uint32_t at) {
    pair_everywhere = count == 0 || pair_everywhere == materials ? materials : none;
    if (count == record.size()) {
      record.resize(count + contact::kernels::chunk_size, k);
      a.resize(record.size(), body_a);
      b.resize(record.size(), body_b);
      pair.resize(record.size(), materials);
      seat.resize(record.size(), at);
      touching.push_back(0);
    }
    record[count] = k;
    a[count] = body_a;
    b[count] = body_b;
    pair[count] = materials;
    seat[count++] = at;
  }
  void clear() {
    for (auto* v : {&record, &a, &b, &pair, &seat, &place, &touching}) v->clear();
    count = 0;
  }
  std::size_t chunks() const { return touching.size(); }
};

// The records of one pair of kinds, answered by one function: dispatch happens here, never per pair.
struct Bin {
  shapes::Kind a = shapes::Kind::sphere, b = shapes::Kind::sphere;
  contact::ChunkQuery query = nullptr;  // null: sphere–sphere and sphere–plane, which have kernels of their own
  bool wall = false;                    // b is a wall
  bool regions = false;                 // its pairs may touch in several regions
  bool smooth = false;                  // of two ellipsoids or ellipses, by the method that lanes have
  bool exact = true;                    // answers agree with every proof of separation: no measure of a method's own
  std::vector<std::uint32_t> records;
  std::vector<std::uint32_t> a_index, b_index, pair;  // of each record: its bodies, its pair of materials; padded by 4
  std::vector<std::uint32_t> awake;                   // places in `records` that a step looks at, of pairs; sleep.h
  Met met;  // of pairs of round bodies, or of smooth ones; no one of them is in `awake`
  bool round() const { return query == nullptr && !wall; }
};

// The order in which a step goes through chunks of round pairs and through blocks of bodies; see sweep.h.
struct Sweep {
  std::uint32_t bin = none;                // whose chunks; none: there are none
  std::size_t chunks = 0;                  // of its Met: whole ones at the last rebuild
  std::vector<std::uint32_t> first, last;  // of each block of bodies: the chunks that its pairs lie between, or none
  std::vector<std::uint32_t> order;        // the blocks by their last chunk
  std::uint32_t widest = 0;                // from the first to the last chunk of a block, at most
};

// The records of one pair of bodies, or of a body and a wall, of which one at least has parts: they follow one another
// and are answered together, because parts of one body share what they touch (contact_share.h). Their index_a is the
// body key.a.
struct Group {
  std::uint32_t first, count;
};
// What answers a pair of parts; dispatch is by its place in Contacts::part_queries.
struct PartQuery {
  shapes::Kind a, b;  // in kind order
  contact::ChunkQuery query;
};

struct Contacts {
  std::vector<Key> key;  // row by row
  std::vector<std::uint32_t> index_a,
      index_b;  // particle index; index_b = wall index for walls. a is lower in kind order
  // Where a record has its history and its slots. Pairs of round bodies get a seat when they first touch after a
  // rebuild and keep it until the next one; until then they have none. All others have one from the start.
  std::vector<std::uint32_t> seat;
  std::vector<contact::History> history;  // by seat; zero when not touching
  std::vector<Slot> slot;                 // seats below double_seats have two, the others one
  std::uint32_t double_seats = 0;
  std::uint32_t round_seats = 0;  // seats from this one on are those of pairs of round bodies
  // What laws remember beside the History, `words` doubles per record: their states, then what the map does
  // (law_map.h), then the stored energy (J). Empty where the fused kernels do.
  std::vector<double> memory;
  std::size_t words = 0;
  std::vector<contact::Ledger> ledger;  // empty without law.ledger
  std::vector<Gone> gone;               // that a rebuild found out of reach, until the books are made up
  std::vector<std::uint8_t> touching;
  std::vector<Vec3d> centre;          // relative to a's centre, m; zero: midway; empty when all are spheres
  std::vector<contact::Cache> cache;  // likewise
  // A pair that was found apart by a proven gap needs no query before its bodies have moved by that much; see
  // coherence.h. Both are empty when all are spheres and in cells that deform.
  std::vector<double> travel;       // per particle: at least the way of its farthest point since the last rebuild, m
  std::vector<double> apart_until;  // per record: the sum of its bodies' travels up to which it is apart; 0: unknown
  // Way of the farthest body and of the farthest wall in this step; its sum since the awake were listed; up to where
  // their list holds, m. See sleep.h.
  double step_way = 0, way = 0, way_allowed = -1;
  double since_look = 0, look_after = 0;  // the same for the look whether the list must be rebuilt (candidates.cpp)

  std::vector<Bin> bins;      // of the records that are in no group
  std::vector<Group> groups;  // empty without bodies of parts, as are the next four
  std::vector<PartQuery> part_queries;
  std::vector<std::uint8_t> part_query;        // of each record
  std::vector<double> share;                   // of each record: of the stiffness of its contact; 1 in no group
  std::vector<Quatd> reference_orientation;    // of the particles, at the last rebuild
  std::vector<std::uint32_t> incidence_start;  // per particle (count + 1): its records in order of partner
  std::vector<std::uint32_t> incidence;        // record · 2 + (1 when the particle is b)
  // Per particle, from the same start, of those of its records that count: the slot · 2 + (1 when the particle is b).
  // Pairs of round bodies count from when they meet: the slots of those that do not touch are zero. Others count while
  // they touch.
  std::vector<std::uint32_t> active;
  std::vector<std::uint32_t> active_count;
  Sweep sweep;
  std::vector<std::uint32_t> wall_records;  // records with a wall
  std::vector<Vec3d> reference;             // particle positions at the last rebuild
  double largest_sum = 0;                   // of the bounding radii of two bodies, m
  std::vector<double> allowance;            // per particle: way that the list holds for, m; see allowance.h
  bool stale = true;                        // the list must be rebuilt before it is used
  std::size_t count() const { return key.size(); }

  // Of a record that has a seat.
  contact::History& history_of(std::size_t k) { return history[seat[k]]; }
  const contact::History& history_of(std::size_t k) const { return history[seat[k]]; }
  // What acts on a: in its first slot. On b: in its second, or in the same one.
  std::size_t slot_of(std::size_t k) const { return first_slot(seat[k]); }
  std::size_t slot_of_b(std::size_t k) const { return slot_of(k) + (seat[k] < double_seats ? 1 : 0); }
  std::size_t first_slot(std::uint32_t at) const { return std::size_t(at) + std::min(at, double_seats); }
  bool counts(std::size_t k) const { return touching[k] != 0 || (seat[k] >= round_seats && seat[k] != none); }
  // The entry of `active` for one of `incidence`.
  std::uint32_t active_entry(std::uint32_t incident) const {
    const std::size_t k = incident >> 1;
    const bool is_b = (incident & 1) != 0;
    return static_cast<std::uint32_t>(2 * (is_b ? slot_of_b(k) : slot_of(k)) + (is_b ? 1 : 0));
  }
  // Seats in all, the new ones at rest.
  void make_seats(std::size_t seats) {
    const auto grow = [](auto& list, std::size_t size) {  // a few at a time: not to twice the size
      if (size > list.capacity()) list.reserve(size + size / 8);
      list.resize(size);
    };
    grow(history, seats);
    grow(slot, first_slot(static_cast<std::uint32_t>(seats)));
  }
  // Adds a touching contact to a list that output reads, until the next rebuild makes the full one.
  void list(const Key& of, std::uint32_t a, std::uint32_t b, const contact::History& remembered, const Vec3d& force) {
    key.push_back(of);
    index_a.push_back(a);
    index_b.push_back(b);
    seat.push_back(static_cast<std::uint32_t>(history.size()));
    history.push_back(remembered);
    slot.push_back({force, 0, {}, 0});
    touching.push_back(1);
  }
};

}  // namespace dem
