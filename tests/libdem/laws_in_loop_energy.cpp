// Energy under every law. Two bodies that meet obliquely: kinetic + stored + lost stays what it was, to second order in
// the step. Balls stirred in a box: the same at the automatic step; and what forces and torques do to their motion is
// their work, to rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

using law_loop::Meeting;
using law_loop::Shape;

// The largest |KE + stored + lost − E0|/E0 at the ends of steps, until the bodies have parted or for some time.
double energy_error(const LawSpec& law, Shape shape, bool wall, double fraction, double phase) {
  Meeting m(law, law_loop::material(), shape, wall);
  Scene& s = m.scene;
  s.law.ledger = true;
  s.run.dt_fraction = fraction;
  const double speed = 0.1, time = m.duration(speed);
  for (BodySpec& b : s.bodies) {
    const double up = b.position.z > 0 ? 1 : -1;
    b.velocity += Vec3d{0.5 * up * speed, 0.2 * up * speed, 0};
    b.spin = Vec3d{0.1, up * 0.3, 0.2} * (speed / law_loop::radius);
    if (shape != Shape::sphere) b.orientation = scenes::turn({0.6, 0.8, 0}, 0.4 * up) * b.orientation;
  }
  const double dt = build_world(s).time_step.dt;
  m.approach(speed, 0.3 * time + phase * dt);
  World w = build_world(s);
  const auto total = [&] {
    double sum = 0;
    for (const double lost : dissipated(w)) sum += lost;
    const Energies e = energies(w);
    return e.translational + e.rotational + e.elastic + sum;
  };
  const double start = total();
  double worst = 0;
  bool met = false;
  while (w.time() < 12 * time) {
    advance(w, 1);
    worst = std::max(worst, std::abs(total() - start) / start);
    const bool touching = !touching_contacts(w).empty();
    if (met && !touching) break;
    met = met || touching;
  }
  EXPECT_TRUE(met);
  return worst;
}

class LawEnergy : public testing::TestWithParam<std::tuple<std::size_t, int, bool>> {};

TEST_P(LawEnergy, IsKeptAtSecondOrder) {
  const auto& [law, shape, wall] = GetParam();
  const auto error = [&](double fraction) {
    double worst = 0;
    for (int k = 0; k < 6; ++k)
      worst = std::max(
          worst, energy_error(law_loop::every_law()[law], static_cast<Shape>(shape), wall, fraction, (k + 0.5) / 6));
    return worst;
  };
  const double e[] = {error(0.1), error(0.05), error(0.025), error(0.0125)};
  std::printf("  %.2e %.2e %.2e %.2e, orders %.2f %.2f %.2f\n", e[0], e[1], e[2], e[3], std::log2(e[0] / e[1]),
              std::log2(e[1] / e[2]), std::log2(e[2] / e[3]));
  EXPECT_LE(e[0], 5e-3);
  EXPECT_GE(std::log2(e[0] / e[3]) / 3, 1.7);
}

// Balls on a lattice in a box of planes, thrown about.
Scene balls(const LawSpec& law) {
  Scene s;
  s.law = law;
  s.law.ledger = true;
  s.gravity = {0, 1, -9.81};
  s.materials = {law_loop::material()};
  const double r = law_loop::radius, pitch = 2.1 * r, far = 3 * pitch;
  s.shapes = {scenes::sphere("ball", r)};
  s.walls = {scenes::plane("west", "m", {0, 0, 0}, {1, 0, 0}),   scenes::plane("east", "m", {far, 0, 0}, {-1, 0, 0}),
             scenes::plane("south", "m", {0, 0, 0}, {0, 1, 0}),  scenes::plane("north", "m", {0, far, 0}, {0, -1, 0}),
             scenes::plane("bottom", "m", {0, 0, 0}, {0, 0, 1}), scenes::plane("top", "m", {0, 0, far}, {0, 0, -1})};
  for (int i = 0; i < 27; ++i) {
    Random random(5, 0, static_cast<std::uint64_t>(i));
    const auto any = [&](double most) {
      const double x = random.uniform(-most, most), y = random.uniform(-most, most), z = random.uniform(-most, most);
      return Vec3d{x, y, z};
    };
    const Vec3d at{(i % 3 + 0.5) * pitch, (i / 3 % 3 + 0.5) * pitch, (i / 9 + 0.5) * pitch}, speed = any(0.4);
    s.bodies.push_back(scenes::body("ball", "m", at, speed, any(100)));
  }
  s.run.steps = 1;
  return s;
}

class LawBalance : public testing::TestWithParam<std::size_t> {};

TEST_P(LawBalance, OfStirredBalls) {
  World w = build_world(balls(law_loop::every_law()[GetParam()]));
  const auto total = [&] {
    double sum = 0;
    for (const double lost : dissipated(w)) sum += lost;
    const Energies e = energies(w);
    return e.translational + e.rotational + e.potential + e.elastic + sum;
  };
  const double start = total(), dt = w.time_step.dt, kinetic = energies(w).translational;
  double worst = 0, work = 0, largest = kinetic + energies(w).rotational, before = largest, off = 0;
  for (int i = 0; i < 400; ++i) {
    // Each of the two kicks of a step does F · v̄ dt/2, v̄ the mean of the speeds before and after it.
    const Particles old = w.particles;
    advance(w, 1);
    ASSERT_EQ(old.id, w.particles.id);
    for (std::size_t k = 0; k < old.count(); ++k) {
      const Vec3d weight = w.scene.gravity * old.mass[k];
      const Vec3d speed = old.motion[k].velocity + (old.force[k] + weight) * (0.5 * dt / old.mass[k]);
      const Vec3d spin = (old.angular_momentum[k] + old.torque[k] * (0.5 * dt)) * (1 / old.inertia[k].x);
      const Motion& m = w.particles.motion[k];
      work += 0.25 * dt *
              (dot(old.force[k] + weight, old.motion[k].velocity + speed) +
               dot(w.particles.force[k] + weight, speed + m.velocity) + dot(old.torque[k], old.motion[k].spin + spin) +
               dot(w.particles.torque[k], spin + m.spin));
    }
    const Energies e = energies(w);
    const double now = e.translational + e.rotational;
    largest = std::max(largest, now);
    off = std::max(off, std::abs(now - before - work));
    worst = std::max(worst, std::abs(total() - start) / kinetic);
  }
  std::printf("  energy %.1e, work %.1e; %llu contact steps\n", worst, off / largest,
              static_cast<unsigned long long>(w.counters.contact_steps));
  EXPECT_GT(w.counters.contact_steps, 1000u);
  EXPECT_LE(worst, 5e-3);
  EXPECT_LE(off, 1e-12 * largest);
}

INSTANTIATE_TEST_SUITE_P(Every, LawBalance, testing::Range(std::size_t(0), law_loop::every_law().size()),
                         [](const auto& p) { return law_loop::test_name(law_loop::every_law()[p.param]); });

std::string name_of(const testing::TestParamInfo<std::tuple<std::size_t, int, bool>>& p) {
  const auto& [law, shape, wall] = p.param;
  return law_loop::test_name(law_loop::every_law()[law]) + "_" + law_loop::shape_names[shape] +
         (wall ? "_on_a_plane" : "_pair");
}

INSTANTIATE_TEST_SUITE_P(Every, LawEnergy,
                         testing::Combine(testing::Range(std::size_t(0), law_loop::every_law().size()),
                                          testing::Range(0, 2), testing::Bool()),
                         name_of);

}  // namespace
}  // namespace dem
