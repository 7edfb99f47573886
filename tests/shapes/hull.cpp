// Hull: canonical form, and all that it must not depend on.
#include "shapes/geometry.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;
using shapes::polyhedron_from_points;

TEST(Hull, random_points_are_canonical_in_both_frames) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u})
    for (const int count : {4, 5, 12, 60, 400})
      for (const Frame frame : {Frame::as_given, Frame::principal})
        expect_canonical(polyhedron_from_points(random_points(seed, count), frame));
}

TEST(Hull, holds_every_point_and_keeps_coordinates_as_given) {
  const auto points = random_points(7, 200);
  const Polyhedron p = polyhedron_from_points(points, Frame::as_given);
  for (const auto& face : p.faces)
    for (const Vec3d& x : points) EXPECT_LE(dot(face.normal, x), face.offset + 64 * eps);
  std::size_t at = 0;  // vertices are a subsequence of the input, bit for bit
  for (const Vec3d& v : p.vertices) {
    while (at < points.size() && !(points[at] == v)) ++at;
    ASSERT_LT(at++, points.size());
  }
}

TEST(Hull, does_not_depend_on_order_duplicates_or_points_that_are_not_extreme) {
  for (const Frame frame : {Frame::as_given, Frame::principal}) {
    auto points = random_points(11, 40);
    const Polyhedron p = polyhedron_from_points(points, Frame::as_given);
    const auto reference = fingerprint(polyhedron_from_points(points, frame));
    points.insert(points.end(), p.vertices.begin(), p.vertices.end());
    for (const auto& e : p.edges) points.push_back(0.5 * (p.vertices[e.vertex[0]] + p.vertices[e.vertex[1]]));
    for (const auto& f : p.faces) {
      Vec3d middle{};
      for (std::uint32_t i = 0; i < f.count; ++i) middle += p.vertices[p.face_vertices[f.first + i]];
      points.push_back(middle * (1.0 / f.count));
      points.push_back(middle * (0.9 / f.count));
    }
    Random random(3);
    for (int repeat = 0; repeat < 20; ++repeat) {
      random.shuffle(points);
      EXPECT_EQ(fingerprint(polyhedron_from_points(points, frame)), reference);
    }
  }
}

TEST(Hull, grid_of_a_rotated_cube_is_a_cube) {
  Random random(5);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto rotation = random.rotation();
    const Vec3d shift = random.in_box({-9, -9, -9}, {9, 9, 9});
    std::vector<Vec3d> points;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j)
        for (int k = 0; k < 5; ++k) points.push_back(rotate(rotation, Vec3d{i / 3.0, j / 3.0, k / 3.0}) + shift);
    const Polyhedron p = polyhedron_from_points(points, Frame::as_given);
    expect_canonical(p);
    EXPECT_EQ(p.vertices.size(), 8u);
    EXPECT_EQ(p.faces.size(), 6u);
  }
}

TEST(Hull, faces_that_differ_in_the_fifth_decimal_stay_apart) {
  const std::vector<Vec3d> roof = {{0, 0, 0},         {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.5, 1.00001},
                                   {1, 0.5, 1.00001}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const Polyhedron p = polyhedron_from_points(roof, Frame::as_given);
  expect_canonical(p);
  EXPECT_EQ(p.faces.size(), 7u);
  EXPECT_EQ(p.vertices.size(), 10u);
}

TEST(Hull, change_of_units_by_powers_of_two_gives_the_same_bits) {
  const auto points = random_points(13, 50);
  for (const Frame frame : {Frame::as_given, Frame::principal}) {
    const Polyhedron p = polyhedron_from_points(points, frame);
    for (const int k : {-300, -20, -1, 20, 300}) {
      auto moved = points;
      for (Vec3d& v : moved) v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
      const Polyhedron q = polyhedron_from_points(moved, frame);
      EXPECT_EQ(fingerprint(q, k), fingerprint(p));
      EXPECT_EQ(fingerprint(scaled(p, std::ldexp(1.0, k)), k), fingerprint(p));
      EXPECT_EQ(p.face_vertices, q.face_vertices);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_EQ(q.mass.inertia.row[i][j], std::ldexp(p.mass.inertia.row[i][j], 5 * k));
    }
  }
}

TEST(Hull, principal_frame_maps_back_to_the_input) {
  auto points = random_points(17, 30);
  for (Vec3d& v : points) v += Vec3d{5, -3, 2};
  const Polyhedron given = polyhedron_from_points(points, Frame::as_given);
  const Polyhedron p = polyhedron_from_points(points, Frame::principal);
  ASSERT_EQ(p.vertices.size(), given.vertices.size());
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    EXPECT_LE(max_abs(rotate(p.frame.orientation, p.vertices[i]) + p.frame.position - given.vertices[i]), 8 * eps * 6);
  EXPECT_LE(p.mass.inertia.row[0].x, p.mass.inertia.row[1].y);
  EXPECT_LE(p.mass.inertia.row[1].y, p.mass.inertia.row[2].z);
  const auto again =
      polyhedron_from_points(p.vertices, Frame::as_given).mass;  // computed afresh from the moved vertices
  EXPECT_LE(max_abs(again.centre), 4 * eps * p.circumradius);
  EXPECT_LE(std::fabs(again.inertia.row[0].y), 1e-14 * again.inertia.row[2].z);
  EXPECT_LE(std::fabs(again.inertia.row[0].z), 1e-14 * again.inertia.row[2].z);
  EXPECT_LE(std::fabs(again.inertia.row[1].z), 1e-14 * again.inertia.row[2].z);
  EXPECT_EQ(fingerprint(polyhedron_from_points(p.vertices, Frame::principal)).size(), fingerprint(p).size());
}

TEST(Hull, box_keeps_exact_corners_and_axes) {
  const Vec3d size{0.3, 0.1, 0.7};
  const Polyhedron p = shapes::make_box(size);
  expect_canonical(p);
  ASSERT_EQ(p.vertices.size(), 8u);
  ASSERT_EQ(p.faces.size(), 6u);
  for (const Vec3d& v : p.vertices)
    EXPECT_TRUE(std::fabs(v.x) == size.x / 2 && std::fabs(v.y) == size.y / 2 && std::fabs(v.z) == size.z / 2);
  for (const auto& f : p.faces) {
    EXPECT_EQ(max_abs(f.normal), 1);
    EXPECT_EQ(f.offset, dot(scaled(f.normal, f.normal), size) / 2);
  }
  EXPECT_TRUE(p.frame.position == Vec3d{} && p.frame.orientation.w == 1);
  EXPECT_EQ(p.inscribed_radius, 0.05);
}

TEST(Hull, thin_plates_and_needles) {
  for (const double thin : {1e-3, 1e-6, 1e-9}) {
    for (const Vec3d& size : {Vec3d{1, 1, thin}, Vec3d{1, thin, thin}}) {
      const Polyhedron p = shapes::make_box(size);
      expect_canonical(p);
      EXPECT_EQ(p.faces.size(), 6u);
      EXPECT_NEAR(p.mass.volume / (size.x * size.y * size.z), 1, 8 * eps);
    }
  }
}

TEST(Hull, refuses_what_has_no_volume) {
  const auto refused = [](std::vector<Vec3d> points) {
    return refusal([&] { polyhedron_from_points(points, Frame::as_given); });
  };
  EXPECT_TRUE(holds(refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "3 points"));
  EXPECT_TRUE(holds(refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.2, 0.3, 0}}), "volume"));
  EXPECT_TRUE(holds(refused({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), "volume"));
  EXPECT_TRUE(holds(refused({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), "volume"));
  EXPECT_TRUE(holds(refused({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), "volume"));
  EXPECT_TRUE(holds(refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, NAN}}), "point 3"));
  EXPECT_TRUE(holds(refusal([] { shapes::make_box({1, -2, 1}); }), "box size"));
  EXPECT_TRUE(holds(refusal([] { shapes::make_prism(2, 1, 1); }), "prism sides: 2"));
  EXPECT_TRUE(holds(refusal([] { scaled(shapes::make_box({1, 1, 1}), 0); }), "scale"));
}

}  // namespace
}  // namespace shape_tests
