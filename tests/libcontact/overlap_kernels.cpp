// The kernels of overlap_sums.h, each set of them: what they find against plain loops, and the same bits in every set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/overlap_sums.h"

namespace {

using namespace contact;
using namespace contact::kernels;
using shapes::Vec3d;

struct Planes {
  std::vector<double> x, y, z, level;
  Points normals() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

class OverlapKernelSet : public testing::TestWithParam<const KernelSet*> {
 protected:
  const OverlapKernels& set() const { return *GetParam()->overlaps; }
  std::mt19937_64 random_{11};
  std::normal_distribution<double> draw_;
  Vec3d any() { return {draw_(random_), draw_(random_), draw_(random_)}; }

  // `count` planes about the origin, filled up by the first one.
  Planes planes(std::size_t count) {
    Planes p;
    for (std::size_t i = 0; i < (count + 7) / 8 * 8; ++i) {
      const Vec3d n = normalized(any());
      p.x.push_back(i < count ? n.x : p.x[0]);
      p.y.push_back(i < count ? n.y : p.y[0]);
      p.z.push_back(i < count ? n.z : p.z[0]);
      p.level.push_back(i < count ? std::abs(draw_(random_)) : p.level[0]);
    }
    return p;
  }
};

double most_over(const Planes& p, std::size_t i, const std::vector<Vec3d>& corners) {
  double most = -HUGE_VAL;
  for (const Vec3d& c : corners) most = std::max(most, dot(Vec3d{p.x[i], p.y[i], p.z[i]}, c) - p.level[i]);
  return most;
}

TEST_P(OverlapKernelSet, FindsThePlanesThatCornersLieOver) {
  for (const std::size_t count : {1, 6, 9, 16, 17, 60, 131})
    for (const double size : {0.01, 0.3, 2.0})
      for (const std::size_t corners : {4, 6, 11}) {
        const Planes p = planes(count);
        const Vec3d middle = 0.5 * any();
        std::vector<Vec3d> at;
        std::vector<OverlapRow> rows;
        for (std::size_t i = 0; i < corners; ++i) at.push_back(middle + size * any());
        for (std::size_t i = 0; i < (corners + 3) / 4 * 4; ++i) {
          const Vec3d& c = at[i < corners ? i : 0];
          rows.push_back({c.x, c.y, c.z, 0});
        }
        std::vector<std::uint32_t> found(p.x.size()), expected;
        found.resize(set().cutting(p.normals(), p.level.data(), count, rows.data(), rows.size(), found.data()));
        for (std::uint32_t i = 0; i < count; ++i)
          if (most_over(p, i, at) > 0) expected.push_back(i);
        EXPECT_EQ(found, expected) << count << " planes, " << corners << " corners";
      }
}

TEST_P(OverlapKernelSet, KeepsThePlanesThatCutAndNamesTheDeepest) {
  for (const std::size_t count : {1, 3, 4, 7, 13})
    for (int repeat = 0; repeat < 20; ++repeat) {
      const Planes all = planes(count);
      Planes p = all;
      std::vector<Vec3d> at;
      for (int i = 0; i < 7; ++i) at.push_back(any());
      std::size_t deepest = count, most = 0, left = 0;
      const std::size_t kept =
          set().deepest({p.x.data(), p.y.data(), p.z.data(), p.level.data()}, count, at.data(), at.size(), deepest);
      for (std::size_t i = 0; i < count; ++i) {
        if (!(most_over(all, i, at) > 0)) continue;
        ASSERT_LT(left, kept);
        EXPECT_EQ(p.x[left], all.x[i]);
        EXPECT_EQ(p.level[left], all.level[i]);
        if (most_over(p, left, at) > most_over(p, most, at)) most = left;
        ++left;
      }
      EXPECT_EQ(left, kept);
      EXPECT_EQ(deepest, kept > 0 ? most : count);
    }
}

// Two edges through each other: the form whose lists can be written down.
TEST_P(OverlapKernelSet, SumsHaveTheSameBitsInEverySet) {
  const OverlapTriangle cones[4] = {{1, 3, 2}}, others[4] = {{0, 2, 3}, {1, 3, 2}};
  const OverlapSide rim[4] = {{1, 2, 0, 3}, {2, 0, 0, 2}, {0, 3, 1, 2}, {3, 1, 1, 3}};
  for (int repeat = 0; repeat < 50; ++repeat) {
    OverlapRow corner[4], normal[4], places[4];
    const Vec3d e{1, 0.2 * draw_(random_), 0}, f{0.3 * draw_(random_), 1, 0}, at{0.1 * draw_(random_), 0, -0.2};
    const Vec3d x[4] = {-0.5 * e, 0.5 * e, at + 0.5 * f, at - 0.5 * f};
    const Vec3d middle = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    const int faces[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    for (int i = 0; i < 4; ++i) {
      corner[i] = {x[i].x, x[i].y, x[i].z, 0};
      Vec3d n = normalized(cross(x[faces[i][1]] - x[faces[i][0]], x[faces[i][2]] - x[faces[i][0]]));
      if (dot(n, x[faces[i][0]] - middle) < 0) n = -n;
      normal[i] = {n.x, n.y, n.z, 0};
    }
    const OverlapLists lists{corner, normal, cones, others, rim, places, 4, 4, 4, 4, 4};
    DepthSlope mine, narrowest;
    ASSERT_TRUE(set().slope(lists, 1, mine));
    ASSERT_TRUE(kernel_sets().front()->overlaps->slope(lists, 1, narrowest));
    EXPECT_NEAR(mine.volume, std::abs(dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0]))) / 6, 1e-15);
    EXPECT_EQ(std::memcmp(&mine, &narrowest, sizeof mine), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, OverlapKernelSet, testing::ValuesIn(kernel_sets().begin(), kernel_sets().end()),
                         [](const auto& info) { return std::string(info.param->name); });

}  // namespace
