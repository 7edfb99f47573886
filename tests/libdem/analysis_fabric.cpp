// Fabric of lattices in closed form, of random directions within their noise, and its frame independence.
#include <gtest/gtest.h>

#include "libdem/analysis/fabric.h"
#include "libdem/analysis/grid.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

Fabric fabric(const Snapshot& s) { return fabric_of(s, pairs_of(s), domain_of(s)); }

void expect_isotropic(const Mat3d& m, int dimension) {
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j) EXPECT_NEAR(m.row[i][j], i == j ? 1.0 / dimension : 0, 1e-12);
}

TEST(AnalysisFabric, CubicLatticesAreIsotropic) {
  for (const Snapshot& s : {sets::simple_cubic(), sets::body_centred(), sets::face_centred()}) {
    const Fabric f = fabric(s);
    expect_isotropic(f.normals.second(), 3);
    expect_isotropic(f.branches.second(), 3);
    expect_isotropic(f.forces.second(), 3);
    EXPECT_NEAR(f.mean_branch, 1, 1e-12);
    EXPECT_LT(deviator(f.normals.second(), 3), 1e-12);
  }
  expect_isotropic(fabric(sets::square()).normals.second(), 2);
  expect_isotropic(fabric(sets::hexagonal()).normals.second(), 2);
  expect_isotropic(fabric(sets::close_packed()).normals.second(), 3);  // the ideal ratio of its axes
}

TEST(AnalysisFabric, FourthOrderTellsLatticesApart) {
  // <x⁴>, <x²y²>: SC directions x; BCC (1,1,1)/√3; FCC (1,1,0)/√2; HCP about z as isotropic, <z⁴> = 6 (2/3)²/12.
  const Fabric sc = fabric(sets::simple_cubic()), bcc = fabric(sets::body_centred()),
               fcc = fabric(sets::face_centred()), hcp = fabric(sets::close_packed());
  EXPECT_NEAR(sc.normals.fourth(0, 0, 0, 0), 1.0 / 3, 1e-12);
  EXPECT_NEAR(sc.normals.fourth(0, 1, 0, 1), 0, 1e-12);
  EXPECT_NEAR(bcc.normals.fourth(2, 2, 2, 2), 1.0 / 9, 1e-12);
  EXPECT_NEAR(bcc.normals.fourth(1, 1, 2, 2), 1.0 / 9, 1e-12);
  EXPECT_NEAR(fcc.normals.fourth(1, 1, 1, 1), 1.0 / 6, 1e-12);
  EXPECT_NEAR(fcc.normals.fourth(2, 0, 2, 0), 1.0 / 12, 1e-12);
  EXPECT_NEAR(hcp.normals.fourth(2, 2, 2, 2), 2.0 / 9, 1e-12);
  EXPECT_NEAR(hcp.normals.fourth(0, 0, 0, 0), 3 * hcp.normals.fourth(0, 0, 1, 1), 1e-12);
  // Contraction of the fourth order is the second.
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += hcp.normals.fourth(2, 2, k, k);
  EXPECT_NEAR(sum, hcp.normals.second().row[2].z, 1e-12);
}

TEST(AnalysisFabric, FactorOfFaceCentred) {
  const Fabric f = fabric(sets::face_centred());
  EXPECT_NEAR(f.factor, 8.485281374, 1e-8);  // trace of F, d = 1
}

TEST(AnalysisFabric, RandomNormalsAreIsotropicWithinTheirNoise) {
  for (const int dimension : {2, 3}) {
    DirectionMoments m;
    Random random(5, 0, 0);
    const double count = 20000;
    for (int i = 0; i < static_cast<int>(count); ++i)
      m.add(rotate(dimension == 3 ? random.rotation() : random.turn(), Vec3d{1, 0, 0}));
    EXPECT_LT(deviator(m.second(), dimension), 3 / std::sqrt(count));
    EXPECT_GT(deviator(m.second(), dimension), 0);
    EXPECT_NEAR(m.fourth(0, 0, 0, 0), dimension == 3 ? 0.2 : 0.375, 3 / std::sqrt(count));
  }
}

TEST(AnalysisFabric, DistributionGivesItsOwnFit) {
  // Plane: E = (1 + A cos 2(θ − θ0))/2π has φ1 − φ2 = A/2; D has the principal values ± A.
  const double a = 0.4, turned = 0.7;
  DirectionMoments m;
  for (int i = 0; i < 1000; ++i) {
    const double t = (i + 0.5) * std::numbers::pi / 1000;
    m.add({std::cos(t), std::sin(t), 0}, 1 + a * std::cos(2 * (t - turned)));
  }
  EXPECT_NEAR(deviator(m.second(), 2), a / 2, 1e-12);
  const Principal p = principal_of(second_order_fit(m.second(), 2), 2);
  EXPECT_NEAR(p.value[0], a, 1e-12);
  EXPECT_NEAR(p.value[1], -a, 1e-12);
  EXPECT_NEAR(std::atan2(p.axis[0].y, p.axis[0].x), turned, 1e-12);
  // Space: E = (1 + D n n)/4π about z, with D = diag(−d/2, −d/2, d).
  const double d = 0.6;
  DirectionMoments space;
  for (int i = 0; i < 4000; ++i)
    for (int k = 0; k < 8; ++k) {
      const double z = (i + 0.5) / 2000 - 1, r = std::sqrt(1 - z * z), t = k * std::numbers::pi / 4;
      space.add({r * std::cos(t), r * std::sin(t), z}, 1 + d * (1.5 * z * z - 0.5));
    }
  const Mat3d fit = second_order_fit(space.second(), 3);
  EXPECT_NEAR(fit.row[2].z, d, 1e-6);
  EXPECT_NEAR(fit.row[0].x, -d / 2, 1e-6);
}

TEST(AnalysisFabric, TurnsWithTheBodies) {
  Snapshot s = sets::thrown(200, false, 6);
  const Mat3d before = fabric(s).normals.second();
  Random random(8, 0, 0);
  const Mat3d r = rotation_matrix(random.rotation());
  for (SnapshotContact& c : s.contacts) {
    c.normal = r * c.normal;
    c.branch = r * c.branch;
    c.force = r * c.force;
  }
  const Mat3d after = fabric(s).normals.second(), expected = r * before * transposed(r);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(after.row[i][j], expected.row[i][j], 1e-13);
  EXPECT_NEAR(deviator(after, 3), deviator(before, 3), 1e-13);
  EXPECT_NEAR(trace(after), 1, 1e-13);
}

TEST(AnalysisFabric, NoContactsIsSaid) {
  Snapshot s;
  sets::add_body(s, {}, 1);
  const Result r = report_fabric(s, {});
  ASSERT_EQ(r.scalars.size(), 1u);
  EXPECT_EQ(r.scalars[0].value, 0);
  EXPECT_EQ(r.notes.size(), 1u);
  for (const Scalar& x : report_fabric(sets::thrown(100, true, 1), {}).scalars) EXPECT_TRUE(std::isfinite(x.value));
}

}  // namespace
}  // namespace dem::analysis
