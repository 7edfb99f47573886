// Head-on impact of two equal spheres through the loop: the rebound speed ratio is the asked restitution, whatever the
// phase of the step in which they meet. Off-centre it is that of the contact's point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "libcontact/laws/mix.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.01, density = 2500, speed = 0.5;  // m, kg/m³, m/s each: closing speed 1 m/s

// Duration of the undamped contact, s; the sheet's closed forms.
double contact_time(LawName law, const MaterialSpec& m) {
  const double mass_eff = 0.5 * density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  if (law == LawName::spring_dashpot) return std::numbers::pi * std::sqrt(mass_eff / m.stiffness);
  const double young_eff = 0.5 * m.young / (1 - m.poisson * m.poisson);
  return 2.8682657 * std::pow(mass_eff * mass_eff / (0.5 * radius * young_eff * young_eff * 2 * speed), 0.2);
}

double measured_restitution(LawName law, double e, int steps_per_contact, double phase, bool clip = true) {
  Scene s;
  s.law.name = law;
  s.law.clip = clip;
  s.materials = {scenes::material("m", 5e6, density, e, 0)};
  s.materials[0].stiffness = 1e4;
  s.shapes = {scenes::sphere("ball", radius)};
  s.run.dt_auto = false;
  s.run.dt = contact_time(law, s.materials[0]) / steps_per_contact;
  s.run.steps = 1;
  const double half_gap = (1 + phase) * speed * s.run.dt;
  s.bodies = {scenes::body("ball", "m", {-radius - half_gap, 0, 0}, {speed, 0, 0}),
              scenes::body("ball", "m", {radius + half_gap, 0, 0}, {-speed, 0, 0})};
  World w = build_world(s);
  bool met = false;
  for (int i = 0; i < 20 * steps_per_contact; ++i) {
    advance(w, 1);
    const bool touching = !touching_contacts(w).empty();
    if (met && !touching) break;
    met = met || touching;
  }
  return scenes::motion(w, 1).velocity.x / speed;
}

double worst_error(LawName law, double e, int steps_per_contact, bool clip = true) {
  double worst = 0;
  for (int k = 0; k < 20; ++k)
    worst = std::max(worst, std::abs(measured_restitution(law, e, steps_per_contact, k / 20.0, clip) - e));
  return worst / e;
}

class Restitution : public testing::TestWithParam<LawName> {};

TEST_P(Restitution, IsHitAtEveryPhaseOfOnset) {
  std::printf("   e   worst relative error over 20 phases at contact time /50 /100 /200 /400, orders\n");
  for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    double error[4];
    for (int i = 0; i < 4; ++i) error[i] = worst_error(GetParam(), e, 50 << i);
    std::printf("  %.1f  %.3e %.3e %.3e %.3e   %.2f %.2f %.2f\n", e, error[0], error[1], error[2], error[3],
                std::log2(error[0] / error[1]), std::log2(error[1] / error[2]), std::log2(error[2] / error[3]));
    EXPECT_LT(error[0], 0.005) << "e = " << e;
    EXPECT_LT(error[3], 0.1 * error[0]) << "e = " << e << ": slower than first order";
  }
}

// The dashpot pulls up to the end, which may lie anywhere in a step: what is left is a share of the impact speed, not
// of the rebound.
TEST_P(Restitution, IsHitUnclipped) {
  for (const double e : {0.1, 0.5, 0.9, 1.0}) {
    const double coarse = worst_error(GetParam(), e, 50, false), fine = worst_error(GetParam(), e, 400, false);
    std::printf("  %.1f  %.3e at contact time /50, %.3e at /400\n", e, coarse, fine);
    EXPECT_LT(coarse * e, 0.005) << "e = " << e;
    EXPECT_LT(fine, 0.002) << "e = " << e;
  }
}

// e = 0, which a clipped contact cannot have: critical damping, x = v t exp(−ω t) for the linear law and the same in a
// stretched time for Hertz. The bodies come back at up to exp(−2) of the impact speed, never part and come to rest.
TEST_P(Restitution, ZeroComesToRestUnclipped) {
  for (int k = 0; k < 5; ++k) {
    Scene s;
    s.law.name = GetParam();
    s.law.clip = false;
    s.materials = {scenes::material("m", 5e6, density, 0, 0)};
    s.materials[0].stiffness = 1e4;
    s.shapes = {scenes::sphere("ball", radius)};
    s.run.steps = 1;
    const double half_gap = 1e-5 * (1 + 0.2 * k);
    s.bodies = {scenes::body("ball", "m", {-radius - half_gap, 0, 0}, {speed, 0, 0}),
                scenes::body("ball", "m", {radius + half_gap, 0, 0}, {-speed, 0, 0})};
    World w = build_world(s);
    double fastest = 0, deepest = 0;
    for (int i = 0; i < 20000; ++i) {
      advance(w, 1);
      fastest = std::max(fastest, scenes::motion(w, 1).velocity.x);
      const auto touching = touching_contacts(w);
      if (!touching.empty()) deepest = std::max(deepest, touching[0].overlap);
    }
    EXPECT_NEAR(fastest / speed / std::exp(-2), 1, 0.005);
    ASSERT_EQ(touching_contacts(w).size(), 1u);
    EXPECT_LT(touching_contacts(w)[0].overlap, 1e-6 * deepest);
    EXPECT_LT(std::abs(scenes::motion(w, 1).velocity.x), 1e-6 * speed);
  }
}

// A tilted ellipsoid and a tilted box drop on a plane without friction: what rebounds by e is the point of contact,
// whose effective mass holds the inertia. Slowly, so that the pose hardly changes meanwhile.
TEST_P(Restitution, IsThatOfThePointOfContactOffCentre) {
  for (const ShapeSpec& shape :
       {scenes::ellipsoid("body", {0.01, 0.02, 0.03}), scenes::box("body", {0.02, 0.03, 0.04})})
    for (const double e : {0.3, 0.7, 1.0}) {
      Scene s;
      s.law.name = GetParam();
      s.materials = {scenes::material("m", 5e9, density, e, 0)};
      s.materials[0].stiffness = 1e7;
      s.shapes = {shape};
      s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
      s.run.dt_fraction = 0.02;
      s.run.steps = 1;
      s.bodies = {scenes::body("body", "m", {0, 0, 0.05}, {}, {}, scenes::turn({0.6, 0.8, 0}, 0.7))};
      // Find the height at which it touches, and let it come from just above.
      double low = 0.005, high = 0.05;
      while (high - low > 1e-9 * high) {
        s.bodies[0].position.z = 0.5 * (low + high);
        s.run.max_initial_overlap = 10;
        (touching_contacts(build_world(s)).empty() ? high : low) = s.bodies[0].position.z;
      }
      s.bodies[0].position.z = high;
      s.bodies[0].velocity = {0, 0, -1e-3};
      World w = build_world(s);
      const Motion& m = w.particles.motion[0];
      Vec3d arm{};
      bool met = false;
      for (int i = 0; i < 1000000; ++i) {
        advance(w, 1);
        const auto touching = touching_contacts(w);
        if (met && touching.empty()) break;
        if (!touching.empty() && !met) arm = touching[0].point - m.position;
        met = met || !touching.empty();
      }
      ASSERT_TRUE(met);
      EXPECT_GT(std::abs(arm.x) + std::abs(arm.y), 0.1 * std::abs(arm.z));  // off-centre
      EXPECT_NEAR((m.velocity + cross(m.spin, arm)).z / 1e-3, e, 2e-3) << shape.kind << ", e = " << e;
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, Restitution, testing::Values(LawName::spring_dashpot, LawName::hertz_mindlin),
                         [](const auto& p) {
                           return p.param == LawName::hertz_mindlin ? "hertz_mindlin" : "spring_dashpot";
                         });

}  // namespace
}  // namespace dem
