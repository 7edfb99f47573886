// Forces as a graph: clusters, percolation and chains against floods of all pairs; distributions in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <queue>
#include <set>

#include "libdem/analysis/force_chains.h"
#include "libdem/analysis/force_network.h"
#include "libdem/analysis/histogram.h"
#include "libdem/analysis/report_forces.h"
#include "libdem/analysis/write.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

// The images of bodies that body i is joined to by contacts of at least this force, by a flood over (body, cell).
using Image = std::pair<std::uint32_t, std::array<int, 3>>;
std::set<Image> flood(const Snapshot& s, std::uint32_t start, double least) {
  std::set<Image> seen{{start, {}}};
  std::queue<Image> next;
  next.push({start, {}});
  while (!next.empty()) {
    const auto [i, cell] = next.front();
    next.pop();
    for (const SnapshotContact& c : s.contacts) {
      if (c.pressing() < least || (c.a != i && c.b != i)) continue;
      const std::uint32_t j = c.a == i ? c.b : c.a;
      std::array<int, 3> to = cell;
      bool near = true;
      for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        if (!s.periodic[axis]) continue;
        const double there = s.position[i][k] + (c.a == i ? 1 : -1) * c.branch[k];
        to[axis] += static_cast<int>(std::lround((there - s.position[j][k]) / s.length[k]));
        near = near && std::abs(to[axis]) <= 3;
      }
      if (near && seen.insert({j, to}).second) next.push({j, to});
    }
  }
  return seen;
}

bool goes_through(const Snapshot& s, const Domain& region, int axis, double least) {
  double reach = 0;
  for (const double r : s.bounding_radius) reach += r / static_cast<double>(s.count());
  const auto at = static_cast<std::size_t>(axis);
  for (std::uint32_t i = 0; i < s.count(); ++i) {
    const bool low = s.position[i][axis] - s.radius[i] - reach <= region.lower[axis];
    if (!s.periodic[at] && !low) continue;
    const std::set<Image> met = flood(s, i, least);
    if (met.size() < 2) continue;
    for (const auto& [j, cell] : met) {
      if (s.periodic[at] && j == i && cell[at] != 0) return true;
      if (!s.periodic[at] && s.position[j][axis] + s.radius[j] + reach >= region.upper[axis]) return true;
    }
  }
  return false;
}

TEST(AnalysisForces, PercolationIsThatOfAFlood) {
  int found = 0, missed = 0;
  for (const bool periodic : {false, true})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Snapshot s = sets::thrown(seed < 3 ? 60 : 45, periodic, seed, seed < 3 ? 3 : 2);
      const Domain region = domain_of(s);
      const ForceNetwork n = force_network_of(s, pairs_of(s), region, 1);
      for (int axis = 0; axis < s.dimension; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        EXPECT_EQ(n.percolates[k], goes_through(s, region, axis, n.threshold));
        EXPECT_EQ(n.critical[k].has_value(), goes_through(s, region, axis, 1e-300));
        ++(n.critical[k] ? found : missed);
        if (!n.critical[k]) continue;
        EXPECT_TRUE(goes_through(s, region, axis, *n.critical[k]));
        EXPECT_FALSE(goes_through(s, region, axis, *n.critical[k] * (1 + 1e-12)));
      }
    }
  EXPECT_GT(found, 3);
  EXPECT_GT(missed, 3);
}

TEST(AnalysisForces, ClustersAreThoseOfAFlood) {
  const Snapshot s = sets::thrown(200, true, 7);
  const ForceNetwork n = force_network_of(s, pairs_of(s), domain_of(s), 1);
  std::vector<std::uint32_t> sizes;
  std::set<std::uint32_t> done;
  for (std::uint32_t i = 0; i < s.count(); ++i) {
    if (done.contains(i)) continue;
    std::set<std::uint32_t> met;
    for (const auto& [j, cell] : flood(s, i, n.threshold)) met.insert(j);
    done.insert(met.begin(), met.end());
    for (const std::uint32_t j : met)
      EXPECT_EQ(n.clusters.of_body[j], met.size() > 1 ? n.clusters.of_body[i] : Clusters::none);
    if (met.size() > 1) sizes.push_back(static_cast<std::uint32_t>(met.size()));
  }
  std::sort(sizes.rbegin(), sizes.rend());
  EXPECT_EQ(n.clusters.sizes, sizes);
  EXPECT_GT(sizes.size(), 3u);
}

TEST(AnalysisForces, OrderOfContactsDoesNotMatter) {
  Snapshot s = sets::thrown(300, true, 12);
  const ForceNetwork before = force_network_of(s, pairs_of(s), domain_of(s), 1);
  std::reverse(s.contacts.begin(), s.contacts.end());
  const ForceNetwork after = force_network_of(s, pairs_of(s), domain_of(s), 1);
  EXPECT_EQ(before.clusters.of_body, after.clusters.of_body);
  EXPECT_EQ(before.critical, after.critical);
}

// A column of discs under a load, between weaker ones that touch it from the side.
TEST(AnalysisForces, ColumnIsAChain) {
  Snapshot s;
  s.dimension = 2;
  for (int i = 0; i < 6; ++i) sets::add_body(s, {0, 1.0 * i, 0}, 0.5);
  for (int i = 0; i < 6; ++i) sets::add_body(s, {1, 1.0 * i, 0}, 0.5);
  s.walls.resize(2);
  for (std::size_t i = 0; i + 1 < 6; ++i) sets::touch(s, i, i + 1, 10);
  for (std::size_t i = 0; i < 6; ++i) sets::touch(s, i, i + 6, 1);
  sets::touch_wall(s, 0, 0, {0, -1, 0}, 10);
  sets::touch_wall(s, 5, 1, {0, 1, 0}, 10);
  const double pi = std::numbers::pi;
  const Mat3d stress = body_stresses(s)[2];
  EXPECT_NEAR(stress.row[1].y, 2 * 0.5 * 10 / (pi / 4), 1e-12);  // 2 R F / V
  EXPECT_NEAR(stress.row[0].x, 0.5 * 1 / (pi / 4), 1e-12);
  const Pairs pairs = pairs_of(s);
  const ForceChains c = force_chains_of(s, pairs);
  ASSERT_EQ(c.chains.size(), 1u);
  EXPECT_EQ(c.chains[0].bodies, 6u);
  EXPECT_EQ(c.chains[0].links, 5u);
  EXPECT_EQ(c.chains[0].branches, 0u);
  EXPECT_NEAR(c.chains[0].length, 5, 1e-14);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(c.of_body[i], 0u);
  for (std::size_t i = 6; i < 12; ++i) EXPECT_EQ(c.of_body[i], Clusters::none);
  const Result r = report_forces(s, {});
  EXPECT_EQ(scalar(r, "strong_share"), 5.0 / 11);
  EXPECT_EQ(scalar(r, "largest_cluster"), 6);
  EXPECT_EQ(scalar(r, "percolates_y"), 1);
  EXPECT_EQ(scalar(r, "percolates_x"), 0);  // the loaded column stands at one side
  EXPECT_EQ(scalar(r, "bodies_in_chains"), 0.5);
  for (const Table& t : r.tables) {
    if (t.name != "bodies") continue;
    const std::vector<double>& chain = t.columns.back().values;
    EXPECT_EQ(std::count(chain.begin(), chain.end(), -1.0),
              std::count(chain.begin(), chain.end(), 0.0));  // none; the one
    EXPECT_EQ(std::count(chain.begin(), chain.end(), -1.0), static_cast<std::ptrdiff_t>(s.count() / 2));
  }
  // A bend of more than 45° breaks it: the upper half leans over.
  for (int i = 1; i < 4; ++i)
    s.position[static_cast<std::size_t>(i) + 2] = {std::sin(1.0) * i, 2 + std::cos(1.0) * i, 0};
  s.contacts.clear();
  for (std::size_t i = 0; i + 1 < 6; ++i) sets::touch(s, i, i + 1, 10);
  sets::touch_wall(s, 0, 0, {0, -1, 0}, 10);
  const ForceChains bent = force_chains_of(s, pairs_of(s));
  for (std::size_t k = 0; k < bent.chains.size(); ++k) EXPECT_LT(bent.chains[k].bodies, 6u);
}

TEST(AnalysisForces, DistributionOfExponentialForces) {
  Snapshot s = sets::simple_cubic(14);  // 8232 contacts
  Random random(4, 0, 0);
  double sum = 0;
  for (SnapshotContact& c : s.contacts) {
    const double f = -std::log(1 - random.uniform());
    c.force = c.normal * -f;
    sum += f;
  }
  const Result r = report_forces(s, {});
  const auto n = static_cast<double>(s.contacts.size());
  EXPECT_NEAR(scalar(r, "mean_normal_force"), sum / n, 1e-12);
  EXPECT_NEAR(scalar(r, "normal_participation"), 0.5, 3 / std::sqrt(n));
  EXPECT_NEAR(scalar(r, "strong_share"), std::exp(-1.0), 3 * 0.48 / std::sqrt(n));
  EXPECT_NEAR(scalar(r, "strong_force_share"), 2 * std::exp(-1.0), 3 / std::sqrt(n));
  bool seen = false;
  for (const Table& t : r.tables) {
    if (t.name != "normal") continue;
    seen = true;
    double total = 0;
    for (std::size_t k = 0; k < t.columns[0].values.size(); ++k) {
      total += t.columns[2].values[k] / 6;  // bins of 1/6
      if (t.columns[0].values[k] > 3) continue;
      const double expected = n / 6 * std::exp(-t.columns[0].values[k]);
      EXPECT_NEAR(t.columns[1].values[k], expected, 4 * std::sqrt(expected) + 0.01 * expected);
    }
    EXPECT_NEAR(total, 1, 1e-12);
  }
  EXPECT_TRUE(seen);
}

TEST(AnalysisForces, MobilisedFriction) {
  Snapshot s;
  for (int i = 0; i < 4; ++i) sets::add_body(s, {1.0 * i, 0, 0}, 0.5);
  sets::touch(s, 0, 1, 2, 0.2);
  sets::touch(s, 1, 2, 2, 0.6);
  sets::touch(s, 2, 3, -1, 0.5);  // pulls
  const Result r = report_forces(s, {});
  EXPECT_NEAR(scalar(r, "mean_mobilised_friction"), 0.2, 1e-15);
  EXPECT_NEAR(scalar(r, "largest_mobilised_friction"), 0.3, 1e-15);
  EXPECT_EQ(scalar(r, "pulling_contacts"), 1);
  EXPECT_NEAR(scalar(r, "mean_tangential_force"), 0.4, 1e-15);
}

TEST(AnalysisForces, LinesGoToTheNearestImage) {
  Snapshot s = sets::simple_cubic();
  s.walls.resize(1);
  sets::touch_wall(s, 3, 0, {0, 0, -1}, 2);
  const Pairs pairs = pairs_of(s);
  const auto lines = network_lines(s, pairs, force_network_of(s, pairs, domain_of(s), 1));
  ASSERT_EQ(lines.size(), pairs.bodies.size() + 1);
  for (const NetworkLine& l : lines) EXPECT_NEAR(norm(l.to - l.from), l.wall ? 0.5 : 1, 1e-12);
  EXPECT_EQ(lines.back().relative, 2);
  const std::string path = ::testing::TempDir() + "analysis_forces_network.vtp";
  write_surface(network_surface(lines), path);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("NumberOfLines=\"193\""), std::string::npos);
}

TEST(AnalysisForces, NothingToSayIsSaid) {
  Snapshot s;
  EXPECT_EQ(report_forces(s, {}).notes.size(), 1u);
  sets::add_body(s, {}, 0.5);
  EXPECT_EQ(report_forces(s, {}).notes.size(), 1u);
  sets::add_body(s, {1, 0, 0}, 0.5);
  sets::touch(s, 0, 1, 0);
  const Result r = report_forces(s, {});
  EXPECT_EQ(r.notes.size(), 1u);
  for (const Scalar& x : r.scalars) EXPECT_TRUE(std::isfinite(x.value));
  s.has_forces = false;
  EXPECT_TRUE(report_forces(s, {}).scalars.empty());
}

}  // namespace
}  // namespace dem::analysis
