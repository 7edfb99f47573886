// How contacts of parts share stiffness and history.
#include <gtest/gtest.h>

#include "libdem/contact_share.h"

namespace dem {
namespace {

PartContact contact_of(double overlap, double weight, double cover, const Vec3d& centre = {}) {
  PartContact c;
  c.overlap = overlap;
  c.weight = weight;
  c.cover = cover;
  c.centre = centre;
  return c;
}
// The matrix of direct joints, symmetric, from its upper triangle.
std::vector<double> joints(std::size_t n, std::initializer_list<double> upper) {
  std::vector<double> m(n * n, 0);
  auto v = upper.begin();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) m[i * n + j] = m[j * n + i] = *v++;
  return m;
}

TEST(PartsShare, AContactAloneIsWhole) {
  std::vector<PartContact> c{contact_of(0.1, 3, 1, {1, 2, 3})};
  auto m = joints(1, {});
  share_stiffness(c, m);
  EXPECT_EQ(c[0].share, 1);
  EXPECT_EQ(c[0].common_overlap, 0.1);
  EXPECT_TRUE(c[0].common_centre == (Vec3d{1, 2, 3}));
  c[0].cover = 0.25;
  m = joints(1, {});
  share_stiffness(c, m);
  EXPECT_DOUBLE_EQ(c[0].share, 0.25);
  c[0].cover = 0;
  m = joints(1, {});
  share_stiffness(c, m);
  EXPECT_EQ(c[0].share, 0);
}

TEST(PartsShare, WhatLiesApartKeepsItsOwn) {
  std::vector<PartContact> c{contact_of(0.1, 3, 1), contact_of(0.2, 1, 1)};
  auto m = joints(2, {0});
  share_stiffness(c, m);
  EXPECT_EQ(c[0].share, 1);
  EXPECT_EQ(c[1].share, 1);
  EXPECT_EQ(c[0].common_overlap, 0.1);
}

TEST(PartsShare, SharesOfOneContactAddToOne) {
  // a chain: 0 and 2 do not meet, but both meet 1, at least as deep as the shallower of the two
  std::vector<PartContact> c{contact_of(0.1, 3, 1, {-1, 0, 0}), contact_of(0.3, 1, 1),
                             contact_of(0.2, 2, 1, {2, 0, 0})};
  auto m = joints(3, {0.1, 0, 0.2});
  share_stiffness(c, m);
  EXPECT_DOUBLE_EQ(c[0].share, 0.5);
  EXPECT_DOUBLE_EQ(c[1].share, 1.0 / 6);
  EXPECT_DOUBLE_EQ(c[2].share, 1.0 / 3);
  for (const PartContact& x : c) {
    EXPECT_EQ(x.common_overlap, 0.3);
    EXPECT_NEAR(x.common_centre.x, 1.0 / 6, 1e-15);
  }
  EXPECT_EQ(m[2], 1);  // by way of 1
}

// Through a neck that goes under, a cover that closes, a weight that begins at 0: no jump anywhere.
TEST(PartsShare, NothingJumps) {
  const auto sum = [](double neck, double weight, double cover) {
    std::vector<PartContact> c{contact_of(0.1, 3, 1), contact_of(0.05, weight, cover)};
    auto m = joints(2, {neck});
    share_stiffness(c, m);
    return std::pair(c[0].share * c[0].common_overlap, c[1].share * c[1].common_overlap);
  };
  const double step = 1e-6;
  for (const double weight : {0.5, 2.0})
    for (const double cover : {0.0, 0.3, 1.0})
      for (double neck = 0; neck < 0.07; neck += 0.0005) {
        const auto a = sum(neck, weight, cover), b = sum(neck + step * 0.05, weight, cover);
        EXPECT_NEAR(a.first, b.first, 4 * step);
        EXPECT_NEAR(a.second, b.second, 4 * step);
      }
  for (const double neck : {0.0, 0.02, 0.05}) {
    for (double cover = 0; cover < 1; cover += 0.01) {
      const auto a = sum(neck, 1, cover), b = sum(neck, 1, cover + step);
      EXPECT_NEAR(a.first, b.first, 4 * step);
      EXPECT_NEAR(a.second, b.second, 4 * step);
    }
    EXPECT_EQ(sum(neck, 1, 0).second, 0);
    EXPECT_EQ(sum(neck, 1, 0).first, sum(0, 1, 1).first);  // what is covered takes nothing
  }
  EXPECT_NEAR(sum(0.05, 1e-9, 1).second, 0, 1e-9);
  EXPECT_NEAR(sum(0.05, 1e-9, 1).first, 0.1, 1e-9);
}

TEST(PartsShare, HistoryPassesOnWhole) {
  std::vector<PartContact> c{contact_of(0.1, 3, 1), contact_of(0.1, 1, 1), contact_of(0.2, 1, 1)};
  auto same = joints(3, {0.1, 0, 0});  // 0 and 1 are one, 2 lies apart
  share_stiffness(c, same);
  std::vector<contact::History> h(3);
  h[0] = {{4, 0, 8}, 0.1, {0, 0, 1}, 2};
  h[2] = {{1, 1, 1}, 0.2, {1, 0, 0}, 3};
  pool_histories(c, same, h);
  EXPECT_TRUE(h[0].force_t == (Vec3d{3, 0, 6}));
  EXPECT_TRUE(h[1].force_t == (Vec3d{1, 0, 2}));
  EXPECT_EQ(h[0].twist + h[1].twist, 2);
  EXPECT_EQ(h[1].overlap, 0.1);  // goes on where 0 was
  EXPECT_TRUE(h[1].normal == (Vec3d{0, 0, 1}));
  EXPECT_TRUE(h[2].force_t == (Vec3d{1, 1, 1}));
  // contact 0 is covered by 1: all that it remembers goes on
  c[0].cover = 0;
  same = joints(3, {0.1, 0, 0});
  share_stiffness(c, same);
  pool_histories(c, same, h);
  EXPECT_EQ(c[0].share, 0);
  EXPECT_TRUE(h[1].force_t == (Vec3d{4, 0, 8}));
}

}  // namespace
}  // namespace dem
