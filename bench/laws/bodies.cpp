// Balls on a plane and on each other, through the loop of libdem: a stack, an incline, slip that turns into rolling,
// resistance to rolling and spin; terminal velocity. The set-ups of MFIX, MercuryDPM, Chrono and LAMMPS (the sheet, 4.5
// and 4.6); expected: closed forms of rigid bodies, met to the order of overlap over radius.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/laws/digits.h"
#include "bench/laws/report.h"
#include "libdem/build.h"
#include "libdem/fields/drag.h"
#include "libdem/world.h"
#include "tests/libdem/scenes_in_code.h"

namespace laws {
namespace {

using dem::Scene;
using dem::World;
using shapes::Vec3d;

struct Ground {
  double radius, young, friction, rolling = 0, twisting = 0;
  std::string law{};  // rolling law
  Vec3d gravity{0, 0, -9.81};
  double restitution = 0.5, density = 2500;
};

// A ball at rest in its own dent, on a rigid floor, then given speed and spin.
Scene on_floor(const Ground& g, const Vec3d& velocity, const Vec3d& spin) {
  Scene s;
  s.gravity = g.gravity;
  s.law.rolling = g.law;
  dem::MaterialSpec m = dem::scenes::material("m", g.young, g.density, g.restitution, g.friction);
  m.rolling_friction = g.rolling;
  m.twisting_friction = g.twisting;
  dem::MaterialSpec floor = m;
  floor.name = "floor";
  floor.rigid = true;
  s.materials = {m, floor};
  s.shapes = {dem::scenes::sphere("ball", g.radius)};
  const double mass = g.density * 4.0 / 3 * std::numbers::pi * std::pow(g.radius, 3);
  const double young_eff = g.young / (1 - 0.3 * 0.3);
  const double dent = std::pow(-mass * g.gravity.z / (4.0 / 3 * young_eff * std::sqrt(g.radius)), 2.0 / 3);
  s.bodies = {dem::scenes::body("ball", "m", {0, 0, g.radius - dent}, velocity, spin)};
  s.walls = {dem::scenes::plane("floor", "floor", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 1;
  s.run.dt_overlap = 1e-4;  // these press little
  return s;
}

// The ball after `time` s.
World after(const Scene& s, double time) {
  World w = dem::build_world(s);
  const auto steps = static_cast<std::uint64_t>(std::ceil(time / w.time_step.dt));
  w.time_step.dt = time / static_cast<double>(steps);
  for (std::uint64_t i = 0; i < steps; ++i) dem::advance(w, 1);
  return w;
}

void stack(Report& r) {
  r.heading("five balls of 5 mm on each other on a rigid floor, E 7e7 Pa, ν 0.25, ρ 2500, at rest after 0.3 s");
  const double radius = 5e-3, young = 7e7, nu = 0.25, density = 2500, gravity = 9.81;
  Scene s;
  s.gravity = {0, 0, -gravity};
  dem::MaterialSpec m = dem::scenes::material("m", young, density, 0.5, 0);
  m.poisson = nu;
  dem::MaterialSpec floor = m;
  floor.name = "floor";
  floor.rigid = true;
  s.materials = {m, floor};
  s.shapes = {dem::scenes::sphere("ball", radius)};
  s.walls = {dem::scenes::plane("floor", "floor", {0, 0, 0}, {0, 0, 1})};
  for (int i = 0; i < 5; ++i) s.bodies.push_back(dem::scenes::body("ball", "m", {0, 0, radius * (2 * i + 1)}));
  s.run.steps = 1;
  s.run.dt_overlap = 1e-3;
  const World w = after(s, 0.3);
  const double stated[] = {4.36534e-6, 7.52387e-6, 6.21082e-6, 4.73974e-6, 2.98585e-6};
  const Digits R = radius, mass = Digits(density) * 4 / 3 * pi() * R * R * R, e = Digits(young) / (1 - Digits(nu) * nu);
  double below = 0;
  for (int i = 0; i < 5; ++i) {
    const bool lowest = i == 0;
    const Digits force = (5 - i) * mass * Digits(gravity);
    const Digits base = force * 3 / (4 * (lowest ? e : e / 2) * sqrt(lowest ? R : R / 2));
    const double expected = as_double(pow(base, Digits(2) / 3)),
                 z = w.particles.motion[static_cast<std::size_t>(i)].position.z;
    r.close(fmt::format("overlap {} (m)", lowest ? "on the floor" : fmt::format("below ball {}", i + 1)), expected,
            (lowest ? radius : 2 * radius) - (z - below), 1e-6);
    r.close("  published digits (m)", stated[i], expected, 2e-6);
    below = z;
  }
}

Vec3d tilted(double angle, double g) { return {g * std::sin(angle), 0, -g * std::cos(angle)}; }

void inclines(Report& r) {
  r.heading("an incline, from rest: rolling a = (5/7) g sin; sliding a = g (sin − μ cos), α R = (5/2) μ g cos");
  const double degree = std::numbers::pi / 180;
  {
    const double g = 9.8, angle = 15 * degree;
    const World w = after(on_floor({5e-3, 1e8, 0.5, 0, 0, "", tilted(angle, g)}, {}, {}), 1);
    r.close("15 degrees, rolls: speed after 1 s (m/s)", 5.0 / 7 * g * std::sin(angle), w.particles.motion[0].velocity.x,
            1e-4);
    r.near("  MercuryDPM's (m/s)", 1.81167, w.particles.motion[0].velocity.x, 2e-4);
  }
  {
    const double g = 9.81, angle = 30 * degree, mu = 0.1;
    const World w = after(on_floor({5e-3, 1e8, mu, 0, 0, "", tilted(angle, g)}, {}, {}), 0.5);
    r.close("30 degrees, μ 0.1, slides: speed after 0.5 s (m/s)", 0.5 * g * (std::sin(angle) - mu * std::cos(angle)),
            w.particles.motion[0].velocity.x, 1e-4);
    r.close("  R ω after 0.5 s (m/s)", 0.5 * 2.5 * mu * g * std::cos(angle), w.particles.motion[0].spin.y * 5e-3, 1e-3);
  }
  for (const char* law : {"constant", "viscous", "spring"}) {
    if (std::string(law) == "viscous") continue;
    const double g = 9.81, angle = 15 * degree, rolling = 0.1;
    const World w = after(on_floor({5e-3, 1e8, 0.5, rolling, 0, law, tilted(angle, g)}, {}, {}), 0.5);
    r.close(fmt::format("15 degrees, rolling friction 0.1 ({}): speed after 0.5 s (m/s)", law),
            0.5 * 5.0 / 7 * g * (std::sin(angle) - rolling * std::cos(angle)), w.particles.motion[0].velocity.x, 2e-3);
    const World held = after(on_floor({5e-3, 1e8, 0.5, 0.3, 0, law, tilted(angle, g)}, {}, {}), 0.5);
    if (std::string(law) == "spring")
      r.near(fmt::format("15 degrees, rolling friction 0.3 > tan ({}): stands still (m/s)", law), 0,
             held.particles.motion[0].velocity.x, 1e-5);
    else
      r.note(fmt::format("15 degrees, rolling friction 0.3 > tan ({}): creeps at (m/s)", law),
             held.particles.motion[0].velocity.x);
  }
}

void rolling(Report& r) {
  r.heading("slip that turns into rolling: v0 0.1 m/s, R 0.5 mm, μ 0.2");
  const double v0 = 0.1, radius = 5e-4, mu = 0.2, g = 9.81, slips = 2 * v0 / (7 * mu * g);
  const Ground small{radius, 1e7, mu};
  const World half = after(on_floor(small, {v0, 0, 0}, {}), 0.5 * slips);
  r.close("half-way through the slip: speed (m/s)", v0 - 0.5 * mu * g * slips, half.particles.motion[0].velocity.x,
          1e-3);
  const World late = after(on_floor(small, {v0, 0, 0}, {}), 1.5 * slips);
  r.close("rolling: speed 5/7 v0 (m/s)", 5.0 / 7 * v0, late.particles.motion[0].velocity.x, 1e-3);
  r.close("rolling: spin (rad/s)", 5.0 / 7 * v0 / radius, late.particles.motion[0].spin.y, 2e-3);
  r.close("way slipped and rolled (m)", 12 * v0 * v0 / (49 * mu * g) + 0.5 * slips * 5.0 / 7 * v0,
          late.particles.motion[0].position.x, 1e-3);

  r.heading("rolling friction 0.1 and a ball that rolls at 1 m/s, R 5 mm: stops after 0.713558 m and 1.427115 s");
  const double mu_r = 0.1;
  for (const char* law : {"constant", "spring"}) {
    const World w = after(on_floor({5e-3, 1e8, 0.5, mu_r, 0, law}, {1, 0, 0}, {0, 200, 0}), 0.7);
    r.close(fmt::format("{}: speed after 0.7 s (m/s)", law), 1 - 5.0 / 7 * mu_r * g * 0.7,
            w.particles.motion[0].velocity.x, 2e-3);
    const World end = after(on_floor({5e-3, 1e8, 0.5, mu_r, 0, law}, {1, 0, 0}, {0, 200, 0}), 1.6);
    r.close(fmt::format("{}: way until it stands (m)", law), 0.713558, end.particles.motion[0].position.x, 2e-3);
  }
  r.heading("spins: about y without friction ω = ω0 − (5 μ_r g/(2R)) t; about z ω = ω0 − (5 μ_tw g a/(2R²)) t");
  for (const char* law : {"constant", "spring"}) {
    const World w = after(on_floor({5e-3, 1e8, 0, mu_r, 0, law}, {}, {0, 100, 0}), 0.1);
    r.close(fmt::format("{}: spin about y after 0.1 s (rad/s)", law), 100 - 2.5 * mu_r * g / 5e-3 * 0.1,
            w.particles.motion[0].spin.y, 2e-3);
    const World t = after(on_floor({5e-3, 1e8, 0, 0, 0.5, law}, {}, {0, 0, 10}), 0.1);
    const double dent = 5e-3 - t.particles.motion[0].position.z, a = std::sqrt(5e-3 * dent);
    r.close(fmt::format("{}: spin about z after 0.1 s (rad/s)", law), 10 - 2.5 * 0.5 * g * a / 25e-6 * 0.1,
            t.particles.motion[0].spin.z, 2e-3);
  }
}

void falling(Report& r) {
  r.heading("terminal velocity of 100 µm, ρ 2000, in air (1.2 kg/m³, 1.8e-5 Pa s)");
  const double d = 1e-4, weight = (2000 - 1.2) * std::numbers::pi / 6 * d * d * d * 9.81;
  dem::Flow air;
  air.density = 1.2;
  air.viscosity = 1.8e-5;
  for (const auto& [name, expected] : {std::pair{"stokes", .605192}, std::pair{"schiller_naumann", .457536}}) {
    double low = 0, high = 10;
    while (high - low > 1e-12) {
      const double v = 0.5 * (low + high);
      (dem::drag(dem::find_drag_law(name)->law, air, d, {0, 0, v}).z < weight ? low : high) = v;
    }
    r.near(fmt::format("{} (m/s), published digits", name), expected, low, 6e-7);
  }
}

}  // namespace

void bodies(Report& r) {
  stack(r);
  inclines(r);
  rolling(r);
  falling(r);
}

}  // namespace laws
