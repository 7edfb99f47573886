// A periodic box that follows its stress: it comes to the target, along each axis or with one rate for all, and stays.
#include <gtest/gtest.h>

#include <algorithm>

#include "libdem/deformation.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.005;  // m

DeformSpec servo(const std::string& axes, const Vec3d& target, double rate_limit, bool isotropic = false) {
  DeformSpec d;
  d.stress_axes = axes;
  d.target_stress = target;
  d.rate_limit = rate_limit;
  d.isotropic = isotropic;
  return d;
}

Scene spheres(double edge, LawName law) {
  Scene s;
  s.run.steps = 1;
  s.law.name = law;
  s.materials = {scenes::material("glass", 5e6, 2500, 0.3, 0.3)};
  s.materials[0].stiffness = 2e4;
  s.shapes = {scenes::sphere("ball", radius)};
  s.periodic.axes = "xyz";
  s.periodic.upper = {edge, edge, edge};
  return s;
}

// A simple cubic lattice whose spheres are a little apart.
Scene lattice(LawName law) {
  const double edge = 2 * radius * 1.001;
  Scene s = spheres(4 * edge, law);
  for (int i = 0; i < 64; ++i)
    s.bodies.push_back(scenes::body("ball", "glass", Vec3d{i % 4 + 0.5, i / 4 % 4 + 0.5, i / 16 + 0.5} * edge));
  return s;
}

// `count` spheres at random, apart, in a box that they fill by 0.3: each is tried at random places until one is free.
Scene cloud(int count, double friction) {
  const double edge = std::cbrt(count * 4.18879 / 0.3) * radius;
  Scene s = spheres(edge, LawName::hertz_mindlin);
  s.materials[0].friction = friction;
  Random random(5, 0, 0);
  while (s.bodies.size() < static_cast<std::size_t>(count)) {
    const Vec3d x{random.uniform(0, edge), random.uniform(0, edge), random.uniform(0, edge)};
    const bool free = std::all_of(s.bodies.begin(), s.bodies.end(), [&](const BodySpec& b) {
      Vec3d d = b.position - x;
      for (int k = 0; k < 3; ++k) d[k] -= edge * std::round(d[k] / edge);
      return dot(d, d) > 4 * radius * radius;
    });
    if (free) s.bodies.push_back(scenes::body("ball", "glass", x));
  }
  return s;
}

double mean_stress(const World& w) {
  const Mat3d s = cell_stress(w);
  return (s.row[0].x + s.row[1].y + s.row[2].z) / 3;
}

TEST(CellServo, ALatticeComesToItsTargetsWithoutOvershoot) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin}) {
    Scene s = lattice(law);
    const Vec3d target{2e4, 1e4, 3e4};
    s.periodic.deform = {servo("xyz", target, 2)};
    World w = build_world(s);
    double highest = 0;
    while (w.time() < 0.1) {
      advance(w, 1);
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(std::abs(w.cell.lattice.rate[k]), 2);
        highest = std::max(highest, cell_stress(w).row[k][k] / target[k]);
      }
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(cell_stress(w).row[k][k], target[k], 1e-4 * target[k]) << k;
    EXPECT_LT(highest, 1.05);
    EXPECT_LT(max_abs(w.cell.lattice.rate), 1e-4);
    EXPECT_EQ(w.counters.rebuilds, 1u);
  }
}

// Dashpots oppose the rate that the servo has just chosen: if it took that for the stress to work off, rates would
// alternate from step to step.
TEST(CellServo, StrongDashpotsAndGainDoNotMakeTheRateAlternate) {
  for (const bool isotropic : {false, true}) {
    Scene s = lattice(LawName::spring_dashpot);
    s.materials[0].restitution = 0.05;
    s.periodic.deform = {servo("xyz", {2e4, 2e4, 2e4}, 2, isotropic)};
    s.periodic.deform[0].gain = 10;
    World w = build_world(s);
    while (mean_stress(w) < 1e3) advance(w, 1);
    int turns = 0;
    double before = w.cell.lattice.rate.x;
    for (int i = 0; i < 8000; ++i) {
      advance(w, 1);
      turns += before * w.cell.lattice.rate.x < 0 ? 1 : 0;
      before = w.cell.lattice.rate.x;
    }
    EXPECT_LE(turns, 3) << isotropic;
    EXPECT_NEAR(mean_stress(w), 2e4, 2) << isotropic;
  }
}

TEST(CellServo, OneRateForAllAxesKeepsTheShape) {
  Scene s = lattice(LawName::hertz_mindlin);
  s.periodic.deform = {servo("xyz", {2e4, 2e4, 2e4}, 2, true)};
  const World w = scenes::run(s, 2500);
  EXPECT_NEAR(mean_stress(w), 2e4, 2);
  const Vec3d& length = w.cell.lattice.length;
  EXPECT_EQ(length.x, length.y);
  EXPECT_EQ(length.x, length.z);
}

TEST(CellServo, WithoutContactsTheRateIsTheLimit) {
  Scene s = lattice(LawName::hertz_mindlin);
  for (BodySpec& b : s.bodies) b.scale = 0.5;
  s.periodic.deform = {servo("xz", {2e4, 0, 1e4}, 3)};
  const World w = scenes::run(s, 10);
  EXPECT_EQ(w.cell.lattice.rate, (Vec3d{-3, 0, -3}));
}

TEST(CellServo, ARandomPackingComesToItsPressure) {
  for (const double friction : {0.0, 0.4}) {
    Scene s = cloud(300, friction);
    s.run.dt_fraction = 0.2;
    s.periodic.deform = {servo("xyz", {4e3, 4e3, 4e3}, 8, true)};
    World w = build_world(s);
    double highest = 0;
    while (w.time() < 0.35) {
      advance(w, 1);
      highest = std::max(highest, mean_stress(w));
    }
    EXPECT_NEAR(mean_stress(w), 4e3, 20) << friction;
    EXPECT_LT(highest, 6e3) << friction;
    const double z = coordination(w).backbone, isostatic = friction > 0 ? 4 : 6;
    EXPECT_TRUE(z > isostatic && z < isostatic + 2) << z;
    EXPECT_TRUE(solid_fraction(w) > 0.6 && solid_fraction(w) < 0.7) << solid_fraction(w);
  }
}

// Triaxial compression: two axes keep their stress while the third is driven.
TEST(CellServo, TwoAxesKeepTheirStressWhileTheThirdIsDriven) {
  Scene s = cloud(300, 0.4);
  s.run.dt_fraction = 0.2;
  DeformSpec press = servo("xy", {1e4, 1e4, 0}, 8);
  press.start = 0.25;
  press.strain_rates = {0, 0, -0.2};
  s.periodic.deform = {servo("xyz", {1e4, 1e4, 1e4}, 8), press};
  World w = build_world(s);
  while (w.time() < 0.25) advance(w, 1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(cell_stress(w).row[k][k], 1e4, 100) << k;
  while (w.time() < 0.5) advance(w, 1);
  const Mat3d stress = cell_stress(w);
  EXPECT_NEAR(stress.row[0].x, 1e4, 300);
  EXPECT_NEAR(stress.row[1].y, 1e4, 300);
  EXPECT_GT(stress.row[2].z, 1.3e4);
  EXPECT_LT(stress.row[2].z, 4e4);
}

TEST(CellServo, ALimitTooFastForTheTimeStepIsRefused) {
  Scene s = lattice(LawName::hertz_mindlin);
  s.run.dt_auto = false;
  s.run.dt = 1e-5;
  s.periodic.deform = {servo("z", {0, 0, 1e4}, 1001)};
  EXPECT_THROW(build_world(s), InputError);
  s.periodic.deform = {servo("z", {0, 0, 1e4}, 999)};
  EXPECT_NO_THROW(build_world(s));
}

}  // namespace
}  // namespace dem
