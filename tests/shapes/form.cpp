// Length, width, thickness, area and sphericity of convex bodies.
#include "shapes/form.h"

#include "shapes/geometry.h"
#include "shapes/math/random.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Form;
using shapes::form_of;
using shapes::Frame;

TEST(Form, OfABox) {
  const Form f = form_of(shapes::make_box({3, 2, 1}));
  EXPECT_NEAR(f.length, std::sqrt(14.0), 1e-14);
  EXPECT_NEAR(f.area, 22, 1e-13);
  EXPECT_NEAR(f.volume, 6, 1e-14);
  EXPECT_NEAR(f.sphericity(), std::cbrt(std::numbers::pi) * std::pow(36.0, 2.0 / 3) / 22, 1e-14);
}

// Corners on the axes at ±a, ±b, ±c: those are its longest lines, as far as each is longer than the next by enough.
TEST(Form, OfAStretchedOctahedron) {
  const std::vector<Vec3d> corners{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 2}, {0, 0, -2}};
  const Form f = form_of(shapes::polyhedron_from_points(corners, Frame::as_given));
  EXPECT_NEAR(f.length, 10, 1e-14);
  EXPECT_NEAR(f.width, 6, 1e-14);
  EXPECT_NEAR(f.thickness, 4, 1e-14);
  EXPECT_NEAR(std::abs(f.along.x), 1, 1e-15);
  EXPECT_NEAR(std::abs(f.across.y), 1, 1e-15);
}

// A regular tetrahedron: two opposite edges are perpendicular, both as long as the length; across them lies the
// distance of these edges, edge/√2.
TEST(Form, OfATetrahedron) {
  const Form f = form_of(shapes::make_platonic(shapes::Platonic::tetrahedron, 1));
  const double edge = std::sqrt(8.0 / 3);
  EXPECT_NEAR(f.length, edge, 1e-14);
  EXPECT_NEAR(f.width, edge, 1e-14);
  EXPECT_NEAR(f.thickness, edge / std::sqrt(2.0), 1e-14);
}

// The widest line lies between corners of the body but ends at none of them: a prism on its side, cut across.
TEST(Form, OfAnEllipsoidOfManyCorners) {
  std::vector<Vec3d> points;
  shapes::Random random(1, 2, 3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d u = random.direction();
    points.push_back({5 * u.x, 4 * u.y, 3 * u.z});
  }
  const Form f = form_of(shapes::polyhedron_from_points(points, Frame::as_given));
  EXPECT_NEAR(f.length, 10, 0.1);
  EXPECT_NEAR(f.width, 8, 0.1);
  EXPECT_NEAR(f.thickness, 6, 0.1);
}

// No line of the body is longer: random lines across the length and along the thickness.
TEST(Form, NoLineIsLonger) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    shapes::Random random(seed, 0, 0);
    std::vector<Vec3d> points;
    for (int i = 0; i < 16; ++i) points.push_back(scaled(Vec3d{1.0, 0.8, 0.5}, random.direction()));
    const Polyhedron p = shapes::polyhedron_from_points(points, Frame::as_given);
    const Form f = form_of(p);
    EXPECT_LE(f.width, f.length * (1 + 1e-14));
    double widest = 0, thickest = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec3d x = scaled(Vec3d{0.6, 0.5, 0.3}, random.direction()) * random.uniform();
      const auto chord = [&](const Vec3d& n) {
        double low = -1e9, high = 1e9;
        for (const auto& face : p.faces) {
          const double rate = dot(face.normal, n), room = face.offset - dot(face.normal, x);
          if (rate > 0) high = std::min(high, room / rate);
          if (rate < 0) low = std::max(low, room / rate);
        }
        return high - low;
      };
      Vec3d across = random.direction();
      across -= dot(across, f.along) * f.along;
      widest = std::max(widest, chord(across * (1 / norm(across))));
      thickest = std::max(thickest, chord(f.through));
    }
    EXPECT_LE(widest, f.width * (1 + 1e-12));
    EXPECT_GT(widest, 0.9 * f.width);
    EXPECT_LE(thickest, f.thickness * (1 + 1e-12));
    EXPECT_GT(thickest, 0.9 * f.thickness);
  }
}

}  // namespace
}  // namespace shape_tests
