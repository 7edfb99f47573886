// Constraints of contacts: faces, edges and corners of boxes and squares against each other and against walls.
#include <gtest/gtest.h>

#include "libdem/analysis/constraints.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

constexpr double pi = std::numbers::pi;

Quatd turned(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

Snapshot boxes() {
  Snapshot s;
  ShapeEntry e;
  e.kind = shapes::Kind::polyhedron;
  e.polyhedron = std::make_shared<shapes::Polyhedron>(shapes::make_box({1, 1, 1}));
  s.shapes = {e};
  return s;
}

// A box, and above it (b) another one, met along z at a point; the overlap 1e-4.
int above(const Vec3d& offset, const Quatd& first, const Quatd& second, const Vec3d& point) {
  Snapshot s = boxes();
  for (const auto& [x, q] : {std::pair{Vec3d{}, first}, std::pair{offset, second}}) {
    sets::add_body(s, x, 0.62);
    s.size.back() = {1, 1, 1};
    s.orientation.back() = q;
  }
  sets::touch(s, 0, 1);
  s.contacts[0].normal = {0, 0, 1};
  s.contacts[0].point = point;
  s.contacts[0].force = {0, 0, -1};
  s.contacts[0].overlap = 1e-4;
  return constraints_of(s, pairs_of(s)).of_pair.at(0);
}

TEST(AnalysisConstraints, BoxesOnEachOther) {
  const Quatd flat{}, on_edge = turned({1, 0, 0}, pi / 4);
  const Quatd on_corner = turned({1, 0, 0}, std::atan(1 / std::sqrt(2.0))) * turned({0, 1, 0}, pi / 4);
  const double half = std::sqrt(0.5), corner = std::sqrt(0.75), top = 0.5 - 1e-4;
  EXPECT_EQ(above({0, 0, 0.5 + top}, flat, flat, {0, 0, 0.5}), 3);
  EXPECT_EQ(above({0.3, -0.4, 0.5 + top}, flat, turned({0, 0, 1}, 0.4), {0.15, -0.2, 0.5}), 3);
  EXPECT_EQ(above({0.95, 0, 0.5 + top}, flat, flat, {0.475, 0, 0.5}), 2);         // a strip 0.05 wide
  EXPECT_EQ(above({0.95, 0.95, 0.5 + top}, flat, flat, {0.475, 0.475, 0.5}), 1);  // corner over corner
  EXPECT_EQ(above({0, 0, half + top}, flat, on_edge, {0, 0, 0.5}), 2);
  EXPECT_EQ(above({0, 0, corner + top}, flat, on_corner, {0, 0, 0.5}), 1);
  const double edges = 2 * half - 1e-4;
  EXPECT_EQ(above({0, 0, edges}, on_edge, on_edge, {0, 0, half}), 2);                              // along each other
  EXPECT_EQ(above({0, 0, edges}, on_edge, turned({0, 0, 1}, pi / 2) * on_edge, {0, 0, half}), 1);  // crossed
  // Tilted by more than the overlap explains: an edge.
  EXPECT_EQ(above({0, 0, 0.5 + top}, flat, turned({1, 0, 0}, 0.02), {0, -0.5, 0.5}), 2);
}

TEST(AnalysisConstraints, BoxesOnAFloorAndInACorner) {
  Snapshot s = boxes();
  sets::add_body(s, {0, 0, 0.5}, 0.62);
  s.size.back() = {1, 1, 1};
  s.walls.resize(2);
  sets::touch_wall(s, 0, 0, {0, 0, -1});
  sets::touch_wall(s, 0, 1, {0, -1, 0});
  s.contacts[0].point = {0, 0, 0};
  s.contacts[1].point = {0, -0.5, 0.5};
  EXPECT_EQ(constraints_of(s, pairs_of(s)).of_wall, (std::vector<std::uint8_t>{3, 3}));
  // Both faces against facets of one wall: five independent forces, the motion along both faces is free.
  s.contacts[1].b = 0;
  s.contacts[1].part = 1;
  EXPECT_EQ(constraints_of(s, pairs_of(s)).of_wall, (std::vector<std::uint8_t>{5}));
  EXPECT_EQ(degrees_of_freedom(s, 0), 6);
}

TEST(AnalysisConstraints, SquaresOfThePlane) {
  Snapshot s;
  s.dimension = 2;
  ShapeEntry e;
  e.kind = shapes::Kind::polygon;
  const std::vector<Vec3d> outline{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  e.polygon = std::make_shared<shapes::Polygon>(shapes::polygon_from_outline(outline));
  s.shapes = {e};
  const double half = std::sqrt(0.5);
  for (const auto& [x, angle] :
       {std::pair{Vec3d{}, 0.0}, std::pair{Vec3d{0.3, 1, 0}, 0.0}, std::pair{Vec3d{0.5 + half, 0, 0}, pi / 4}}) {
    sets::add_body(s, x, 0.56);
    s.size.back() = {1, 1, 1};
    s.orientation.back() = turned({0, 0, 1}, angle);
  }
  sets::touch(s, 0, 1);
  s.contacts[0].normal = {0, 1, 0};
  s.contacts[0].point = {0.15, 0.5, 0};
  sets::touch(s, 0, 2);
  s.contacts[1].point = {0.5, 0, 0};
  const Constraints c = constraints_of(s, pairs_of(s));
  EXPECT_EQ(c.of_pair, (std::vector<std::uint8_t>{2, 1}));
  EXPECT_FALSE(c.from_points);
  EXPECT_EQ(degrees_of_freedom(s, 0), 3);
}

TEST(AnalysisConstraints, RoundBodiesAndBodiesOfParts) {
  const Snapshot spheres = sets::face_centred();
  for (const std::uint8_t n : constraints_of(spheres, pairs_of(spheres)).of_pair) EXPECT_EQ(n, 1);
  EXPECT_EQ(degrees_of_freedom(spheres, 0), 3);
  Snapshot s;
  s.shapes.emplace_back().kind = shapes::Kind::compound;
  s.materials.emplace_back("glass");
  sets::add_body(s, {0, 0, 0.5}, 0.5);
  s.walls.resize(1);
  for (const Vec3d& x : {Vec3d{0.3, 0, 0}, Vec3d{-0.3, 0.1, 0}, Vec3d{0, -0.3, 0}}) {
    sets::touch_wall(s, 0, 0, {0, 0, -1});
    s.contacts.back().point = x;
    const Constraints c = constraints_of(s, pairs_of(s));
    EXPECT_EQ(c.of_wall.at(0), s.contacts.size());  // points: 1, 2 in line, 3
    EXPECT_TRUE(c.from_points);
  }
}

}  // namespace
}  // namespace dem::analysis
