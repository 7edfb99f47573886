// The memory diagram against Mindlin & Deresiewicz's closed forms, an unbounded diagram, and energy.
#include <cmath>
#include <limits>

#include "libcontact/laws/tangential/coulomb_spring.h"
#include "libcontact/laws/tangential/memory_diagram.h"
#include "tests/libcontact/memory_reference.h"
#include "tests/libcontact/tangential_path.h"

namespace contact::tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
T kappa_of(const PairOf<T>& p) {
  return p.young_eff / (T(4) * p.shear_eff);
}

#if TEST_HAS_BOOST

struct Node {
  double depth, slip;  // z/z0, slip/(κ μ z0), in tenths where they are not whole
  Wide force;          // Ft/(μ N0)
};

Wide p15(int tenths) {
  const Wide x = Wide(tenths) / 10;
  return x * sqrt(x);
}

// From z0 on, the depths of slip by hand: above 1.5 a layer, signs of D, exponents 3/2.
template <class T>
void expect_path(std::initializer_list<Node> nodes, double tolerance) {
  Path<MemoryDiagram, T> path;
  const T z0 = T(1) / T(100000), unit = kappa_of(path.pair) * path.pair.friction * z0;
  T slip(0), scale(0);
  int i = 0;
  for (const Node& node : nodes) {
    const T to = T(node.slip) / T(10) * unit;
    const T f = path.along(T(node.depth) / T(10) * z0, to - slip);
    slip = to;
    if (scale == T(0))
      scale = path.pair.friction * path.normal.elastic / (T(node.depth) / T(10) * sqrt(T(node.depth) / T(10)));
    EXPECT_LT(abs(Wide(f / scale) - node.force), tolerance) << "node " << i;
    ++i;
  }
  EXPECT_EQ(path.state.merges, T(0));
}

template <class T>
void expect_sheet_paths(double tolerance) {
  using std::sqrt;
  const Wide zero = 0, one = 1;
  expect_path<T>({{10, 0, zero}, {10, 5, one - p15(5)}, {8, 5, p15(8) - p15(3)}}, tolerance);  // A
  expect_path<T>({{10, 0, zero},
                  {10, 5, one - p15(5)},
                  {12, 9, p15(12) - p15(3)},
                  {12, 0, 2 * Wide(0.75) * sqrt(Wide(0.75)) - p15(3) - p15(12)},
                  {12, 9, p15(12) - p15(3)}},
                 tolerance);  // B
  expect_path<T>({{10, 0, zero}, {10, 6, one - p15(4)}, {9, 1, 2 * p15(7) - p15(4) - p15(9)}, {10, 6, one - p15(4)}},
                 tolerance);  // C
  expect_path<T>(
      {{10, 0, zero}, {10, 5, one - p15(5)}, {15, 6, one - p15(5) + (p15(15) - one) / 5}, {15, 12, p15(15) - p15(3)}},
      tolerance);                                                 // D
  expect_path<T>({{10, 5, one / 2}, {5, 5, p15(5)}}, tolerance);  // E
}

TEST(MemoryDiagram, PathsOfTheSheet) {
  EXPECT_NEAR(static_cast<double>(1 - p15(5)), 0.64645, 5.1e-6);  // as printed
  EXPECT_NEAR(static_cast<double>(p15(12) - p15(3)), 1.15022, 5.1e-6);
  EXPECT_NEAR(static_cast<double>(p15(15) - p15(3)), 1.67280, 5.1e-6);
  expect_sheet_paths<double>(5e-15);
  expect_sheet_paths<Wide>(1e-45);
}

// Constant pressing force, slip of ±s: force, slip and work of a cycle.
TEST(MemoryDiagram, LoopsAtConstantPressingForce) {
  const double printed_slip[] = {0.770925e-6, 1.665210e-6, 2.858027e-6};
  const double printed_work[] = {9.82120e-7, 1.07169e-5, 6.28396e-5};
  int row = 0;
  for (const int tenths : {3, 6, 9}) {
    PairOf<Wide> wide = sheet_pair<Wide>();
    wide.young_eff = Wide(38000000000LL);
    wide.shear_eff = wide.young_eff * 7 / 34;
    const Wide z = Wide(1) / 100000, a = sqrt(z / 80), force = 4 * wide.young_eff * a * z / 3;
    const Wide t = Wide(tenths) / 10, cap = wide.friction * force, rest = pow(1 - t, Wide(2) / 3);
    const Wide compliance = 3 * cap / (16 * wide.shear_eff * a);
    const Wide slip = compliance * (1 - rest);
    const Wide work =
        9 * cap * cap / (10 * wide.shear_eff * a) * (1 - pow(1 - t, Wide(5) / 3) - 5 * t / 6 * (1 + rest));
    EXPECT_NEAR(static_cast<double>(slip), printed_slip[row], 5.1e-13);
    EXPECT_NEAR(static_cast<double>(work), printed_work[row], 5.1e-6 * printed_work[row]);
    ++row;

    Path<MemoryDiagram> path;
    path.pair.young_eff = 38e9;
    path.pair.shear_eff = 38e9 * 7 / 34;
    const double s = static_cast<double>(slip), depth = 1e-5, c = static_cast<double>(cap);
    path.along(depth, 0);
    EXPECT_NEAR(path.along(depth, s) / c, 0.1 * tenths, 1e-14);
    // Along the way back: the slip at which half of the force is taken off again.
    auto back = path;
    const Wide part = 2 * pow(1 - t / 4, Wide(2) / 3) - rest - 1;  // at Ft = t/2
    EXPECT_NEAR(back.along(depth, static_cast<double>(compliance * part - slip)) / c, 0.05 * tenths, 1e-14);
    const auto branch = [&](double from, double to, int n) {  // Simpson, the force is smooth but for its start
      double sum = 0, before = path.state.force.x;
      for (int i = 0; i < n; ++i) {
        const double h = (to - from) / (2 * n), f1 = path.along(depth, h), f2 = path.along(depth, h);
        sum += (before + 4 * f1 + f2) * h / 3;
        before = f2;
      }
      return sum;
    };
    const double down = branch(s, -s, 4000);
    EXPECT_NEAR(path.state.force.x / c, -0.1 * tenths, 1e-11);
    const double up = branch(-s, s, 4000);
    EXPECT_NEAR(path.state.force.x / c, 0.1 * tenths, 1e-11);
    EXPECT_NEAR((down + up) / static_cast<double>(work), 1, 1e-8);
    EXPECT_EQ(path.state.merges, 0);
  }
}

// Random walks that need no more layers than there are: force and stored energy of the unbounded diagram.
TEST(MemoryDiagram, WalksInThePlaneAgainstAnUnboundedDiagram) {
  std::mt19937_64 engine(3);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  int layers = 0, slid = 0;
  double worst = 0, worst_energy = 0;
  for (int walk = 0; walk < 40; ++walk) {
    Path<MemoryDiagram> path;
    DiagramReference<Wide> reference;
    const PairOf<Wide> wide = sheet_pair<Wide>();
    const double unit = kappa_of(path.pair) * path.pair.friction;
    for (int i = 0; i < 30; ++i) {
      const double z = in(0, 1) < 0.5 && i > 0 ? path.overlap : in(0.3, 1.5) * 1e-5;
      const double size = unit * 1e-5 * in(0, 1) * in(0, 1);
      const Vec3d d = {size * in(-1, 1), size * in(-1, 1), 0};
      const auto out = path.step(z, d);
      const Wide scale = kappa_of(wide) * wide.friction;
      reference.step(Wide(z), Wide(d.x) / scale, Wide(d.y) / scale);
      if (path.state.merges > 0) break;
      layers = std::max(layers, static_cast<int>(reference.size()));
      Wide x, y;
      reference.force(x, y);
      const Wide k = wide.friction * 4 * wide.young_eff * sqrt(Wide(1) / 80) / 3;
      const double cap = path.pair.friction * path.normal.elastic;
      slid += shapes::norm(out.force) > cap * (1 - 1e-12);
      worst = std::max({worst, std::abs(static_cast<double>(x * k) - out.force.x) / cap,
                        std::abs(static_cast<double>(y * k) - out.force.y) / cap});
      worst_energy =
          std::max(worst_energy, std::abs(static_cast<double>(reference.energy() * k * scale * 3 / 2) - out.energy) /
                                     (cap * unit * z));
    }
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_energy, 1e-12);
  EXPECT_GE(layers, 10);
  EXPECT_GT(slid, 20);
}

#endif  // TEST_HAS_BOOST

// A path that asks for a layer at every step: growing while it turns. What is lost is small, and counted; no energy is
// gained, to the second order of the steps that the sum of the work has.
TEST(MemoryDiagram, FusedLayersLoseLittleForceAndNoEnergyComesFromIt) {
  Path<MemoryDiagram> path;
  DiagramReference<double> reference;
  const double unit = kappa_of(path.pair) * path.pair.friction, top = 1e-5;
  const int n = 2000;
  double worst = 0, work = 0, gain = 0;
  const double most = 0.3 * 4.0 / 3 * path.pair.young_eff * std::sqrt(0.0125 * top) * top;
  Vec3d last{};
  const auto go = [&](double z, const Vec3d& d) {
    const auto out = path.step(z, d);
    reference.step(z, d.x / unit, d.y / unit);
    double x = 0, y = 0;
    reference.force(x, y);
    const double k = most / (top * std::sqrt(top));
    worst = std::max(worst, std::hypot(x * k - out.force.x, y * k - out.force.y) / most);
    work += 0.5 * dot(out.force + last, d);
    gain = std::max(gain, (out.energy - work) / (most * unit * top));
    last = out.force;
  };
  for (int i = 1; i <= n; ++i) {
    const double angle = 5.0 * i / n, rate = 0.9 * std::cos(1.3 * angle);
    go(top * i / n, Vec3d{std::cos(angle), std::sin(angle), 0} * (unit * top / n * rate));
  }
  for (int i = 1; i < n; ++i) go(top * (n - i) / n, Vec3d{0.3, -0.6, 0} * (unit * top / n));
  EXPECT_GT(path.state.merges, n / 2);
  EXPECT_LT(worst, 7.1e-3);
  EXPECT_GT(worst, 1e-3);
  EXPECT_LT(gain, 1e-9);
}

// Step by step: what is stored grows by no more than the work put in, on any walk.
TEST(MemoryDiagram, NoStepGainsEnergy) {
  std::mt19937_64 engine(5);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  for (const double friction : {0.05, 0.3, 2.0, 1e4}) {
    double merges = 0;
    for (int walk = 0; walk < 200; ++walk) {
      Path<MemoryDiagram> path;
      path.pair.friction = friction;
      const double unit = kappa_of(path.pair) * friction * 1e-5, reach = in(0, 1);
      double stored = 0;
      for (int i = 0; i < 200; ++i) {
        const bool grows = i > 0 && i % 60 < 40;  // in small steps that mostly stick
        const double by = 0.01 * in(0, 1), jump = in(0, 1) < 0.02 ? 0 : in(0.5, 1.5) * 1e-5;
        const double z = grows ? path.overlap * (1 + by) : in(0, 1) < 0.3 && i > 0 ? path.overlap : jump;
        const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * (unit * (grows ? by : reach * in(0, 1)));
        const auto out = path.step(z, d);
        const double scale = friction * 4.0 / 3 * 38.5e9 * std::sqrt(0.0125e-15) * unit;
        ASSERT_LE(out.energy - stored - dot(out.force, d), 1e-13 * scale) << walk << ' ' << i;
        ASSERT_GE(out.energy, 0);
        ASSERT_LE(shapes::norm(out.force), friction * path.normal.holding * (1 + 4e-16));
        stored = out.energy;
      }
      merges += path.state.merges;
    }
    EXPECT_GT(merges, 4000) << friction;
  }
}

TEST(MemoryDiagram, ClosedLoopsTakeWork) { EXPECT_GE(least_work_of_loops<MemoryDiagram>({.steps = 400}), -1e-10); }

TEST(MemoryDiagram, TurnsWithThePlane) {
  std::mt19937_64 engine(17);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  const double c = std::cos(1.1), s = std::sin(1.1);
  const auto turned = [&](const Vec3d& v) { return Vec3d{c * v.x - s * v.y, s * v.x + c * v.y, 0}; };
  Path<MemoryDiagram> path, other;
  for (int i = 0; i < 300; ++i) {
    const double z = in(0.3, 1) * 1e-5;
    const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * 1e-6;
    const auto f = path.step(z, d), g = other.step(z, turned(d));
    EXPECT_LT(shapes::norm(turned(f.force) - g.force), 1e-11 * path.normal.elastic);
  }
}

// A pair that turns as one rigid body about an oblique axis: `carried` turns the layers with the force, which is as it
// would be from them anew.
TEST(MemoryDiagram, LayersAreCarriedWithTheContact) {
  Path<MemoryDiagram> path;
  path.along(1e-5, 0);
  path.step(1e-5, {1e-6, 0.5e-6, 0});
  path.step(1.1e-5, {-3e-7, 4e-7, 0});
  const Vec3d first = path.state.force, axis = shapes::normalized(Vec3d{1, 2, 2}), n0{0, 0, 1};
  Vec3d old = n0;
  const int steps = 400;
  for (int i = 1; i <= steps; ++i) {
    const double angle = 2 * M_PI / steps, at = i * angle;
    const Vec3d n = n0 * std::cos(at) + cross(axis, n0) * std::sin(at) + axis * (dot(axis, n0) * (1 - std::cos(at)));
    path.state.force = carried(path.state.force, old, n, dot(axis, n) * angle);
    for (Vec3d& d : path.state.share) d = carried(d, old, n, dot(axis, n) * angle);
    const Vec3d kept = path.state.force;
    path.step(1.1e-5, {});
    EXPECT_LT(shapes::norm(path.state.force - kept), 1e-12 * shapes::norm(first));
    old = n;
  }
  EXPECT_LT(shapes::norm(path.state.force - first), 2e-4 * shapes::norm(first));
}

TEST(MemoryDiagram, WithoutFriction) {
  Path<MemoryDiagram> path;
  path.pair.friction = 0;
  path.damping_t = 1;
  for (const double z : {1e-5, 1.5e-5, 0.5e-5, 0.0, 1e-5}) {
    const auto out = path.step(z, {1e-6, 2e-6, 0});
    EXPECT_EQ(shapes::norm(out.force), 0);
    EXPECT_EQ(shapes::norm(path.state.force), 0);
    EXPECT_EQ(out.energy, 0);
  }
}

TEST(MemoryDiagram, WithoutSlipWhereFrictionIsWithoutBound) {
  Path<MemoryDiagram> path, large;
  path.pair.friction = infinity;
  large.pair.friction = 1e5;
  const double g = path.pair.shear_eff;
  const auto a = [&](double z) { return std::sqrt(0.0125 * z); };
  for (auto* p : {&path, &large}) {
    const double tolerance = p == &path ? 1e-14 : 1e-5;
    p->along(1e-5, 0);
    double force = 8 * g * a(1e-5) * 1e-6;
    EXPECT_NEAR(p->along(1e-5, 1e-6) / force, 1, tolerance);
    force *= std::sqrt(0.7);
    EXPECT_NEAR(p->along(0.7e-5, 0) / force, 1, tolerance);
    EXPECT_NEAR(p->along(0.9e-5, 0) / force, 1, tolerance);
    force -= 8 * g * a(0.9e-5) * 3e-6;
    EXPECT_NEAR(p->along(0.9e-5, -3e-6) / force, 1, tolerance);
  }
  const auto apart = path.step(0, {1, 0, 0});
  EXPECT_EQ(shapes::norm(apart.force), 0);
  EXPECT_EQ(shapes::norm(path.state.force), 0);
}

TEST(MemoryDiagram, AnIdleContactGivesNothing) {
  Path<MemoryDiagram> path;
  const auto out = path.step(0, {1e-6, 0, 0});
  EXPECT_EQ(shapes::norm(out.force), 0);
  EXPECT_EQ(out.energy, 0);
  for (const double z : path.state.depth) EXPECT_EQ(z, 0);
}

TEST(MemoryDiagram, AStepOfNothingChangesNothing) {
  Path<MemoryDiagram> path;
  for (int i = 1; i <= 30; ++i) path.step(1e-5 + 1e-7 * std::sin(i), {1e-7 * std::cos(2 * i), 1e-7 * std::sin(i), 0});
  const auto before = path.state;
  const auto out = path.step(path.overlap, {});
  EXPECT_TRUE(before.force == path.state.force);
  EXPECT_TRUE(out.force == path.state.force);
  EXPECT_EQ(before.merges, path.state.merges);
}

// The dashpot is outside the memory, is silent where all slips, and the cap bounds the sum.
TEST(MemoryDiagram, DashpotIsOutsideTheMemoryAndUnderTheCap) {
  Path<MemoryDiagram> path, plain;
  path.damping_t = 5;
  path.dt = plain.dt = 1e-6;
  path.along(1e-5, 0);
  plain.along(1e-5, 0);
  const double f = path.along(1e-5, 3e-7), bare = plain.along(1e-5, 3e-7);
  EXPECT_NEAR(f - bare, 5 * 0.3, 1e-12);
  EXPECT_EQ(path.state.force.x, bare);
  path.damping_t = 1e6;
  EXPECT_NEAR(path.along(1e-5, 1e-7) / (0.3 * path.normal.holding), 1, 1e-15);
  EXPECT_LT(path.state.force.x, 0.3 * path.normal.holding * 0.9);
  path.damping_t = 5;
  EXPECT_NEAR(path.along(1e-5, 1e-5) / path.state.force.x, 1, 1e-15);  // all slips
}

TEST(MemoryDiagram, ShrinksWithAPressingForceThatADashpotLowers) {
  Path<MemoryDiagram> path;
  path.along(1e-5, 1e-4);
  path.along(1e-5, 1e-4);
  path.pair.damping = 0.5;
  path.dt = 1e-6;
  path.along(0.99e-5, 1e-7);
  ASSERT_LT(path.normal.holding, 0.95 * path.normal.elastic);
  ASSERT_GT(path.normal.holding, 0);
  EXPECT_NEAR(path.state.force.x / (0.3 * path.normal.holding), 1, 1e-15);
  path.pair.damping = 0;
  EXPECT_LT(path.along(path.overlap, 0), 0.3 * 0.95 * path.normal.elastic);  // remembered
}

TEST(MemoryDiagram, AnotherUnitGivesTheSameBits) {
  std::mt19937_64 engine(23);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  Path<MemoryDiagram> path, other;  // lengths times 2^10, forces times 2^6
  other.radius_eff *= 1024;
  other.pair.young_eff *= 64.0 / (1024 * 1024);
  other.pair.shear_eff *= 64.0 / (1024 * 1024);
  for (int i = 0; i < 200; ++i) {
    const double z = in(0.3, 1) * 1e-5;
    const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * 1e-6;
    const auto f = path.step(z, d), g = other.step(z * 1024, d * 1024.0);
    EXPECT_TRUE(f.force * 64.0 == g.force);
    EXPECT_EQ(f.energy * 65536, g.energy);
  }
}

TEST(MemoryDiagram, LanesAreScalars) {
  EXPECT_GT(expect_lanes_are_scalars<MemoryDiagram>(7, sheet_pair<double>()).merges, 20);
}

}  // namespace
}  // namespace contact::tests
