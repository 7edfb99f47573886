// Polygons: canonical form, moments, refusals.
#include <gtest/gtest.h>

#include <vector>

#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace {

using shapes::Vec3d;

TEST(Polygon, outline_is_canonical_and_its_moments_are_exact) {
  // Clockwise square with a doubled corner and a vertex on an edge.
  const std::vector<Vec3d> given{{1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {3, 1, 0}, {2, 1, 0}, {1, 1, 0}};
  const shapes::Polygon p = shapes::polygon_from_outline(given);
  ASSERT_EQ(p.vertices.size(), 4u);
  EXPECT_TRUE(p.vertices[0] == (Vec3d{1, 1, 0}) && p.vertices[1] == (Vec3d{3, 1, 0}));
  EXPECT_TRUE(p.convex);
  EXPECT_DOUBLE_EQ(p.area, 4);
  EXPECT_TRUE(p.centroid == (Vec3d{2, 2, 0}));
  EXPECT_DOUBLE_EQ(p.second_moment, 4 * (4 + 4) / 12.0);
  EXPECT_TRUE(p.normals[0] == (Vec3d{0, -1, 0}));
  EXPECT_DOUBLE_EQ(p.offsets[0], -1);
}

TEST(Polygon, an_l_shape_is_not_convex) {
  const std::vector<Vec3d> l{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const shapes::Polygon p = shapes::polygon_from_outline(l);
  EXPECT_FALSE(p.convex);
  EXPECT_DOUBLE_EQ(p.area, 3);
  EXPECT_DOUBLE_EQ(p.centroid.x, 2.5 / 3);
  // Squares of side 1 about (½, ½), (3/2, ½), (½, 3/2).
  EXPECT_NEAR(p.second_moment, 11.0 / 6, 1e-14);
  EXPECT_EQ(shapes::polygon_hull(l).vertices.size(), 5u);
}

TEST(Polygon, crossing_and_flat_outlines_are_refused) {
  const std::vector<Vec3d> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Vec3d> flat{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}};
  EXPECT_THROW(shapes::polygon_from_outline(bow), shapes::Error);
  EXPECT_THROW(shapes::polygon_from_outline(flat), shapes::Error);
  EXPECT_THROW(shapes::polygon_hull(flat), shapes::Error);
}

}  // namespace
