// Stress of Love and Weber against closed forms, the loop's own, and sums over boxes.
#include <gtest/gtest.h>

#include <cmath>

#include "libdem/analysis/stress.h"
#include "libdem/analysis/tensor.h"
#include "libdem/deformation.h"
#include "tests/libdem/scenes_in_code.h"
#include "tests/libdem/scenes_planar.h"

namespace {

using namespace dem;
using namespace dem::analysis;

// Balls of radius 1, mass 1 where asked, at rest.
Snapshot balls(const std::vector<Vec3d>& position) {
  Snapshot s;
  ShapeEntry ball;
  ball.size = {1, 1, 1};
  ball.equivalent_radius = ball.circumradius = 1;
  s.shapes = {ball};
  s.position = position;
  const std::size_t n = position.size();
  for (std::size_t i = 0; i < n; ++i) s.id.push_back(i);
  for (auto* list : {&s.shape, &s.material, &s.species}) list->assign(n, 0);
  s.size.assign(n, {1, 1, 1});
  for (auto* list : {&s.velocity, &s.spin, &s.rotation}) list->assign(n, Vec3d{});
  s.orientation.assign(n, {});
  for (auto* list : {&s.mass, &s.radius, &s.bounding_radius}) list->assign(n, 1.0);
  s.volume.assign(n, 4.18879);
  return s;
}
void press(Snapshot& s, std::uint32_t a, std::uint32_t b, const Vec3d& force_on_a) {
  SnapshotContact c;
  c.a = a;
  c.b = b;
  c.branch = s.between(s.position[a], s.position[b]);
  c.normal = normalized(c.branch);
  c.point = s.position[a] + c.branch * 0.5;
  c.force = force_on_a;
  s.contacts.push_back(c);
}
void lean(Snapshot& s, std::uint32_t a, const Vec3d& point, const Vec3d& force_on_a) {
  SnapshotContact c;
  c.a = a;
  c.wall = true;
  c.point = point;
  c.branch = point - s.position[a];
  c.normal = normalized(c.branch);
  c.force = force_on_a;
  s.contacts.push_back(c);
}

void expect_near(const Mat3d& a, const Mat3d& b, double tolerance) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(a.row[i][j], b.row[i][j], tolerance) << i << j;
}

// A column of n balls between two plates under the load P: P/A in every layer, as in the whole.
TEST(AnalysisStress, LoadedColumn) {
  constexpr int n = 10;
  constexpr double load = 7;
  std::vector<Vec3d> x;
  for (int i = 0; i < n; ++i) x.push_back({0, 0, 2.0 * i + 1});
  Snapshot s = balls(x);
  for (std::uint32_t i = 0; i + 1 < n; ++i) press(s, i, i + 1, {0, 0, -load});
  lean(s, 0, {0, 0, 0}, {0, 0, load});
  lean(s, n - 1, {0, 0, 2.0 * n}, {0, 0, -load});
  Settings settings;
  Mat3d expected;
  expected.row[2].z = load / 4;  // over the domain, 2 wide in x and y
  expect_near(stress_of(s, settings).total(), expected, 1e-14);
  for (const int layers : {2, 7, 10, 33}) {  // faces amid branches and on the contacts
    const Grid grid(s, domain_of(s), {1, 1, layers});
    for (const bool open : {true, false})
      for (const Stress& box : stress_in_boxes(s, grid, open)) expect_near(box.total(), expected, 1e-13);
  }
  const Grid aside(s, {{-1, -1, 5}, {0.5, 1, 9}}, {1, 1, 1});  // the branches run within
  expected.row[2].z = load / 3;
  expect_near(stress_in_boxes(s, aside, false)[0].total(), expected, 1e-14);
  settings.region = Domain{{5, 5, 5}, {6, 6, 6}};
  expect_near(stress_of(s, settings).total(), {}, 0);
}

// Two bodies that press on each other along d by F, and shear by T: V σ = F |d| n n + T |d| t n, and its antisymmetric
// part is half of the moment.
TEST(AnalysisStress, TwoBodies) {
  Snapshot s = balls({{0, 0, 0}, {1.2, 1.6, 0}});
  const Vec3d n{0.6, 0.8, 0}, t{-0.8, 0.6, 0};
  press(s, 0, 1, n * -5.0 + t * -2.0);
  Mat3d expected;
  add_to(expected, outer(n, n), 5 * 2.0);
  add_to(expected, outer(t, n), 2 * 2.0);
  const double volume = domain_of(s).volume(s);
  EXPECT_NEAR(volume, 3.2 * 3.6 * 2, 1e-12);
  for (Vec3d& row : expected.row) row *= 1 / volume;
  const Mat3d total = stress_of(s, {}).total();
  expect_near(total, expected, 1e-15);
  EXPECT_NEAR(antisymmetric_part(total).row[0].y, -2 * 2.0 / 2 / volume, 1e-15);
  s.velocity = {{3, 0, 0}, {-1, 0, 0}};
  s.mass = {1, 3};  // mean velocity 0
  EXPECT_NEAR(stress_of(s, {}).kinetic.row[0].x, (9 + 3) / volume, 1e-14);
  for (Vec3d& v : s.velocity) v += Vec3d{10, 20, 30};
  EXPECT_NEAR(stress_of(s, {}).kinetic.row[0].x, (9 + 3) / volume, 1e-12);
  EXPECT_NEAR(stress_of(s, {}).kinetic.row[1].y, 0, 1e-12);
}

// A column at rest by the loop: V σ_zz = Σ m g (z − z of the floor's point), whatever the overlaps.
TEST(AnalysisStress, ColumnUnderItsWeight) {
  Scene scene;
  scene.gravity = {0, 0, -10};
  scene.run.steps = 20000;
  scene.materials = {scenes::material("soft", 1e6, 2500, 0.1, 0.5)};
  scene.shapes = {scenes::sphere("ball", 0.01)};
  scene.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  for (int i = 0; i < 4; ++i) scene.bodies.push_back(scenes::body("ball", "soft", {0, 0, 0.01 + 0.02 * i}));
  const World world = scenes::run(scene, 20000);
  const Snapshot s = snapshot_of(world);
  ASSERT_EQ(s.contacts.size(), 4u);
  const double floor = s.contacts[1].point.z;
  ASSERT_TRUE(s.contacts[1].wall);
  double expected = 0;
  for (std::size_t i = 0; i < s.count(); ++i) expected += s.mass[i] * 10 * (s.position[i].z - floor);
  const double volume = domain_of(s).volume(s);
  const Stress stress = stress_of(s, {});
  EXPECT_NEAR(stress.total().row[2].z * volume / expected, 1, 1e-9);
  EXPECT_LT(std::abs(stress.total().row[0].x), 1e-12 * stress.total().row[2].z);
}

// In a periodic cell that of the loop, whose kinetic part is about zero velocity; boxes that cut its faces add to it.
TEST(AnalysisStress, OfAPeriodicCellAndItsBoxes) {
  const World world = scenes::run(scenes::every_shape_in_a_cell(150), 250);
  const Snapshot s = snapshot_of(world);
  Mat3d expected = cell_stress(world);
  Vec3d momentum{};
  double mass = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    momentum += s.velocity[i] * s.mass[i];
    mass += s.mass[i];
  }
  const double volume = cell_volume(world), scale = trace(expected);
  add_to(expected, outer(momentum, momentum), -1 / (mass * volume));
  expect_near(stress_of(s, {}).total(), expected, 1e-12 * scale);

  const Grid grid(s, domain_of(s), {3, 4, 5});
  const Mat3d contacts = stress_of(s, {}).contacts;
  for (const bool open : {true, false}) {
    Mat3d sum;
    double bodies = 0;
    for (const Stress& box : stress_in_boxes(s, grid, open)) {
      add_to(sum, box.contacts, 1 / static_cast<double>(grid.size()));
      bodies += static_cast<double>(box.bodies);
    }
    expect_near(sum, contacts, 1e-12 * scale);
    EXPECT_EQ(bodies, 150);
  }
  // A region that hangs over the cell's faces holds the same as the cell moved there.
  Domain shifted = domain_of(s);
  const Vec3d by = (shifted.upper - shifted.lower) * 0.37;
  shifted.lower += by;
  shifted.upper += by;
  expect_near(stress_in_boxes(s, Grid(s, shifted, {1, 1, 1}), false)[0].contacts, contacts, 1e-12 * scale);
}

// Branches of random contacts, cut by random boxes: against brute force along each branch.
TEST(AnalysisStress, SharesOfBranches) {
  Random random(3, 0, 0);
  const auto point = [&] { return Vec3d{random.uniform(0, 10), random.uniform(0, 10), random.uniform(0, 10)}; };
  std::vector<Vec3d> x;
  for (int i = 0; i < 20; ++i) x.push_back(point());
  Snapshot s = balls(x);
  for (std::uint32_t i = 0; i + 1 < 20; ++i) press(s, i, i + 1, point());
  const Grid grid(s, {{1, 2, 3}, {9, 7, 8}}, {3, 1, 4});
  const auto stress = stress_in_boxes(s, grid, false);
  std::vector<Mat3d> brute(grid.size());
  constexpr int pieces = 20000;
  for (const SnapshotContact& c : s.contacts)
    for (int p = 0; p < pieces; ++p) {
      const std::size_t box = grid.index(s.position[c.a] + c.branch * ((p + 0.5) / pieces));
      if (box != Grid::none) add_to(brute[box], outer(c.force, c.branch), -1.0 / pieces / grid.box_volume());
    }
  for (std::size_t b = 0; b < grid.size(); ++b) expect_near(stress[b].contacts, brute[b], 1e-2);
}

TEST(AnalysisStress, OfThePlaneOverItsThickness) {
  const World world = scenes::run(scenes::planar_tray({scenes::disc("coin", 0.004)}, 40), 3000);
  const Snapshot s = snapshot_of(world);
  ASSERT_GT(s.contacts.size(), 10u);
  const Stress stress = stress_of(s, {});
  EXPECT_EQ(stress.total().row[2], Vec3d{});
  double virial = 0;
  for (const SnapshotContact& c : s.contacts) virial -= dot(c.force, c.branch);
  const Domain d = domain_of(s);
  EXPECT_NEAR(trace(stress.contacts), virial / ((d.upper.x - d.lower.x) * (d.upper.y - d.lower.y) * 0.01),
              1e-12 * virial / d.volume(s));
  const Result r = report_stress(s, {});
  EXPECT_EQ(r.scalars[0].name, "pressure");
  EXPECT_EQ(r.scalars[0].value, trace(stress.total()) / 2);
}

TEST(AnalysisStress, NothingToReport) {
  EXPECT_TRUE(report_stress(Snapshot{}, {}).scalars.empty());
  EXPECT_FALSE(report_stress(Snapshot{}, {}).notes.empty());
  const Result one = report_stress(balls({{1, 2, 3}}), {});
  for (const Scalar& x : one.scalars) EXPECT_EQ(x.value, 0) << x.name;
  EXPECT_EQ(one.notes.size(), 2u);
}

}  // namespace
