// Roses: a lattice's directions and no others, flat for random normals, the fit of a known distribution.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "libdem/analysis/rose.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

std::vector<Pair> pairs_along(const std::vector<Vec3d>& normals) {
  std::vector<Pair> list(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    list[i].normal = normals[i];
    list[i].pressing = 1;
  }
  return list;
}

// The bins that are not empty hold exactly these angles, with equal shares.
void expect_directions(const Rose& rose, std::vector<double> degrees) {
  std::vector<double> found;
  for (std::size_t k = 0; k < rose.number.size(); ++k) {
    if (rose.number[k] <= 0) continue;
    found.push_back(rose.mean_angle[k] * 180 / pi);
    EXPECT_NEAR(rose.number[k], 1 / static_cast<double>(degrees.size()), 1e-14);
    EXPECT_NEAR(rose.force[k], 1 / static_cast<double>(degrees.size()), 1e-14);
  }
  ASSERT_EQ(found.size(), degrees.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], degrees[k], 1e-10);
}

TEST(AnalysisRose, LatticesOfThePlane) {
  for (const int bins : {12, 24, 36, 72, 90, 360}) {
    expect_directions(rose_of(pairs_of(sets::square()).bodies, x_axis, y_axis, bins), {0, 90, 180, 270});
    expect_directions(rose_of(pairs_of(sets::hexagonal()).bodies, x_axis, y_axis, bins), {0, 60, 120, 180, 240, 300});
  }
  // Turned so that directions lie on edges of bins, but for rounding.
  Snapshot s = sets::square();
  Random random(1, 0, 0);
  for (SnapshotContact& c : s.contacts) {
    const double noise = 1e-15 * random.uniform(-1, 1);
    const double turned = std::atan2(c.normal.y, c.normal.x) + pi / 4 + noise;
    c.normal = {std::cos(turned), std::sin(turned), 0};
    c.force = -c.normal;
  }
  expect_directions(rose_of(pairs_of(s).bodies, x_axis, y_axis, 36), {45, 135, 225, 315});
}

TEST(AnalysisRose, PlanesOfLatticesInSpace) {
  const Rose rose = rose_of(pairs_of(sets::simple_cubic()).bodies, x_axis, y_axis, 36);
  expect_directions(rose, {0, 90, 180, 270});
  EXPECT_EQ(rose.across, 64u);  // those along z
  expect_directions(rose_of(pairs_of(sets::body_centred()).bodies, y_axis, z_axis, 36), {45, 135, 225, 315});
}

TEST(AnalysisRose, SphereBinsAreOfEqualAngle) {
  for (const std::size_t wanted : {1u, 2u, 7u, 64u, 206u, 1000u}) {
    const HalfSphereBins bins(wanted);
    ASSERT_EQ(bins.size(), wanted);
    std::vector<double> hits(wanted, 0);
    Random random(2, 0, 0);
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
      const Vec3d n = rotate(random.rotation(), Vec3d{1, 0, 0});
      ASSERT_EQ(bins.index(n), bins.index(-n));
      ++hits[bins.index(n)];
    }
    const double mean = count / static_cast<double>(wanted);
    for (std::size_t k = 0; k < wanted; ++k) {
      EXPECT_NEAR(hits[k], mean, 5 * std::sqrt(mean));
      EXPECT_EQ(bins.index(bins.centre(k)), k);
    }
  }
}

TEST(AnalysisRose, SphereOfLatticesHasTheirDirections) {
  const std::pair<Snapshot, std::size_t> lattices[] = {
      {sets::simple_cubic(), 3}, {sets::body_centred(), 4}, {sets::face_centred(), 6}};
  for (const auto& [s, directions] : lattices)
    for (const std::size_t wanted : {50u, 206u, 800u}) {
      const HalfSphereBins bins(wanted);
      const SphereRose rose = rose_of(pairs_of(s).bodies, bins);
      std::size_t found = 0;
      for (std::size_t k = 0; k < bins.size(); ++k) {
        if (rose.number[k] <= 0) continue;
        ++found;
        EXPECT_NEAR(rose.number[k], 1 / static_cast<double>(directions), 1e-14);
        // A direction of the lattice itself: components 0 or all of one size.
        const Vec3d& n = rose.mean[k];
        const double largest = max_abs(n);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::abs(n[i] / largest), std::round(std::abs(n[i] / largest)), 1e-12);
      }
      EXPECT_EQ(found, directions);
    }
}

TEST(AnalysisRose, RandomNormalsAreFlat) {
  std::vector<Vec3d> space, plane;
  Random random(3, 0, 0);
  const std::size_t count = 40000;
  for (std::size_t i = 0; i < count; ++i) {
    space.push_back(rotate(random.rotation(), x_axis));
    plane.push_back(rotate(random.turn(), x_axis));
  }
  const double noise = 3 / std::sqrt(static_cast<double>(count));
  const Rose rose = rose_of(pairs_along(plane), x_axis, y_axis, 36);
  EXPECT_LT(rose.number_fit.a2, noise);
  EXPECT_LT(rose.number_fit.a4, noise);
  for (const double r : rose.number) EXPECT_NEAR(r * 36, 1, noise * std::sqrt(18.0));
  EXPECT_NEAR(std::accumulate(rose.number.begin(), rose.number.end(), 0.0), 1, 1e-12);
  const HalfSphereBins bins(100);
  const SphereRose sphere = rose_of(pairs_along(space), bins);
  for (const double r : sphere.number) EXPECT_NEAR(r * 100, 1, 1.3 * noise * 10);  // the largest of 100
  EXPECT_NEAR(std::accumulate(sphere.number.begin(), sphere.number.end(), 0.0), 1, 1e-12);
}

TEST(AnalysisRose, FitsAKnownDistribution) {
  const double a2 = 0.3, t2 = 0.4, a4 = 0.1, t4 = 1.2;
  std::vector<Pair> list;
  for (int i = 0; i < 3600; ++i) {
    const double t = (i + 0.5) * pi / 3600;
    Pair p;
    p.normal = {std::cos(t), std::sin(t), 0};
    p.pressing = 1 + a2 * std::cos(2 * (t - t2)) + a4 * std::cos(4 * (t - t4));
    list.push_back(p);
  }
  const Rose rose = rose_of(list, x_axis, y_axis, 36);
  EXPECT_NEAR(rose.force_fit.a2, a2, 1e-12);
  EXPECT_NEAR(rose.force_fit.angle2, t2, 1e-12);
  EXPECT_NEAR(rose.force_fit.a4, a4, 1e-12);
  EXPECT_NEAR(rose.force_fit.angle4, t4, 1e-12);
  EXPECT_LT(rose.number_fit.a2, 1e-12);
  for (std::size_t k = 0; k < 36; ++k)
    EXPECT_NEAR(rose.force[k] / rose.width(), rose.force_fit.density(rose.width() * static_cast<double>(k)), 2e-3);
}

TEST(AnalysisRose, OddBinsAndNoContactsAreSaid) {
  Snapshot s = sets::square();
  Settings settings;
  settings.bins = 35;
  const Result r = report_rose(s, settings);
  EXPECT_EQ(r.notes.size(), 1u);
  EXPECT_EQ(r.tables.at(0).columns.at(0).values.size(), 36u);
  s.contacts.clear();
  EXPECT_EQ(report_rose(s, {}).notes.size(), 1u);
}

}  // namespace
}  // namespace dem::analysis
