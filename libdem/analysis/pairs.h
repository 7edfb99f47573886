// Contacts of a snapshot, one per pair of bodies: bodies that meet in several places have several records, and what
// counts contacts counts them once.
//
//   force    sum of the records' forces on a                                                                  [N]
//   normal   Σ w n / |Σ w n|, point Σ w x / Σ w, w = |normal force| of a record; equal weights where all are zero
//   pressing -force·normal, tangential |force + pressing normal|                                               [N]
//
// Order: as the records of the snapshot, so sums over pairs are the same on any number of threads.
// Cost: O(records). Tests: tests/libdem/analysis_pairs.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "libdem/analysis/result.h"
#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

struct Pair {
  std::uint32_t a = 0, b = 0;  // places of bodies; of a wall in Pairs::walls
  bool wall = false;
  std::uint32_t first = 0, count = 0;  // its records: Pairs::records[first .. first + count)
  Vec3d force{};                       // on a, N
  Vec3d point{};                       // m, next to a where the cell is periodic
  Vec3d normal{};                      // unit, from a to b
  Vec3d branch{};                      // from a's centre to b's nearest image, m; of a wall to the point
  double overlap = 0;                  // m, of the deepest record
  double pressing = 0;                 // N, > 0 where the bodies push
  double tangential = 0;               // N, >= 0
};

struct Pairs {
  std::vector<Pair> bodies, walls;     // of two bodies; of a body and a wall
  std::vector<std::uint32_t> records;  // places in Snapshot::contacts, grouped by pair
  // Adjacency of bodies: the pairs of body i are pair_of[start[i] .. start[i + 1]), in order of the pairs.
  std::vector<std::uint32_t> start, pair_of;

  std::uint32_t contacts_of(std::size_t body) const { return start[body + 1] - start[body]; }
  std::uint32_t partner(std::size_t body, std::uint32_t pair) const {
    return bodies[pair].a == body ? bodies[pair].b : bodies[pair].a;
  }
  double mean_pressing() const;  // of the pairs of bodies, N; 0 without any
};

Pairs pairs_of(const Snapshot& snapshot);

// The pairs of bodies whose points are in the region, all of them without one. Adjacency follows.
Pairs within(Pairs pairs, const Snapshot& snapshot, const std::optional<Domain>& region);

// Whether there is nothing to say about contacts, with the note that says why: no bodies, or a file without contacts.
bool lacks_contacts(const Snapshot& snapshot, Result& result);
// The same, or contacts without forces.
bool lacks_forces(const Snapshot& snapshot, Result& result);

}  // namespace dem::analysis
