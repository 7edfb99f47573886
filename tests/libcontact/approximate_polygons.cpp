// Clipped areas and vertices in triangles: closed forms, kinds of contact, cuts that give nothing, and random pairs of
// polygons that are not convex against a grid.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libcontact/dispatch.h"
#include "libcontact/methods/clip.h"
#include "libcontact/methods/vertex_triangle.h"
#include "shapes/polygon_build.h"

namespace {

using namespace contact;
using shapes::Polygon;

using Outline = std::vector<Vec3d>;

Placed<Polygon> place(const Polygon& p, double angle = 0) { return {&p, 1, std::cos(angle), std::sin(angle)}; }

const Polygon& square() {
  static const Polygon p = shapes::polygon_hull(Outline{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  return p;
}
const Polygon& bar() {
  static const Polygon p = shapes::polygon_hull(Outline{{-3, -0.25, 0}, {3, -0.25, 0}, {3, 0.25, 0}, {-3, 0.25, 0}});
  return p;
}
// The unit square less its upper right quarter, in units of 2.
const Polygon& ell() {
  static const Polygon p =
      shapes::polygon_from_outline(Outline{{-1, -1, 0}, {1, -1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}});
  return p;
}

Contact clip(const Placed<Polygon>& a, const Placed<Polygon>& b, const Vec3d& d) {
  return Clip::query(a, b, d, {}, nullptr);
}

TEST(Clip, areas_of_squares) {
  // Face on face: a strip of 0.25 × 1.5.
  const Contact strip = clip(place(square()), place(square()), {1.75, 0.5, 0});
  EXPECT_FALSE(strip.handed_over);
  // Two outlines that cross in (1, −0.5) and (0.75, 1): the line of contact is their chord.
  EXPECT_NEAR(strip.method_overlap, 0.25 * 1.5 / std::hypot(0.25, 1.5), 8 * epsilon);
  EXPECT_NEAR(strip.method_normal.x, 1.5 / std::hypot(0.25, 1.5), 8 * epsilon);
  EXPECT_NEAR(strip.method_normal.y, 0.25 / std::hypot(0.25, 1.5), 8 * epsilon);
  EXPECT_NEAR(strip.method_point.x, 0.875, 8 * epsilon);
  EXPECT_NEAR(strip.method_point.y, 0.25, 8 * epsilon);
  // A corner in a face: a triangle of depth h and base 2 h.
  const double h = 0.125;
  const Contact corner = clip(place(square()), place(square(), M_PI / 4), {1 + std::sqrt(2) - h, 0.25, 0});
  EXPECT_NEAR(corner.method_overlap, 0.5 * h, 64 * epsilon);
  EXPECT_NEAR(corner.method_normal.x, 1, 8 * epsilon);
  EXPECT_NEAR(corner.gap, -h, 64 * epsilon);
  EXPECT_LE(corner.gap_upper, 0);
  // Apart, and one in the other: no line of contact.
  EXPECT_TRUE(clip(place(square()), place(square()), {2.5, 0, 0}).handed_over);
  const Polygon small = shapes::make_regular_polygon(5, 0.25);
  EXPECT_TRUE(clip(place(square()), place(small), {0.125, 0, 0}).handed_over);
}

// The L is the square less a quarter, whatever it is cut into.
TEST(Clip, cuts_add_nothing) {
  const Contact c = clip(place(ell()), place(square()), {1.75, -1.5, 0});  // overlap [0.75, 1] × [−1, −0.5]
  EXPECT_NEAR(c.method_overlap, 0.25 * 0.5 / std::hypot(0.25, 0.5), 16 * epsilon);
  EXPECT_NEAR(c.method_point.x, 0.875, 16 * epsilon);
  EXPECT_NEAR(c.method_point.y, -0.75, 16 * epsilon);
  // A block over the whole corner of the L, across its cut: S = (0.5, 0.5), area 0.25 · 1.25 + 0.25 · 1.
  const Contact both = clip(place(ell()), place(square()), {0.75, 0.75, 0});
  EXPECT_NEAR(both.method_overlap, 0.5625 / std::hypot(1.25, 1.25), 16 * epsilon) << both.method_overlap;
  EXPECT_NEAR(both.method_normal.x, both.method_normal.y, 16 * epsilon);
}

// The area falls by S·e as b moves along e: it is piecewise quadratic, so that central differences are exact.
TEST(Clip, surface_is_the_gradient_of_the_area) {
  const Placed<Polygon> a = place(ell(), 0.3), b = place(ell(), 2.1);
  for (const Vec3d& d : {Vec3d{1.1, 0.625, 0}, Vec3d{-0.9, 0.3, 0}, Vec3d{0.2, 1.25, 0}}) {
    const ClippedArea at = clipped_area(a, b, d);
    EXPECT_GT(at.area, 0.01);
    for (const Vec3d& e : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}) {
      const double step = 0x1p-14;
      const double change = clipped_area(a, b, d + step * e).area - clipped_area(a, b, d - step * e).area;
      EXPECT_NEAR(change / (2 * step), -dot(at.surface, e), 1e-11);
    }
  }
}

std::vector<VertexContact> contacts(const Placed<Polygon>& a, const Placed<Polygon>& b, const Vec3d& d) {
  VertexContact out[16];
  const std::size_t count = vertex_triangle_contacts(a, b, d, out, 16);
  return {out, out + count};
}

TEST(VertexTriangle, kinds_of_contact) {
  // Two squares, the right one half a side higher: a corner of each behind the other's face, and these are parallel.
  const auto shifted = contacts(place(square()), place(square()), {1.75, 0.5, 0});
  ASSERT_EQ(shifted.size(), 2u);
  for (const VertexContact& c : shifted) {
    EXPECT_EQ(c.kind, VertexContact::face_face);
    EXPECT_NEAR(c.depth, 0.25, 8 * epsilon);
    EXPECT_NEAR(c.normal.x, 1, 8 * epsilon);
  }
  // A smaller face on a larger one: both its corners behind one edge.
  const Polygon small = shapes::make_regular_polygon(4, 0.5);
  const auto flat = contacts(place(square()), place(small, M_PI / 4), {1 + 0.5 / std::sqrt(2) - 0.0625, 0, 0});
  ASSERT_EQ(flat.size(), 2u);
  for (const VertexContact& c : flat) EXPECT_EQ(c.kind, VertexContact::face_face);
  // A corner in a face.
  const auto corner = contacts(place(square()), place(square(), M_PI / 4), {1 + std::sqrt(2) - 0.125, 0.25, 0});
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0].kind, VertexContact::face_corner);
  EXPECT_FALSE(corner[0].vertex_of_a);
  EXPECT_NEAR(corner[0].depth, 0.125, 8 * epsilon);
  EXPECT_NEAR(corner[0].normal.x, 1, 8 * epsilon);
  // Two corners, one turned: each lies inside the other body.
  const auto corners = contacts(place(square()), place(square(), 0.25), {1.65, 1.9, 0});
  ASSERT_EQ(corners.size(), 2u);
  for (const VertexContact& c : corners) EXPECT_EQ(c.kind, VertexContact::corner_corner);
}

TEST(VertexTriangle, bars_that_cross_are_handed_over_and_never_apart) {
  EXPECT_TRUE(contacts(place(bar()), place(bar(), M_PI / 2), {0.5, 0.25, 0}).empty());
  const Contact c = VertexTriangle::query(place(bar()), place(bar(), M_PI / 2), {0.5, 0.25, 0}, {}, nullptr);
  EXPECT_TRUE(c.handed_over);
  EXPECT_EQ(c.status, Status::overlapping);
}

// A corner deep in the L, near the cut from its reflex corner: the nearest edge is one of the outline.
TEST(VertexTriangle, inner_edges_give_no_normal) {
  std::mt19937_64 engine(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = uniform(-3, 3);
    const Vec3d d{uniform(-2, 2), uniform(-2, 2), 0};
    for (const VertexContact& c : contacts(place(ell()), place(square(), angle), d)) {
      ++found;
      if (c.vertex_of_a) continue;
      EXPECT_NEAR(std::abs(c.normal.x) + std::abs(c.normal.y), 1, 1e-15);  // edges of the L lie along the axes
    }
    const Contact c = VertexTriangle::query(place(ell()), place(square(), angle), d, {}, nullptr);
    Contact exact =
        query({shapes::Kind::polygon, 0, &ell(), {1, 0, 0}},
              {shapes::Kind::polygon,
               0,
               &square(),
               {1, 0, 0},
               {{{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}}},
              d);
    EXPECT_EQ(c.status, exact.status);
    EXPECT_EQ(c.gap, exact.gap);
  }
  EXPECT_GT(found, 200);
}

}  // namespace
