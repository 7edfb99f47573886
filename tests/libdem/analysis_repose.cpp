// Angle of repose of heaps made under a known surface: in the plane, a cone, a ridge, against a wall.
#include <gtest/gtest.h>

#include "libdem/analysis/repose.h"
#include "libdem/scene/where.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Bodies wherever they fit under h = height − slope · r; r from (shift, 0).
template <class Radius>
Snapshot heap(int dimension, double angle, double height, Radius radius_of, bool ridge = false) {
  Snapshot s;
  s.dimension = dimension;
  s.gravity = dimension == 2 ? Vec3d{0, -9.81, 0} : Vec3d{0, 0, -9.81};
  const double slope = std::tan(angle * degree), reach = height / slope, r = 0.25;
  if (ridge) {
    s.periodic = {false, true, false};
    s.length = {0, 4, 0};
  }
  Random random(11, 0, 0);
  const int count = dimension == 2 ? 6000 : (ridge ? 30000 : 150000);
  for (int i = 0; i < count; ++i) {
    Vec3d x{random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(r, height)};
    if (dimension == 2) x = {x.x, x.z, 0};
    if (ridge) x.y = random.uniform(0, 4);
    const double up = dimension == 2 ? x.y : x.z;
    if (up + r <= height - slope * radius_of(x)) sets::add_body(s, x, r);
  }
  return s;
}
double along_x(const Vec3d& x) { return std::abs(x.x); }
double about_z(const Vec3d& x) { return std::hypot(x.x, x.y); }

void expect_angle(const Snapshot& s, double angle, double within, std::size_t sides) {
  const Repose found = repose_of(free_surface_of(s, {}));
  ASSERT_TRUE(found.angle);
  EXPECT_EQ(found.slopes.size(), sides);
  EXPECT_NEAR(found.angle.value_or(0) / degree, angle, within);
  EXPECT_NEAR(found.angle.value_or(0), angle * degree, 3 * found.error + 0.2 * degree);
  EXPECT_GT(found.error, 0);
  EXPECT_LT(found.error / degree, 2);
}

TEST(AnalysisRepose, HeapsOfTheirOwnAngle) {
  for (const double angle : {18.0, 25.0, 34.0}) expect_angle(heap(2, angle, 10, along_x), angle, 1, 2);
  expect_angle(heap(3, 28, 8, about_z), 28, 1, 8);
  expect_angle(heap(3, 28, 8, along_x, true), 28, 1, 2);
}

// Between two walls a few bodies apart a heap is a slice of a ridge, along whichever axis; here it leans on a wall.
TEST(AnalysisRepose, ASliceBetweenWallsIsARidge) {
  for (const bool turned : {false, true}) {
    Snapshot s;
    s.dimension = 3;
    s.gravity = {0, 0, -9.81};
    Random random(12, 0, 0);
    const double slope = std::tan(28 * degree), r = 0.25;
    for (int i = 0; i < 6000; ++i) {
      const Vec3d x{random.uniform(0, 8 / slope), random.uniform(0, 1.25), random.uniform(r, 8)};
      if (x.z + r <= 8 - slope * x.x) sets::add_body(s, turned ? Vec3d{x.y, x.x, x.z} : x, r);
    }
    expect_angle(s, 28, 1, 1);
  }
}

TEST(AnalysisRepose, UpIsWhereGravitySays) {
  Snapshot s = heap(3, 28, 8, about_z);
  const double expected = repose_of(free_surface_of(s, {})).angle.value_or(0);
  for (Vec3d& x : s.position) x = {x.z, x.x, x.y};  // up is x
  s.gravity = {-9.81, 0, 0};
  EXPECT_NEAR(repose_of(free_surface_of(s, {})).angle.value_or(0), expected, 1e-12);
}

TEST(AnalysisRepose, HeapAgainstAWallHasOneSideLess) {
  Snapshot s = heap(2, 25, 10, [](const Vec3d& x) { return x.x < -1.5 ? 1e9 : std::abs(x.x); });
  const Repose found = repose_of(free_surface_of(s, {}));
  ASSERT_EQ(found.slopes.size(), 1u);
  EXPECT_NEAR(found.angle.value_or(0) / degree, 25, 1);
}

TEST(AnalysisRepose, BasesAndFlyingBodies) {
  Snapshot s = heap(2, 25, 10, along_x);
  s.walls.resize(2);
  s.walls[0].name = "floor";
  s.walls[0].kind = shapes::Kind::line;
  s.walls[0].position = {0, -2, 0};
  s.walls[1] = s.walls[0];
  s.walls[1].name = "lower";
  s.walls[1].position.y = -3;
  EXPECT_EQ(free_surface_of(s, {}).base, -3);
  Settings settings;
  settings.base_wall = "floor";
  EXPECT_EQ(free_surface_of(s, settings).base, -2);
  settings.base_wall = "ceiling";
  EXPECT_THROW(free_surface_of(s, settings), InputError);
  // Contacts for all but a body high above.
  for (std::size_t i = 0; i + 1 < s.count(); ++i) sets::touch(s, i, i + 1);
  const double height = repose_of(free_surface_of(s, {})).height;
  sets::add_body(s, {0, 50, 0}, 0.25);
  EXPECT_EQ(repose_of(free_surface_of(s, {})).height, height);
}

// Bodies wherever they fit under a plane that falls by `slope` along `down`, in a box of 2 `half` by `depth`.
Snapshot bed_under(const Vec3d& slope, double depth, double half = 6) {
  Snapshot s;
  s.gravity = {0, 0, -9.81};
  Random random(5, 0, 0);
  for (int i = 0; i < 60000; ++i) {
    const Vec3d x{random.uniform(-half, half), random.uniform(0, depth), random.uniform(0, 20)};
    if (x.z + 0.25 <= 8 - dot(slope, x)) sets::add_body(s, x, 0.25);
  }
  return s;
}

TEST(AnalysisRepose, TiltOfAFlatSurface) {
  for (const double angle : {10.0, 30.0}) {
    const double steep = std::tan(angle * degree);
    for (const Vec3d down : {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0.8, 0.6, 0}}) {
      const auto tilt = tilt_of(free_surface_of(bed_under(down * steep, 4), {}));
      ASSERT_TRUE(tilt);
      EXPECT_NEAR(tilt->angle / degree, angle, 1);
      EXPECT_NEAR(tilt->angle, angle * degree, 3 * tilt->error + 0.2 * degree);
      EXPECT_GT(tilt->error, 0);
      EXPECT_LT(tilt->error / degree, 1);
    }
  }
  // One square across: the line along it.
  const auto thin = tilt_of(free_surface_of(bed_under({std::tan(10 * degree), 0, 0}, 0.6, 24), {}));
  ASSERT_TRUE(thin);
  EXPECT_NEAR(thin->angle / degree, 10, 1);
  EXPECT_FALSE(tilt_of(free_surface_of(sets::square(), {})));  // too few squares
}

TEST(AnalysisRepose, NoSquareIsASliverAlongAWall) {
  // A level bed whose depth is no whole number of squares: every square has a body near the top.
  Snapshot s;
  s.gravity = {0, 0, -9.81};
  Random random(6, 0, 0);
  for (int i = 0; i < 30000; ++i)
    sets::add_body(s, {random.uniform(0, 10), random.uniform(0, 3.07), random.uniform(0, 4)}, 0.25);
  const FreeSurface f = free_surface_of(s, {});
  EXPECT_EQ(f.points.size(), 10u * 3u - 3u);  // the extent along x is a little below ten squares
  for (const SurfacePoint& p : f.points) EXPECT_GT(p.height, 4);
}

TEST(AnalysisRepose, NoHeapIsSaid) {
  EXPECT_EQ(report_repose(Snapshot{}, {}).notes.size(), 1u);
  const Result r = report_repose(sets::square(), {});  // a level bed
  EXPECT_EQ(r.notes.size(), 3u);
  for (const Scalar& x : r.scalars) EXPECT_NE(x.name, "angle_of_repose");
}

}  // namespace
}  // namespace dem::analysis
