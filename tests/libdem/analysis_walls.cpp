// Forces and pressures on walls: sums, torque, and that a map finds the square, side or triangle under a contact.
#include <gtest/gtest.h>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/wall_profile.h"
#include "libdem/analysis/walls.h"
#include "shapes/mesh_build.h"
#include "shapes/polygon_build.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

Quatd turned(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

// Spheres side by side on a floor in a box of 4 × 6, each as heavy as its place.
Snapshot bed() {
  Snapshot s;
  s.walls.resize(1);
  s.walls[0].name = "base";
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 4; ++i) {
      const std::size_t k = sets::add_body(s, {i + 0.5, j + 0.5, 0.5}, 0.5);
      sets::touch_wall(s, k, 0, {0, 0, -1}, 1 + i + 10 * j);
    }
  return s;
}

TEST(AnalysisWalls, FloorBearsTheSum) {
  Snapshot s = bed();
  s.contacts[0].force.x = 0.5;  // friction
  s.walls[0].position = {1, 0, 0};
  const WallForce w = wall_forces(s).at(0);
  double sum = 0, about_x = 0, about_y = 0;
  for (const SnapshotContact& c : s.contacts) {
    sum += c.force.z;
    about_x -= c.point.y * c.force.z;
    about_y += (c.point.x - 1) * c.force.z;
  }
  EXPECT_EQ(w.contacts, 24u);
  EXPECT_NEAR(w.force.z, -sum, 1e-12);
  EXPECT_NEAR(w.force.x, -0.5, 1e-15);
  EXPECT_NEAR(w.torque.x, about_x, 1e-12);
  EXPECT_NEAR(w.torque.y, about_y, 1e-12);
  EXPECT_NEAR(w.torque.z, 0.5 * 0.5, 1e-12);  // r × f of the friction, 0.5 from the axis
  const Result r = report_walls(s, {});
  EXPECT_NEAR(scalar(r, "base_pressure"), sum / 24, 1e-12);
}

TEST(AnalysisWalls, SquaresOfAPlane) {
  Snapshot s = bed();
  // The same squares whichever way the plane's own frame is turned about its normal, by right angles.
  for (int quarter = 0; quarter < 4; ++quarter) {
    s.walls[0].orientation = turned({0, 0, 1}, quarter * std::numbers::pi / 2);
    const bool across = quarter % 2 != 0;
    const auto map = wall_map(s, 0, domain_of(s), across ? std::array{6, 4} : std::array{4, 6});
    ASSERT_EQ(map.size(), 24u);
    for (const WallPatch& p : map) {
      EXPECT_NEAR(p.area, 1, 1e-12);
      const double expected = 1 + std::floor(p.centre.x) + 10 * std::floor(p.centre.y);
      EXPECT_NEAR(p.pressing, expected, 1e-12);
      EXPECT_NEAR(p.centre.z, 0, 1e-12);
    }
  }
  Settings settings;
  settings.boxes = {2, 3, 1};
  s.walls[0].orientation = {};
  for (const Table& t : report_walls(s, settings).tables) {
    ASSERT_EQ(t.columns[0].values.size(), 6u);
    EXPECT_NEAR(t.columns[4].values[0], (1 + 2 + 11 + 12) / 4.0, 1e-12);
  }
}

TEST(AnalysisWalls, TrianglesOfAMesh) {
  Snapshot s = bed();
  const std::vector<Vec3d> corners{{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {0, 0, 3}, {0, 6, 3}};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4};
  s.walls[0].kind = shapes::Kind::mesh;
  s.walls[0].mesh = std::make_shared<shapes::Mesh>(shapes::mesh_from_triangles(corners, triangles));
  const auto facet_of = [&](std::uint32_t triangle) {
    for (std::uint32_t f = 0; f < s.walls[0].mesh->facets.size(); ++f) {
      const auto& facet = s.walls[0].mesh->facets[f];
      for (std::uint32_t k = 0; k < facet.triangle_count; ++k)
        if (s.walls[0].mesh->facet_triangles[facet.first_triangle + k] == triangle) return f;
    }
    return 99u;
  };
  for (SnapshotContact& c : s.contacts) c.part = facet_of(0);
  sets::touch_wall(s, 0, 0, {-1, 0, 0}, 7);
  s.contacts.back().part = facet_of(2);
  const auto map = wall_map(s, 0, domain_of(s), {1, 1});
  ASSERT_EQ(map.size(), 4u);
  double below = 0, above = 0;
  for (std::size_t k = 0; k < 24; ++k) {
    const SnapshotContact& c = s.contacts[k];
    (c.point.y * 4 < c.point.x * 6 ? below : above) += c.pressing();
  }
  EXPECT_NEAR(map[0].pressing, below, 1e-12);
  EXPECT_NEAR(map[1].pressing, above, 1e-12);
  EXPECT_NEAR(map[2].pressing + map[3].pressing, 7, 1e-12);
  EXPECT_NEAR(map[0].area, 12, 1e-12);
  EXPECT_NEAR(map[2].area, 9, 1e-12);
  s.walls[0].orientation = turned({1, 0, 0}, 1.1);  // a wall that has turned with its bodies
  s.walls[0].position = {3, 2, 1};
  for (SnapshotContact& c : s.contacts) {
    c.point = s.walls[0].position + rotate(s.walls[0].orientation, c.point);
    c.force = rotate(s.walls[0].orientation, c.force);
    c.normal = rotate(s.walls[0].orientation, c.normal);
  }
  const auto moved = wall_map(s, 0, domain_of(s), {1, 1});
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(moved[k].pressing, map[k].pressing, 1e-11);
}

TEST(AnalysisWalls, LinesAndOutlinesOfThePlane) {
  Snapshot s;
  s.dimension = 2;
  s.thickness = 0.1;
  s.walls.resize(2);
  s.walls[0].name = "floor";
  s.walls[0].kind = shapes::Kind::line;
  s.walls[1].name = "block";
  s.walls[1].kind = shapes::Kind::polygon;
  const std::vector<Vec3d> outline{{4, 0, 0}, {6, 0, 0}, {6, 3, 0}, {4, 3, 0}};
  s.walls[1].polygon = std::make_shared<shapes::Polygon>(shapes::polygon_from_outline(outline));
  for (int i = 0; i < 4; ++i) {
    sets::add_body(s, {i + 0.5, 0.5, 0}, 0.5);
    sets::touch_wall(s, static_cast<std::size_t>(i), 0, {0, -1, 0}, 1 + i);
  }
  sets::touch_wall(s, 3, 1, {1, 0, 0}, 6);
  const Domain region{{0, 0, 0}, {4, 1, 0}};
  const auto floor = wall_map(s, 0, region, {2, 1});
  ASSERT_EQ(floor.size(), 2u);
  EXPECT_NEAR(floor[0].area, 0.2, 1e-15);
  EXPECT_NEAR(floor[0].pressing, 3, 1e-15);
  EXPECT_NEAR(floor[1].pressing, 7, 1e-15);
  int loaded = 0;
  for (const WallPatch& p : wall_map(s, 1, region, {1, 1})) {
    if (p.pressing <= 0) continue;
    ++loaded;
    EXPECT_NEAR(p.centre.x, 4, 1e-12);
    EXPECT_NEAR(p.area, 0.3, 1e-12);
    EXPECT_NEAR(p.pressing, 6, 1e-12);
  }
  EXPECT_EQ(loaded, 1);
}

// Bodies that press on the wall at x = 0 as heavily as they lie deep below z = 8.
Snapshot beside_a_wall(int wall) {
  Snapshot s;
  s.gravity = {0, 0, -9.81};
  s.walls.resize(2);
  s.walls[0].name = "flat side";
  s.walls[0].orientation = turned({0, 1, 0}, std::numbers::pi / 2);  // normal along x
  s.walls[1].name = "sloping";
  s.walls[1].kind = shapes::Kind::mesh;
  // A square on its corner in the plane x = 0: 2 (z − 4) wide from 4 up to 8, 2 (12 − z) from there.
  const std::vector<Vec3d> corners{{0, 2, 4}, {0, 6, 8}, {0, 2, 12}, {0, -2, 8}};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
  s.walls[1].mesh = std::make_shared<shapes::Mesh>(shapes::mesh_from_triangles(corners, triangles));
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 4; ++j) {
      const std::size_t i = sets::add_body(s, {0.5, j + 0.5, k + 0.5}, 0.5);
      sets::touch_wall(s, i, static_cast<std::size_t>(wall), {-1, 0, 0}, 8 - (k + 0.5));
      s.contacts.back().force.z = 0.5;
    }
  return s;
}

TEST(AnalysisWalls, PressureOverHeight) {
  const Snapshot s = beside_a_wall(0);
  const Domain region{{0, 0, 0}, {1, 4, 8}};
  const std::vector<WallBand> bands = wall_profile(s, 0, region, 2.1);  // four bands fit best
  ASSERT_EQ(bands.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(bands[k].from, 2.0 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(bands[k].area, 8, 1e-12);
    EXPECT_NEAR(bands[k].pressing / bands[k].area, 8 - (bands[k].from + 1), 1e-12);  // hydrostatic
    EXPECT_NEAR(bands[k].across, 8 * 0.5, 1e-12);
  }
  const Table t = profile_table(s, 0, region, 1);
  EXPECT_EQ(t.name, "height_flat_side");
  EXPECT_EQ(t.columns[0].values.size(), 8u);
  Snapshot level = bed();
  EXPECT_TRUE(wall_profile(level, 0, {{0, 0, 0}, {4, 6, 8}}, 1).empty());
}

TEST(AnalysisWalls, AreaOfAMeshOverHeight) {
  const Snapshot s = beside_a_wall(1);
  double area = 0, pressing = 0, all = 0;
  for (const WallBand& b : wall_profile(s, 1, {{0, -2, 0}, {1, 6, 16}}, 0.7)) {
    const auto below = [](double z) {  // area of the mesh below z
      const double h = std::clamp(z, 4.0, 12.0);
      return h < 8 ? (h - 4) * (h - 4) : 32 - (12 - h) * (12 - h);
    };
    EXPECT_NEAR(b.area, below(b.to) - below(b.from), 1e-12);
    area += b.area;
    pressing += b.pressing;
  }
  EXPECT_NEAR(area, 32, 1e-12);
  for (const SnapshotContact& c : s.contacts) all += c.pressing();
  EXPECT_NEAR(pressing, all, 1e-12);  // those beyond its ends count with the outermost
}

TEST(AnalysisWalls, LinesOverHeight) {
  Snapshot s;
  s.dimension = 2;
  s.thickness = 0.1;
  s.gravity = {0, -1, 0};
  s.walls.resize(1);
  s.walls[0].kind = shapes::Kind::line;
  s.walls[0].orientation = turned({0, 0, 1}, -0.25 * std::numbers::pi);  // falls at 45 degrees
  sets::add_body(s, {1, -1, 0}, 0.5);
  sets::touch_wall(s, 0, 0, {-std::sqrt(0.5), -std::sqrt(0.5), 0}, 3);
  const auto bands = wall_profile(s, 0, {{-2, -2, 0}, {2, 2, 0}}, 1);
  ASSERT_EQ(bands.size(), 4u);
  for (const WallBand& b : bands) EXPECT_NEAR(b.area, 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(bands[0].pressing, 3, 1e-12);
}

TEST(AnalysisWalls, WithoutWallsOrContacts) {
  Snapshot s;
  sets::add_body(s, {}, 1);
  EXPECT_EQ(report_walls(s, {}).notes.size(), 1u);
  s.walls.resize(2);
  s.walls[0].name = "a";
  s.walls[1].name = "b";
  s.walls[1].present = false;
  const Result r = report_walls(s, {});
  EXPECT_EQ(scalar(r, "a_normal_force"), 0);
  EXPECT_EQ(r.notes.size(), 2u);
  for (const Scalar& x : r.scalars) EXPECT_TRUE(std::isfinite(x.value));
}

}  // namespace
}  // namespace dem::analysis
