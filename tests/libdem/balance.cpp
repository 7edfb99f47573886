// Books of a run: momentum against the impulse of external forces, mass, counts; energy of an undamped, frictionless
// run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

// |p − p0 − ∫F dt + what left| relative to the sum of the sizes of what is added.
double momentum_error(const World& w) {
  const Vec3d p = momentum(w);
  double error = 0, size = 0;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Balance& b = w.balance;
    const double d = (p[k] - b.initial_momentum[i]) + b.removed_momentum[i].value() - b.impulse[i].value();
    error += d * d;
    size = std::max({size, std::abs(p[k]), std::abs(b.initial_momentum[i]), std::abs(b.impulse[i].value()),
                     std::abs(b.removed_momentum[i].value())});
  }
  return std::sqrt(error) / size;
}

TEST(Balance, MomentumMassAndCountsWithAnOutlet) {
  Scene s = scenes::every_shape(250);
  OutletSpec out;
  out.name = "drain";
  out.point = {0, 0, 0.02};
  out.normal = {0, 0, 1};
  s.outlets = {out};
  OutletSpec side = out;
  side.name = "side";
  side.point = {0.03, 0, 0};
  side.normal = {-1, 0, 0.25};
  s.outlets.push_back(side);
  World w = build_world(s);
  double worst = 0;
  for (int i = 0; i < 700; ++i) {
    advance(w, 1);
    worst = std::max(worst, momentum_error(w));
    ASSERT_EQ(w.particles.count() + w.counters.deleted, 250u);
  }
  std::printf("  momentum balance to %.1e; %llu of 250 bodies left by the outlets\n", worst,
              static_cast<unsigned long long>(w.counters.deleted));
  EXPECT_LT(worst, 1e-10);
  EXPECT_GT(w.counters.deleted, 20u);
  EXPECT_GT(w.particles.count(), 20u);
  EXPECT_GT(w.outlets[0].count, 0u);
  EXPECT_GT(w.outlets[1].count, 0u);
  EXPECT_EQ(w.outlets[0].count + w.outlets[1].count, w.counters.deleted);
  EXPECT_EQ(w.discharge.size(), w.counters.deleted);
  EXPECT_EQ(w.discharge.back().count, w.counters.deleted);
  double present = 0;
  for (const std::uint32_t i : order_by_id(w)) present += w.particles.mass[i];
  EXPECT_NEAR(w.balance.present.value() / present, 1, 1e-15);
  EXPECT_NEAR((present + w.balance.removed_mass) / w.balance.initial_mass, 1, 1e-14);
  EXPECT_NEAR((w.outlets[0].mass + w.outlets[1].mass) / w.balance.removed_mass, 1, 1e-14);
  EXPECT_EQ(w.discharge.back().mass, w.balance.removed_mass);
}

// A body leaves at the step at which its centre is behind the plane; others keep their ids.
TEST(Outlet, TakesWhatIsBehindItAndNothingElse) {
  Scene s;
  s.materials = {scenes::material("m", 5e6, 1000, 1, 0)};
  s.shapes = {scenes::sphere("ball", 0.01)};
  s.run.dt_auto = false;
  s.run.dt = 0x1p-10;
  s.run.steps = 1;
  for (int i = 0; i < 5; ++i) s.bodies.push_back(scenes::body("ball", "m", {0.05 * i, 0, 1}, {0, 0, -1.0 - i}));
  OutletSpec out;
  out.name = "floor";
  out.normal = {0, 0, 1};
  s.outlets = {out};
  World w = build_world(s);
  for (std::uint64_t left = 1; left <= 3; ++left) {  // the fastest first: id 4 at 1/5 s, id 3 at 1/4 s, id 2 at 1/3 s
    while (w.counters.deleted < left) advance(w, 1);
    const double fall = 1.0 / static_cast<double>(6 - left);
    EXPECT_GT(w.time(), fall);
    EXPECT_LE(w.time(), fall + w.time_step.dt * (1 + 1e-12));
    for (const std::uint64_t id : w.particles.id) EXPECT_LT(id, 5 - left);
    EXPECT_EQ(w.particles.count(), 5 - left);
  }
  EXPECT_EQ(w.next_id, 5u);
}

// Spheres in a box of planes, e = 1, no friction: the largest swing of the energy falls with dt².
double energy_error(LawName law, double fraction) {
  Scene s;
  s.law.name = law;
  s.gravity = {0, 0, -9.81};
  s.materials = {scenes::material("m", 5e6, 2500, 1, 0)};
  s.materials[0].stiffness = 5e3;
  s.shapes = {scenes::sphere("ball", 0.005)};
  s.walls = {scenes::plane("bottom", "m", {0, 0, 0}, {0, 0, 1}), scenes::plane("top", "m", {0, 0, 0.04}, {0, 0, -1}),
             scenes::plane("west", "m", {0, 0, 0}, {1, 0, 0}),   scenes::plane("east", "m", {0.04, 0, 0}, {-1, 0, 0}),
             scenes::plane("south", "m", {0, 0, 0}, {0, 1, 0}),  scenes::plane("north", "m", {0, 0.04, 0}, {0, -1, 0})};
  for (int i = 0; i < 27; ++i) {
    Random r(3, 0, static_cast<std::uint64_t>(i));
    s.bodies.push_back(scenes::body("ball", "m",
                                    {0.008 + 0.012 * (i % 3), 0.008 + 0.012 * (i / 3 % 3), 0.008 + 0.012 * (i / 9)},
                                    {r.uniform(-1, 1), r.uniform(-1, 1), r.uniform(-1, 1)}));
  }
  s.run.steps = 1;
  s.run.dt_fraction = fraction;
  World w = build_world(s);
  const auto total = [](const Energies& e) { return e.translational + e.rotational + e.potential + e.elastic; };
  const Energies start = energies(w);
  double worst = 0, contacts = 0;
  while (w.time() < 0.004) {
    advance(w, 1);
    worst = std::max(worst, std::abs(total(energies(w)) - total(start)) / start.translational);
    contacts += static_cast<double>(touching_contacts(w).size());
  }
  EXPECT_GT(contacts, 100);
  return worst;
}

TEST(Balance, EnergyOfAnUndampedRunHoldsAtSecondOrder) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin}) {
    const double error[] = {energy_error(law, 0.1), energy_error(law, 0.05), energy_error(law, 0.025)};
    std::printf("  energy error %.2e %.2e %.2e of the kinetic energy, orders %.2f %.2f\n", error[0], error[1], error[2],
                std::log2(error[0] / error[1]), std::log2(error[1] / error[2]));
    EXPECT_LT(error[0], 0.01);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.4);
    EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.4);
  }
}

}  // namespace
}  // namespace dem
