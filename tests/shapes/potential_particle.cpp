// Potential particles: support points against extended precision, mass properties against closed forms and limits,
// radii, units, refusals.
#include "shapes/geometry.h"
#include "tests/shapes/potential_samples.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;
using shapes::HalfSpace;
using shapes::make_potential_particle;
using shapes::MassProperties;
using shapes::PotentialParticle;

template <class F>
std::string message_of(F f) {
  try {
    f();
  } catch (const shapes::Error& e) {
    return e.what();
  }
  return "";
}

TEST(PotentialParticle, support_agrees_with_extended_precision_and_a_near_start) {
  Random random(31);
  for (const PotentialParticle& p : potential_particles()) {
    for (int i = 0; i < 2000; ++i) {
      const Vec3d n = i < 100 && static_cast<std::size_t>(i) < p.planes.size()
                          ? p.planes[static_cast<std::size_t>(i)].normal
                          : random.direction();
      const auto s = shapes::support_from_centre<double>(p, n);
      const shapes::Vec3<long double> wide{n.x, n.y, n.z};
      const auto exact = shapes::support_from_centre<long double>(p, wide);
      ASSERT_TRUE(s.found && exact.found);
      EXPECT_NEAR(s.height, static_cast<double>(exact.height), 8 * eps * p.circumradius);
      EXPECT_LE(s.excess, 4 * eps * p.circumradius);
      const Vec3d near = normalized(n + 0.02 * random.direction());
      const auto t = shapes::support_from_centre<double>(p, near, &s.from_centre);
      ASSERT_TRUE(t.found);
      const auto cold = shapes::support_from_centre<double>(p, near);
      EXPECT_NEAR(t.height, cold.height, 4 * eps * p.circumradius);
    }
  }
}

// dy/dn of the support point is the matrix of radii of curvature; none is below the bound that the body states.
TEST(PotentialParticle, radii_of_curvature_move_the_support_point) {
  Random random(32);
  for (const PotentialParticle& p : potential_particles()) {
    EXPECT_GT(p.least_curvature_radius, 0);
    for (int i = 0; i < 500; ++i) {
      const Vec3d n = random.direction();
      Vec3d t1, t2;
      tangent_frame(n, t1, t2);
      const auto s = shapes::support_from_centre<double>(p, n);
      const auto k = shapes::curvature_radii(s, n, t1, t2);
      const double half = 0.5 * (k.k11 - k.k22), mean = 0.5 * (k.k11 + k.k22);
      EXPECT_GE(mean - std::sqrt(half * half + k.k12 * k.k12), p.least_curvature_radius * (1 - 1e-9));
      const double step = 1e-7;
      const auto moved = shapes::support_from_centre<double>(p, normalized(n + step * t1));
      if (shapes::level_at(p, moved.from_centre).beyond != shapes::level_at(p, s.from_centre).beyond) continue;
      const Vec3d rate = (1 / step) * (moved.from_centre - s.from_centre);
      const double scale = std::fabs(k.k11) + std::fabs(k.k12);
      EXPECT_NEAR(dot(rate, t1), k.k11, 1e-4 * scale + 1e-6 * p.circumradius);
      EXPECT_NEAR(dot(rate, t2), k.k12, 1e-4 * scale + 1e-6 * p.circumradius);
    }
  }
}

TEST(PotentialParticle, k_of_one_is_the_sphere) {
  const auto box = planes_of_faces(shapes::make_box({1, 1, 1}));
  for (const double radius : {1.0, 0.37, 3e-4}) {
    const PotentialParticle p = make_potential_particle(box, 1, 0.1, radius, Frame::principal);
    const MassProperties exact = shapes::mass_properties(shapes::Sphere{radius});
    EXPECT_NEAR(p.mass.volume / exact.volume, 1, 1e-12);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(p.mass.inertia.row[i][i] / exact.inertia.row[i][i], 1, 1e-12);
    EXPECT_EQ(p.mass.centre, (Vec3d{0, 0, 0}));
    EXPECT_NEAR(p.circumradius / radius, 1, 4 * eps);
    EXPECT_NEAR(p.inscribed_radius / radius, 1, 4 * eps);
    EXPECT_NEAR(p.least_curvature_radius / radius, 1, 2e-3);
    Random random(33);
    for (int i = 0; i < 100; ++i) {
      const Vec3d n = random.direction();
      EXPECT_LE(norm(support(p, n) - radius * n), 4 * eps * radius);
    }
  }
  // And k near 1 is near it.
  const double near = make_potential_particle(box, 1 - 1e-6, 0.3, 0.6, Frame::principal).mass.volume;
  EXPECT_NEAR(near / shapes::mass_properties(shapes::Sphere{0.6}).volume, 1, 1e-5);
}

// Planes through the centre, all but: quadratic in each coordinate, so an ellipsoid.
TEST(PotentialParticle, planes_through_the_centre_make_an_ellipsoid) {
  const double tiny = 1e-13, k = 0.3, r = 0.4, R = 0.9;
  const std::vector<HalfSpace> planes{{{1, 0, 0}, tiny}, {{-1, 0, 0}, tiny}, {{0, 2, 0}, tiny}, {{0, -2, 0}, tiny}};
  const PotentialParticle p = make_potential_particle(planes, k, r, R, Frame::principal);
  const double c = R / std::sqrt(k), a = 1 / std::sqrt((1 - k) / (r * r) + k / (R * R));
  const MassProperties exact = shapes::mass_properties(shapes::Ellipsoid{{a, a, c}});
  EXPECT_NEAR(p.mass.volume / exact.volume, 1, 1e-11);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(p.mass.inertia.row[i][i] / exact.inertia.row[i][i], 1, 1e-11);
  EXPECT_NEAR(p.circumradius / c, 1, 1e-3);
  EXPECT_NEAR(p.inscribed_radius / a, 1, 1e-8);
}

// As r and k shrink together the body becomes the box of its planes: volume of order r, then nothing.
TEST(PotentialParticle, small_r_and_k_leave_the_box) {
  const Vec3d size{1, 1.4, 0.8};
  const auto box = planes_of_faces(shapes::make_box(size));
  const double volume = size.x * size.y * size.z, area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  double last = 2;
  for (const double r : {0.1, 0.03, 0.01}) {
    const PotentialParticle p = make_potential_particle(box, 0.1 * r, r, 1, Frame::principal, 1e-7);
    const double excess = p.mass.volume / volume - 1;
    EXPECT_GT(excess, 0);
    EXPECT_LT(excess, 1.01 * r * area / volume + 12 * r * r);  // within the planes moved out by r
    EXPECT_NEAR(excess * volume / (area * r), 1, 4 * r);
    EXPECT_LT(excess, 0.5 * last);
    last = excess;
    EXPECT_TRUE(p.frame.orientation.w == 1 && p.frame.position == (Vec3d{0, 0, 0}));
  }
}

TEST(PotentialParticle, mass_converges_and_states_its_error) {
  for (const std::size_t i : {0u, 4u, 5u}) {
    const PotentialParticle& p = potential_particles()[i];
    double fine_error = 0;
    const MassProperties fine = shapes::potential::mass_by_quadrature(p, 1e-9, fine_error);
    EXPECT_LT(fine_error, 1.25e-9);
    for (const double tolerance : {8e-9, 1e-6, 1e-4}) {
      double stated = 0;
      const MassProperties m = shapes::potential::mass_by_quadrature(p, tolerance, stated);
      EXPECT_LE(stated, 1.25 * tolerance);
      EXPECT_LE(std::fabs(m.volume / fine.volume - 1), stated + fine_error);
      EXPECT_LE(max_abs(m.centre - fine.centre), 4 * (stated + fine_error) * p.circumradius);
      for (int j = 0; j < 3; ++j)
        EXPECT_LE(std::fabs(m.inertia.row[j][j] / fine.inertia.row[j][j] - 1), stated + fine_error);
      if (tolerance < 1e-8) {
        EXPECT_LE(std::fabs(m.volume / fine.volume - 1), 1e-10);
      }
    }
  }
}

// A body without symmetry, given about another point than its centre of mass.
TEST(PotentialParticle, principal_frame_is_that_of_the_body) {
  const PotentialParticle p = make_potential_particle(irregular_planes(), 0.02, 0.2, 1, Frame::principal);
  const PotentialParticle given = make_potential_particle(irregular_planes(), 0.02, 0.2, 1, Frame::as_given);
  double error = 0;
  const MassProperties m = shapes::potential::mass_by_quadrature(p, 8e-9, error);
  EXPECT_LE(max_abs(m.centre), 2e-8 * p.circumradius);
  EXPECT_GT(max_abs(p.centre), 0.01);
  for (int j = 0; j < 3; ++j) {
    EXPECT_LE(std::fabs(m.inertia.row[j][(j + 1) % 3]), 4e-8 * m.inertia.row[j][j]);
    EXPECT_NEAR(m.inertia.row[j][j] / p.mass.inertia.row[j][j], 1, 2e-8);
  }
  EXPECT_NEAR(p.mass.volume / given.mass.volume, 1, 2e-8);
  Random random(35);
  for (int i = 0; i < 100; ++i) {
    const Vec3d n = random.direction();
    const Vec3d x = rotate(p.frame.orientation, support(p, n)) + p.frame.position;
    EXPECT_LE(norm(x - support(given, rotate(p.frame.orientation, n))), 1e-11);
  }
}

TEST(PotentialParticle, powers_of_two_scale_every_bit) {
  const std::vector<HalfSpace> planes = irregular_planes();
  const PotentialParticle p = make_potential_particle(planes, 0.02, 0.1, 1.1, Frame::principal, 1e-5);
  for (const int power : {-40, 7}) {
    const double s = std::ldexp(1.0, power);
    auto larger = planes;
    for (auto& plane : larger) plane.offset *= s;
    const PotentialParticle q = make_potential_particle(larger, 0.02, 0.1 * s, 1.1 * s, Frame::principal, 1e-5);
    EXPECT_EQ(q.mass.volume, std::ldexp(p.mass.volume, 3 * power));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(q.mass.inertia.row[i][i], std::ldexp(p.mass.inertia.row[i][i], 5 * power));
    EXPECT_EQ(q.centre, p.centre * s);
    EXPECT_EQ(q.circumradius, p.circumradius * s);
    EXPECT_EQ(q.inscribed_radius, p.inscribed_radius * s);
    EXPECT_EQ(q.least_curvature_radius, p.least_curvature_radius * s);
    Random random(34);
    for (int i = 0; i < 100; ++i) {
      const Vec3d n = random.direction();
      EXPECT_EQ(support(q, n), support(p, n) * s);
    }
  }
}

TEST(PotentialParticle, drawing_lies_inside_and_fills_most_of_it) {
  for (const PotentialParticle& p : potential_particles()) {
    const Polyhedron drawing = shapes::drawing_of(p);
    for (const Vec3d& v : drawing.vertices) EXPECT_LE(shapes::level_at(p, v - p.centre).g, 1 + 1e-12);
    EXPECT_GT(drawing.mass.volume, 0.95 * p.mass.volume);
  }
}

TEST(PotentialParticle, refuses_what_it_cannot_be) {
  const auto box = planes_of_faces(shapes::make_box({1, 1, 1}));
  const auto made = [&](std::vector<HalfSpace> planes, double k, double r, double R) {
    return message_of([&] { make_potential_particle(planes, k, r, R, Frame::principal); });
  };
  const auto holds = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(made(box, 0.1, 0.1, 1), "");
  EXPECT_TRUE(holds(made(box, 0, 0.1, 1), "k = 0; allowed: 0 < k <= 1"));
  EXPECT_TRUE(holds(made(box, 1.5, 0.1, 1), "k = 1.5"));
  EXPECT_TRUE(holds(made(box, 0.1, 0, 1), "r = 0; allowed"));
  EXPECT_TRUE(holds(made(box, 0.1, 0.1, -1), "R = -1; allowed"));
  EXPECT_TRUE(holds(made(box, 1e-6, 1e-4, 1), "(1 - k) R^2 / (k r^2)"));
  auto outside = box;
  outside[3].offset = -0.1;
  EXPECT_TRUE(holds(made(outside, 0.1, 0.1, 1), "planes[3]: distance from the origin = -0.1"));
  outside[3] = {{0, 0, 0}, 1};
  EXPECT_TRUE(holds(made(outside, 0.1, 0.1, 1), "planes[3]: length of the normal = 0"));
  EXPECT_TRUE(holds(made(std::vector<HalfSpace>(65, box[0]), 0.1, 0.1, 1), "number of planes = 65"));
}

}  // namespace
}  // namespace shape_tests
