// gjk_epa and mpr by themselves: closed forms, and what they say beside the exact methods.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/polyhedron_build.h"

namespace {

using namespace contact;
using shapes::Kind;

struct Draw {
  std::mt19937_64 engine{41};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (const double s = dot(v, v); s > 0.01 && s < 1) return normalized(v);
    }
  }
  Mat3d rotation() {
    return rotation_matrix(normalized(shapes::Quatd{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}));
  }
};

const std::vector<shapes::Polyhedron>& solids() {
  using enum shapes::Platonic;
  static const std::vector<shapes::Polyhedron> list{
      shapes::make_box({1, 1.5, 2}), shapes::make_box({2, 2, 0.25}), shapes::make_platonic(tetrahedron, 1),
      shapes::make_platonic(icosahedron, 1), shapes::make_prism(7, 0.5, 1.5)};
  return list;
}

Body sample(Kind kind, Draw& draw) {
  Body b{kind, 0, nullptr, {draw.uniform(0.3, 1.2), 0, 0}, draw.rotation()};
  if (kind == Kind::ellipsoid) b.size = {draw.uniform(0.3, 1.2), draw.uniform(0.3, 1.2), draw.uniform(0.3, 1.2)};
  if (kind == Kind::polyhedron) b.geometry = &solids()[draw.engine() % solids().size()];
  return b;
}

const std::pair<Kind, Kind> pairs[] = {{Kind::sphere, Kind::ellipsoid},
                                       {Kind::sphere, Kind::polyhedron},
                                       {Kind::ellipsoid, Kind::ellipsoid},
                                       {Kind::ellipsoid, Kind::polyhedron},
                                       {Kind::polyhedron, Kind::polyhedron}};

// Apart or in a shallow overlap gjk_epa finds the gap, and its interval closes to a millionth; of bodies with corners
// alone to rounding.
TEST(ConvexMethods, gjk_epa_finds_the_gap) {
  for (const auto& [ka, kb] : pairs) {
    Draw draw;
    int handed = 0, open = 0;
    for (int i = 0; i < 300; ++i) {
      const Body a = sample(ka, draw), b = sample(kb, draw);
      const double reach = circumradius(a) + circumradius(b);
      const Vec3d d = draw.uniform(0.4, 1.1) * reach * draw.direction();
      const Contact c = query(a, b, d, {}, "gjk_epa"), exact = query(a, b, d);
      SCOPED_TRACE(std::string(name_of(ka)) + " " + name_of(kb) + " " + std::to_string(i));
      const double size = reach + norm(d);
      handed += c.handed_over;
      open += c.status == Status::not_converged;
      EXPECT_LE(c.gap_lower, exact.gap_upper);
      EXPECT_GE(c.gap_upper, exact.gap_lower);
      if (c.status != Status::not_converged) {
        EXPECT_NEAR(c.gap, exact.gap, 1.1e-6 * size);
      }
      const bool corners = ka == Kind::polyhedron || (ka == Kind::sphere && kb == Kind::polyhedron);
      if (corners && !c.handed_over) {
        EXPECT_NEAR(c.gap, exact.gap, 2e-10 * size);
      }
    }
    EXPECT_LE(handed, 6);
    EXPECT_LE(open, 6) << name_of(ka) << " " << name_of(kb);
  }
}

// mpr decides overlap; its depth is that along its own normal, never less than the least translation, at times far
// more.
TEST(ConvexMethods, mpr_decides_overlap_and_is_never_shallower) {
  for (const auto& [ka, kb] : pairs) {
    Draw draw;
    int handed = 0, open = 0, deeper = 0;
    for (int i = 0; i < 300; ++i) {
      const Body a = sample(ka, draw), b = sample(kb, draw);
      const double reach = circumradius(a) + circumradius(b);
      const Vec3d d = draw.uniform(0.4, 1.1) * reach * draw.direction();
      const Contact c = query(a, b, d, {}, "mpr"), exact = query(a, b, d);
      SCOPED_TRACE(std::string(name_of(ka)) + " " + name_of(kb) + " " + std::to_string(i));
      handed += c.handed_over;
      open += c.status == Status::not_converged;
      const double tolerance = 1e-9 * (reach + norm(d));
      if (std::abs(exact.gap) > tolerance) {
        EXPECT_EQ(c.method_overlap > 0, exact.gap < 0) << c.method_overlap << " " << exact.gap;
      }
      EXPECT_GE(c.method_overlap, -exact.gap - tolerance);
      EXPECT_NEAR(c.gap, -c.method_overlap, tolerance);
      deeper += exact.gap < 0 && c.method_overlap > 1.05 * -exact.gap;
    }
    EXPECT_LE(handed, 3);
    EXPECT_EQ(open, 0) << name_of(ka) << " " << name_of(kb);
    EXPECT_GT(deeper, 5);
  }
}

TEST(ConvexMethods, a_ball_in_a_face_and_beside_it) {
  const shapes::Polyhedron cube = shapes::make_box({2, 2, 2});
  Body ball, box;
  ball.size = {0.5, 0, 0};
  box.kind = Kind::polyhedron;
  box.geometry = &cube;
  box.size = {1, 0, 0};
  for (const char* method : {"gjk_epa", "mpr"})
    for (const double x : {1.25, 1.4375, 1.75}) {  // the centre outside: of the face, apart from it in the end
      const Contact c = query(ball, box, {-x, 0.25, 0.125}, {}, method);
      SCOPED_TRACE(std::string(method) + " " + std::to_string(x));
      EXPECT_LE(c.gap, x - 1.5 + 1e-12);
      if (std::string(method) == "gjk_epa") {
        EXPECT_NEAR(c.gap, x - 1.5, 1e-12);
        EXPECT_NEAR(c.normal.x, -1, 1e-9);
        EXPECT_NEAR(c.method_overlap, 1.5 - x, 1e-9);
        EXPECT_LE(c.gap_upper - c.gap_lower, 1e-9);
        EXPECT_NEAR(c.method_point.x, -0.5 * (0.5 + (x - 1)), 1e-9);
      }
    }
}

}  // namespace
