// Bodies from half-spaces.
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;
using shapes::HalfSpace;
using shapes::polyhedron_from_half_spaces;

std::vector<HalfSpace> planes_of(const Polyhedron& p) {
  std::vector<HalfSpace> planes;
  for (const auto& f : p.faces) planes.push_back({f.normal, f.offset});
  return planes;
}

std::vector<HalfSpace> cube_planes() {
  return {{{1, 0, 0}, 0.5},  {{-2, 0, 0}, 1},  {{0, 3, 0}, 1.5},
          {{0, -1, 0}, 0.5}, {{0, 0, 1}, 0.5}, {{0, 0, -0.25}, 0.125}};
}

TEST(HalfSpaces, cube_comes_out_to_the_bit_whatever_the_order_and_redundant_planes) {
  auto planes = cube_planes();
  const auto reference = fingerprint(shapes::make_box({1, 1, 1}));
  planes.push_back({{1, 1, 1}, 2});
  planes.push_back({{0, 0, 2}, 1});  // a plane twice
  planes.push_back({{0, 1, 0}, 0.75});
  Random random(1);
  for (int repeat = 0; repeat < 50; ++repeat) {
    random.shuffle(planes);
    const Polyhedron p = polyhedron_from_half_spaces(planes, Frame::principal);
    expect_canonical(p);
    EXPECT_EQ(fingerprint(p), reference);
  }
}

TEST(HalfSpaces, round_trip_of_hulls) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    auto points = random_points(seed, 30);
    for (Vec3d& v : points) v += Vec3d{0.3, 2, -0.8};  // origin outside
    const Polyhedron p = shapes::polyhedron_from_points(points, Frame::as_given);
    const Polyhedron q = polyhedron_from_half_spaces(planes_of(p), Frame::as_given);
    expect_canonical(q);
    ASSERT_EQ(q.vertices.size(), p.vertices.size());
    EXPECT_EQ(q.faces.size(), p.faces.size());
    for (const Vec3d& v : q.vertices) {
      double nearest = 10;
      for (const Vec3d& w : p.vertices) nearest = std::fmin(nearest, max_abs(v - w));
      EXPECT_LE(nearest, 1e-13);  // 450 eps of the size: planes of random hulls meet at angles down to a few degrees
    }
  }
}

// An apex where many planes meet within rounding stays one corner.
TEST(HalfSpaces, pyramids_and_rotated_solids_keep_their_corners) {
  Random random(2);
  for (const int sides : {4, 5, 8, 12}) {
    std::vector<Vec3d> points;
    const Polyhedron base = shapes::make_prism(sides, 1, 1);
    for (const Vec3d& v : base.vertices)
      if (v.z < 0) points.push_back(v);
    points.push_back({0, 0, 1});
    const auto rotation = random.rotation();
    for (Vec3d& v : points) v = rotate(rotation, v);
    const Polyhedron p = shapes::polyhedron_from_points(points, Frame::as_given);
    const Polyhedron q = polyhedron_from_half_spaces(planes_of(p), Frame::as_given);
    expect_canonical(q);
    EXPECT_EQ(q.vertices.size(), points.size());
    EXPECT_EQ(q.faces.size(), points.size());
  }
}

TEST(HalfSpaces, thin_plates) {
  for (const double thin : {1e-3, 1e-6, 1e-9}) {
    const Polyhedron p = shapes::make_box({1, 0.5, thin});
    EXPECT_EQ(fingerprint(polyhedron_from_half_spaces(planes_of(p), Frame::principal)), fingerprint(p)) << thin;
  }
}

TEST(HalfSpaces, platonic_solids_keep_their_faces) {
  for (const auto solid : {shapes::Platonic::tetrahedron, shapes::Platonic::octahedron, shapes::Platonic::dodecahedron,
                           shapes::Platonic::icosahedron}) {
    const Polyhedron p = shapes::make_platonic(solid, 2.5);
    const Polyhedron q = polyhedron_from_half_spaces(planes_of(p), Frame::principal);
    expect_canonical(q);
    EXPECT_EQ(q.faces.size(), p.faces.size());
    EXPECT_EQ(q.vertices.size(), p.vertices.size());
    EXPECT_NEAR(q.mass.volume / p.mass.volume, 1, 32 * eps);
  }
}

TEST(HalfSpaces, change_of_units_gives_the_same_bits) {
  const auto planes = planes_of(shapes::polyhedron_from_points(random_points(9, 40), Frame::as_given));
  const auto reference = fingerprint(polyhedron_from_half_spaces(planes, Frame::principal));
  for (const int k : {-300, -20, 20, 300}) {
    auto moved = planes;
    for (HalfSpace& h : moved) h.offset = std::ldexp(h.offset, k);
    EXPECT_EQ(fingerprint(polyhedron_from_half_spaces(moved, Frame::principal), k), reference);
  }
}

TEST(HalfSpaces, refuses_empty_and_unbounded) {
  const auto refused = [](const std::vector<HalfSpace>& planes) {
    return refusal([&] { polyhedron_from_half_spaces(planes, Frame::as_given); });
  };
  auto planes = cube_planes();
  planes.push_back({{1, 0, 0}, -0.75});
  EXPECT_TRUE(holds(refused(planes), "empty"));
  planes.back() = {{1, 0, 0}, -0.5};  // a face is left
  EXPECT_TRUE(holds(refused(planes), "no interior"));
  for (std::size_t missing = 0; missing < 6; ++missing) {
    planes = cube_planes();
    planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_TRUE(holds(refused(planes), "unbounded")) << missing;
  }
  EXPECT_TRUE(holds(refused({{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}}), "unbounded"));
  planes = cube_planes();
  planes[2].normal = {};
  EXPECT_TRUE(holds(refused(planes), "half-space 2"));
  EXPECT_TRUE(holds(refused({}), "at least 4"));
}

}  // namespace
}  // namespace shape_tests
