// Rounded polyhedra on meshes: a floor of any triangulation is the plane, a convex mesh answers once and like the
// solid, a concave edge is silent, faces that hang over a border are met by the face.
#include <gtest/gtest.h>

#include <algorithm>

#include "libcontact/methods/rounded.h"
#include "shapes/mesh_build.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;
using shapes::Mesh;

Mesh box_mesh(const Vec3d& half) {
  const Polyhedron box = shapes::make_box(2.0 * half);
  std::vector<std::uint32_t> triangles;
  for (const auto& f : box.faces)
    for (std::uint32_t k = 1; k + 1 < f.count; ++k)
      for (const std::uint32_t i : {0u, k, k + 1}) triangles.push_back(box.face_vertices[f.first + i]);
  return shapes::mesh_from_triangles(box.vertices, triangles);
}

Mesh mesh_of(const std::vector<Vec3d>& vertices, const std::vector<std::uint32_t>& triangles) {
  return shapes::mesh_from_triangles(vertices, triangles);
}

Placed<Mesh> wall(const Mesh& mesh, std::uint32_t facet, const Mat3d& rotation = Mat3d::identity()) {
  return {&mesh, facet, 1, rotation};
}

TEST(RoundedMesh, FloorOfTwoTrianglesIsThePlane) {
  Draw draw(7);
  const Mesh mesh = mesh_of({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {0, 1, 2, 0, 2, 3});
  const Polyhedron solids[2] = {shapes::make_box({0.5, 0.4, 0.3}), grain("cement140_06.off")};
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Polyhedron& solid = solids[i % 2];
    const Mat3d turn = rotation_matrix(draw.orientation()), own = rotation_matrix(draw.orientation());
    const double scale = 0.5 / solid.circumradius, radius = draw.between(0.02, 0.3);
    const Placed<shapes::RoundedPolyhedron> body{{&solid, scale, own}, radius};
    const Vec3d centre{draw.between(-1, 1), draw.between(-1, 1), draw.between(radius + 0.01, 1.0)};
    const Vec3d offset = -(turn * centre);
    const Contact facet = Rounded::query(body, wall(mesh, 0, turn), offset, {}, nullptr);
    const Contact plane = Rounded::query(body, Placed<shapes::Plane>{turn.column(2)}, offset, {}, nullptr);
    ASSERT_EQ(facet.status, plane.status) << i;
    ASSERT_NEAR(facet.gap, plane.gap, 1e-13) << i;
    ASSERT_LE(norm(facet.normal - plane.normal), 1e-13) << i;
    ASSERT_LE(norm(facet.point_b - plane.point_b), 1e-6) << i;
    if (plane.gap > 0) continue;
    ++touching;
    ASSERT_LE(norm(facet.patch.centre - plane.patch.centre), 1e-12) << i;
    for (int k = 0; k < 6; ++k) ASSERT_NEAR(facet.patch.spread[k], plane.patch.spread[k], 1e-12) << i;
  }
  EXPECT_GT(touching, 500);
}

// As the core stays outside the box, exactly one facet answers, with the gap and normal of the solid box.
TEST(RoundedMesh, ConvexBoxAnswersOnceLikeTheSolid) {
  Draw draw(11);
  const Vec3d half{1, 0.7, 0.4};
  const Mesh mesh = box_mesh(half);
  const Polyhedron box = shapes::make_box(2.0 * half);
  const Polyhedron solids[2] = {shapes::make_box({0.5, 0.4, 0.3}), grain("cement140_06.off")};
  int faces = 0, edges = 0;
  for (int i = 0; i < 8000; ++i) {
    const Polyhedron& solid = solids[i % 2];
    const double scale = 0.4 / solid.circumradius, radius = 0.2;
    const Placed<shapes::RoundedPolyhedron> body{{&solid, scale, rotation_matrix(draw.orientation())}, radius};
    const Vec3d centre{draw.between(-1.6, 1.6), draw.between(-1.3, 1.3), draw.between(-1, 1)};
    const Placed<Polyhedron> whole{&box, 1, Mat3d::identity()};
    const Contact c = Rounded::query(whole, body, centre, {}, nullptr);
    if (!(c.gap < -1e-9 && c.gap > -radius + 1e-9)) continue;  // the cores apart, in reach
    int answers = 0;
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
      const Contact r = Rounded::query(body, wall(mesh, f), -centre, {}, nullptr);
      if (r.status != Status::overlapping) continue;
      ++answers;
      ASSERT_NEAR(r.gap, c.gap, 1e-12) << i;
      ASSERT_LE(norm(r.normal + c.normal), 1e-7) << i;
      (max_abs(r.normal) > 1 - 1e-12 ? faces : edges) += 1;
    }
    ASSERT_EQ(answers, 1) << i << " gap " << c.gap;
  }
  EXPECT_GT(faces, 100);
  EXPECT_GT(edges, 100);
}

// A box flat on the table's edge, most of it outside, each corner of the face that hangs over included.
TEST(RoundedMesh, AFaceThatHangsOverIsMetByTheFaceOnce) {
  const Vec3d half{1, 1, 0.5};
  const Mesh mesh = box_mesh(half);
  const Polyhedron brick = shapes::make_box({0.6, 0.4, 0.3});
  for (const double overhang : {0.0, 0.1, 0.25, 0.29, 0.299}) {
    for (const double angle : {0.0, 0.3, 1.1}) {
      const Placed<shapes::RoundedPolyhedron> body{
          {&brick, 1, rotation_matrix(Quatd{std::cos(0.5 * angle), 0, 0, std::sin(0.5 * angle)})}, 0.1};
      const Vec3d centre{1 + overhang - 0.1, 0.2, 0.5 + 0.15 + 0.1 - 0.02};
      int answers = 0;
      for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const Contact r = Rounded::query(body, wall(mesh, f), -centre, {.overlap_only = true, .patch = true}, nullptr);
        if (r.status != Status::overlapping) continue;
        ++answers;
        EXPECT_NEAR(r.gap, -0.02, 1e-14);
        EXPECT_LE(norm(r.normal - Vec3d{0, 0, -1}), 1e-14);
        EXPECT_GT(r.patch.spread[1], 0) << "a patch of the face";
      }
      EXPECT_EQ(answers, 1) << overhang << " " << angle;
    }
  }
}

TEST(RoundedMesh, ConcaveEdgeIsSilent) {
  // A floor and a wall that meet at x = 0; the body lies in the corner.
  const Mesh mesh = mesh_of({{0, -2, 0}, {2, -2, 0}, {2, 2, 0}, {0, 2, 0}, {0, -2, 2}, {0, 2, 2}},
                            {0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4});
  ASSERT_EQ(mesh.facets.size(), 2u);
  Draw draw(3);
  const Polyhedron brick = shapes::make_box({0.5, 0.4, 0.3});
  for (int i = 0; i < 1000; ++i) {
    const Mat3d r = rotation_matrix(draw.orientation());
    const Placed<shapes::RoundedPolyhedron> body{{&brick, 1, r}, 0.1};
    // Sunk by 0.02 into both, as the planes see it.
    const auto reach = [&](const Vec3d& n) {
      double most = 0;
      for (const Vec3d& v : brick.vertices) most = std::max(most, dot(n, r * v));
      return most + 0.1 - 0.02;
    };
    const Vec3d centre{reach({-1, 0, 0}), draw.between(-0.5, 0.5), reach({0, 0, -1})};
    for (std::uint32_t f = 0; f < 2; ++f) {
      const Contact c = Rounded::query(body, wall(mesh, f), -centre, {}, nullptr);
      ASSERT_EQ(c.status, Status::overlapping) << i;
      ASSERT_NEAR(c.gap, -0.02, 1e-13) << i;
      ASSERT_GT(max_abs(c.normal), 1 - 1e-13) << i;
    }
  }
}

// Pushed down through the surface of a box near its edge: the gap falls steadily, without a jump where the core begins
// to cross.
TEST(RoundedMesh, TheGapIsContinuousAsTheCoreBeginsToCross) {
  Draw draw(5);
  const Mesh mesh = box_mesh({1, 1, 1});
  const Polyhedron solid = grain("cement140_06.off");
  const double scale = 0.4 / solid.circumradius, step = 1e-3;
  for (int i = 0; i < 60; ++i) {
    const Placed<shapes::RoundedPolyhedron> body{{&solid, scale, rotation_matrix(draw.orientation())}, 0.1};
    const double x = draw.between(0.2, 0.75), y = draw.between(-0.5, 0.5);
    double before = 0;
    for (double z = 1.5; z > 1.2; z -= step) {
      double least = 1;
      for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const Contact c = Rounded::query(body, wall(mesh, f), -Vec3d{x, y, z}, {}, nullptr);
        if (!std::isinf(c.gap_upper)) least = std::min(least, c.gap);
      }
      if (z < 1.5) {
        ASSERT_LE(std::abs(least - before), 1.01 * step) << i << " at " << z;
      }
      before = least;
    }
  }
}

}  // namespace
