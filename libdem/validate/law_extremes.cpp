#include "libdem/validate/law_extremes.h"

#include <algorithm>
#include <tuple>

#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"
#include "libcontact/laws/model.h"
#include "libdem/validate/law_scenes.h"

namespace dem::validate {

std::vector<Row> mass_ratios(const std::string&law), size_ratios(const std::string&law),
    fines_on_a_large_body(const std::string&law), through_each_other(const std::string&law),
    nothing_in_reach(const std::string&law);

namespace {

// Laws whose restitution is that of a dashpot beside an elastic spring, and nothing else.
bool restitution_by_dashpot(const contact::NamedLaw& l) {
  return l.damped && (l.normal == contact::Linear::name || l.normal == contact::Hertz::name) &&
         l.cohesion == contact::NoCohesion::name;
}

bool hertzian(const std::string& law) {
  const auto names = contact::named_law(law);
  return names && contact::hertzian(names->normal);
}

using Rows = std::vector<Row>;

// What it rebounds with from the floor, over the speed that it came with.
double rebound(World w) {
  const double speed = -motion_of(w, 0).velocity.z;
  until_parted(w);
  return motion_of(w, 0).velocity.z / speed;
}

Rows restitution(const std::string& law) {
  Rows rows;
  const auto ask = [&](double e, bool clip) {
    return Case(law, false).set("material.small.restitution", e).set("law.clip", std::string(clip ? "true" : "false"));
  };
  const double least = contact::least_clipped_restitution;
  rows.push_back(right("e 1", rebound(ask(1, true).build()), 1, 1e-3));
  rows.push_back(
      right(fmt::format("e {}, the least clipped one", least), rebound(ask(least, true).build()), least, 5e-3));
  rows.push_back(refused(fmt::format("e {}, clipped", 0.99 * least), ask(0.99 * least, true), "law.clip = false"));
  rows.push_back(right("e 0.5, unclipped", rebound(ask(0.5, false).build()), 0.5, 5e-3));
  rows.push_back(refused("e 0, clipped", ask(0, true), "law.clip = false"));
  World w = ask(0, false).build();
  const double speed = -motion_of(w, 0).velocity.z;
  double fastest = 0;
  for (int i = 0; i < 30000; ++i) {
    advance(w, 1);
    fastest = std::max(fastest, motion_of(w, 0).velocity.z);
  }
  rows.push_back(right("e 0, unclipped: fastest way back (critical damping)", fastest / speed, std::exp(-2), 5e-3));
  rows.push_back(
      at_most("e 0, unclipped: speed at last, of the first", std::abs(motion_of(w, 0).velocity.z) / speed, 1e-6));
  rows.push_back(is_true("e 0, unclipped: stays", touching_contacts(w).size() == 1, "1 contact",
                         fmt::format("{} contacts", touching_contacts(w).size())));
  return rows;
}

Rows friction(const std::string& law) {
  const double speed = 0.1;
  const auto slid = [&](double mu) {
    World w = Case(law, false)
                  .set("world.gravity", Vec3d{0, 0, -earth})
                  .set("material.small.friction", mu)
                  .set("body[0].position", Vec3d{0, 0, Ball::radius})
                  .set("body[0].velocity", Vec3d{speed, 0, 0})
                  .build();
    step_for(w, 0.01);
    return motion_of(w, 0);
  };
  const Motion smooth = slid(0), rough = slid(infinity);
  return {right("mu 0: speed after sliding", smooth.velocity.x, speed, 0, "m/s"),
          at_most("mu 0: spin", norm(smooth.spin), 0, "rad/s"),
          right("mu inf: rolls with 5/7 of the speed", rough.velocity.x / speed, 5.0 / 7, 1e-3),
          right("mu inf: spin that rolls", rough.spin.y * Ball::radius / rough.velocity.x, 1, 1e-3)};
}

Rows poisson(const std::string& law) {
  Rows rows;
  for (const double nu : {0.0, 0.5}) {
    const double mu = 0.1, e = 0.5, vn = 0.1, vt = 6 * mu * (1 + e) * vn;  // slides throughout
    World w = Case(law, false)
                  .set("material.small.poisson", nu)
                  .set("material.small.friction", mu)
                  .set("body[0].velocity", Vec3d{vt, 0, -vn})
                  .build();
    const PairParameters& q = w.pairs[1];  // small on floor
    const double ratio = hertzian(law) ? 4 * q.shear_eff / q.young_eff : q.stiffness_t / q.stiffness_n;
    rows.push_back(right(fmt::format("nu {}: kt/kn", nu), ratio, 2 * (1 - nu) / (2 - nu), 1e-14));
    until_parted(w);
    const Motion m = motion_of(w, 0);
    rows.push_back(right(fmt::format("nu {}: restitution", nu), m.velocity.z / vn, e, 2e-3));
    rows.push_back(
        right(fmt::format("nu {}: speed along the floor", nu), m.velocity.x, vt - mu * (1 + e) * vn, 1e-3, "m/s"));
    rows.push_back(
        right(fmt::format("nu {}: spin", nu), m.spin.y, 2.5 * mu * (1 + e) * vn / Ball::radius, 5e-3, "rad/s"));
  }
  return rows;
}

double overlap_at_rest(const std::string& law, double factor) {  // of the ball on the floor, stiffness times factor
  const double weight = Ball::mass * earth;
  if (!hertzian(law)) return weight / (factor * Ball::stiffness);
  const double young_eff = factor * Ball::young / (1 - Ball::poisson * Ball::poisson);
  return std::pow(weight / (4.0 / 3.0 * young_eff * std::sqrt(Ball::radius)), 2.0 / 3.0);
}

// Young's modulus 10^3 to 10^15 Pa, stiffness 0.1 N/m to 10^11 N/m; the one of the worst answer is told.
Rows stiffness(const std::string& law) {
  Row bounce, force, sinks;
  double worst[3] = {-1, -1, -1};
  const auto keep = [&](int i, Row& row, const Row& found, double got, double expected) {
    if (!(std::abs(got / expected - 1) <= worst[i])) {
      row = found;
      worst[i] = std::abs(got / expected - 1);
    }
  };
  for (int power = -5; power <= 7; ++power) {
    const double factor = std::pow(10.0, power);
    const auto setting = [&] {
      return Case(law, false)
          .set("material.small.young", factor * Ball::young)
          .set("material.small.stiffness", factor * Ball::stiffness);
    };
    const std::string at = fmt::format("E {:.0e} Pa: ", factor * Ball::young);
    const double speed = 0.1 * std::sqrt(factor),
                 e = rebound(setting().set("body[0].velocity", Vec3d{0, 0, -speed}).build());
    keep(0, bounce, right(at + "restitution", e, 0.5, 2e-3), e, 0.5);
    const double depth = overlap_at_rest(law, factor);
    World w = setting()
                  .set("world.gravity", Vec3d{0, 0, -earth})
                  .set("run.dt_overlap", std::min(0.5, 2 * depth / Ball::radius))
                  .set("body[0].position", Vec3d{0, 0, Ball::radius})
                  .set("body[0].velocity", Vec3d{})
                  .build();
    for (int i = 0; i < 4000; ++i) advance(w, 1);
    const std::vector<ContactReport> touching = touching_contacts(w);
    const double f = touching.empty() ? 0 : touching[0].force.z / (Ball::mass * earth),
                 d = touching.empty() ? 0 : touching[0].overlap;
    // A place is known to 1 part in 2^52 of itself, an overlap of 1e-16 m to 1 part in 500.
    const double tolerance = 1e-4 + 8 * 0x1p-52 * Ball::radius / depth;
    keep(1, force, right(at + "force at rest, of the weight", f, 1, tolerance), f, 1);
    keep(2, sinks, right(at + "overlap at rest", d, depth, tolerance, "m"), d, depth);
  }
  return {bounce, force, sinks};
}

// Let go from an overlap of 4/5 of the radius at rest, and thrown to that overlap.
Rows deep(const std::string& law) {
  const double depth = 0.8 * Ball::radius;
  const auto setting = [&] {
    return Case(law, false)
        .set("material.small.restitution", 1)
        .set("run.max_initial_overlap", 1)
        .set("run.dt_overlap", 0.5);
  };
  World w =
      setting().set("body[0].position", Vec3d{0, 0, Ball::radius - depth}).set("body[0].velocity", Vec3d{}).build();
  const double stored = energies(w).elastic;
  until_parted(w);
  Rows rows{right("overlap 0.8 R, no speed: kinetic energy after", energies(w).translational, stored, 2e-3, "J")};
  World thrown = setting().set("body[0].velocity", Vec3d{0, 0, -std::sqrt(2 * stored / Ball::mass)}).build();
  const double before = total(energies(thrown));
  rows.push_back(right("impact to 0.8 R: largest overlap", until_parted(thrown), depth, 2e-3, "m"));
  rows.push_back(right("impact to 0.8 R: energy after", total(energies(thrown)), before, 2e-3, "J"));
  return rows;
}

Rows alone(const std::string& law) {
  Rows rows;
  for (const double g : {earth, 0.0}) {
    World w = Case(law, false)
                  .set("world.gravity", Vec3d{0, 0, -g})
                  .set("body[0].position", Vec3d{0, 0, 1})
                  .set("body[0].velocity", Vec3d{0.1, 0.2, 0.3})
                  .build();
    for (int i = 0; i < 10000; ++i) advance(w, 1);
    const double t = w.time();
    const std::string under = g > 0 ? "one ball in free fall: " : "one ball without gravity: ";
    rows.push_back(right(under + "height", motion_of(w, 0).position.z, 1 + 0.3 * t - 0.5 * g * t * t, 1e-11, "m"));
    rows.push_back(right(under + "way", motion_of(w, 0).position.y, 0.2 * t, 1e-11, "m"));
  }
  // Just in touch with nothing to do.
  World w =
      Case(law, false).set("body[0].position", Vec3d{0, 0, Ball::radius}).set("body[0].velocity", Vec3d{}).build();
  for (int i = 0; i < 1000; ++i) advance(w, 1);
  rows.push_back(is_true("no overlap, no speed: stays to the bit",
                         motion_of(w, 0).position == Vec3d{0, 0, Ball::radius} && motion_of(w, 0).velocity == Vec3d{},
                         "as it was", fmt::format("moved by {:.1e} m", motion_of(w, 0).position.z - Ball::radius)));
  return rows;
}

// A ball let go on the floor sinks to twice its overlap at rest: the limit there is seen in a run of short steps.
Rows time_step(const std::string& law) {
  const auto setting = [&] {
    return Case(law, false)
        .set("world.gravity", Vec3d{0, 0, -earth})
        .set("material.small.restitution", 0.7)
        .set("body[0].position", Vec3d{0, 0, Ball::radius})
        .set("body[0].velocity", Vec3d{});
  };
  World w = setting().build();
  for (int i = 0; i < 20000; ++i) advance(w, 1);
  World at_limit = setting().set("run.dt", 0.9 * w.tightest_limit).build();
  for (int i = 0; i < 4000; ++i) advance(at_limit, 1);
  const std::vector<ContactReport> touching = touching_contacts(at_limit);
  const double force = touching.empty() ? 0 : touching[0].force.z;
  Rows rows{
      right("dt 0.9 of the limit: force at rest, of the weight", force / (Ball::mass * earth), 1, 1e-6),
      stops("dt 1.5 of the limit, at rest", setting().set("run.dt", 1.5 * w.tightest_limit), 1000, "stability limit")};
  // An impact that is over before any other look.
  const auto impact = [&] {
    return Case(law, false).set("material.small.restitution", 1).set("run.dt_overlap", 0.003);
  };
  const double limit = impact().build().time_step.limit;
  rows.push_back(stops("dt 3 of the limit, an impact", impact().set("run.dt", 3 * limit), 1000, "stability limit"));
  rows.push_back(
      for_information("dt 0.5 of the limit: restitution for 1", rebound(impact().set("run.dt_fraction", 0.5).build())));
  return rows;
}

}  // namespace

const std::vector<LawExtreme>& law_extremes() {
  static const std::vector<LawExtreme> list{
      {"restitution", restitution},
      {"friction", friction},
      {"poisson", poisson},
      {"stiffness", stiffness},
      {"mass_ratio", mass_ratios},
      {"size_ratio", size_ratios},
      {"fines", fines_on_a_large_body},
      {"deep_overlap", deep},
      {"through_each_other", through_each_other},
      {"alone", alone},
      {"nothing_in_reach", nothing_in_reach},
      {"time_step", time_step},
  };
  return list;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const contact::NamedLaw& l : contact::named_laws)
    if (restitution_by_dashpot(l)) names.emplace_back(l.name);
  return names;
}

extern const Validation law_extremes_entry;
const Validation law_extremes_entry{
    "law_extremes", "law_extremes.toml",
    "every force law at its extremes: right by closed forms, stopped or refused by a message",
    [](Runs&) -> std::vector<Row> {
      std::vector<Row> rows;
      for (const std::string& law : law_names())
        for (const LawExtreme& extreme : law_extremes())
          for (Row& row : extreme.check(law)) {
            row.criterion.insert(0, law + ", ");
            rows.push_back(std::move(row));
          }
      return rows;
    }};

}  // namespace dem::validate
