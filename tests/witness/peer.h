// Asking FCL and libccd about pairs, in a process of their own: they abort, throw and hang on some input.
#pragma once

#include <string>
#include <vector>

#include "tests/witness/bodies.h"

namespace witness {

// fcl: signed distance, GJK + EPA of libccd with FCL's own end game, tolerance 1e-6 (its default). epa, mpr: libccd's
// ccdGJKPenetration and ccdMPRPenetration at their default tolerance 1e-4.
enum class Query { fcl, epa, mpr };
const char* name_of(Query query);

struct Answer {
  enum class End { answered, threw, aborted, hung, not_asked } end = End::not_asked;
  bool overlap = false;
  double gap = 0;     // epa, mpr: only when overlapping
  Vec3d direction{};  // from A to B; zero when none was given
  bool has_points = false;
  Vec3d point_a{}, point_b{};  // from A's origin; epa, mpr: the same point twice
};

// One answer per pair, in order. A pair gets a quarter of a second of processor time; after eight pairs that took
// longer the rest is not asked, so a batch ends.
std::vector<Answer> ask(Query query, const std::vector<Pair>& pairs);

}  // namespace witness
