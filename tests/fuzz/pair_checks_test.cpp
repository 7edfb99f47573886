// The checks of pair_checks.h find answers that are wrong on purpose: bounds shifted to either side, a normal that is
// tilted, a gap without bounds around it.
#include "tests/fuzz/pair_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/libcontact/catalogue.h"

namespace {

using namespace pair_fuzz;
using contact::Status;

// Certified answers in full, with bounds within rounding.
template <class Use>
int each_answer(const MethodInfo& m, Use&& use) {
  int used = 0;
  for (std::uint64_t seed = 0; seed < 2000 && used < 200; ++seed) {
    Source source(seed);
    const PairCase pair = draw_pair(m, source);
    Contact answer;
    contact::find(m.a, m.b, m.name)(1, &pair.a.body, &pair.b.body, &pair.offset, {}, nullptr, &answer);
    const double unit = contact::epsilon * pair.extent();
    if (!answer.certified || !(answer.gap_upper - answer.gap_lower <= 256 * unit)) continue;
    ++used;
    use(pair, answer, unit, source);
  }
  return used;
}

class PairChecks : public testing::TestWithParam<MethodInfo> {};

TEST_P(PairChecks, ShiftedBoundsAreFound) {
  const int used = each_answer(GetParam(), [](const PairCase& pair, const Contact& good, double unit, Source& source) {
    EXPECT_EQ(judge(pair, good, source).broken, nullptr);
    for (const double shift : {-300 * unit, 300 * unit, -1e-3 * pair.extent(), 1e-3 * pair.extent()}) {
      Contact bad = good;
      bad.gap += shift;
      bad.gap_lower += shift;
      bad.gap_upper += shift;
      bad.status = bad.gap_lower > 0 ? Status::separated : bad.gap_upper < 0 ? Status::overlapping : Status::touching;
      const Judgement j = judge(pair, bad, source);
      ASSERT_NE(j.broken, nullptr) << shift / unit << " eps L";
      EXPECT_NE(std::string(j.broken).find(shift > 0 ? "gap_lower" : "gap_upper"), std::string::npos) << j.broken;
    }
  });
  EXPECT_GE(used, 100);
}

TEST_P(PairChecks, TiltedNormalsAndOpenBoundsAreFound) {
  const bool flat = shapes::dimension_of(GetParam().a) == 2;
  const bool wall = shapes::is_wall(GetParam().b);  // of walls the normal is given
  int found = 0;
  const int used = each_answer(GetParam(), [&](const PairCase& pair, const Contact& good, double, Source& source) {
    const Vec3d n = good.normal;
    Vec3d tilt = flat ? Vec3d{-n.y, n.x, 0} : cross(n, std::abs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
    tilt = normalized(tilt);
    Contact bad = good;
    bad.normal = normalized(n + 0.05 * tilt);
    found += judge(pair, bad, source).broken != nullptr;
    bad = good;
    bad.normal = 1.0001 * n;
    EXPECT_NE(judge(pair, bad, source).broken, nullptr);
    bad = good;
    bad.gap = good.gap_upper + std::abs(good.gap_upper) * 1e-3;
    EXPECT_NE(judge(pair, bad, source).broken, nullptr);
    bad = good;
    bad.gap_upper = std::nan("");
    EXPECT_NE(judge(pair, bad, source).broken, nullptr);
  });
  // Along a ridge, and about a common centre of round bodies, a tilted normal may be as good.
  if (!wall) {
    EXPECT_GE(found, used * 6 / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, PairChecks, testing::ValuesIn(catalogue::of_own_methods()), catalogue::entry_name);

}  // namespace
