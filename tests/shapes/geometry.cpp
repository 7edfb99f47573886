// Properties of every finite solid kind: support points, mass properties, radii. Runs over samples of each kind.
#include "shapes/geometry.h"

#include "shapes/list.h"
#include "tests/shapes/potential_samples.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Ellipsoid;
using shapes::MassProperties;
using shapes::PotentialParticle;
using shapes::RoundedPolyhedron;
using shapes::Sphere;

template <class S>
struct Samples;
template <>
struct Samples<Sphere> {
  static std::vector<Sphere> make() { return {{1.0}, {0.3}, {7e-6}}; }
};
template <>
struct Samples<Ellipsoid> {
  static std::vector<Ellipsoid> make() {
    return {{{1, 1, 1}}, {{1, 0.5, 0.2}}, {{0.01, 1, 0.9}}, {{3e-5, 1e-5, 2e-5}}};
  }
};
template <>
struct Samples<Polyhedron> {
  static std::vector<Polyhedron> make() {
    std::vector<Polyhedron> list = {shapes::make_box({1, 0.3, 2}), shapes::make_prism(5, 1, 0.4),
                                    shapes::make_prism(64, 0.1, 3)};
    for (const auto s : {shapes::Platonic::tetrahedron, shapes::Platonic::cube, shapes::Platonic::octahedron,
                         shapes::Platonic::dodecahedron, shapes::Platonic::icosahedron})
      list.push_back(shapes::make_platonic(s, 0.7));
    for (const unsigned seed : {1u, 2u, 3u}) {
      list.push_back(shapes::polyhedron_from_points(random_points(seed, 25), shapes::Frame::principal));
      auto points = random_points(seed, 8);
      for (Vec3d& v : points) v += Vec3d{2, -1, 3};
      list.push_back(shapes::polyhedron_from_points(points, shapes::Frame::as_given));
    }
    return list;
  }
};

template <>
struct Samples<RoundedPolyhedron> {
  static std::vector<RoundedPolyhedron> make() {
    std::vector<RoundedPolyhedron> list = {{shapes::make_box({1, 0.3, 2}), 0.1}, {shapes::make_prism(5, 1, 0.4), 0.7}};
    for (const auto& p : Samples<Polyhedron>::make())
      if (p.vertices.size() < 30) list.push_back({p, 0.3 * p.circumradius});
    return list;
  }
};

template <>
struct Samples<PotentialParticle> {
  static std::vector<PotentialParticle> make() { return potential_particles(); }
};

// Level function, <= 0 inside, and a random point of the surface.
double level(const Sphere& s, const Vec3d& x) { return norm(x) / s.radius - 1; }
double level(const Ellipsoid& e, const Vec3d& x) {
  return norm(Vec3d{x.x / e.semi_axes.x, x.y / e.semi_axes.y, x.z / e.semi_axes.z}) - 1;
}
double level(const Polyhedron& p, const Vec3d& x) {
  double worst = dot(p.faces[0].normal, x) - p.faces[0].offset;
  for (const auto& f : p.faces) worst = std::fmax(worst, dot(f.normal, x) - f.offset);
  return worst / p.circumradius;
}
// Distance to the core by the nearest face, edge or corner.
double distance_to(const Polyhedron& p, const Vec3d& x) {
  double best = level(p, x) <= 0 ? 0 : 1e300;
  for (const auto& e : p.edges) {
    const Vec3d a = p.vertices[e.vertex[0]], d = p.vertices[e.vertex[1]] - a;
    const double t = std::fmin(1, std::fmax(0, dot(x - a, d) / dot(d, d)));
    best = std::fmin(best, norm(x - a - t * d));
  }
  for (const auto& f : p.faces) {
    const double height = dot(f.normal, x) - f.offset;
    if (height <= 0) continue;
    bool over = true;
    for (std::uint32_t i = 0; i < f.count; ++i) {
      const Vec3d a = p.vertices[p.face_vertices[f.first + i]];
      const Vec3d b = p.vertices[p.face_vertices[f.first + (i + 1) % f.count]];
      over = over && dot(cross(b - a, x - a), f.normal) >= 0;
    }
    if (over) best = std::fmin(best, height);
  }
  return best;
}
double level(const RoundedPolyhedron& b, const Vec3d& x) {
  return (distance_to(b.core, x) - b.radius) / shapes::circumradius(b);
}
Vec3d surface_point(const Sphere& s, Random& random) { return s.radius * random.direction(); }
Vec3d surface_point(const Ellipsoid& e, Random& random) { return scaled(e.semi_axes, random.direction()); }
Vec3d surface_point(const Polyhedron& p, Random& random) {
  const auto& f = p.faces[static_cast<std::size_t>(random.uniform(0, static_cast<double>(p.faces.size())))];
  Vec3d sum{};
  double total = 0;
  for (std::uint32_t i = 0; i < f.count; ++i) {
    const double w = -std::log(random.uniform(1e-9, 1));
    sum += w * p.vertices[p.face_vertices[f.first + i]];
    total += w;
  }
  return (1 / total) * sum;
}

Vec3d surface_point(const RoundedPolyhedron& b, Random& random) { return support(b, random.direction()); }

// In units of the size: 2(√g − 1) is the distance over size, about, also where g is steep.
double level(const PotentialParticle& p, const Vec3d& x) {
  const auto at = shapes::level_at(p, x - p.centre);
  return (at.g - 1) / (2 * norm(at.half_gradient) * p.circumradius);
}
Vec3d surface_point(const PotentialParticle& p, Random& random) { return support(p, random.direction()); }

template <class S>
class Solid : public testing::Test {};

// The kinds of the list that are finite solids, that is, have mass properties.
template <class... S>
auto solids_of(std::tuple<S...>) {
  return std::tuple_cat([]<class K>(K*) {
    if constexpr (requires(const K& k) { shapes::mass_properties(k); })
      return std::tuple<K>{};
    else
      return std::tuple<>{};
  }(static_cast<S*>(nullptr))...);
}
template <class Tuple>
struct ToTypes;
template <class... S>
struct ToTypes<std::tuple<S...>> {
  using type = testing::Types<S...>;
};
using SolidKinds = ToTypes<decltype(solids_of(shapes::List{}))>::type;
TYPED_TEST_SUITE(Solid, SolidKinds);

TYPED_TEST(Solid, support_point_is_on_the_surface_and_farthest) {
  Random random(21);
  for (const TypeParam& s : Samples<TypeParam>::make()) {
    const double size = shapes::circumradius(s);
    for (int i = 0; i < 200; ++i) {
      const Vec3d n = random.direction(), x = support(s, n);
      EXPECT_NEAR(level(s, x), 0, 16 * eps);
      for (int k = 0; k < 50; ++k) EXPECT_LE(dot(n, surface_point(s, random)), dot(n, x) + 4 * eps * size);
    }
  }
}

TYPED_TEST(Solid, radii_enclose_and_are_reached) {
  Random random(22);
  for (const TypeParam& s : Samples<TypeParam>::make()) {
    const double outer = shapes::circumradius(s), inner = shapes::inscribed_radius(s);
    double farthest = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3d n = random.direction();
      const double distance = norm(support(s, n));
      farthest = std::fmax(farthest, distance);
      EXPECT_LE(distance, outer * (1 + 4 * eps));
      if (inner > 0) {  // else the origin is outside and the support distance may be anything
        EXPECT_GE(dot(n, support(s, n)), inner - 4 * eps * outer);
      }
    }
    EXPECT_GE(farthest, 0.99 * outer);
  }
}

// Monte Carlo over a box a little larger than the body: 10 sums, each within 4 of its own standard errors.
TYPED_TEST(Solid, volume_centre_and_inertia_agree_with_monte_carlo) {
  Random random(23);
  constexpr int samples = 100000;
  for (const TypeParam& s : Samples<TypeParam>::make()) {
    const MassProperties m = shapes::mass_properties(s);
    Vec3d lower{}, upper{};
    for (int i = 0; i < 3; ++i) {
      Vec3d axis{};
      axis[i] = 1;
      upper[i] = support(s, axis)[i];
      lower[i] = support(s, -axis)[i];
    }
    const Vec3d margin = 0.05 * (upper - lower);  // or a box would have no sampling error
    lower -= margin;
    upper += margin;
    const Vec3d extent = upper - lower;
    const double box = extent.x * extent.y * extent.z;
    double sum[10] = {}, squares[10] = {};
    for (int i = 0; i < samples; ++i) {
      const Vec3d x = random.in_box(lower, upper);
      if (level(s, x) > 0) continue;
      const Vec3d r = x - m.centre;
      const double value[10] = {
          1,          r.x,        r.y,       r.z, r.y * r.y + r.z * r.z, r.z * r.z + r.x * r.x, r.x * r.x + r.y * r.y,
          -r.x * r.y, -r.y * r.z, -r.z * r.x};
      for (int k = 0; k < 10; ++k) {
        sum[k] += value[k];
        squares[k] += value[k] * value[k];
      }
    }
    const auto& I = m.inertia.row;
    const double exact[10] = {m.volume, 0, 0, 0, I[0].x, I[1].y, I[2].z, I[0].y, I[1].z, I[2].x};
    for (int k = 0; k < 10; ++k) {
      const double mean = sum[k] / samples, error = std::sqrt((squares[k] / samples - mean * mean) / samples);
      EXPECT_LE(std::fabs(box * mean - exact[k]), 4 * box * error) << k;
    }
    EXPECT_TRUE(I[0].y == I[1].x && I[1].z == I[2].y && I[0].z == I[2].x);
  }
}

TEST(RoundedPolyhedron, volume_follows_steiner_and_a_tiny_core_is_a_ball) {
  const double r = 0.2, pi = std::numbers::pi;
  const MassProperties m = shapes::mass_properties(RoundedPolyhedron{shapes::make_box({1, 2, 3}), r});
  EXPECT_NEAR(m.volume, 6 + 22 * r + pi * 6 * r * r + 4 * pi / 3 * r * r * r, 32 * eps * m.volume);
  const MassProperties ball = shapes::mass_properties(RoundedPolyhedron{shapes::make_box({1e-9, 1e-9, 1e-9}), 1});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(ball.inertia.row[i][i], 8 * pi / 15, 1e-8);
  // Rounding moves the centre of mass of a pyramid; its principal frame brings it back to the origin.
  const std::vector<Vec3d> pyramid{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 2}};
  const auto core = shapes::polyhedron_from_points(pyramid, shapes::Frame::principal);
  EXPECT_GT(std::fabs(shapes::mass_properties(RoundedPolyhedron{core, 0.5}).centre.z) +
                std::fabs(shapes::mass_properties(RoundedPolyhedron{core, 0.5}).centre.x),
            0.01);
  const RoundedPolyhedron body = shapes::make_rounded(core, 0.5);
  EXPECT_LE(max_abs(shapes::mass_properties(body).centre), 64 * eps);
  const Vec3d apex = rotate(body.core.frame.orientation, body.core.vertices[4]) + body.core.frame.position;
  EXPECT_LE(norm(apex - pyramid[4]), 64 * eps);
  EXPECT_TRUE(holds(refusal([&] { shapes::make_rounded(core, -1); }), "allowed"));
  for (const Vec3d& v : shapes::drawing_of(body).vertices) EXPECT_LE(level(body, v), 64 * eps);
}

TEST(RoundedPolyhedron, a_thin_bar_is_a_capsule) {
  const double length = 2, r = 0.5, pi = std::numbers::pi;
  const MassProperties m = shapes::mass_properties(RoundedPolyhedron{shapes::make_box({1e-10, 1e-10, length}), r});
  const double cylinder = pi * r * r * length, ball = 4 * pi / 3 * r * r * r;
  EXPECT_NEAR(m.volume, cylinder + ball, 1e-8);
  EXPECT_NEAR(m.inertia.row[2].z, 0.5 * cylinder * r * r + 0.4 * ball * r * r, 1e-8);
  const double half = 0.5 * length + 0.375 * r;  // centre of mass of a half ball
  EXPECT_NEAR(m.inertia.row[0].x,
              cylinder * (length * length / 12 + r * r / 4) + ball * (83.0 / 320 * r * r + half * half), 1e-8);
}

TEST(EquivalentRadius, inverts_the_volume_and_follows_units) {
  for (const double r : {1.0, 0.3, 7e-6, 123.0}) {
    const double volume = shapes::mass_properties(Sphere{r}).volume;
    EXPECT_NEAR(shapes::equivalent_radius(volume) / r, 1, 3 * eps);
    for (int k = -300; k <= 300; ++k)
      ASSERT_EQ(shapes::equivalent_radius(std::ldexp(volume, 3 * k)), std::ldexp(shapes::equivalent_radius(volume), k))
          << k;
  }
  EXPECT_EQ(shapes::equivalent_radius(0), 0);
}

}  // namespace
}  // namespace shape_tests
