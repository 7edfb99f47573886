// What the tests of laws in the loop share: every combination that the lists of laws give, and two bodies that meet.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"
#include "libdem/laws_of_scene.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem::law_loop {

constexpr double radius = 1e-3, density = 2500, restitution = 0.6;  // m, kg/m³, –

// A material that every law finds its parameters in: millimetres, 10 MPa.
inline MaterialSpec material() {
  MaterialSpec m = scenes::material("m", 1e7, density, restitution, 0.4);
  m.stiffness = 1e3;
  m.viscous_time = 4e-6;
  m.yield_pressure = 2.5e5;
  m.work_of_adhesion = 0.1;
  m.plastic_stiffness = 5e3;
  m.adhesive_stiffness = 300;
  m.plastic_depth = 0.05;
  m.rolling_friction = 0.1;
  m.rolling_viscosity = 1;
  m.rolling_damping = 0.3;
  m.twisting_friction = 0.1;
  m.cohesion = 2e-4;
  m.contact_angle = 0.3;
  return m;
}

inline LawSpec combination(std::size_t i) {
  LawSpec law;
  law.name = static_cast<LawName>(i);
  law.surface_tension = 0.07;
  law.bridge_volume = 1e-12;
  return law;
}
inline LawSpec combination(LawName name) { return combination(static_cast<std::size_t>(name)); }

// The named combinations, and every law of each list that none of them has, with the partners that it needs.
inline std::vector<LawSpec> every_law() {
  std::vector<LawSpec> all;
  for (std::size_t i = 0; i < std::size(contact::named_laws); ++i) all.push_back(combination(i));
  const auto is_in = [&](auto member, std::string_view name) {
    for (const LawSpec& l : all)
      if (law_names(l).*member == name) return true;
    return false;
  };
  contact::each_law<contact::NormalLaws>([&](auto law, std::size_t) {
    if (is_in(&contact::LawNames::normal, law.name)) return;
    all.push_back(combination(contact::hertzian(law.name) ? LawName::hertz_mindlin : LawName::spring_dashpot));
    all.back().normal = law.name;
  });
  contact::each_law<contact::TangentialLaws>([&](auto law, std::size_t) {
    if (is_in(&contact::LawNames::tangential, law.name)) return;
    all.push_back(combination(LawName::hertz_mindlin));
    all.back().tangential = law.name;
    for (const contact::Partners& p : contact::partners)
      if (p.law == law.name) all.back().normal = p.normal.substr(0, p.normal.find(','));
  });
  contact::each_law<contact::RollingLaws>([&](auto law, std::size_t) {
    if (is_in(&contact::LawNames::rolling, law.name)) return;
    for (const LawName name : {LawName::hertz_mindlin, LawName::spring_dashpot}) {
      all.push_back(combination(name));
      all.back().rolling = law.name;
    }
  });
  contact::each_law<contact::CohesionLaws>([&](auto law, std::size_t) {
    if (is_in(&contact::LawNames::cohesion, law.name)) return;
    for (const LawName name : {LawName::hertz_mindlin, LawName::spring_dashpot}) {
      all.push_back(combination(name));
      all.back().cohesion = law.name;
    }
  });
  // Memories of all four families side by side, and a normal law that remembers beside a bridge that outlives it.
  all.push_back(combination(LawName::mindlin_deresiewicz_exact));
  all.back().rolling = "spring";
  all.back().cohesion = "liquid_bridge";
  all.push_back(combination(LawName::thornton_ning));
  all.back().cohesion = "liquid_bridge_rabinovich";
  all.push_back(combination(LawName::spring_dashpot));
  all.back().normal = "latching_spring";
  all.back().cohesion = "liquid_bridge";
  all.push_back(combination(LawName::hertz_mindlin));
  all.back().normal = "jkr";
  all.back().rolling = "spring";
  return all;
}

// As a name of a test.
inline std::string test_name(const LawSpec& law) {
  std::string name = law_title(law);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

inline bool holds_on(const LawSpec& law) { return law_model_of(law).lingers; }

inline std::vector<std::size_t> laws_that_hold_on() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < every_law().size(); ++i)
    if (holds_on(every_law()[i])) all.push_back(i);
  return all;
}

enum class Shape { sphere, ellipsoid, box };
inline constexpr const char* shape_names[] = {"sphere", "ellipsoid", "box"};

// Two like bodies one above the other, or one above a plane; normals are along z.
struct Meeting {
  Shape shape = Shape::sphere;
  bool wall = false;
  double equivalent_radius = 0, mass = 0;  // of a body
  double half = 0;                         // its half height, m
  double radius_eff = 0, mass_eff = 0;
  contact::PairParameters pair;
  Scene scene;  // bodies as yet without speed; the surfaces touch

  Meeting(const LawSpec& law, const MaterialSpec& m, Shape of, bool on_a_wall) : shape(of), wall(on_a_wall) {
    scene.law = law;
    scene.materials = {m};
    double volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    half = radius;
    switch (shape) {
      case Shape::sphere:
        scene.shapes = {scenes::sphere("body", radius)};
        break;
      case Shape::ellipsoid:
        half = 1.25 * radius;
        volume *= 1.25;
        scene.shapes = {scenes::ellipsoid("body", {radius, radius, half})};
        break;
      case Shape::box:
        scene.shapes = {scenes::box("body", {2 * radius, 2 * radius, 2 * radius})};
        volume = 8 * radius * radius * radius;
        break;
    }
    equivalent_radius = std::cbrt(volume * 0.75 / std::numbers::pi);
    mass = m.density * volume;
    radius_eff = (wall ? 1 : 0.5) * equivalent_radius;
    mass_eff = (wall ? 1 : 0.5) * mass;
    const contact::Material material = material_of(m, law);
    pair = contact::mix(material, material, law.clip);
    scene.run.steps = 1;
    if (wall) {
      scene.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
      scene.bodies = {scenes::body("body", "m", {0, 0, half})};
    } else {
      scene.bodies = {scenes::body("body", "m", {0, 0, half}),
                      scenes::body("body", "m", {0, 0, -half}, {}, {}, scenes::turn({0, 0, 1}, 0.3))};
    }
  }

  // The bodies come together at this speed from a gap of as much as it covers in `gap` seconds.
  void approach(double speed, double gap) {
    for (BodySpec& b : scene.bodies) {
      const double share = wall ? 1 : 0.5, up = b.position.z > 0 ? 1 : -1;
      b.position.z += up * share * speed * gap;
      b.velocity.z = -up * share * speed;
    }
  }

  // Of the elastic contact at this speed of impact, s.
  double duration(double speed) const {
    if (law_model_of(scene.law).hertzian)
      return 2.8682657 * std::pow(mass_eff * mass_eff / (radius_eff * pair.young_eff * pair.young_eff * speed), 0.2);
    return std::numbers::pi * std::sqrt(mass_eff / pair.stiffness_n);
  }

  double gap(const World& w) const {
    const double z = scenes::motion(w, 0).position.z;
    return wall ? z - half : z - scenes::motion(w, 1).position.z - 2 * half;
  }
  // At which the bodies part, m/s.
  double speed(const World& w) const {
    return scenes::motion(w, 0).velocity.z - (wall ? 0 : scenes::motion(w, 1).velocity.z);
  }
};

// The force on a, away from b, of a contact that has just been pressed to this overlap; b is a plane, the bodies of the
// first material, with R* = radius. The energy that it stores.
inline double force_of(const World& w, double radius_eff, double overlap, double* energy = nullptr) {
  contact::kernels::LawChunk chunk{};
  const auto work = std::make_unique<contact::kernels::LawWork>();
  for (std::size_t i = 0; i < contact::kernels::chunk_size; ++i) {
    contact::each_parameter(chunk.pair, w.pairs[0], [i](contact::kernels::Lane& l, double x) { l[i] = x; });
    chunk.overlap[i] = overlap;
    chunk.normal.z[i] = -1;
    chunk.radius_eff[i] = radius_eff;
    chunk.mass_eff[i] = w.particles.mass[0];
    work->gain[i] = 1;
  }
  w.law.run(chunk, *work, 1, 0, w.law_options, false);
  if (energy != nullptr) *energy = contact::stored_energy(chunk, *work, 0);
  return chunk.force.z[0];
}

}  // namespace dem::law_loop
