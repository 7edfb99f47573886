// Radial distribution: shells of lattices at their radii with their counts, random sets against counting every pair,
// and no bias where a box ends.
#include <gtest/gtest.h>

#include "libdem/analysis/rdf.h"
#include "libdem/scene/where.h"
#include "tests/libdem/analysis_lattices.h"

namespace dem::analysis {
namespace {

Domain cell_of(const Snapshot& s) { return {s.lower, s.lower + s.length}; }
Domain unit_box(const Snapshot& s) { return {{0, 0, 0}, {1, 1, s.dimension == 2 ? 0.0 : 1.0}}; }

Groups by_species(const Snapshot& s) { return groups_of(s, "species", nullptr); }

TEST(AnalysisRdf, LatticesHaveTheirShells) {
  for (const Lattice& l : lattices()) {
    const Snapshot s = lattice_of(l, {6, 6, 6}, {0.1, 0.2, 0.3});
    const double range = l.shells.back().first + 0.0123;  // up to where the list goes
    const Rdf rdf = rdf_of(s, by_species(s), cell_of(s), range, 1000);
    ASSERT_FALSE(rdf.bounded);
    std::vector<double> expected(1000, 0.0);
    for (const auto& [r, count] : l.shells) {
      const double at = r / rdf.width;
      ASSERT_GT(std::fabs(at - std::round(at)), 1e-6);  // no shell on an edge of bins
      if (r < range) expected[static_cast<std::size_t>(at)] += count;
    }
    for (std::size_t k = 0; k < 1000; ++k) {
      EXPECT_EQ(rdf.pairs[0].count[k], expected[k]) << l.name << " in bin " << k;
      if (!(expected[k] > 0)) continue;
      const double a = rdf.width * static_cast<double>(k), b = a + rdf.width;
      const double pi = std::numbers::pi;
      const double shell = l.dimension == 2 ? pi * (b * b - a * a) : 4 * pi / 3 * (b * b * b - a * a * a);
      EXPECT_NEAR(rdf.pairs[0].g[k] * shell / (expected[k] * l.voronoi_volume), 1, 1e-12);
    }
  }
}

// Counting every ordered pair, shells by the definition.
struct Counted {
  std::vector<double> count, shell;
};
Counted by_force(const Snapshot& s, const Domain& region, double range, int bins, std::uint32_t a, std::uint32_t b) {
  const Groups groups = by_species(s);
  Counted c{std::vector<double>(static_cast<std::size_t>(bins)), {}};
  double about = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (a != Groups::none && groups.of_body[i] != a) continue;
    if (!s.periodic[0] && !region.holds(s.position[i])) continue;
    ++about;
    for (std::size_t j = 0; j < s.count(); ++j) {
      if (j == i || (b != Groups::none && groups.of_body[j] != b)) continue;
      if (!s.periodic[0] && !region.holds(s.position[j])) continue;
      const double r = norm(s.between(s.position[i], s.position[j]));
      if (r < range) ++c.count[static_cast<std::size_t>(r / range * bins)];
    }
  }
  for (double& n : c.count) n /= about;
  return c;
}

TEST(AnalysisRdf, CountsAreThoseOfEveryPair) {
  for (const int dimension : {2, 3})
    for (const bool periodic : {false, true}) {
      Snapshot s = random_rounds(400, 0.01, 0.03, periodic, dimension);
      s.species_names = {"red", "blue"};
      for (std::size_t i = 0; i < s.count(); ++i) s.species[i] = static_cast<std::uint32_t>(i % 7 == 0 ? 0 : i % 3);
      for (const double range : {0.1, 0.22, 0.49}) {
        const Rdf rdf = rdf_of(s, by_species(s), unit_box(s), range, 20);
        ASSERT_EQ(rdf.pairs.size(), 10u);
        for (const PairDistribution& p : rdf.pairs)
          EXPECT_EQ(p.count, by_force(s, unit_box(s), range, 20, p.a, p.b).count);
      }
    }
}

TEST(AnalysisRdf, ARegionInsideCountsItsOwnBodies) {
  const Snapshot s = random_rounds(600, 0.01, 0.03, false);
  const Domain region{{0.2, 0.1, 0.3}, {0.9, 0.8, 0.7}};
  const Rdf rdf = rdf_of(s, by_species(s), region, 0.3, 15);
  EXPECT_EQ(rdf.pairs[0].count, by_force(s, region, 0.3, 15, Groups::none, Groups::none).count);
  EXPECT_TRUE(rdf.bounded);
}

TEST(AnalysisRdf, SharesOfShellsAreThoseOfPoints) {
  // Two bodies, one in a corner: g n̄ S = count; S from points at random in the shell.
  for (const int dimension : {2, 3}) {
    Snapshot s;
    s.dimension = dimension;
    add_round(s, {0.1, 0.2, dimension == 2 ? 0 : 0.15}, 0.1);
    add_round(s, {0.5, 0.6, dimension == 2 ? 0 : 0.55}, 0.1);
    const Rdf rdf = rdf_of(s, by_species(s), unit_box(s), 1, 4);
    Random random(5, 0, 0);
    std::vector<double> share(4);
    const int points = 400000;
    for (int p = 0; p < points; ++p) {
      const Vec3d x{random.uniform(), random.uniform(), dimension == 2 ? 0 : random.uniform()};
      for (const Vec3d& c : s.position)
        if (norm(x - c) < 1) share[static_cast<std::size_t>(norm(x - c) * 4)] += 1.0 / points;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      if (!(rdf.pairs[0].g[k] > 0)) continue;
      const double space = rdf.pairs[0].count[k] * 2 / (2 * rdf.pairs[0].g[k]);  // Σ of the two shells
      EXPECT_NEAR(space, share[k], 0.01 * share[k]) << dimension << " " << k;
    }
  }
}

TEST(AnalysisRdf, NoBiasAtBoundariesOfRandomPoints) {
  // Independent points: g = 1 − 1/N everywhere; uncorrected it would be 0.4 at the far end.
  double sum = 0, squares = 0;
  constexpr std::uint64_t sets = 12;
  for (std::uint64_t k = 0; k < sets; ++k) {
    const Snapshot s = random_rounds(500, 0, 0, false, 3, k + 1);
    const Rdf rdf = rdf_of(s, by_species(s), unit_box(s), 0.6, 3);
    const double g = rdf.pairs[0].g[2] / (1 - 1.0 / 500);
    sum += g / sets;
    squares += g * g / sets;
  }
  const double error = std::sqrt((squares - sum * sum) / (sets - 1));
  EXPECT_LT(error, 0.005);
  EXPECT_NEAR(sum, 1, 3 * error);
}

TEST(AnalysisRdf, ReportSaysHowAndWhatItCannot) {
  EXPECT_EQ(report_rdf(Snapshot{}, {}).notes, std::vector<std::string>{"no bodies"});
  Snapshot one;
  add_round(one, {0, 0, 0}, 1);
  EXPECT_EQ(report_rdf(one, {}).notes, std::vector<std::string>{"one body has no distances"});
  const Lattice l = lattices()[2];
  Result r = report_rdf(lattice_of(l, {4, 4, 4}), {});
  ASSERT_EQ(r.notes.size(), 2u);  // five diameters do not fit into half the cell
  EXPECT_NE(r.notes[0].find("half the periodic cell"), std::string::npos);
  EXPECT_NEAR(r.scalars[1].value, 1, 0.02);
  Settings far;
  far.region = Domain{{100, 100, 100}, {101, 101, 101}};
  EXPECT_EQ(report_rdf(random_rounds(10, 0.1, 0.1, false), far).notes,
            std::vector<std::string>{"fewer than two bodies in the region"});
  EXPECT_THROW(rdf_of(one, by_species(one), {{0, 0, 0}, {1, 1, 1}}, -1, 10), InputError);
}

}  // namespace
}  // namespace dem::analysis
