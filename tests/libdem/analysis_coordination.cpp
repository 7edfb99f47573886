// Contacts per body: lattices, the figure of eleven bodies, rattlers, random sets against all pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "libdem/analysis/coordination.h"
#include "libdem/rattlers.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

TEST(AnalysisCoordination, Lattices) {
  const std::pair<Snapshot, double> lattices[] = {{sets::simple_cubic(), 6},  {sets::body_centred(), 8},
                                                  {sets::face_centred(), 12}, {sets::close_packed(), 12},
                                                  {sets::square(), 4},        {sets::hexagonal(), 6}};
  for (const auto& [s, z] : lattices) {
    const Pairs pairs = pairs_of(s);
    const Coordination c = coordination_of(s, pairs);
    EXPECT_EQ(c.mean, z);
    EXPECT_EQ(c.mechanical, z);
    EXPECT_EQ(backbone_of(s, pairs, c, 2).mean, z);
    EXPECT_TRUE(std::all_of(c.of_body.begin(), c.of_body.end(), [z](std::uint32_t n) { return n == z; }));
    // A region has the same mean as the whole.
    const Domain part{{0.3, 0.3, 0.3}, {2.1, 2.4, 1.9}};
    const Coordination of_part = coordination_of(s, pairs, part);
    EXPECT_EQ(of_part.mean, z);
    EXPECT_LT(of_part.bodies, s.count());
  }
}

// Eleven bodies with 0, 2, 3, 3, 2, 2, 2, 3, 3, 3, 1 contacts.
Snapshot eleven() {
  Snapshot s;
  for (int i = 0; i < 11; ++i) sets::add_body(s, {0.4 * i, 0.1 * i * i, 0}, 0.5);
  const std::size_t met[][2] = {{2, 3}, {2, 4}, {3, 4}, {3, 5},  {4, 6},  {5, 7},
                                {6, 8}, {7, 9}, {8, 9}, {8, 10}, {9, 10}, {10, 11}};
  for (const auto& m : met) sets::touch(s, m[0] - 1, m[1] - 1);
  return s;
}

TEST(AnalysisCoordination, ElevenBodies) {
  const Snapshot s = eleven();
  const Pairs pairs = pairs_of(s);
  const Coordination c = coordination_of(s, pairs);
  EXPECT_EQ(c.of_body, (std::vector<std::uint32_t>{0, 2, 3, 3, 2, 2, 2, 3, 3, 3, 1}));
  EXPECT_DOUBLE_EQ(c.mean, 24.0 / 11);
  EXPECT_DOUBLE_EQ(*c.mechanical, 23.0 / 9);
  EXPECT_DOUBLE_EQ(*c.mechanical_both_ends, 22.0 / 9);
  const Backbone b = backbone_of(s, pairs, c, 2);
  EXPECT_DOUBLE_EQ(*b.mean, 22.0 / 9);
  EXPECT_EQ(b.rattlers, 2u);
  EXPECT_FALSE(backbone_of(s, pairs, c, 4).mean);
  const Result r = report_coordination(s, {});
  EXPECT_DOUBLE_EQ(scalar(r, "coordination"), 24.0 / 11);
  EXPECT_DOUBLE_EQ(scalar(r, "mechanical_coordination"), 23.0 / 9);
}

TEST(AnalysisCoordination, ChainsOfRattlersGoOneAfterTheOther) {
  Snapshot s = eleven();
  for (int i = 11; i < 14; ++i) {  // a tail of four from body 10, which ends at a wall
    sets::add_body(s, {0.4 * i, 0.1 * i * i, 0}, 0.5);
    sets::touch(s, static_cast<std::size_t>(i) - 1, static_cast<std::size_t>(i));
  }
  Coordination c = coordination_of(s, pairs_of(s));
  EXPECT_DOUBLE_EQ(*c.mechanical, (2.0 * 15 - 1) / (14 - 2));
  EXPECT_EQ(backbone_of(s, pairs_of(s), c, 2).rattlers, 5u);
  EXPECT_DOUBLE_EQ(*backbone_of(s, pairs_of(s), c, 2).mean, 22.0 / 9);
  s.walls.emplace_back();
  sets::touch_wall(s, 13, 0, {0, 1, 0});
  c = coordination_of(s, pairs_of(s));
  EXPECT_EQ(backbone_of(s, pairs_of(s), c, 2).rattlers, 1u);
  EXPECT_DOUBLE_EQ(c.mean_with_walls, 31.0 / 14);
}

TEST(AnalysisCoordination, RattlersOfRandomSetsAreThoseOfRepeatedPasses) {
  const Snapshot s = sets::thrown(500, true, 9);
  std::vector<BodyPair> pairs;
  for (const Pair& p : pairs_of(s).bodies) pairs.emplace_back(p.a, p.b);
  for (const std::uint32_t least : {2u, 3u, 4u}) {
    std::vector<std::uint8_t> gone(s.count(), 0);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < s.count(); ++i) {
        std::uint32_t n = 0;
        for (const auto& [a, b] : pairs) n += (a == i && gone[b] == 0) || (b == i && gone[a] == 0) ? 1 : 0;
        if (gone[i] != 0 || n >= least) continue;
        gone[i] = 1;
        changed = true;
      }
    }
    EXPECT_EQ(rattlers(s.count(), pairs, {}, least), gone);
    EXPECT_NE(std::count(gone.begin(), gone.end(), 1), 0);
  }
}

TEST(AnalysisCoordination, LinesOfDensity) {
  EXPECT_NEAR(line_of_ordered(0.740480), 12.105, 1e-3);
  EXPECT_NEAR(line_of_ordered(0.523599), 6.594, 1e-3);
  EXPECT_NEAR(line_of_random(0.64), 6.946, 1e-3);
  EXPECT_NEAR(line_of_random(0.680175), 7.256, 1e-3);
  EXPECT_EQ(line_of_random(1), 14);
  EXPECT_NEAR(scalar(report_coordination(sets::simple_cubic(), {}), "line_9_45"), 6.154, 1e-3);
}

TEST(AnalysisCoordination, SpeciesMeetEachOther) {
  Snapshot s = sets::simple_cubic();
  for (std::size_t i = 0; i < s.count(); ++i) {
    const Vec3d& x = s.position[i];
    s.species[i] = 1 + static_cast<std::uint32_t>(std::lround(x.x + x.y + x.z)) % 2;
  }
  for (const Table& t : report_coordination(s, {}).tables) {
    if (t.name != "species") continue;
    EXPECT_EQ(t.columns[3].values, (std::vector<double>{0, 6, 6, 0}));
  }
}

TEST(AnalysisCoordination, NothingToCountIsSaid) {
  Snapshot s;
  EXPECT_TRUE(report_coordination(s, {}).scalars.empty());
  EXPECT_EQ(report_coordination(s, {}).notes.size(), 1u);
  sets::add_body(s, {}, 1);
  const Result one = report_coordination(s, {});
  EXPECT_EQ(scalar(one, "coordination"), 0);
  EXPECT_TRUE(std::none_of(one.scalars.begin(), one.scalars.end(), [](const Scalar& x) {
    return x.name == "mechanical_coordination" || !std::isfinite(x.value);
  }));
  s.has_contacts = false;
  EXPECT_TRUE(report_coordination(s, {}).scalars.empty());
}

}  // namespace
}  // namespace dem::analysis
