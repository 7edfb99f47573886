// The tangential spring: Coulomb's cone, transport with the contact frame, energy over closed paths.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "libcontact/kernels/chunk.h"
#include "shapes/math/vec.h"

namespace contact::kernels {
namespace {

using shapes::Vec3d;

void put(Lane3& lane, const Vec3d& v) {
  lane.x[0] = v.x;
  lane.y[0] = v.y;
  lane.z[0] = v.z;
}
Vec3d get(const Lane3& lane) { return {lane.x[0], lane.y[0], lane.z[0]}; }

// One contact led along a path of overlap and slip, in lane 0.
class Led {
 public:
  explicit Led(double friction, double damping = 0) {
    LawChunk& c = *chunk_;
    c.radius_eff[0] = 0.0125;
    c.mass_eff[0] = 0.02;
    c.pair.young_eff[0] = 38.46153846e9;
    c.pair.shear_eff[0] = c.pair.young_eff[0] / (4 * 1.2142857142857142);  // κ at ν = 0.3
    c.pair.stiffness_n[0] = 1e7;
    c.pair.stiffness_t[0] = c.pair.stiffness_n[0] / 1.2142857142857142;
    c.pair.friction[0] = friction;
    c.pair.damping[0] = damping;
    put(c.normal, {0, 0, 1});
  }
  LawChunk& chunk() { return *chunk_; }
  // Over dt: slip by `slip` while the overlap becomes `overlap`. Returns the tangential force on b.
  Vec3d step(double overlap, const Vec3d& slip, LawKernel kernel, double dt = 1, bool rescale = true) {
    chunk_->overlap[0] = overlap;
    put(chunk_->velocity, slip * (1 / dt));
    kernel(*chunk_, 1, dt, {.rescale = rescale});
    const Vec3d f = get(chunk_->force), n = get(chunk_->normal);
    return -(f - n * dot(f, n));
  }
  double normal_force() const { return -dot(get(chunk_->force), get(chunk_->normal)); }
  double stiffness_t() const {
    return 8 * chunk_->pair.shear_eff[0] * std::sqrt(chunk_->radius_eff[0] * chunk_->overlap[0]);
  }

 private:
  std::unique_ptr<LawChunk> chunk_ = std::make_unique<LawChunk>();
};

TEST(Tangential, ForceStaysWithinTheCone) {
  for (const auto kernel : {kernels().hertz_mindlin, kernels().spring_dashpot}) {
    Led contact(0.3, 0.4);
    double slid = 0, stuck = 0;
    for (int i = 0; i < 2000; ++i) {
      const double depth = 1e-5 * (1 + 0.5 * std::sin(0.013 * i));
      const Vec3d ft = contact.step(depth, Vec3d{std::cos(0.1 * i), std::sin(0.07 * i), 0} * 2e-7, kernel, 1e-3);
      const double cap = 0.3 * contact.normal_force();
      EXPECT_LE(shapes::norm(ft), cap * (1 + 4e-16)) << i;
      (shapes::norm(ft) > cap * (1 - 1e-12) ? slid : stuck) += 1;
    }
    EXPECT_GT(slid, 0);
    EXPECT_GT(stuck, 0);
  }
}

TEST(Tangential, SlipsAtTheCapAgainstTheMotionAndKeepsTheCapAsItsSpring) {
  for (const auto kernel : {kernels().hertz_mindlin, kernels().spring_dashpot}) {
    Led contact(0.3);
    contact.step(1e-5, {}, kernel);
    Vec3d ft{};
    for (int i = 0; i < 10; ++i) ft = contact.step(1e-5, {3e-6, 4e-6, 0}, kernel);
    const double cap = 0.3 * contact.normal_force();
    EXPECT_NEAR(ft.x / cap, 0.6, 1e-15);
    EXPECT_NEAR(ft.y / cap, 0.8, 1e-15);
    const Vec3d held = contact.step(1e-5, {}, kernel);
    EXPECT_NEAR(shapes::norm(held - ft) / cap, 0, 1e-15);
  }
}

// Without a limit the spring holds all of the slip as long as the bodies press on each other, and nothing where they do
// not: at a clipped force of zero neither a force nor a number that is none.
TEST(Tangential, InfiniteFrictionHoldsWhatIsPressed) {
  for (const auto kernel : {kernels().hertz_mindlin, kernels().spring_dashpot, kernels().hertz_mindlin_patch,
                            kernels().spring_dashpot_patch}) {
    Led contact(std::numeric_limits<double>::infinity(), 0.4);
    LawChunk& c = contact.chunk();
    c.spread_xx[0] = c.spread_yy[0] = 1e-6;
    put(c.relative_spin, {0, 0, 1});
    contact.step(1e-5, {}, kernel, 1e3);
    const bool hertz = kernel == kernels().hertz_mindlin || kernel == kernels().hertz_mindlin_patch;
    const double kt = hertz ? contact.stiffness_t() : c.pair.stiffness_t[0];
    contact.step(1e-5, {1, 0, 0}, kernel, 1e9);
    EXPECT_NEAR(c.history_force.x[0] / kt, 1, 1e-12);
    put(c.velocity, {1, 0, -1e6});  // parts so fast that the dashpot would pull
    kernel(c, 1, 1e-12, {});
    EXPECT_EQ(shapes::norm(get(c.force)), 0);
    EXPECT_EQ(shapes::norm(get(c.history_force)), 0);
    EXPECT_EQ(shapes::norm(get(c.couple)), 0);
    EXPECT_EQ(c.history_twist[0], 0);
    kernel(c, 1, 1e-12, {.clip = false});
    EXPECT_GT(c.force.z[0], 0);  // pulls a along
    EXPECT_EQ(c.force.x[0], 0);  // what pulls does not rub
  }
}

// A pair that turns as one rigid body: the spring keeps its length and its direction in the body frame.
TEST(Tangential, TurnsWithTheContactFrame) {
  for (const auto kernel : {kernels().hertz_mindlin, kernels().spring_dashpot}) {
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      Led contact(0.5);
      contact.step(1e-5, {}, kernel);
      const Vec3d first = contact.step(1e-5, {4e-7, 3e-7, 0}, kernel);
      const int steps = 200 << fine;
      const Vec3d axis = shapes::normalized(Vec3d{1, 2, 2});
      const double angle = 2 * M_PI / steps;
      Vec3d ft{};
      for (int i = 1; i <= steps; ++i) {
        const double a = i * angle, c = std::cos(a), s = std::sin(a);
        const Vec3d n0{0, 0, 1};
        const Vec3d n = n0 * c + cross(axis, n0) * s + axis * (dot(axis, n0) * (1 - c));
        put(contact.chunk().normal, n);
        contact.chunk().turn[0] = dot(axis, n) * angle;  // both bodies spin about the axis; dt = 1
        ft = contact.step(1e-5, {}, kernel);
        EXPECT_NEAR(shapes::norm(ft) / shapes::norm(first), 1, 1e-12);
        EXPECT_LT(std::abs(dot(ft, n)), 1e-13 * shapes::norm(first));
      }
      error[fine] = shapes::norm(ft - first) / shapes::norm(first);
    }
    EXPECT_LT(error[0], 5e-4);  // rad, 0.02° after one turn of 200 steps
    EXPECT_NEAR(error[0] / error[1], 4, 0.4);
  }
}

// Load at high N, lower N, slip back, raise N: work put in over the loop, in units of kt X²/2 at high N.
double loop_work(bool rescale) {
  Led contact(1e3);
  const double high = 1e-5, low = 0.5e-5, slip = 1e-7;
  const int n = 20000;
  contact.step(high, {}, kernels().hertz_mindlin, 1, rescale);
  const double kt = contact.stiffness_t();
  double work = 0;
  Vec3d before{};
  const auto go = [&](double from, double to, double distance) {
    for (int i = 1; i <= n; ++i) {
      const Vec3d ds{distance / n, 0, 0};
      const Vec3d ft = contact.step(from + (to - from) * i / n, ds, kernels().hertz_mindlin, 1, rescale);
      work += 0.5 * dot(before + ft, ds);
      before = ft;
    }
  };
  go(high, high, slip);
  go(high, low, 0);
  go(low, low, -slip);
  go(low, high, 0);
  return work / (0.5 * kt * slip * slip);
}

TEST(Tangential, AClosedLoopCreatesNoEnergyWhenRescaled) {
  // On the way out the spring takes kt X²/2. At low N its stiffness is kt/√2: back it gives (kt − kt/(2√2)) X² when it
  // kept its force, in all 1 − 2 + 1/√2 = −0.293; rescaled to kt X/√2 it gives kt X²/(2√2), in all 1 − 1/√2 = +0.293.
  EXPECT_NEAR(loop_work(false), -(1 - std::sqrt(0.5)), 1e-4);
  EXPECT_NEAR(loop_work(true), 1 - std::sqrt(0.5), 1e-4);
}

TEST(Tangential, OnlyThePartOfTheFirstStepInContactSlips) {
  Led contact(10);
  LawChunk& c = contact.chunk();
  c.overlap[0] = 1e-6;
  put(c.velocity, {1, 0, 4});  // in 1 µs it closes by 4 µm: a quarter of the step in contact
  kernels().spring_dashpot(c, 1, 1e-6, {});
  EXPECT_NEAR(-c.force.x[0], c.pair.stiffness_t[0] * 0.25e-6, 1e-12);
}

}  // namespace
}  // namespace contact::kernels
