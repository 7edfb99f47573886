// Peeling and sliding of an adhesive contact: Savkoor & Briggs' energy balance, Thornton's sliding forces.
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/laws/tangential/thornton_peeling.h"
#include "tests/libcontact/tangential_path.h"

namespace contact::tests {
namespace {

using Law = ThorntonPeeling;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double radius_eff = 0.0125;

// An adhesive contact that is led by its force: F = Fc (overlap/10 µm − 1), the radius that of JKR.
struct LedByForce {
  template <class T>
  using State = NoState<T>;
  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions&, State<T>&) {
    const T pull = peeling::pull_off(p, k.radius_eff), force = pull * (k.overlap * T(1e5) - T(1));
    const auto touches = k.overlap > T(0);
    NormalForce<T> f;
    f.force = f.elastic = select(touches, force, T(0));
    f.contact_radius = select(touches, peeling::radius(p, k.radius_eff, force, T(0)), T(0));
    f.stiffness_t = T(8) * p.shear_eff * f.contact_radius;
    f.holding = select(touches, larger(force + T(2) * pull, T(0)), T(0));
    f.shrink = T(1);
    return f;
  }
};

PairOf<double> sticky(double friction, double work_of_adhesion = 0.2) {
  PairOf<double> p = sheet_pair<double>(friction);
  p.work_of_adhesion = work_of_adhesion;
  return p;
}
double at(double force_over_pull_off) { return 1e-5 * (force_over_pull_off + 1); }

struct Peeling : Path<Law, double, LedByForce> {
  explicit Peeling(double friction, double work_of_adhesion = 0.2) { pair = sticky(friction, work_of_adhesion); }
  double pull() const { return peeling::pull_off(pair, radius_eff); }
  double limit(double force) const { return peeling::peel_force(pair, radius_eff, force * pull()); }
};

#if TEST_HAS_BOOST

// The formulas in 50 digits, π included.
struct Reference {
  Wide e = Wide(38461538460LL), g = e * 7 / 34, r = Wide(1) / 80, w = Wide(0.2);
  Wide pi = boost::math::constants::pi<Wide>(), pull = 3 * pi * w * r / 2;
  Wide root(const Wide& f, const Wide& t) const {
    return sqrt(Wide(4 * f * pull + 4 * pull * pull - t * t * e / (4 * g)));
  }
  Wide radius(const Wide& f, const Wide& t) const {
    return pow(Wide(3 * r / (4 * e) * (f + 2 * pull + root(f, t))), Wide(1) / 3);
  }
  Wide limit(const Wide& f) const { return 4 * sqrt(Wide(g / e * (f * pull + pull * pull))); }
};

TEST(ThorntonPeeling, RadiusIsThatOfTheEnergyBalance) {
  const Reference ref;
  const PairOf<double> p = sticky(0.3);
  for (const double f : {-0.9, -0.3, 0.0, 0.7, 5.0, 300.0})
    for (const double t : {0.0, 0.1, 0.6, 0.95, 0.9999}) {
      const Wide force = ref.pull * f, shear = ref.limit(force) * t, a = ref.radius(force, shear), cube = a * a * a;
      const Wide apparent = 4 * ref.e * cube / (3 * ref.r) - force;
      const Wide balance =
          apparent * apparent / (8 * ref.pi * ref.e * cube) + shear * shear / (32 * ref.pi * ref.g * cube);
      EXPECT_LT(abs(balance / ref.w - 1), 1e-45);
      const double law = peeling::radius(p, radius_eff, static_cast<double>(force), static_cast<double>(shear));
      EXPECT_NEAR(static_cast<double>(law / a), 1, t > 0.99 ? 1e-12 : 3e-15) << f << ' ' << t;
    }
}

TEST(ThorntonPeeling, EndsWhereTheRootVanishes) {
  const Reference ref;
  const PairOf<double> p = sticky(0.3);
  for (const double f : {-0.9, -0.3, 0.0, 0.7, 5.0, 300.0}) {
    const Wide force = ref.pull * f, limit = ref.limit(force);
    EXPECT_LT(abs(ref.root(force, limit * (1 - Wide("1e-30"))) / ref.pull), 1e-13);
    EXPECT_NEAR(static_cast<double>(peeling::peel_force(p, radius_eff, static_cast<double>(force)) / limit), 1, 2e-15);
    const Wide left = pow(Wide(3 * ref.r / (4 * ref.e) * (force + 2 * ref.pull)), Wide(1) / 3);  // (9.18)
    EXPECT_NEAR(static_cast<double>(peeling::radius(p, radius_eff, static_cast<double>(force),
                                                    static_cast<double>(limit * Wide(1.001))) /
                                    left),
                1, 3e-15);
  }
}

// Constant F: Ft = 8 G* a(Ft) x until it peels.
TEST(ThorntonPeeling, FollowsTheRadiusThatItsOwnForceLeaves) {
  const Reference ref;
  for (const double f : {-0.8, 0.0, 4.0})
    for (const double part : {0.3, 0.9, 0.999}) {
      double error[2];
      for (int fine = 0; fine < 2; ++fine) {
        Peeling path(2.0);
        const Wide force = ref.pull * f, target = ref.limit(force) * Wide(part);
        const double slip = static_cast<double>(target / (8 * ref.g * ref.radius(force, target)));
        const int n = 1 << (4 * fine);
        path.along(at(f), 0);
        for (int i = 0; i < n; ++i) path.along(at(f), slip / n);
        EXPECT_EQ(path.state.peeled, 0);
        error[fine] = path.state.force.x / static_cast<double>(target) - 1;
      }
      for (const double e : error) EXPECT_NEAR(e, 0, 1e-13);  // at any step
    }
}

#endif  // TEST_HAS_BOOST

// Friction below what adhesion holds: up to (9.17), then down to μ H at once, and there it stays.
TEST(ThorntonPeeling, DropsToSlidingWhenItHasPeeled) {
  for (const double f : {-0.8, -0.31, -0.29, 0.0, 3.0}) {
    Peeling path(0.05);
    const double limit = path.limit(f), pull = path.pull(), h = peeling::pressing(path.pair, radius_eff, f * pull);
    ASSERT_LT(0.05 * h, 0.9 * limit);
    path.along(at(f), 0);
    double most = 0;
    int steps = 0;
    for (; path.state.peeled == 0 && steps < 100000; ++steps) {
      const double t = path.along(at(f), 1e-11);
      if (path.state.peeled == 0) most = std::max(most, t);
    }
    EXPECT_LT(most, limit);
    EXPECT_GT(most, 0.998 * limit);
    EXPECT_NEAR(path.state.force.x / (0.05 * h), 1, 1e-14);
    EXPECT_NEAR(path.along(at(f), 1e-11) / (0.05 * h), 1, 1e-14);
    EXPECT_NEAR(path.along(at(f), -1e-6) / (0.05 * h), -1, 1e-14);
    EXPECT_EQ(path.state.peeled, 1);
  }
}

// Friction above it: on from the peeled contact as Box 9.1 with F + 2Fc, to μ (F + 2Fc).
TEST(ThorntonPeeling, GoesOnWithMicroSlipWhereFrictionHoldsMore) {
  Peeling path(1.5);
  const double f = 2, limit = path.limit(f), h = (f + 2) * path.pull(),
               a = peeling::radius(path.pair, radius_eff, f * path.pull(), 10 * limit);
  ASSERT_GT(1.5 * h, 1.2 * limit);
  path.along(at(f), 0);
  for (int i = 0; i < 1000000 && path.state.peeled == 0; ++i) path.along(at(f), 1e-12);
  const double start = path.state.force.x;
  EXPECT_NEAR(start / limit, 1, 1e-3);
  // (1 − Ft/μH)^⅔ falls by x · 16 G* a/(3 μ H).
  const double x = 2e-8, unit = 3 * 1.5 * h / (16 * path.pair.shear_eff * a);
  const int n = 100000;
  for (int i = 0; i < n; ++i) path.along(at(f), x / n);
  const double rest = std::pow(1 - start / (1.5 * h), 2.0 / 3) - x / unit;
  ASSERT_GT(rest, 0.05);
  EXPECT_NEAR(path.state.force.x / (1.5 * h), 1 - rest * std::sqrt(rest), 1e-5);
  EXPECT_NEAR(path.along(at(f), 1e-6) / (1.5 * h), 1, 1e-12);
}

TEST(ThorntonPeeling, SlidingForceAndItsStep) {
  const PairOf<double> p = sticky(1);
  const double pull = peeling::pull_off(p, radius_eff);
  const auto h = [&](double f) { return peeling::pressing(p, radius_eff, f * pull) / pull; };
  for (const double f : {-0.2999, 0.0, 7.0}) EXPECT_NEAR(h(f), f + 2, 1e-14);
  for (const double f : {-0.999, -0.7, -0.3001}) {
    const double whole = f + 2 + 2 * std::sqrt(f + 1);
    EXPECT_NEAR(h(f), whole * std::pow(1 - (whole - f) / (3 * whole), 1.5), 1e-14);
  }
  const double below = h(std::nextafter(-0.3, -1)), above = h(-0.3 + 1e-15);
  EXPECT_NEAR(below, 1.7151, 5e-5);
  EXPECT_NEAR(above, 1.7000, 5e-5);
  EXPECT_NEAR(below / above - 1, 0.009, 2e-4);
  const auto difference = [&](double f) {  // where the two cross
    const double whole = f + 2 + 2 * std::sqrt(f + 1);
    return whole * std::pow(1 - (whole - f) / (3 * whole), 1.5) - (f + 2);
  };
  EXPECT_LT(difference(-0.32524) * difference(-0.32522), 0);
}

// What the normal force lets go by itself.
TEST(ThorntonPeeling, PeelsWhenTheNormalForceFalls) {
  Peeling path(0.02);
  path.along(at(3), 0);
  const double force = path.along(at(3), 1e-8);
  ASSERT_LT(force, path.limit(3));
  double last = force;
  bool peeled = false;
  for (int i = 1; i <= 2000; ++i) {
    const double f = 3 - 3.95 * i / 2000, t = path.along(at(f), 0);
    EXPECT_LE(t, last);
    if (!peeled && path.state.peeled > 0) {
      EXPECT_GT(last, 0.99 * path.limit(f));
      EXPECT_GT(f, -0.95);
      peeled = true;
    }
    if (peeled) {
      EXPECT_NEAR(t / (0.02 * peeling::pressing(path.pair, radius_eff, f * path.pull())), 1, 1e-12);
    }
    last = t;
  }
  EXPECT_TRUE(peeled);
}

TEST(ThorntonPeeling, ForceShrinksWithTheRadius) {
  Peeling path(2);
  path.along(at(5), 0);
  const double force = path.along(at(5), 1e-9), radius = path.state.radius;
  const double less = path.along(at(4), 0);
  EXPECT_NEAR(less / force, path.state.radius / radius, 1e-14);
  EXPECT_LT(less, 0.98 * force);
  EXPECT_NEAR(path.along(at(5), 0) / less, 1, 1e-14);
}

#if TEST_HAS_BOOST
// In 50 digits: next to the cap θ is a cube root of rounding.
TEST(ThorntonPeeling, WithoutAdhesionIsBox91) {
  Path<Law, Wide> plain;
  Path<MindlinDeresiewicz, Wide> box;
  std::mt19937_64 engine(29);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  for (int i = 0; i < 100; ++i) {
    const Wide z = in(0.5, 1) * 1e-5;
    const Vec3<Wide> d = {in(-1, 1) * 3e-7, in(-1, 1) * 3e-7, 0};
    const auto f = plain.step(z, d), g = box.step(z, d);
    EXPECT_LT(abs(f.force.x - g.force.x) + abs(f.force.y - g.force.y), 1e-8 * box.normal.elastic) << i;
    EXPECT_LT(abs(f.energy / g.energy - 1), 1e-7) << i;
  }
}
#endif

TEST(ThorntonPeeling, WithoutFrictionHoldsUntilPeeledAndWithUnboundedAlways) {
  Peeling smooth(0), rough(infinity);
  smooth.along(at(1), 0);
  rough.along(at(1), 0);
  EXPECT_GT(smooth.along(at(1), 1e-9), 0);
  EXPECT_EQ(smooth.along(at(1), 1e-6), 0);
  EXPECT_EQ(smooth.state.peeled, 1);
  EXPECT_EQ(smooth.along(at(1), 1e-9), 0);
  rough.along(at(1), 1e-6);
  EXPECT_EQ(rough.state.peeled, 1);
  const double a = peeling::radius(rough.pair, radius_eff, rough.pull(), infinity), kt = 8 * rough.pair.shear_eff * a;
  const double force = rough.state.force.x;
  EXPECT_GT(force, 10 * rough.limit(1));
  EXPECT_NEAR((rough.along(at(1), 2e-6) - force) / (kt * 2e-6), 1, 1e-14);
  const auto out = rough.step(0, {1, 0, 0});
  EXPECT_EQ(shapes::norm(out.force), 0);
  EXPECT_EQ(shapes::norm(rough.state.force), 0);
  EXPECT_EQ(rough.state.peeled, 0);
}

TEST(ThorntonPeeling, TurnsWithThePlane) {
  std::mt19937_64 engine(17);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  const auto quarter = [](const Vec3d& v) { return Vec3d{-v.y, v.x, 0}; };
  int peeled = 0, held = 0;
  for (int walk = 0; walk < 50; ++walk) {
    Peeling path(0.8), upright(0.8);
    for (int i = 0; i < 40; ++i) {
      const double z = in(0.2, 5) * 1e-5;
      const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * (2e-9 * in(0, 2));
      ASSERT_TRUE(quarter(path.step(z, d).force) == upright.step(z, quarter(d)).force) << i;
      (path.state.peeled > 0 ? peeled : held) += 1;
    }
  }
  EXPECT_GT(peeled, 100);
  EXPECT_GT(held, 100);
}

TEST(ThorntonPeeling, DashpotIsOutsideTheMemory) {
  Peeling path(0.5), plain(0.5);
  path.dt = plain.dt = 1e-6;
  path.along(at(1), 0);
  plain.along(at(1), 0);
  path.damping_t = 0.1;
  const double f = path.along(at(1), 1e-9), bare = plain.along(at(1), 1e-9);
  EXPECT_NEAR((f - bare) / (0.1 * 1e-3), 1, 1e-10);
  EXPECT_EQ(path.state.force.x, bare);
  path.damping_t = 1e6;
  EXPECT_NEAR(path.along(at(1), 1e-9) / std::max(path.limit(1), 0.5 * path.normal.holding), 1, 1e-14);
  EXPECT_EQ(path.state.peeled, 0);
}

TEST(ThorntonPeeling, AnotherUnitGivesTheSameBits) {
  std::mt19937_64 engine(23);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  Path<Law> path, other;  // lengths times 2^10, forces times 2^6
  path.pair = other.pair = sticky(0.4, 64);
  other.radius_eff *= 1024;
  other.pair.young_eff *= 64.0 / (1024 * 1024);
  other.pair.shear_eff *= 64.0 / (1024 * 1024);
  other.pair.work_of_adhesion *= 64.0 / 1024;
  for (int i = 0; i < 300; ++i) {
    const double z = in(0.3, 1) * 1e-5;
    const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * 1e-7;
    const auto f = path.step(z, d), g = other.step(z * 1024, d * 1024.0);
    EXPECT_TRUE(f.force * 64.0 == g.force);
    EXPECT_EQ(f.energy * 65536, g.energy);
    EXPECT_EQ(path.state.peeled, other.state.peeled);
  }
}

TEST(ThorntonPeeling, LanesAreScalars) {
  expect_lanes_are_scalars<Law, LedByForce>(7, sticky(0.3, 100));
  expect_lanes_are_scalars<Law>(7, sticky(0.3, 100));
}

}  // namespace
}  // namespace contact::tests
