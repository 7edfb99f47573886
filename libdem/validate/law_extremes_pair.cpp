// Cases of two balls: ratios of mass and size, fines on a large body.
#include <algorithm>

#include "libdem/validate/law_scenes.h"

namespace dem::validate {

namespace {

using Rows = std::vector<Row>;

// The small ball flies against the large one, which is at rest, far above the floor.
struct Impact {
  double e, momentum;      // rebound speed ratio; momentum that is lost, over the first
  double speed, expected;  // of the small one after, m/s
};
Impact impact(const std::string& law, double size_ratio, double density_ratio, double e) {
  const double speed = 0.1, large = size_ratio * Ball::radius, gap = 1e-4 * Ball::radius;
  World w = Case(law, true)
                .set("shape.large.radius", large)
                .set("material.large.density", density_ratio * Ball::density)
                .set("material.large.restitution", e)
                .set("material.small.restitution", e)
                .set("body[0].position", Vec3d{-(large + Ball::radius + gap), 0, 2 * large + 1})
                .set("body[0].velocity", Vec3d{speed, 0, 0})
                .set("body[1].position", Vec3d{0, 0, 2 * large + 1})
                .build();
  until_parted(w);
  const Vec3d a = motion_of(w, 0).velocity, b = motion_of(w, 1).velocity;
  const double ratio = density_ratio * size_ratio * size_ratio * size_ratio;
  return {(b.x - a.x) / speed, std::abs((a.x + ratio * b.x) / speed - 1), a.x, speed * (1 - e * ratio) / (1 + ratio)};
}

}  // namespace

std::vector<Row> mass_ratios(const std::string& law) {
  Rows rows;
  for (const double ratio : {1e-6, 1e6})
    for (const double e : {0.5, 1.0}) {
      const Impact i = impact(law, 1, ratio, e);
      const std::string of = fmt::format("mass ratio {:.0e}: ", ratio);
      rows.push_back(right(of + fmt::format("restitution {}", e), i.e, e, 2e-3));
      rows.push_back(right(of + "speed of the one that came", i.speed, i.expected, 2e-3, "m/s"));
      rows.push_back(at_most(of + "momentum, relative", i.momentum, 1e-9));
    }
  return rows;
}

std::vector<Row> size_ratios(const std::string& law) {
  Rows rows;
  for (const double ratio : {3.0, 10.0, 30.0, 100.0, 1e3, 1e6})
    rows.push_back(right(fmt::format("size ratio {}: restitution", ratio), impact(law, ratio, 1, 0.5).e, 0.5, 2e-3));
  return rows;
}

namespace {

// A large ball on the smooth floor, much heavier and stiffer, and a small one on its top or beside it, in touch.
Case on_top(const std::string& law, double ratio, double angle, double mu) {
  const double large = ratio * Ball::radius, mass_ratio = 1e3 * ratio * ratio * ratio, far = large + Ball::radius;
  Case c(law, true);
  c.set("world.gravity", Vec3d{0, 0, -earth})
      .set("run.dt_fraction", 0.2)
      .set("run.dt_overlap", 1e-3)
      .set("material.floor.friction", 0)
      .set("material.small.friction", mu)
      .set("material.large.friction", mu)
      .set("shape.large.radius", large)
      .set("material.large.density", 1e3 * Ball::density)
      .set("material.small.stiffness", 1e4 * Ball::mass * earth / Ball::radius)
      .set("material.large.stiffness", 1e5 * mass_ratio * Ball::mass * earth / Ball::radius)
      .set("material.small.young", 1e6 * Ball::mass * earth / (Ball::radius * Ball::radius))
      .set("material.large.young", 1e7 * mass_ratio * Ball::mass * earth / (Ball::radius * Ball::radius))
      .set("body[0].position", Vec3d{far * std::sin(angle), 0, large + far * std::cos(angle)})
      .set("body[0].velocity", Vec3d{})
      .set("body[1].position", Vec3d{0, 0, large});
  return c;
}

// The cosine, from the vertical, of where the small ball leaves the large one.
double leaves_at(const std::string& law, double ratio, double angle, double mu) {
  World w = on_top(law, ratio, angle, mu).build();
  const double free = 0.3 * std::sqrt(Ball::radius / earth);  // s, that it is off for good
  double cosine = 0, since = 0;
  while (w.time() - since < free && w.time() < 30 * std::sqrt(ratio * Ball::radius / earth)) {
    advance(w, 1);
    for (const ContactReport& c : touching_contacts(w)) {
      if (c.wall) continue;
      since = w.time();
      const Vec3d way = motion_of(w, 0).position - motion_of(w, 1).position;
      cosine = way.z / norm(way);
    }
  }
  return cosine;
}

}  // namespace

std::vector<Row> fines_on_a_large_body(const std::string& law) {
  Rows rows;
  const double angle = 0.3;
  for (const double ratio : {3.0, 10.0, 30.0, 100.0}) {
    const std::string of = fmt::format("fine on a ball {} times larger: ", ratio);
    // Without friction it leaves at cos = 2/3 of where it began; as it rolls, at 10/17.
    rows.push_back(right(of + "slides off at, cos", leaves_at(law, ratio, angle, 0), 2.0 / 3 * std::cos(angle), 1e-2));
    rows.push_back(
        right(of + "rolls off at, cos", leaves_at(law, ratio, angle, infinity), 10.0 / 17 * std::cos(angle), 1e-2));
    // On top it is carried along until it rolls: 2/7 of the speed below it, a force μ m g until then.
    const double speed = 0.1 * std::sqrt(earth * Ball::radius), mu = 0.3, slips = 2 * speed / (7 * mu * earth);
    World w = on_top(law, ratio, 0, mu).set("body[1].velocity", Vec3d{speed, 0, 0}).build();
    step_for(w, 0.5 * slips);
    rows.push_back(right(of + "speed while it slips", motion_of(w, 0).velocity.x / speed, 1.0 / 7, 2e-2));
    step_for(w, 0.75 * slips);
    rows.push_back(right(of + "speed as it rolls", motion_of(w, 0).velocity.x / speed, 2.0 / 7, 2e-2));
  }
  return rows;
}

// Two balls whose speed carries them beyond each other's middle, and two at one place.
std::vector<Row> through_each_other(const std::string& law) {
  const auto setting = [&](double distance) {
    return Case(law, true)
        .set("shape.large.radius", Ball::radius)
        .set("run.max_initial_overlap", 1)
        .set("material.small.restitution", 1)
        .set("material.large.restitution", 1)
        .set("body[0].position", Vec3d{-distance, 0, 1})
        .set("body[0].velocity", Vec3d{})
        .set("body[1].position", Vec3d{0, 0, 1});
  };
  const double stored = energies(setting(1.001 * Ball::radius).build()).elastic;  // at an overlap of the radius
  return {
      stops("beyond each other's middle",
            setting(2.01 * Ball::radius).set("body[0].velocity", Vec3d{std::sqrt(2 * 20 * stored / Ball::mass), 0, 0}),
            2000, "pass through each other"),
      refused("two at one place", setting(0), "run.max_initial_overlap")};
}

std::vector<Row> nothing_in_reach(const std::string& law) {
  const double beside = 2 * Ball::radius * (1 + 1e-9);
  World w = Case(law, true)
                .set("shape.large.radius", Ball::radius)
                .set("body[0].position", Vec3d{-0.01, 0, 1})
                .set("body[0].velocity", Vec3d{1, 0, 0})
                .set("body[1].position", Vec3d{0, 0, 1 + beside})
                .build();
  step_for(w, 0.02);
  const Motion a = motion_of(w, 0), b = motion_of(w, 1);
  return {is_true("passes at 1e-9 of the size",
                  w.counters.contact_steps == 0 && a.velocity == Vec3d{1, 0, 0} && b.velocity == Vec3d{},
                  "no contact, no change to the bit",
                  fmt::format("{} contacts, speed {}", w.counters.contact_steps, norm(b.velocity))),
          right("passes at 1e-9 of the size: way", a.position.x + 0.01, w.time(), 1e-12, "m")};
}

}  // namespace dem::validate
