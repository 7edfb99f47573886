// Nematic order of known sets of axes, the axis of every kind of body, alignment along a wall.
#include <gtest/gtest.h>

#include "libdem/analysis/orientation.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

constexpr double pi = std::numbers::pi;

Snapshot ellipsoids(std::size_t count, const Vec3d& semi_axes) {
  Snapshot s;
  ShapeEntry e;
  e.kind = shapes::Kind::ellipsoid;
  s.shapes = {e};
  for (std::size_t i = 0; i < count; ++i) {
    sets::add_body(s, {0, 0, 0.1 * static_cast<double>(i)}, 0.5);
    s.size.back() = semi_axes;
  }
  return s;
}

std::vector<Vec3d> axes_of(const Snapshot& s) {
  std::vector<Vec3d> list;
  for (std::size_t i = 0; i < s.count(); ++i) list.push_back(body_axis(s, i).value());
  return list;
}

TEST(AnalysisOrientation, AlignedBodiesHaveOrderOne) {
  Random random(1, 0, 0);
  const Quatd q = random.rotation();
  for (const Vec3d& semi : {Vec3d{1, 2, 0.5}, Vec3d{1, 1, 0.2}, Vec3d{1, 1, 3}}) {
    Snapshot s = ellipsoids(20, semi);
    for (std::size_t i = 0; i < s.count(); ++i) {
      s.orientation[i] = q;
      if (i % 2 == 0) s.orientation[i] = q * Quatd{0, 0, 1, 0};  // turned by π about y: no axis changes but its sense
    }
    const NematicOrder o = nematic_order(axes_of(s), 3);
    EXPECT_NEAR(o.principal.value[0], 1, 1e-12);
    EXPECT_NEAR(o.principal.value[1], -0.5, 1e-12);
    const Vec3d axis = semi.y == 2 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};  // the flat one: across
    EXPECT_NEAR(std::abs(dot(o.principal.axis[0], rotate(q, axis))), 1, 1e-12);
    EXPECT_NEAR(trace(o.tensor), 0, 1e-12);
  }
}

TEST(AnalysisOrientation, IsotropicAndPlanarSets) {
  Random random(2, 0, 0);
  const std::size_t count = 20000;
  std::vector<Vec3d> space, around;
  for (std::size_t i = 0; i < count; ++i) {
    space.push_back(rotate(random.rotation(), Vec3d{1, 0, 0}));
    around.push_back(rotate(random.turn(), Vec3d{1, 0, 0}));
  }
  const double noise = 3 / std::sqrt(static_cast<double>(count));
  EXPECT_LT(nematic_order(space, 3).principal.value[0], noise);
  EXPECT_LT(nematic_order(around, 2).principal.value[0], noise);
  const NematicOrder lying = nematic_order(around, 3);  // across z
  EXPECT_NEAR(lying.principal.value[2], -0.5, 1e-12);
  EXPECT_NEAR(lying.principal.value[0], 0.25, noise);
  EXPECT_NEAR(std::abs(lying.principal.axis[2].z), 1, 1e-12);
  EXPECT_EQ(nematic_order({}, 3).principal.value[0], 0);
}

TEST(AnalysisOrientation, KnownSpreadInThePlane) {
  std::vector<Vec3d> axes;
  const double spread = 0.4, middle = 1.1;
  for (int i = 0; i < 10001; ++i) {
    const double t = middle + spread * (2.0 * i / 10000 - 1);
    axes.push_back({std::cos(t), std::sin(t), 0});
  }
  const NematicOrder o = nematic_order(axes, 2);
  EXPECT_NEAR(o.principal.value[0], std::sin(2 * spread) / (2 * spread), 1e-4);
  EXPECT_NEAR(std::atan2(o.principal.axis[0].y, o.principal.axis[0].x), middle, 1e-9);
}

TEST(AnalysisOrientation, AxesOfSolidsAndPolygons) {
  Snapshot s;
  ShapeEntry brick, cube, sheet, plank, square;
  const auto solid = [](ShapeEntry& e, const Vec3d& size) {
    e.kind = shapes::Kind::polyhedron;
    e.polyhedron = std::make_shared<shapes::Polyhedron>(shapes::make_box(size));
    const Mat3d& m = e.polyhedron->mass.inertia;
    e.inertia = {m.row[0].x, m.row[1].y, m.row[2].z};
  };
  solid(brick, {1, 3, 2});
  solid(cube, {1, 1, 1});
  solid(sheet, {0.1, 2, 2});
  const auto polygon = [](ShapeEntry& e, double a, double b, double turned) {
    std::vector<Vec3d> outline;
    for (const auto& [x, y] : {std::pair{-a, -b}, std::pair{a, -b}, std::pair{a, b}, std::pair{-a, b}})
      outline.push_back({x * std::cos(turned) - y * std::sin(turned), x * std::sin(turned) + y * std::cos(turned), 0});
    e.kind = shapes::Kind::polygon;
    e.polygon = std::make_shared<shapes::Polygon>(shapes::polygon_from_outline(outline));
  };
  polygon(plank, 2, 0.5, 0.3);
  polygon(square, 1, 1, 0.3);
  s.shapes = {brick, cube, sheet, plank, square};
  for (std::uint32_t k = 0; k < 5; ++k) {
    sets::add_body(s, {}, 1);
    s.shape.back() = k;
  }
  EXPECT_EQ(std::abs(body_axis(s, 0)->y), 1);
  EXPECT_FALSE(body_axis(s, 1));
  EXPECT_EQ(std::abs(body_axis(s, 2)->x), 1);
  EXPECT_NEAR(std::atan(body_axis(s, 3)->y / body_axis(s, 3)->x), 0.3, 1e-12);
  EXPECT_FALSE(body_axis(s, 4));
  EXPECT_EQ(report_orientation(s, {}).tables.at(1).columns.at(0).values.size(), 3u);
}

TEST(AnalysisOrientation, BodiesLieAlongAWall) {
  Snapshot s = ellipsoids(40, {1, 1, 3});  // along z, but for the ten next to the floor: along x
  for (std::size_t i = 0; i < 10; ++i) s.orientation[i] = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};
  s.walls.resize(1);
  s.walls[0].name = "floor";
  s.walls[0].position = {5, 5, -0.05};
  const auto found = wall_alignment(s, s.walls[0], 0.5, 2.5);
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(found[k].bodies, 5);
    EXPECT_NEAR(found[k].p2, k < 2 ? -0.5 : 1, 1e-12);
    EXPECT_NEAR(found[k].distance, 0.25 + 0.5 * static_cast<double>(k), 1e-12);
  }
}

TEST(AnalysisOrientation, RoundBodiesHaveNone) {
  EXPECT_EQ(report_orientation(sets::simple_cubic(), {}).notes.size(), 1u);
  EXPECT_EQ(report_orientation(Snapshot{}, {}).notes.size(), 1u);
}

}  // namespace
}  // namespace dem::analysis
