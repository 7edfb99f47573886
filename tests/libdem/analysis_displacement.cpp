// Displacement, strain and rotation: exact for affine motion, in boxes, about bodies, across periodic faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "libdem/analysis/displacement.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/near_bodies.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

const Mat3d stretch{{{0.02, 0.1, 0.03}, {-0.05, -0.04, 0.01}, {0.02, -0.03, 0.05}}};
const Mat3d planar_stretch{{{0.02, 0.1, 0}, {-0.05, -0.04, 0}, {0, 0, 0}}};

Snapshot moved(const Snapshot& s, const Mat3d& g, const Vec3d& by) {
  Snapshot now = s;
  now.time = s.time + 2;
  for (Vec3d& x : now.position) x += g * x + by;
  return now;
}

void expect_same(const Mat3d& a, const Mat3d& b, double within) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(a.row[i][j], b.row[i][j], within);
}

TEST(AnalysisDisplacement, NearBodiesAreThoseOfAllPairs) {
  for (const bool periodic : {false, true})
    for (const int dimension : {2, 3})
      for (const double range : {0.08, 0.3, 0.5}) {
        const Snapshot s = sets::thrown(250, periodic, 8, dimension);
        const NearBodies near(s, range);
        for (std::uint32_t i = 0; i < s.count(); ++i) {
          std::multiset<std::uint32_t> expected, found;
          for (std::uint32_t j = 0; j < s.count(); ++j)
            if (j != i && norm(s.between(s.position[i], s.position[j])) <= range) expected.insert(j);
          near.each(i, [&](std::uint32_t j, const Vec3d& d) {
            found.insert(j);
            EXPECT_EQ(norm(d - s.between(s.position[i], s.position[j])), 0);
          });
          ASSERT_EQ(found, expected);
        }
      }
}

TEST(AnalysisDisplacement, AffineMotionIsFoundExactly) {
  for (const int dimension : {2, 3}) {
    const Snapshot before = sets::thrown(400, false, 5, dimension);
    const Mat3d& g = dimension == 2 ? planar_stretch : stretch;
    const Snapshot now = moved(before, g, dimension == 2 ? Vec3d{1, -2, 0} : Vec3d{1, -2, 0.3});
    const Displacements u = displacements(now, before);
    EXPECT_EQ(u.known, 400u);
    std::size_t fitted = 0;
    for (const LocalGradient& local : displacement_gradients(now, before, u)) {
      if (!local.fitted) continue;
      ++fitted;
      expect_same(local.gradient, g, 1e-9);
      EXPECT_NEAR(std::sqrt(local.left_over), 0, 1e-8);
    }
    EXPECT_GT(fitted, 350u);
    const Grid grid(before, domain_of(before), {2, 2, 2});
    for (const LocalGradient& box : box_gradients(now, before, u, grid)) {
      ASSERT_TRUE(box.fitted);
      expect_same(box.gradient, g, 1e-12);
    }
  }
}

TEST(AnalysisDisplacement, CellThatDeformsIsAffineAcrossItsFaces) {
  Snapshot before = sets::thrown(300, true, 6);
  Snapshot now = before;
  const Vec3d rate{0.1, -0.05, 0.02};
  for (int k = 0; k < 3; ++k) {
    now.length[k] *= 1 + rate[k];
    now.lower[k] = -0.3;
    for (std::size_t i = 0; i < now.count(); ++i) {
      double x = before.position[i][k] + 0.35;  // a drift that takes bodies through the faces
      x -= std::floor(x);
      now.position[i][k] = now.lower[k] + x * now.length[k];
    }
  }
  const Displacements u = displacements(now, before);
  for (const LocalGradient& local : displacement_gradients(now, before, u)) {
    if (local.fitted) expect_same(local.gradient, Mat3d::diagonal(rate), 1e-9);
  }
}

TEST(AnalysisDisplacement, TurningIsNoStrain) {
  const Snapshot before = sets::thrown(200, false, 5);
  Mat3d g = rotation_matrix(normalized(Quatd{0.9, 0.2, -0.3, 0.4}));
  for (int i = 0; i < 3; ++i) g.row[i][i] -= 1;
  EXPECT_LT(deviator(finite_strain(g), 3), 1e-15);
  EXPECT_NEAR(volume_change(g), 0, 1e-15);
  const Mat3d shear{{{0, 0.3, 0}, {0, 0, 0}, {0, 0, 0}}};
  EXPECT_NEAR(finite_strain(shear).row[0].y, 0.15, 1e-15);
  EXPECT_NEAR(finite_strain(shear).row[1].y, 0.045, 1e-15);
  EXPECT_NEAR(curl_of(shear).z, -0.3, 1e-15);
  EXPECT_NEAR(volume_change(Mat3d::diagonal({0.1, 0.2, -0.1})), 1.1 * 1.2 * 0.9 - 1, 1e-15);
}

TEST(AnalysisDisplacement, VelocitiesOfARigidBodyHaveItsVorticity) {
  Snapshot s = sets::thrown(300, false, 4);
  const Vec3d spin{0.5, -1, 2};
  for (std::size_t i = 0; i < s.count(); ++i) s.velocity[i] = cross(spin, s.position[i]) + Vec3d{3, 4, 5};
  std::size_t fitted = 0;
  for (const LocalGradient& local : velocity_gradients(s)) {
    if (!local.fitted) continue;
    ++fitted;
    EXPECT_NEAR(norm(curl_of(local.gradient) - spin * 2.0), 0, 1e-9);
    EXPECT_NEAR(trace(local.gradient), 0, 1e-9);
  }
  EXPECT_GT(fitted, 250u);
}

TEST(AnalysisDisplacement, NonAffineMotionIsLeftOver) {
  // One body of a lattice moves by itself: Σ|u − G x|² of its own neighbourhood is n |u|² (the fit of a constant: 0).
  Snapshot before = sets::simple_cubic(5);
  Snapshot now = before;
  now.position[62] += Vec3d{0, 0, 0.1};
  const Displacements u = displacements(now, before);
  const LocalGradient own = displacement_gradients(now, before, u, 1.01).at(62);
  EXPECT_EQ(own.neighbours, 6u);
  EXPECT_TRUE(own.fitted);
  EXPECT_NEAR(own.left_over, 0.01, 1e-14);
}

TEST(AnalysisDisplacement, BodiesThatComeAndGo) {
  Snapshot before = sets::thrown(200, false, 3);
  Snapshot now = moved(before, stretch, {});
  for (std::size_t i = 100; i < 200; ++i) now.id[i] += 1000;
  const Displacements u = displacements(now, before);
  EXPECT_EQ(u.known, 100u);
  const auto local = displacement_gradients(now, before, u, 0.4);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(local[i].fitted, i < 100);
    if (i < 100) expect_same(local[i].gradient, stretch, 1e-9);
  }
}

TEST(AnalysisDisplacement, ReportIsFiniteAndSaysWhatLacks) {
  const Snapshot before = sets::thrown(60, false, 3);
  const Snapshot now = moved(before, stretch, {0.1, 0, 0});
  Settings settings;
  settings.reference = &before;
  const Snapshot lone = [] {
    Snapshot s;
    sets::add_body(s, {}, 1);
    return s;
  }();
  for (const Snapshot* s : {&now, &lone})
    for (const bool referred : {false, true}) {
      settings.reference = referred ? &before : nullptr;
      const Result r = report_displacement(*s, settings);
      for (const Scalar& x : r.scalars) EXPECT_TRUE(std::isfinite(x.value)) << x.name;
      for (const Table& t : r.tables)
        for (const Column& c : t.columns) {
          EXPECT_EQ(c.values.size(), t.columns[0].values.size()) << c.name;
          for (const double v : c.values) EXPECT_TRUE(std::isfinite(v)) << c.name;
        }
      EXPECT_EQ(r.notes.empty(), false);
    }
  EXPECT_EQ(report_displacement(Snapshot{}, {}).notes.size(), 1u);
}

}  // namespace
}  // namespace dem::analysis
