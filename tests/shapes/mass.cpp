// Mass properties and radii against closed forms and the table of shipped solids.
#include <fstream>
#include <map>
#include <sstream>

#include "shapes/geometry.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;
using shapes::Platonic;

void expect_isotropic(const Polyhedron& p, double moment) {
  const double found[3] = {p.mass.inertia.row[0].x, p.mass.inertia.row[1].y, p.mass.inertia.row[2].z};
  for (const double m : found) EXPECT_NEAR(m / moment, 1, 16 * eps);
}

TEST(Mass, box) {
  const Vec3d s{0.3, 1.7, 0.9};
  const auto m = shapes::make_box(s).mass;
  const double volume = s.x * s.y * s.z;
  EXPECT_NEAR(m.volume / volume, 1, 4 * eps);
  for (int i = 0; i < 3; ++i) {
    const double b = s[(i + 1) % 3], c = s[(i + 2) % 3];
    EXPECT_NEAR(m.inertia.row[i][i] / (volume * (b * b + c * c) / 12), 1, 8 * eps);
    for (int j = 0; j < 3; ++j)
      if (i != j) {
        EXPECT_EQ(m.inertia.row[i][j], 0);
      }
  }
  EXPECT_TRUE(m.centre == Vec3d{});
}

// Regular solids of edge a: V = v a³, I = i V a².
TEST(Mass, platonic_solids) {
  const double phi = std::numbers::phi, root5 = std::sqrt(5.0);
  struct Row {
    Platonic solid;
    double edge_over_radius, volume, inertia, inscribed_over_edge;
    std::size_t vertices, edges, faces;
  };
  const Row rows[] = {
      {Platonic::tetrahedron, std::sqrt(8.0 / 3), std::sqrt(2.0) / 12, 1.0 / 20, std::sqrt(6.0) / 12, 4, 6, 4},
      {Platonic::cube, 2 / std::sqrt(3.0), 1, 1.0 / 6, 0.5, 8, 12, 6},
      {Platonic::octahedron, std::sqrt(2.0), std::sqrt(2.0) / 3, 1.0 / 10, std::sqrt(6.0) / 6, 6, 12, 8},
      {Platonic::dodecahedron, 4 / (std::sqrt(3.0) * (1 + root5)), (15 + 7 * root5) / 4, (39 * phi + 28) / 150,
       std::sqrt(250 + 110 * root5) / 20, 20, 30, 12},
      {Platonic::icosahedron, 1 / std::sin(2 * std::numbers::pi / 5), 5 * (3 + root5) / 12, phi * phi / 10,
       phi * phi / (2 * std::sqrt(3.0)), 12, 30, 20},
  };
  for (const Row& row : rows) {
    for (const double radius : {1.0, 0.37}) {
      const Polyhedron p = shapes::make_platonic(row.solid, radius);
      expect_canonical(p);
      EXPECT_EQ(p.vertices.size(), row.vertices);
      EXPECT_EQ(p.edges.size(), row.edges);
      EXPECT_EQ(p.faces.size(), row.faces);
      const double a = row.edge_over_radius * radius, volume = row.volume * a * a * a;
      EXPECT_NEAR(p.mass.volume / volume, 1, 16 * eps);
      EXPECT_NEAR(p.circumradius / radius, 1, 4 * eps);
      EXPECT_NEAR(p.inscribed_radius / (row.inscribed_over_edge * a), 1, 16 * eps);
      expect_isotropic(p, row.inertia * volume * a * a);
      EXPECT_EQ(p.frame.orientation.w, 1);
    }
  }
}

TEST(Mass, prism) {
  for (const int n : {3, 4, 6, 17, 100}) {
    const double r = 0.8, h = 0.35, angle = 2 * std::numbers::pi / n;
    const Polyhedron p = shapes::make_prism(n, r, h);
    expect_canonical(p);
    EXPECT_EQ(p.faces.size(), static_cast<std::size_t>(n) + 2);
    const double area = 0.5 * n * r * r * std::sin(angle), volume = area * h;
    const double polar = volume * r * r * (2 + std::cos(angle)) / 6;  // regular polygon about its axis
    EXPECT_NEAR(p.mass.volume / volume, 1, 32 * eps);
    EXPECT_NEAR(p.mass.inertia.row[2].z / polar, 1, 32 * eps);
    EXPECT_NEAR(p.mass.inertia.row[0].x / (polar / 2 + volume * h * h / 12), 1, 32 * eps);
    EXPECT_NEAR(p.mass.inertia.row[1].y / p.mass.inertia.row[0].x, 1, 32 * eps);
    EXPECT_TRUE(p.mass.centre == Vec3d{});
  }
}

TEST(Mass, moves_with_the_body) {
  Random random(31);
  const auto points = random_points(32, 20);
  const auto m = shapes::polyhedron_from_points(points, Frame::as_given).mass;
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto rotation = rotation_matrix(random.rotation());
    const Vec3d shift = random.in_box({-1000, -1000, -1000}, {1000, 1000, 1000});
    auto moved = points;
    for (Vec3d& v : moved) v = rotation * v + shift;
    const auto q = shapes::polyhedron_from_points(moved, Frame::as_given).mass;
    const double rounding = 64 * eps * 1000;  // of the moved coordinates
    EXPECT_NEAR(q.volume / m.volume, 1, rounding);
    EXPECT_LE(max_abs(q.centre - (rotation * m.centre + shift)), rounding);
    const auto turned = rotation * m.inertia * transposed(rotation);
    for (int i = 0; i < 3; ++i) EXPECT_LE(max_abs(q.inertia.row[i] - turned.row[i]), rounding * turned.row[i][i]);
  }
}

// shapes/data/solids: printed to 9 decimals (coordinates) and 5 or 6 (ratios).
TEST(Mass, shipped_solids_agree_with_their_table) {
  std::ifstream table(std::string(PROJECT_ROOT) + "/shapes/data/solids/solids.csv");
  std::string line;
  std::getline(table, line);
  int rows = 0;
  while (std::getline(table, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    std::string name;
    std::size_t vertices = 0, faces = 0, edges = 0;
    double volume = 0, area = 0, sphericity = 0, outer = 0, inner = 0, inertia = 0;
    in >> name >> vertices >> faces >> edges >> volume >> area >> sphericity >> outer >> inner >> inertia;
    ASSERT_TRUE(in) << line;
    const Polyhedron p = shapes::polyhedron_from_file(
        std::string(PROJECT_ROOT) + "/shapes/data/solids/" + name + ".off", Frame::as_given);
    expect_canonical(p);
    const double r = shapes::equivalent_radius(volume);
    EXPECT_EQ(p.vertices.size(), vertices) << name;
    EXPECT_GE(p.faces.size(), faces) << name;  // rounded polygons are several faces of the exact hull
    EXPECT_NEAR(p.mass.volume, volume, 0.87e-9 * area + 0.5e-9) << name;  // corners are off by up to √3/2 of a unit
    EXPECT_NEAR(p.circumradius / r, outer, 0.51e-5) << name;
    EXPECT_NEAR(p.inscribed_radius / r, inner, 0.51e-5) << name;
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(p.mass.inertia.row[i][i] / (p.mass.volume * r * r), inertia, 0.51e-6) << name;
    ++rows;
  }
  EXPECT_EQ(rows, 13);
}

}  // namespace
}  // namespace shape_tests
