// Bodies of any sizes find the same neighbours in their grids as by trying every pair.
#include "libdem/broad_phase/levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace {

using dem::Vec3d;

struct Case {
  double ratio;  // of the largest radius over the least
  bool periodic, flat;
};

class Levels : public testing::TestWithParam<Case> {
 protected:
  static constexpr double side = 1, largest = 0.09;  // m
  dem::Cell box() const {
    dem::Cell cell;
    if (!GetParam().periodic) return cell;
    cell.periodic = true;
    cell.lower = {-0.3, -0.3, -0.3};
    for (int k = 0; k < (GetParam().flat ? 2 : 3); ++k) {
      cell.lattice.length[k] = side;
      cell.lattice.inverse[k] = 1 / side;
    }
    return cell;
  }
  // Some bodies may move farther than others.
  static std::vector<double> allowances(std::size_t count) {
    std::vector<double> list(count);
    for (std::size_t i = 0; i < count; ++i) list[i] = i % 7 == 0 ? 0.02 : 0.002;
    return list;
  }
  std::vector<dem::Motion> bodies() const {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<dem::Motion> list(600);
    for (dem::Motion& m : list) {
      for (int k = 0; k < 3; ++k) m.position[k] = -0.3 + side * share(random);
      if (GetParam().flat) m.position.z = 0;
      m.bounding_radius = largest * std::pow(GetParam().ratio, -share(random));
    }
    return list;
  }
};

TEST_P(Levels, FindWhatEveryPairFinds) {
  const std::vector<dem::Motion> list = bodies();
  const dem::Cell cell = box();
  const std::vector<double> allowance = allowances(list.size());
  const dem::Levels levels(list, allowance, cell);
  std::size_t found = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::multiset<std::uint32_t> near, expected;
    levels.near(i, [&](std::uint32_t j) { near.insert(j); });
    for (std::size_t j = 0; j < list.size(); ++j) {
      const double reach = list[i].bounding_radius + allowance[i] + (list[j].bounding_radius + allowance[j]);
      if (norm(cell.lattice.nearest(list[j].position - list[i].position)) < reach)
        expected.insert(static_cast<std::uint32_t>(j));
    }
    EXPECT_EQ(near, expected) << i;
    found += near.size();
  }
  EXPECT_GT(found, list.size());  // not only themselves
}

TEST_P(Levels, OrderInSpaceHoldsEveryBodyOnce) {
  const std::vector<dem::Motion> list = bodies();
  std::vector<std::uint32_t> order = dem::order_in_space(list, allowances(list.size()), box());
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), list.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Levels,
                         testing::Values(Case{1, false, false}, Case{1, true, false}, Case{5, false, true},
                                         Case{30, false, false}, Case{30, true, false}, Case{1000, true, true},
                                         Case{1e9, false, false}));

TEST(LevelsOfNoBodies, AreNone) {
  const std::vector<dem::Motion> none;
  const std::vector<double> allowance;
  EXPECT_NO_THROW(dem::Levels(none, allowance, {}));
  EXPECT_TRUE(dem::order_in_space(none, allowance, {}).empty());
}

}  // namespace
