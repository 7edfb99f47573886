// Walton & Braun's tangential spring against its closed forms, and closed loops.
#include <cmath>
#include <limits>

#include "libcontact/laws/normal/linear.h"
#include "libcontact/laws/tangential/latching_tangential.h"
#include "tests/libcontact/tangential_path.h"

namespace contact::tests {
namespace {

using Law = LatchingTangential;
constexpr double infinity = std::numeric_limits<double>::infinity();

PairOf<double> springs(double friction = 0.3) {
  PairOf<double> p = sheet_pair<double>(friction);
  p.stiffness_n = 1e7;
  p.stiffness_t = 8e6;
  return p;
}
struct Latched : Path<Law, double, Linear> {
  explicit Latched(double friction = 0.3) { pair = springs(friction); }
  double cap() const { return pair.friction * normal.holding; }
};

#if TEST_HAS_BOOST

// From `from`, `x` along the way to ±μF: Ft* + L (1 − (1 − 2 k0 x/(3L))^1.5).
Wide branch(const Wide& cap, const Wide& from, const Wide& slip) {
  const Wide k0 = 8000000, x = abs(slip), way = slip > 0 ? Wide(cap - from) : Wide(cap + from);
  Wide rest = 1 - 2 * k0 * x / (3 * way);
  if (rest < 0) rest = 0;
  const Wide change = way * (1 - rest * sqrt(rest));
  return slip > 0 ? Wide(from + change) : Wide(from - change);
}

TEST(LatchingTangential, BranchesAtConstantForceForStepsOfAnySize) {
  const Wide cap = Wide(3) / 10 * 100;  // 1e7 N/m, 10 µm
  for (const int n : {1, 3, 50}) {
    Latched path;
    path.along(1e-5, 0);
    Wide at = 0;
    // Loading, unloading, reloading, past zero, to the cap, back.
    for (const double slip : {2e-6, -1e-6, 0.7e-6, -4e-6, 9e-6, -1e-6, -20e-6}) {
      double f = 0;
      for (int i = 0; i < n; ++i) f = path.along(1e-5, slip / n);
      at = branch(cap, at, Wide(slip));
      EXPECT_NEAR(f, static_cast<double>(at), 1e-13 * 30) << slip << ' ' << n;
    }
  }
}

// First loading is Mindlin's curve, cap (1 − (1 − 2 k0 x/(3 cap))^1.5) = cap (1 − (1 − δ 16 G* a/(3 cap))^1.5); a
// return from less than the cap is softer than Mindlin & Deresiewicz's, as its way is μF + Ft* and theirs 2 μF.
TEST(LatchingTangential, AgainstMindlin) {
  Path<Law> path;
  const double z = 1e-5;
  path.along(z, 0);
  const double cap = 0.3 * path.normal.holding, unit = 1.7 / 1.4 * 0.3 * z;
  const double f = path.along(z, 0.5 * unit);
  EXPECT_NEAR(f / cap, 1 - std::pow(0.5, 1.5), 1e-14);
  const double back = path.along(z, -0.2 * unit) / cap, way = 1 + f / cap;
  EXPECT_NEAR(back, f / cap - way * (1 - std::pow(1 - 0.2 / way, 1.5)), 1e-14);
  EXPECT_GT(back, f / cap - 2 * (1 - std::pow(1 - 0.1, 1.5)) + 1e-4);
}

#endif  // TEST_HAS_BOOST

TEST(LatchingTangential, TheReversalIsScaledWithThePressingForce) {
  Latched path;
  path.along(1e-5, 0);
  path.along(1e-5, 2e-6);
  const double at = path.along(1e-5, -0.5e-6), turn = path.state.turned.x;
  path.along(1.5e-5, 0);
  EXPECT_NEAR(path.state.turned.x / turn, 1.5, 1e-15);
  EXPECT_EQ(path.state.force.x, at);
  const double cap = path.cap(), way = cap + 1.5 * turn, gone = 1.5 * turn - at;
  const double slope = (at - path.along(1.5e-5, -1e-12)) / 1e-12;
  EXPECT_NEAR(slope / (8e6 * std::cbrt(1 - gone / way)), 1, 1e-3);
}

// Across e the spring has its first stiffness, and the way to the circle is (1).
TEST(LatchingTangential, AcrossAndAlong) {
  Latched path;
  path.along(1e-5, 0);
  path.along(1e-5, 2e-6);
  const double turn = path.state.force.x;
  path.step(1e-5, {-1e-9, 0, 0});
  auto across = path;
  across.step(1e-5, {0, 1e-9, 0});
  EXPECT_NEAR(across.state.force.y / (8e6 * 1e-9), 1, 1e-12);
  EXPECT_EQ(across.state.force.x, path.state.force.x);
  Latched oblique;  // from a reversal at (turn, 0), along (−3, 4)/5
  oblique.along(1e-5, 0);
  oblique.along(1e-5, 2e-6);
  const double x = 1.5e-6, along = -0.6 * turn, cap = oblique.cap();
  const double way = std::sqrt(cap * cap - turn * turn + along * along) - along;
  oblique.step(1e-5, {-0.6 * x, 0.8 * x, 0});
  const double change = way * (1 - std::pow(1 - 2 * 8e6 * x / (3 * way), 1.5));
  EXPECT_NEAR(oblique.state.force.x / (turn - 0.6 * change), 1, 1e-13);
  EXPECT_NEAR(oblique.state.force.y / (0.8 * change), 1, 1e-13);
}

// The estimate is the work that a reversal gives back at constant pressing force.
TEST(LatchingTangential, EnergyIsWhatAReversalGivesBack) {
  for (const double slip : {1e-11, 1e-6, 3e-6, 9e-6}) {
    Latched path;
    path.along(1e-5, 0);
    double force = path.along(1e-5, slip);
    const double energy = path.step(1e-5, {}).energy, way = path.cap() + force;
    const double back = 1.5 * way / 8e6 * (1 - std::pow(1 - force / way, 2.0 / 3));  // to zero force
    const int n = 2000;
    double work = 0;
    for (int i = 0; i < n; ++i) {
      const double d = -back / (2 * n), f1 = path.along(1e-5, d), f2 = path.along(1e-5, d);
      work -= d / 3 * (force + 4 * f1 + f2);
      force = f2;
    }
    EXPECT_NEAR(force / path.cap(), 0, 1e-10);
    EXPECT_NEAR(energy / work, 1, slip < 1e-9 ? 1e-4 : 1e-9) << slip;
  }
}

// Closed loops of (overlap, slip, slip) through random corners, each led around twice.
template <class Normal>
double least_work(bool line) {
  std::mt19937_64 engine(11);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  double least = infinity;
  for (int loop = 0; loop < 400; ++loop) {
    Path<Law, double, Normal> path;
    path.pair = springs();
    const double unit = 3.6e-6, reach = std::pow(10, in(-2, 0.3));
    const int corners = 3 + loop % 4, n = 200;
    Vec3d corner[8] = {};
    for (int i = 0; i < corners; ++i)
      corner[i] = {1e-5 * in(0.2, 1), unit * reach * in(-1, 1), line ? 0 : unit * reach * in(-1, 1)};
    path.step(corner[0].x, {});
    double work = 0, most = 0;
    Vec3d before{};
    for (int i = 0; i < 2 * corners; ++i) {
      const Vec3d a = corner[i % corners], b = corner[(i + 1) % corners];
      for (int j = 1; j <= n; ++j) {
        const Vec3d d = {(b.y - a.y) / n, (b.z - a.z) / n, 0};
        const auto out = path.step(a.x + (b.x - a.x) * j / n, d);
        work += 0.5 * dot(before + out.force, d);
        before = out.force;
        most = std::max(most, out.energy);
      }
      if (i % corners == corners - 1) least = std::min(least, work / most);
    }
  }
  return least;
}

// Where kt shrinks with the contact radius they take work. With a constant one, what was loaded under a large pressing
// force comes back along a softer way under a small one.
TEST(LatchingTangential, EnergyOfClosedLoops) {
  for (const bool line : {false, true}) EXPECT_GE(least_work<Hertz>(line), 0);
  const double line = least_work<Linear>(true), plane = least_work<Linear>(false);
  EXPECT_GE(line, -0.06);
  EXPECT_LE(line, -0.03);
  EXPECT_GE(plane, -0.06);
}

TEST(LatchingTangential, TurnsWithThePlaneAndStaysWithinTheCone) {
  std::mt19937_64 engine(17);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  const auto quarter = [](const Vec3d& v) { return Vec3d{-v.y, v.x, 0}; };
  Latched path, upright;
  int slid = 0;
  for (int i = 0; i < 3000; ++i) {
    const double z = in(0, 1) < 0.5 && i > 0 ? path.overlap : 1e-5 * in(0.3, 1);
    const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * (3e-6 * in(0, 1) * in(0, 1));
    const auto f = path.step(z, d);
    ASSERT_TRUE(quarter(f.force) == upright.step(z, quarter(d)).force) << i;
    ASSERT_LE(shapes::norm(f.force), path.cap() * (1 + 4e-16));
    slid += shapes::norm(f.force) > path.cap() * (1 - 1e-12);
  }
  EXPECT_GT(slid, 100);
}

#if TEST_HAS_BOOST
TEST(LatchingTangential, TurnsWithThePlaneByAnyAngle) {
  std::mt19937_64 engine(19);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  const Wide c = cos(Wide(1.1)), s = sin(Wide(1.1));
  Path<Law, Wide> path, other;
  for (int i = 0; i < 200; ++i) {
    const Wide z = in(0, 1) < 0.5 && i > 0 ? path.overlap : Wide(1e-5 * in(0.3, 1));
    const double size = 1e-6 * in(0, 1) * in(0, 1);
    const Vec3<Wide> d = {size * in(-1, 1), size * in(-1, 1), 0}, e = {c * d.x - s * d.y, s * d.x + c * d.y, 0};
    const auto f = path.step(z, d), g = other.step(z, e);
    ASSERT_LT(abs(c * f.force.x - s * f.force.y - g.force.x), 1e-9 * path.normal.elastic) << i;
    ASSERT_LT(abs(s * f.force.x + c * f.force.y - g.force.y), 1e-9 * path.normal.elastic) << i;
  }
}
#endif

TEST(LatchingTangential, WithoutFrictionAndWithoutSlip) {
  Latched smooth(0), rough(infinity);
  smooth.damping_t = 1;
  for (const double z : {1e-5, 1.5e-5, 0.5e-5, 0.0, 1e-5}) {
    const auto out = smooth.step(z, {1e-6, 2e-6, 0});
    EXPECT_EQ(shapes::norm(out.force), 0);
    EXPECT_EQ(out.energy, 0);
  }
  rough.along(1e-5, 0);
  EXPECT_NEAR(rough.along(1e-5, 1e-3) / 8e3, 1, 1e-15);
  EXPECT_NEAR(rough.along(0.5e-5, -3e-3) / -16e3, 1, 1e-15);
  EXPECT_NEAR(rough.step(0.5e-5, {}).energy / (0.5 * 16e3 * 16e3 / 8e6), 1, 1e-15);
  EXPECT_EQ(shapes::norm(rough.step(0, {1, 0, 0}).force), 0);
  EXPECT_EQ(shapes::norm(rough.state.force), 0);
  EXPECT_NEAR(rough.along(1e-5, 1e-3) / 8e3, 1, 1e-15);
}

TEST(LatchingTangential, DashpotIsOutsideTheSpringAndUnderTheCap) {
  Latched path, plain;
  path.damping_t = 5;
  path.dt = plain.dt = 1e-6;
  path.along(1e-5, 0);
  plain.along(1e-5, 0);
  const double f = path.along(1e-5, 3e-7), bare = plain.along(1e-5, 3e-7);
  EXPECT_NEAR(f - bare, 5 * 0.3, 1e-12);
  EXPECT_EQ(path.state.force.x, bare);
  path.damping_t = 1e6;
  EXPECT_NEAR(path.along(1e-5, 1e-7) / path.cap(), 1, 1e-15);
  EXPECT_LT(path.state.force.x, path.cap() * 0.9);
}

TEST(LatchingTangential, AnotherUnitGivesTheSameBits) {
  std::mt19937_64 engine(23);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  Latched path, other;  // lengths times 2^10, forces times 2^6
  other.radius_eff *= 1024;
  other.pair.stiffness_n *= 64.0 / 1024;
  other.pair.stiffness_t *= 64.0 / 1024;
  for (int i = 0; i < 300; ++i) {
    const double z = in(0.3, 1) * 1e-5;
    const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * 1e-6;
    const auto f = path.step(z, d), g = other.step(z * 1024, d * 1024.0);
    EXPECT_TRUE(f.force * 64.0 == g.force);
    EXPECT_EQ(f.energy * 65536, g.energy);
  }
}

TEST(LatchingTangential, LanesAreScalars) {
  expect_lanes_are_scalars<Law, Linear>(7, springs());
  expect_lanes_are_scalars<Law>(7, springs());
}

}  // namespace
}  // namespace contact::tests
