// Oblique impact and sliding of spheres through the loop, against closed forms and the published oblique-impact set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

// The set's sphere, but slow: its answers do not depend on speed as long as the overlap is nothing beside the radius
// (the lever of friction is the radius less half the overlap; at the set's 5 m/s that is 0.4 % of the spin).
constexpr double radius = 0.025, speed = 0.05, friction = 0.1;  // m, m/s
constexpr double duration = 1.258602e-4 * 2.5118864315095801;   // s, elastic contact: that at 5 m/s times 100^(1/5)

struct Rebound {
  double contact_speed;  // s' = tangential speed of the contact point, m/s
  double tangential;     // et = centre's tangential speed out / in
  double spin;           // rad/s about the axis that rolling along the motion has
  double normal;         // rebound speed ratio
};

// A sphere onto a plane of the same material, tangential speed vt, both components along skew directions.
Rebound impact(LawName law, double restitution, double vt, double dt_share = 1.0 / 4000) {
  Scene s;
  s.law.name = law;
  s.materials = {scenes::material("alloy", 70e9, 2650, restitution, friction)};
  s.shapes = {scenes::sphere("ball", radius)};
  const Vec3d n = shapes::normalized(Vec3d{0.3, -0.2, 1});
  Vec3d t, u;
  shapes::tangent_frame(n, t, u);
  s.walls = {scenes::plane("floor", "alloy", {0, 0, 0}, n)};
  s.run.dt_auto = false;
  s.run.steps = 1;
  s.run.dt = duration * dt_share;
  const double mass = 2650 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  s.materials[0].stiffness = mass * std::pow(std::numbers::pi / duration, 2);
  s.bodies = {scenes::body("ball", "alloy", n * (radius + 0.3 * speed * s.run.dt), n * -speed + t * vt)};
  World w = build_world(s);
  bool met = false;
  for (int i = 0; i < 100000; ++i) {
    advance(w, 1);
    const bool touching = !touching_contacts(w).empty();
    if (met && !touching) break;
    met = met || touching;
  }
  const Motion& m = w.particles.motion[0];
  const Vec3d v = m.velocity + cross(m.spin, n * -radius);
  return {dot(v, t), dot(m.velocity, t) / vt, dot(m.spin, cross(n, t)), dot(m.velocity, n) / speed};
}

// Elastic set of Thornton, Ning, Chen, Wu (2011): no-slip Hertz–Mindlin with the spring shortened on unloading. s' in
// units of μ vn; Θ = 2 tan(angle)/((1 + e) μ), hence vt = Θ μ vn at e = 1.
TEST(ObliqueImpact, HertzMindlinRescaled) {
  const double table[][3] = {{0.25, .1285, .8612}, {0.5, .2498, .8570},  {1, .4153, .8329},  {1.5, .2710, .7659},
                             {2, -.1908, .6870},   {2.5, -.6330, .6419}, {3, -.9886, .6201}, {4, -1.3980, .6144},
                             {5, -1.4356, .6322},  {6, -.9814, .6676},   {9, 2, .7778}};
  std::printf("  theta  s'/(mu vn)  (set)     et  (set)\n");
  for (const auto& [theta, slip, et] : table) {
    const Rebound r = impact(LawName::hertz_mindlin, 1, theta * friction * speed);
    std::printf("  %5.2f  %9.4f %8.4f  %6.4f %6.4f\n", theta, r.contact_speed / (friction * speed), slip, r.tangential,
                et);
    const double tolerance = theta >= 2 ? 0.01 : 0.02;
    EXPECT_NEAR(r.contact_speed / (friction * speed), slip, tolerance) << theta;
    EXPECT_NEAR(r.tangential, et, tolerance) << theta;
    EXPECT_NEAR(r.normal, 1, 1e-6) << theta;
  }
}

// Sliding throughout: vt' = vt − μ(1 + e) vn, R ω' = (5/2) μ(1 + e) vn; elastic and damped, both laws.
TEST(ObliqueImpact, SlidingFollowsFromTheImpulses) {
  for (const LawName law : {LawName::hertz_mindlin, LawName::spring_dashpot})
    for (const double e : {1.0, 0.75, 0.5}) {
      const double vt = 6 * friction * (1 + e) * speed;
      const Rebound r = impact(law, e, vt, 1.0 / 1000);
      EXPECT_NEAR(r.normal, e, 1e-4);
      EXPECT_NEAR(r.tangential, 1 - friction * (1 + e) * speed / vt, 1e-4);
      EXPECT_NEAR(radius * r.spin / (2.5 * friction * (1 + e) * speed), 1, 2e-4);
    }
}

// Opposite equal spins of two equal spheres: their surfaces move alike, nothing tangential happens.
TEST(ObliqueImpact, MirrorSpinsStay) {
  Scene s;
  s.materials = {scenes::material("alloy", 70e9, 2700, 0.5, 0.4)};
  s.shapes = {scenes::sphere("ball", 0.1)};
  s.run.steps = 1;
  s.run.dt_fraction = 0.05;
  s.bodies = {scenes::body("ball", "alloy", {-0.1000001, 0, 0}, {0.2, 0, 0}, {0, 0, 10}),
              scenes::body("ball", "alloy", {0.1000001, 0, 0}, {-0.2, 0, 0}, {0, 0, -10})};
  const World w = scenes::run(s, 3000);
  EXPECT_EQ(w.counters.contact_steps > 100, true);
  EXPECT_NEAR(scenes::motion(w, 1).velocity.x, 0.1, 0.001);
  for (const std::uint64_t id : {0u, 1u}) {
    EXPECT_LT(std::abs(scenes::motion(w, id).velocity.y), 1e-15);
    EXPECT_NEAR(scenes::motion(w, id).spin.z, id == 0 ? 10 : -10, 1e-12);
  }
}

// A sphere set down sliding on a floor at v0 = 0.1 m/s: it rolls after 2 v0/(7 μ g) at 12 v0²/(49 μ g) with (5/7) v0.
TEST(SlipToRoll, SpeedTimeAndDistance) {
  for (const double mu : {0.2, 0.5}) {
    Scene s;
    s.law.name = LawName::spring_dashpot;
    s.gravity = {0, 0, -9.81};
    s.materials = {scenes::material("grain", 0, 2000, 0.9, mu)};
    const double r = 0.5e-3, mass = 2000 * 4.0 / 3.0 * std::numbers::pi * r * r * r, stiffness = 1e3;
    s.materials[0].stiffness = stiffness;
    s.shapes = {scenes::sphere("ball", r)};
    s.walls = {scenes::plane("floor", "grain", {0, 0, 0}, {0, 0, 1})};
    s.run.steps = 1;
    s.bodies = {scenes::body("ball", "grain", {0, 0, r - mass * 9.81 / stiffness}, {0.1, 0, 0})};
    World w = build_world(s);
    double slid_until = 0, x = 0;
    const double expected = 2 * 0.1 / (7 * mu * 9.81);
    while (w.time() < 2 * expected) {
      advance(w, 1);
      const Motion& m = w.particles.motion[0];
      const auto contacts = touching_contacts(w);
      ASSERT_EQ(contacts.size(), 1u);
      if (scenes::length(contacts[0].tangential) < mu * std::abs(contacts[0].force.z) * 0.999) break;
      slid_until = w.time();
      x = m.position.x;
    }
    EXPECT_NEAR(slid_until / expected, 1, 0.002) << mu;
    EXPECT_NEAR(x / (12 * 0.1 * 0.1 / (49 * mu * 9.81)), 1, 0.002) << mu;
    while (w.time() < 3 * expected) advance(w, 1);
    EXPECT_NEAR(w.particles.motion[0].velocity.x / (5 * 0.1 / 7), 1, 5e-4) << mu;
    EXPECT_NEAR(w.particles.motion[0].spin.y / (5 * 0.1 / 7 / r), 1, 5e-4) << mu;
  }
}

// Inclines: gravity leans by th. Rolls at (5/7) g sin th when μ >= (2/7) tan th, else slides at g (sin th − μ cos th).
TEST(Incline, SphereRollsOrSlides) {
  const auto speed_after = [](double th, double mu, double& spin) {
    Scene s;
    s.gravity = {9.8 * std::sin(th), 0, -9.8 * std::cos(th)};
    s.materials = {scenes::material("m", 1e8, 2500, 0.5, mu)};
    s.shapes = {scenes::sphere("ball", 0.01)};
    s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
    s.run.steps = 1;
    const double e2 = 0.5 * 1e8 / 0.91, weight = 2500 * 4.0 / 3.0 * std::numbers::pi * 1e-6 * 9.8 * std::cos(th);
    const double sink = std::pow(weight / (4.0 / 3.0 * e2 * std::sqrt(0.01)), 2.0 / 3.0);
    s.bodies = {scenes::body("ball", "m", {0, 0, 0.01 - sink})};
    World w = build_world(s);
    while (w.time() < 0.5) advance(w, 1);
    spin = w.particles.motion[0].spin.y * 0.01 / w.time();
    return w.particles.motion[0].velocity.x / w.time();
  };
  const double deg = std::numbers::pi / 180;
  double spin = 0;
  EXPECT_NEAR(speed_after(15 * deg, 0.5, spin) / (5.0 / 7.0 * 9.8 * std::sin(15 * deg)), 1, 1e-3);
  EXPECT_NEAR(spin / (5.0 / 7.0 * 9.8 * std::sin(15 * deg)), 1, 2e-3);
  EXPECT_NEAR(speed_after(30 * deg, 0.1, spin) / (9.8 * (0.5 - 0.1 * std::cos(30 * deg))), 1, 1e-3);
  EXPECT_NEAR(spin / (2.5 * 0.1 * 9.8 * std::cos(30 * deg)), 1, 2e-3);
}

// A block stays below the angle of friction and slides above it.
TEST(Incline, BlockSticksOrSlides) {
  const auto speed_after = [](double slope, double mu) {
    const double th = std::atan(slope);
    Scene s;
    s.gravity = {9.8 * std::sin(th), 0, -9.8 * std::cos(th)};
    s.materials = {scenes::material("m", 5e6, 2500, 0.3, mu)};
    s.shapes = {scenes::box("block", {0.03, 0.02, 0.006})};
    s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
    s.run.steps = 1;
    s.run.dt_fraction = 0.3;
    s.bodies = {scenes::body("block", "m", {0, 0, 0.003})};
    World w = build_world(s);
    while (w.time() < 0.25) advance(w, 1);
    const double v = w.particles.motion[0].velocity.x;
    while (w.time() < 0.5) advance(w, 1);
    return std::pair((w.particles.motion[0].velocity.x - v) / 0.25, v);
  };
  const auto stuck = speed_after(0.35, 0.4), slides = speed_after(0.5, 0.4);
  EXPECT_LT(std::abs(stuck.second), 1e-6);
  EXPECT_LT(std::abs(stuck.first), 1e-6);
  const double th = std::atan(0.5);
  EXPECT_NEAR(slides.first / (9.8 * (std::sin(th) - 0.4 * std::cos(th))), 1, 5e-3);
}

}  // namespace
}  // namespace dem
