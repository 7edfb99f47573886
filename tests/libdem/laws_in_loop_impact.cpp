// Head-on impacts of every law in the loop, of spheres, ellipsoids and boxes on each other and on a plane: the
// restitution that closed forms give, or that the bodies stick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <tuple>

#include "libcontact/laws/mix.h"
#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

using law_loop::Meeting;
using law_loop::Shape;

constexpr double pi = std::numbers::pi;

struct Rebound {
  double restitution = 0;
  bool parted = false;
};

// Until they part, or for `patience` times the duration of the elastic contact.
Rebound impact(Meeting m, double speed, int steps_per_contact, double patience) {
  m.scene.run.dt_auto = false;
  m.scene.run.dt = m.duration(speed) / steps_per_contact;
  m.approach(speed, 1.3 * m.scene.run.dt);
  World w = build_world(m.scene);
  bool met = false;
  for (int i = 0; i < patience * steps_per_contact; ++i) {
    advance(w, 1);
    const bool touching = !touching_contacts(w).empty();
    if (met && !touching) return {m.speed(w) / speed, true};
    met = met || touching;
  }
  EXPECT_TRUE(met);
  return {};
}

// Simpson's rule.
double integral(const std::function<double(double)>& f, double to) {
  constexpr int n = 2000;
  double sum = f(0) + f(to);
  for (int i = 1; i < n; ++i) sum += (i % 2 != 0 ? 4 : 2) * f(to * i / n);
  return sum * to / (3 * n);
}

// What a bridge costs: its published force from touch to rupture.
double bridge_work(const Meeting& m, bool willett) {
  const LawSpec& l = m.scene.law;
  const double angle = m.scene.materials[0].contact_angle, r = 2 * m.radius_eff, v = l.bridge_volume;
  const double most = 2 * pi * r * l.surface_tension * std::cos(angle), end = (1 + angle / 2) * std::cbrt(v);
  const auto force = [&](double h) {
    const double s = h * std::sqrt(r / v);
    return willett ? most / (1 + 1.05 * s + 2.5 * s * s) : most * (1 - 1 / std::sqrt(1 + 2 * v / (pi * r * h * h)));
  };
  return integral([&](double h) { return h > 0 ? force(h) : most; }, end);
}

// The work that sticky bodies lose to part again, of JKR.
double jkr_work(const Meeting& m) {
  const double w = m.pair.work_of_adhesion;
  return 7.092196 * std::cbrt(std::pow(w, 5) * std::pow(m.radius_eff, 4) / (m.pair.young_eff * m.pair.young_eff));
}

double yield_speed(const Meeting& m) {
  const double r = m.radius_eff;
  return std::pow(pi / (2 * m.pair.young_eff), 2) * std::sqrt(8 * pi * r * r * r / (15 * m.mass_eff)) *
         std::pow(m.pair.yield_pressure, 2.5);
}

// Restitution of the normal law by itself; nothing where no closed form is known.
std::optional<double> of_normal_law(const Meeting& m, double speed) {
  const contact::PairParameters& p = m.pair;
  const std::string law = law_names(m.scene.law).normal;
  if (law == "linear" || law == "hertz" || law == "latching_spring") return p.restitution;
  if (law == "viscoelastic_hertz") {
    const double rho = 4.0 / 3 * p.young_eff * std::sqrt(m.radius_eff);
    const double x = 1.5 * p.viscous_time * std::pow(rho / m.mass_eff, 0.4) * std::pow(speed, 0.2);
    return 1 - 1.15345 * x + 0.79826 * x * x - 0.4835 * x * x * x;
  }
  if (law == "adhesive_plastic_spring" && p.restitution == 1) {
    const double k1 = p.stiffness_n, kc = p.adhesive_stiffness;
    const double most = p.plastic_stiffness / (p.plastic_stiffness - k1) * p.plastic_depth * 2 * m.radius_eff;
    const double k2 = k1 + (p.plastic_stiffness - k1) * speed * std::sqrt(m.mass_eff / k1) / most;
    return std::sqrt(std::max(k1 / k2 - kc / k1 * (k2 - k1) * (k2 - k1) / (k2 * (k2 + kc)), 0.0));
  }
  if (law == "thornton_ning") {
    const double y = std::min(yield_speed(m) / speed, 1.0);
    return std::sqrt(6 * std::sqrt(3.0) / 5 * (1 - y * y / 6)) *
           std::pow(y / (y + 2 * std::sqrt(1.2 - 0.2 * y * y)), 0.25);
  }
  if (law == "jkr" && p.restitution == 1)
    return std::sqrt(std::max(1 - 2 * jkr_work(m) / (m.mass_eff * speed * speed), 0.0));
  return {};
}

// With what the bridge costs; a pull that is a potential's costs an elastic contact nothing.
std::optional<double> expected(const Meeting& m, double speed) {
  const contact::LawNames law = law_names(m.scene.law);
  const std::optional<double> e = of_normal_law(m, speed);
  if (law.cohesion == "none") return e;
  if (m.pair.restitution < 1 || (law.normal != "hertz" && law.normal != "linear")) return {};
  if (!law.cohesion.starts_with("liquid_bridge")) return e;
  const double lost = bridge_work(m, law.cohesion == "liquid_bridge");
  return std::sqrt(std::max(*e * *e - 2 * lost / (m.mass_eff * speed * speed), 0.0));
}

class Impact : public testing::TestWithParam<std::tuple<std::size_t, int, bool>> {
 protected:
  LawSpec law() const { return law_loop::every_law()[std::get<0>(GetParam())]; }
  Meeting meeting(double restitution) const {
    MaterialSpec m = law_loop::material();
    m.restitution = restitution;
    return Meeting(law(), m, static_cast<Shape>(std::get<1>(GetParam())), std::get<2>(GetParam()));
  }
};

class LawRestitution : public Impact {};
class SlowImpact : public Impact {};

TEST_P(LawRestitution, IsThatOfTheClosedForms) {
  const bool jumps = law_names(law()).cohesion != "none";  // a pull that sets in and ends within a step
  for (const double e : {1.0, law_loop::restitution})
    for (const double speed : {0.05, 0.2}) {
      const Meeting m = meeting(e);
      const Rebound r = impact(m, speed, 250, 40);
      const std::optional<double> wanted = expected(m, speed);
      std::printf("  e = %.1f, %.2f m/s: %.5f, expected %s\n", e, speed, r.restitution,
                  wanted ? std::to_string(*wanted).c_str() : "no more than 1");
      EXPECT_LE(r.restitution, 1 + (jumps ? 1e-3 : 1e-5));
      if (!wanted) continue;
      EXPECT_NEAR(r.restitution, *wanted, 2e-3);
      EXPECT_EQ(r.parted, *wanted > 0);
    }
}

// Slower than what parting costs, sticky bodies stay; a little faster they do not.
TEST_P(SlowImpact, SticksWhereItIsSlowerThanItsBond) {
  const Meeting m = meeting(1);
  const auto faster_than_the_bond = [&](double speed) { return expected(m, speed).value_or(0) > 0; };
  ASSERT_TRUE(faster_than_the_bond(1));
  double low = 0, high = 1;
  while (high - low > 1e-6 * high) (faster_than_the_bond(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  EXPECT_FALSE(impact(m, 0.985 * high, 400, 40).parted);
  EXPECT_TRUE(impact(m, 1.015 * high, 400, 40).parted);
  std::printf("  sticks below %.4g m/s\n", high);
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::size_t, int, bool>>& p) {
  const auto& [law, shape, wall] = p.param;
  return law_loop::test_name(law_loop::every_law()[law]) + "_" + law_loop::shape_names[shape] +
         (wall ? "_on_a_plane" : "_pair");
}

// Those whose sticking speed has a closed form.
std::vector<std::size_t> sticking() {
  std::vector<std::size_t> all;
  for (const std::size_t i : law_loop::laws_that_hold_on()) {
    MaterialSpec m = law_loop::material();
    m.restitution = 1;
    if (expected(Meeting(law_loop::every_law()[i], m, Shape::sphere, false), 1)) all.push_back(i);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(EveryLaw, LawRestitution,
                         testing::Combine(testing::Range(std::size_t(0), law_loop::every_law().size()),
                                          testing::Range(0, 3), testing::Bool()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(EveryLaw, SlowImpact,
                         testing::Combine(testing::ValuesIn(sticking()), testing::Range(0, 3), testing::Bool()),
                         name_of);

}  // namespace
}  // namespace dem
