// Energy of two bodies that meet obliquely, under every law: kinetic + stored + lost stays what it was, to second order
// in the step.
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
