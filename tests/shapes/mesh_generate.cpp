// Generated wall meshes: facets, areas and closedness against closed forms; the same bits, scaled, in other units.
#include "shapes/mesh_generate.h"

#include <numbers>

#include "shapes/polyhedron_build.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Mesh;

double total_area(const Mesh& m) {
  double sum = 0;
  for (std::uint32_t f = 0; f < m.facets.size(); ++f) sum += shapes::facet_area(m, f);
  return sum;
}
// Of a regular polygon of n corners on a circle, m².
double polygon_area(double radius, int n) { return 0.5 * n * radius * radius * std::sin(2 * std::numbers::pi / n); }
double polygon_side(double radius, int n) { return 2 * radius * std::sin(std::numbers::pi / n); }

TEST(GeneratedMesh, Panel) {
  const Mesh m = shapes::make_panel({1, 2, 3}, {2, 0, 0}, {1, 3, 0});
  EXPECT_EQ(m.facets.size(), 1u);
  EXPECT_NEAR(total_area(m), 6, 1e-14);
  EXPECT_FALSE(shapes::is_closed(m));
  EXPECT_NEAR(shapes::projected_area(m, {0, 0, 1}), 6, 1e-14);
  EXPECT_NEAR(shapes::projected_area(m, {1, 0, 0}), 0, 1e-14);
}

TEST(GeneratedMesh, Box) {
  shapes::BoxFaces faces;
  const Mesh all = shapes::make_box_shell({-1, 0, 2}, {1, 3, 6}, faces);
  EXPECT_EQ(all.facets.size(), 6u);
  EXPECT_EQ(all.edges.size(), 12u);
  EXPECT_TRUE(shapes::is_closed(all));
  EXPECT_NEAR(total_area(all), 2 * (2 * 3 + 3 * 4 + 4 * 2), 1e-12);
  EXPECT_NEAR(shapes::projected_area(all, {1, 0, 0}), 12, 1e-13);
  faces.high[2] = faces.low[0] = false;
  const Mesh open = shapes::make_box_shell({-1, 0, 2}, {1, 3, 6}, faces);
  EXPECT_EQ(open.facets.size(), 4u);
  EXPECT_FALSE(shapes::is_closed(open));
  EXPECT_NEAR(total_area(open), total_area(all) - 6 - 12, 1e-12);
  for (const auto& f : open.facets) EXPECT_FALSE(std::fabs(f.normal.z) > 0.5 && f.offset * f.normal.z > 5);
}

TEST(GeneratedMesh, Tube) {
  const int n = 24;
  const Vec3d base{0.1, -0.2, 0.3}, along{0.02, 0.01, -0.02};  // length 0.03
  const Mesh open = shapes::make_frustum(base, base + along, 0.05, 0.05, n, false, false);
  EXPECT_EQ(open.facets.size(), 24u);
  EXPECT_NEAR(total_area(open) / (n * polygon_side(0.05, n) * 0.03), 1, 1e-13);
  const Mesh closed = shapes::make_frustum(base, base + along, 0.05, 0.05, n, true, true);
  EXPECT_EQ(closed.facets.size(), 26u);
  EXPECT_TRUE(shapes::is_closed(closed));
  EXPECT_NEAR((total_area(closed) - total_area(open)) / (2 * polygon_area(0.05, n)), 1, 1e-12);
  EXPECT_NEAR(shapes::projected_area(closed, along * (1 / 0.03)) / polygon_area(0.05, n), 1, 1e-12);
}

TEST(GeneratedMesh, Cone) {
  const int n = 12;
  const Mesh cone = shapes::make_frustum({0, 0, 0}, {0, 0, 3}, 4, 0, n, true, true);
  EXPECT_EQ(cone.facets.size(), 13u);
  EXPECT_TRUE(shapes::is_closed(cone));
  const double slant = std::hypot(3, 4 * std::cos(std::numbers::pi / n));
  EXPECT_NEAR(total_area(cone), polygon_area(4, n) + n * 0.5 * polygon_side(4, n) * slant, 1e-12);
  const Mesh frustum = shapes::make_frustum({0, 0, 0}, {0, 0, 1.5}, 4, 2, n, false, false);
  EXPECT_EQ(frustum.facets.size(), 12u);
  EXPECT_NEAR(total_area(frustum), 0.75 * n * 0.5 * polygon_side(4, n) * slant, 1e-12);
}

TEST(GeneratedMesh, Die) {
  const Mesh die = shapes::make_die({0, 0, -2}, {3, 4, 0}, 1, true);
  EXPECT_EQ(die.facets.size(), 6u);  // four walls, the bottom, one table in one piece
  EXPECT_NEAR(total_area(die), 2 * (3 + 4) * 2 + 12 + (5 * 6 - 12), 1e-12);
  EXPECT_EQ(shapes::make_die({0, 0, -2}, {3, 4, 0}, 1, false).facets.size(), 5u);
}

TEST(GeneratedMesh, VShell) {
  const int n = 32;
  const double angle = 80 * std::numbers::pi / 180, radius = 0.03, length = 0.1;
  const Mesh v = shapes::make_v_shell({0, 0, 0}, angle, radius, length, n, true);
  EXPECT_TRUE(shapes::is_closed(v));
  EXPECT_EQ(v.facets.size(), 2u * n + 2);
  // The cut of a tube by an oblique plane through its axis leaves its mean length: the side has that of a straight one.
  EXPECT_NEAR(total_area(v) / (2 * (n * polygon_side(radius, n) * length + polygon_area(radius, n))), 1, 1e-10);
  // The joint lies in x = 0.
  int joint = 0;
  for (const Vec3d& x : v.vertices) joint += x.x == 0 ? 1 : 0;
  EXPECT_EQ(joint, n);
  EXPECT_FALSE(shapes::is_closed(shapes::make_v_shell({0, 0, 0}, angle, radius, length, n, false)));
}

TEST(GeneratedMesh, OtherUnitsGiveTheSameBitsScaled) {
  const double s = 0x1p-20;
  const Mesh a = shapes::make_v_shell({1, 2, 3}, 1.2, 0.3, 1, 16, true);
  const Mesh b = shapes::make_v_shell({s, 2 * s, 3 * s}, 1.2, 0.3 * s, s, 16, true);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i] * s, b.vertices[i]);
  ASSERT_EQ(a.facets.size(), b.facets.size());
  for (std::size_t i = 0; i < a.facets.size(); ++i) {
    EXPECT_EQ(a.facets[i].normal, b.facets[i].normal);
    EXPECT_EQ(a.facets[i].offset * s, b.facets[i].offset);
  }
}

TEST(GeneratedMesh, ImpossibleNumbersAreRefused) {
  using shapes::Error;
  EXPECT_THROW(shapes::make_panel({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), Error);
  EXPECT_THROW(shapes::make_box_shell({0, 0, 0}, {1, 0, 1}, {}), Error);
  EXPECT_THROW(shapes::make_box_shell({0, 0, 0}, {1, 1, 1}, {{false, false, false}, {false, false, false}}), Error);
  EXPECT_THROW(shapes::make_frustum({0, 0, 0}, {0, 0, 0}, 1, 1, 8, true, true), Error);
  EXPECT_THROW(shapes::make_frustum({0, 0, 0}, {0, 0, 1}, 0, 0, 8, true, true), Error);
  EXPECT_THROW(shapes::make_frustum({0, 0, 0}, {0, 0, 1}, 1, 1, 2, true, true), Error);
  EXPECT_THROW(shapes::make_die({0, 0, 0}, {1, 1, 1}, 0, true), Error);
  EXPECT_THROW(shapes::make_v_shell({0, 0, 0}, 1.2, 1, 1, 16, true), Error);
}

}  // namespace
}  // namespace shape_tests
