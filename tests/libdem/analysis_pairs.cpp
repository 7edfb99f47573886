// Records of a snapshot merged per pair of bodies, and who touches whom.
#include <gtest/gtest.h>

#include <set>

#include "libdem/analysis/pairs.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

TEST(AnalysisPairs, SeveralRecordsAreOneContact) {
  Snapshot s;
  sets::add_body(s, {0, 0, 0}, 0.5);
  sets::add_body(s, {1, 0, 0}, 0.5);
  sets::add_body(s, {0, 1, 0}, 0.5);
  sets::touch(s, 0, 1);
  SnapshotContact far = s.contacts[0], near = s.contacts[0];
  far.normal = {0, 1, 0};
  far.point = {0.5, 0.3, 0};
  far.force = {0, -3, 0.5};  // presses with 3, pulls along z
  near.point = {0.5, -0.1, 0};
  near.force = {-1, 0, 0};
  far.overlap = 0.02;
  s.contacts = {near, far};
  sets::touch(s, 0, 2, 2);
  const Pairs pairs = pairs_of(s);
  ASSERT_EQ(pairs.bodies.size(), 2u);
  const Pair& p = pairs.bodies[0];
  EXPECT_EQ(p.count, 2u);
  EXPECT_NEAR(p.point.y, (1 * -0.1 + 3 * 0.3) / 4, 1e-15);
  const double length = std::sqrt(10.0);
  EXPECT_NEAR(norm(p.normal - Vec3d{1 / length, 3 / length, 0}), 0, 1e-15);
  EXPECT_NEAR(p.pressing, (1 * 1 + 3 * 3) / length, 1e-15);
  const Vec3d along = p.force + p.normal * p.pressing;
  EXPECT_NEAR(p.tangential, norm(along), 1e-15);
  EXPECT_NEAR(dot(p.force, p.force), p.pressing * p.pressing + p.tangential * p.tangential, 1e-13);
  EXPECT_EQ(p.overlap, 0.02);
  EXPECT_EQ(pairs.contacts_of(0), 2u);
  EXPECT_EQ(pairs.contacts_of(1), 1u);
  EXPECT_EQ(pairs.partner(0, pairs.pair_of[pairs.start[0] + 1]), 2u);
}

TEST(AnalysisPairs, NoForceAndOppositeNormalsStayFinite) {
  Snapshot s;
  sets::add_body(s, {0, 0, 0}, 0.5);
  sets::add_body(s, {1, 0, 0}, 0.5);
  sets::touch(s, 0, 1, 0);
  s.contacts.push_back(s.contacts[0]);
  s.contacts[1].normal = -s.contacts[0].normal;
  s.contacts[1].point.y = 1;
  const Pair p = pairs_of(s).bodies.at(0);
  EXPECT_TRUE(p.normal == s.contacts[0].normal);
  EXPECT_NEAR(p.point.y, 0.5, 1e-15);
  EXPECT_EQ(p.pressing, 0);
}

TEST(AnalysisPairs, AdjacencyIsThatOfAllAgainstAll) {
  const Snapshot s = sets::thrown(400, true, 3);
  const Pairs pairs = pairs_of(s);
  ASSERT_GT(pairs.bodies.size(), 400u);
  for (std::size_t i = 0; i < s.count(); ++i) {
    std::set<std::size_t> expected, found;
    for (std::size_t j = 0; j < s.count(); ++j)
      if (j != i && norm(s.between(s.position[i], s.position[j])) <= s.radius[i] + s.radius[j]) expected.insert(j);
    for (std::uint32_t k = pairs.start[i]; k < pairs.start[i + 1]; ++k)
      found.insert(pairs.partner(i, pairs.pair_of[k]));
    EXPECT_EQ(found, expected);
  }
}

TEST(AnalysisPairs, OnlyContactsOfTheRegionAreKept) {
  const Snapshot s = sets::thrown(300, false, 4);
  const Pairs all = pairs_of(s);
  const Domain region{{0.2, 0.1, 0}, {0.7, 0.9, 0.5}};
  const Pairs some = within(all, s, region);
  std::size_t expected = 0;
  for (const Pair& p : all.bodies) expected += region.holds(p.point) ? 1 : 0;
  EXPECT_EQ(some.bodies.size(), expected);
  EXPECT_LT(expected, all.bodies.size());
  EXPECT_EQ(some.start.back(), 2 * expected);
}

}  // namespace
}  // namespace dem::analysis
