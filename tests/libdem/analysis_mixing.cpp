// Mixing: segregated, random and even sets against Lacey's limits; groups by every word.
#include <gtest/gtest.h>

#include <algorithm>

#include "libdem/analysis/mixing.h"
#include "libdem/scene/where.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

// 1000 spheres in ten boxes along x; the first `first` of them of species 1, the others of species 2.
Snapshot row(std::size_t first) {
  Snapshot s;
  s.species_names = {"a", "b"};
  for (std::size_t i = 0; i < 1000; ++i) {
    sets::add_body(s, {(static_cast<double>(i) + 0.5) * 0.01, 0.5, 0.5}, 0.001);
    s.species.back() = i < first ? 1 : 2;
  }
  return s;
}
Mixing mixed(const Snapshot& s, int boxes = 10) {
  return mixing_of(s, Grid(s, {{0, 0, 0}, {10, 1, 1}}, {boxes, 1, 1}), groups_of(s, "species", nullptr));
}

TEST(AnalysisMixing, Segregated) {
  const Mixing m = mixed(row(300));
  EXPECT_EQ(m.bodies, 1000u);
  EXPECT_EQ(m.boxes, 10u);
  ASSERT_EQ(m.groups.size(), 2u);
  EXPECT_NEAR(m.groups[0].share, 0.3, 1e-15);
  EXPECT_NEAR(m.groups[0].variance, 0.21, 1e-14);
  EXPECT_NEAR(*m.all.lacey(), 0, 1e-13);
  EXPECT_NEAR(*m.all.intensity(), 1, 1e-13);
  EXPECT_NEAR(*m.groups[0].rsd(), std::sqrt(0.21) / 0.3, 1e-13);
  EXPECT_NEAR(m.groups[0].random, 0.21 / 100, 1e-15);
}

TEST(AnalysisMixing, EvenIsBeyondRandom) {
  Snapshot s = row(500);
  for (std::size_t i = 0; i < 1000; ++i) s.species[i] = 1 + i % 2;
  const Mixing m = mixed(s);
  EXPECT_NEAR(m.all.variance, 0, 1e-15);
  EXPECT_NEAR(*m.all.lacey(), 1 / (1 - 0.01), 1e-12);
}

TEST(AnalysisMixing, RandomDealsHaveTheExactMeanVariance) {
  Snapshot s = row(300);
  Random random(6, 0, 0);
  double sum = 0, square = 0;
  const int deals = 400;
  for (int d = 0; d < deals; ++d) {
    for (std::size_t i = 1000; i-- > 1;) std::swap(s.species[i], s.species[random.bits() % (i + 1)]);
    const double v = mixed(s, 7).groups[0].variance;  // boxes of unequal numbers
    sum += v;
    square += v * v;
  }
  const double mean = sum / deals, error = std::sqrt((square / deals - mean * mean) / deals);
  EXPECT_NEAR(mean, mixed(s, 7).groups[0].random_exact, 3 * error);
  EXPECT_LT(error, 0.05 * mean);
}

TEST(AnalysisMixing, VarianceIsThatOfBruteForce) {
  Snapshot s = sets::thrown(500, false, 2);
  for (std::size_t i = 0; i < s.count(); ++i) s.species[i] = static_cast<std::uint32_t>(i % 3);
  const Grid grid(s, {{0, 0, 0}, {1, 1, 1}}, {3, 4, 2});
  const Mixing m = mixing_of(s, grid, groups_of(s, "species", nullptr));
  for (std::uint32_t g = 0; g < 3; ++g) {
    double variance = 0, share = 0;
    for (std::size_t i = 0; i < s.count(); ++i) share += s.species[i] == g ? 1.0 / 500 : 0;
    for (std::size_t i = 0; i < s.count(); ++i) {
      double there = 0, mine = 0;
      for (std::size_t j = 0; j < s.count(); ++j) {
        if (grid.index(s.position[j]) != grid.index(s.position[i])) continue;
        there += 1;
        mine += s.species[j] == g ? 1 : 0;
      }
      variance += (mine / there - share) * (mine / there - share) / 500;
    }
    EXPECT_NEAR(m.groups[g].variance, variance, 1e-14);
  }
}

TEST(AnalysisMixing, GroupsByEveryWord) {
  Snapshot s = row(500);
  s.gravity = {0, 0, -9.81};
  for (std::size_t i = 0; i < 1000; ++i) {
    s.radius[i] = i % 4 == 0 ? 0.002 : 0.001;
    s.position[i].z = static_cast<double>(i % 10) / 9;
    s.mass[i] = s.volume[i] * (i % 2 == 0 ? 1000 : 2500);
  }
  const auto size_of_group = [](const Groups& g, std::uint32_t k) {
    return std::count(g.of_body.begin(), g.of_body.end(), k);
  };
  const Groups size = groups_of(s, "size", nullptr);
  ASSERT_EQ(size.names.size(), 2u);
  EXPECT_EQ(size_of_group(size, 1), 250);
  EXPECT_EQ(size_of_group(groups_of(s, "density", nullptr), 1), 500);
  EXPECT_EQ(groups_of(s, "material", nullptr).names, (std::vector<std::string>{"stuff"}));
  EXPECT_EQ(groups_of(s, "shape", nullptr).names.size(), 1u);
  const Groups layers = groups_of(s, "layers", nullptr, 5);
  for (std::uint32_t k = 0; k < 5; ++k) EXPECT_EQ(size_of_group(layers, k), 200);
  EXPECT_EQ(layers.of_body[0], 0u);
  EXPECT_EQ(layers.of_body[9], 4u);
  EXPECT_EQ(size_of_group(groups_of(s, "position", nullptr), 0), 500);
  EXPECT_EQ(groups_of(s, "x", nullptr, 4).of_body[999], 3u);
  for (const std::string& word : group_words()) EXPECT_EQ(groups_of(s, word, nullptr).of_body.size(), 1000u);
  try {
    groups_of(s, "colour", nullptr);
    ADD_FAILURE();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("'colour'"), std::string::npos);
  }
  // Many radii: two groups at the mean.
  for (std::size_t i = 0; i < 1000; ++i) s.radius[i] = 1 + 0.001 * static_cast<double>(i);
  EXPECT_EQ(size_of_group(groups_of(s, "size", nullptr), 0), 500);
}

TEST(AnalysisMixing, SlabsAreThoseOfTheReference) {
  Snapshot before = row(500);
  Snapshot now = before;
  std::reverse(now.position.begin(), now.position.end());
  now.id.back() = 5000;  // a body that came later
  const Groups g = groups_of(now, "x", &before, 2);
  EXPECT_EQ(g.of_body[0], 0u);
  EXPECT_EQ(g.of_body[998], 1u);
  EXPECT_EQ(g.of_body[999], Groups::none);
  const Mixing m = mixing_of(now, Grid(now, {{0, 0, 0}, {10, 1, 1}}, {10, 1, 1}), g);
  EXPECT_EQ(m.bodies, 999u);
  EXPECT_NEAR(*m.all.lacey(), 0, 1e-12);
}

TEST(AnalysisMixing, OneGroupOrOneBodyEach) {
  EXPECT_FALSE(mixed(row(1000)).all.lacey());
  EXPECT_FALSE(mixed(row(500), 1000).all.lacey());
  Settings settings;
  EXPECT_EQ(report_mixing(row(1000), settings).scalars.size(), 3u);
  EXPECT_EQ(report_mixing(Snapshot{}, settings).notes.size(), 1u);
}

}  // namespace
}  // namespace dem::analysis
