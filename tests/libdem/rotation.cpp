// Torque-free rotation of an asymmetric body through the loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

// An ellipsoid 1:2:3 alone in space. Its moments: I = m/5 (b² + c², a² + c², a² + b²) = m/5 (13, 10, 5) l².
World spinning(const Vec3d& spin, double dt, const Quatd& orientation) {
  Scene s;
  s.materials = {scenes::material("m", 5e6, 1000, 1, 0)};
  s.shapes = {scenes::ellipsoid("stone", {0.01, 0.02, 0.03})};
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.run.steps = 1;
  s.bodies = {scenes::body("stone", "m", {1, 2, 3}, {}, rotate(orientation, spin), orientation)};
  return build_world(s);
}

Vec3d body_spin(const World& w) {
  return shapes::transposed_times(shapes::rotation_matrix(w.particles.orientation[0]), w.particles.motion[0].spin);
}
// R I Rᵀ ω of what output sees.
Vec3d momentum_of_motion(const World& w) {
  return rotate(w.particles.orientation[0], scaled(w.particles.inertia[0], body_spin(w)));
}

const Quatd tilted = scenes::turn(shapes::normalized(Vec3d{1, -2, 0.5}), 0.7);

TEST(Rotation, AngularMomentumIsKeptOver100000Steps) {
  World w = spinning({3, 5, 2}, 1e-3, tilted);
  const Vec3d before = momentum_of_motion(w);
  double worst = 0, worst_vector = 0;
  for (int i = 0; i < 100000; ++i) {
    advance(w, 1);
    const Vec3d now = momentum_of_motion(w);
    worst = std::max(worst, std::abs(scenes::length(now) / scenes::length(before) - 1));
    worst_vector = std::max(worst_vector, scenes::length(now - before) / scenes::length(before));
  }
  std::printf("  10^5 steps: | |L|/|L0| − 1 | <= %.1e, |L − L0|/|L0| <= %.1e\n", worst, worst_vector);
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_vector, 1e-12);
  EXPECT_NEAR(shapes::dot(w.particles.motion[0].position, Vec3d{1, 2, 3}), 14, 1e-13);
}

struct Band {
  double width, first_tenth, last_tenth;  // relative to the energy at the start
};

Band energy_band(double dt) {
  World w = spinning({3, 5, 2}, dt, tilted);
  const double before = energies(w).rotational;
  const int steps = static_cast<int>(100 / dt);
  Band b{0, 0, 0};
  double low = 0, high = 0;
  for (int i = 0; i < steps; ++i) {
    advance(w, 1);
    const double e = energies(w).rotational / before - 1;
    low = std::min(low, e);
    high = std::max(high, e);
    if (i < steps / 10) b.first_tenth += e / (steps / 10);
    if (i >= steps - steps / 10) b.last_tenth += e / (steps / 10);
  }
  b.width = high - low;
  return b;
}

TEST(Rotation, EnergyStaysInABandOfSecondOrderWithoutDrift) {
  Band band[3];
  std::printf("  h        band of energy   first tenth   last tenth\n");
  for (int i = 0; i < 3; ++i) {
    const double h = 0.01 / (1 << i);
    band[i] = energy_band(h);
    std::printf("  %.4f s  %.3e        %+.3e    %+.3e\n", h, band[i].width, band[i].first_tenth, band[i].last_tenth);
    EXPECT_LT(std::abs(band[i].last_tenth - band[i].first_tenth), 0.02 * band[i].width);
  }
  std::printf("  orders %.3f %.3f\n", std::log2(band[0].width / band[1].width),
              std::log2(band[1].width / band[2].width));
  EXPECT_NEAR(std::log2(band[0].width / band[1].width), 2, 0.05);
  EXPECT_NEAR(std::log2(band[1].width / band[2].width), 2, 0.05);
}

// Complete elliptic integral of the first kind, parameter m = k², through 1 − m: K = π/(2 agm(1, sqrt(1 − m))).
double elliptic_k(double complement) {
  double a = 1, b = std::sqrt(complement);
  for (int i = 0; i < 60; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return M_PI / (2 * a);
}

// Time between sign changes of the spin about the intermediate axis: 2 K(m)/λ. Euler's equations give
//   dω2/dt ∝ sqrt((1 − p ω2²)(1 − q ω2²)), hence λ² the larger and m λ² the smaller of
//   (I2 − I3)(2 E I1 − L²)/(I1 I2 I3)  and  (I1 − I2)(L² − 2 E I3)/(I1 I2 I3).
double exact_flip(const Vec3d& inertia, const Vec3d& spin) {
  const double l2 = dot(scaled(inertia, spin), scaled(inertia, spin)), e2 = dot(scaled(inertia, spin), spin);
  const auto& [i1, i2, i3] = inertia;
  const double one = (i2 - i3) * (e2 * i1 - l2) / (i1 * i2 * i3), two = (i1 - i2) * (l2 - e2 * i3) / (i1 * i2 * i3);
  const double slow = std::min(one, two), fast = std::max(one, two);
  return 2 * elliptic_k(1 - slow / fast) / std::sqrt(fast);
}

// Mean time between sign changes over `flips` flips, each placed by linear interpolation between steps.
double measured_flip(double dt, const Vec3d& spin, int flips) {
  World w = spinning(spin, dt, tilted);
  double before = body_spin(w).y, first = -1, last = 0;
  int seen = 0;
  while (seen <= flips) {
    const double t = w.time();
    advance(w, 1);
    const double now = body_spin(w).y;
    if ((now < 0) != (before < 0)) {
      last = t + dt * before / (before - now);
      if (seen == 0) first = last;
      ++seen;
    }
    before = now;
  }
  return (last - first) / flips;
}

TEST(Rotation, FlipPeriodOfTheIntermediateAxisConvergesAtSecondOrder) {
  const Vec3d spin{0.05, 5, 0.02};
  const World w = spinning(spin, 1e-3, tilted);
  const double exact = exact_flip(w.particles.inertia[0], spin);
  double error[3];
  std::printf("  exact flip time %.9f s\n", exact);
  for (int i = 0; i < 3; ++i) {
    const double h = 0.01 / (1 << i);
    error[i] = std::abs(measured_flip(h, spin, 8) / exact - 1);
    std::printf("  h %.4f s: relative error %.3e\n", h, error[i]);
  }
  std::printf("  orders %.3f %.3f\n", std::log2(error[0] / error[1]), std::log2(error[1] / error[2]));
  EXPECT_LT(error[2], 1e-3);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.1);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.1);
}

}  // namespace
}  // namespace dem
