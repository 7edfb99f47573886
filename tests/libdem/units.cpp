// A change of units by powers of two gives the same bits, scaled: every input of the scene with every shape is restated
// in units of length 2^-l m, mass 2^-m kg, time 2^-t s.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/libdem/scene_in_time.h"

namespace dem {
namespace {

struct Units {
  int length, mass, time;  // powers of two
  double of(int l, int m, int t) const { return std::ldexp(1.0, l * length + m * mass + t * time); }
};

void scale(Vec3d& v, double s) { v *= s; }

Scene restated(Scene s, const Units& u) {
  const double length = u.of(1, 0, 0), speed = u.of(1, 0, -1), rate = u.of(0, 0, -1);
  scale(s.gravity, u.of(1, 0, -2));
  s.run.time *= u.of(0, 0, 1);
  s.run.dt *= u.of(0, 0, 1);
  if (s.run.skin > 0) s.run.skin *= length;
  for (MaterialSpec& m : s.materials) {
    m.young *= u.of(-1, 1, -2);
    m.density *= u.of(-3, 1, 0);
    m.stiffness *= u.of(0, 1, -2);
  }
  for (ShapeSpec& x : s.shapes) {
    x.radius *= length;
    scale(x.semi_axes, length);
    scale(x.extents, length);
    for (Vec3d& v : x.vertices) scale(v, length);
  }
  for (WallSpec& w : s.walls) {
    scale(w.point, length);
    for (Vec3d& v : w.vertices) scale(v, length);
    scale(w.velocity, speed);
    scale(w.centre, length);
    scale(w.amplitude, length);
    w.rate *= rate;
    w.frequency *= rate;
    w.start *= u.of(0, 0, 1);
    w.stop *= u.of(0, 0, 1);
    w.remove_at *= u.of(0, 0, 1);
    for (auto& row : w.displacements) {
      row[0] *= u.of(0, 0, 1);
      for (std::size_t k = 1; k < 4; ++k) row[k] *= length;
    }
    for (auto& row : w.turns) row[0] *= u.of(0, 0, 1);
    w.target_force *= u.of(1, 1, -2);
    w.target_pressure *= u.of(-1, 1, -2);
    w.area *= u.of(2, 0, 0);
    w.map_cell *= length;
    w.speed_limit *= speed;
  }
  for (FillSpec& f : s.fills) {
    scale(f.lower, length);
    scale(f.upper, length);
    scale(f.velocity, speed);
  }
  for (BodySpec& b : s.bodies) {
    scale(b.position, length);
    scale(b.velocity, speed);
    scale(b.spin, rate);
  }
  scale(s.periodic.lower, length);
  scale(s.periodic.upper, length);
  for (DeformSpec& d : s.periodic.deform) {
    d.start *= u.of(0, 0, 1);
    scale(d.strain_rates, rate);
    scale(d.target_stress, u.of(-1, 1, -2));
    d.rate_limit *= rate;
  }
  for (OutletSpec& o : s.outlets) {
    scale(o.point, length);
    scale(o.velocity, speed);
  }
  for (RegionSpec& r : s.regions) {
    scale(r.lower, length);
    scale(r.upper, length);
    scale(r.centre, length);
    r.radius *= length;
    r.height *= length;
  }
  for (RainSpec& r : s.rains) {
    r.rate *= rate;
    r.mass_rate *= u.of(0, 1, -1);
    r.start *= u.of(0, 0, 1);
    r.stop *= u.of(0, 0, 1);
    r.mass *= u.of(0, 1, 0);
    scale(r.velocity, speed);
  }
  for (EventSpec& e : s.events) {
    e.at *= u.of(0, 0, 1);
    e.delay *= u.of(0, 0, 1);
    scale(e.gravity, u.of(1, 0, -2));
  }
  return s;
}

bool same(const Vec3d& restated, const Vec3d& v, double factor) { return restated == v * factor; }

// The first body and quantity that is not the same bits, scaled; empty when all are.
std::string difference(const World& a, const World& b, const Units& u) {
  if (a.time_step.dt * u.of(0, 0, 1) != b.time_step.dt) return "dt";
  if (a.skin * u.of(1, 0, 0) != b.skin) return "skin";
  const auto i = order_by_id(a), j = order_by_id(b);
  if (i.size() != j.size()) return "number of bodies";
  const Particles &p = a.particles, &q = b.particles;
  for (std::size_t k = 0; k < i.size(); ++k) {
    const std::string body = " of body " + std::to_string(k);
    const Motion &x = p.motion[i[k]], &y = q.motion[j[k]];
    if (p.mass[i[k]] * u.of(0, 1, 0) != q.mass[j[k]]) return "mass" + body;
    if (!same(q.inertia[j[k]], p.inertia[i[k]], u.of(2, 1, 0))) return "inertia" + body;
    if (!same(y.position, x.position, u.of(1, 0, 0))) return "position" + body;
    if (!same(y.velocity, x.velocity, u.of(1, 0, -1))) return "velocity" + body;
    if (!same(y.spin, x.spin, u.of(0, 0, -1))) return "spin" + body;
    if (std::memcmp(&p.orientation[i[k]], &q.orientation[j[k]], sizeof(Quatd)) != 0) return "orientation" + body;
    if (!same(q.rotation[j[k]], p.rotation[i[k]], 1)) return "rotation" + body;
    if (!same(q.force[j[k]], p.force[i[k]], u.of(1, 1, -2))) return "force" + body;
    if (!same(q.torque[j[k]], p.torque[i[k]], u.of(2, 1, -2))) return "torque" + body;
  }
  for (std::size_t w = 0; w < a.walls.size(); ++w)
    if (!same(b.walls[w].force, a.walls[w].force, u.of(1, 1, -2))) return "force on wall " + a.walls[w].name;
  for (std::size_t w = 0; w < a.walls.size(); ++w)
    if (!same(b.walls[w].position, a.walls[w].position, u.of(1, 0, 0))) return "place of wall " + a.walls[w].name;
  for (std::size_t w = 0; w < a.walls.size(); ++w) {
    const WallLoad &x = a.walls[w].load, &y = b.walls[w].load;
    if (x.work.value() * u.of(2, 1, -2) != y.work.value()) return "work on wall " + a.walls[w].name;
    for (std::size_t k = 0; k < 3; ++k)
      if (x.impulse[k].value() * u.of(1, 1, -1) != y.impulse[k].value()) return "impulse on wall " + a.walls[w].name;
    if (x.map.size() != y.map.size() || x.squares != y.squares) return "map of wall " + a.walls[w].name;
    for (std::size_t t = 0; t < x.map.size(); ++t)
      if (!same(y.map[t].force, x.map[t].force, u.of(1, 1, -1)) ||
          !same(y.map[t].tangential, x.map[t].tangential, u.of(1, 1, -1)) ||
          x.map[t].pressing * u.of(1, 1, -1) != y.map[t].pressing)
        return "map of wall " + a.walls[w].name;
  }
  if (!same(b.cell.lattice.length, a.cell.lattice.length, u.of(1, 0, 0))) return "length of the box";
  for (int k = 0; k < 3; ++k)
    if (!same(b.cell.virial.row[k], a.cell.virial.row[k], u.of(2, 1, -2))) return "stress";
  if (a.cell.work.value() * u.of(2, 1, -2) != b.cell.work.value()) return "work";
  if (a.counters.contact_steps != b.counters.contact_steps) return "number of contacts";
  return "";
}

class ChangeOfUnits : public testing::TestWithParam<LawName> {};

constexpr std::uint64_t bodies = 150, steps = 400;

void expect_same_bits_scaled(const Scene& s, std::uint64_t number = steps) {
  const World reference = scenes::run(s, number);
  EXPECT_GT(reference.counters.contact_steps, 1000u);
  const Units list[] = {{20, 0, 0}, {-20, 0, 0}, {0, 30, 0},    {0, -30, 0},
                        {0, 0, 10}, {0, 0, -10}, {20, -30, 10}, {-20, 30, -10}};
  for (const Units& u : list) {
    World w = build_world(restated(s, u));
    EXPECT_EQ(difference(build_world(s), w, u), "") << "at the start";
    while (w.step < number) advance(w, 1);
    EXPECT_EQ(difference(reference, w, u), "")
        << "length 2^" << u.length << ", mass 2^" << u.mass << ", time 2^" << u.time;
  }
}

TEST_P(ChangeOfUnits, GivesTheSameBitsScaled) {
  Scene s = scenes::every_shape(bodies);
  s.law.name = GetParam();
  expect_same_bits_scaled(s);
}

TEST_P(ChangeOfUnits, GivesTheSameBitsScaledWithDrivenWalls) {
  Scene s = scenes::every_shape_driven(bodies);
  for (WallSpec& w : s.walls) {
    w.pressure_map = true;
    if (w.kind == "plane") w.map_cell = 0.01;
  }
  s.law.name = GetParam();
  expect_same_bits_scaled(s);
}

TEST_P(ChangeOfUnits, GivesTheSameBitsScaledInADeformingCell) {
  Scene s = scenes::every_shape_in_a_cell(bodies);
  s.law.name = GetParam();
  expect_same_bits_scaled(s);
}

// With rain, recycling and events.
TEST_P(ChangeOfUnits, GivesTheSameBitsScaledInTime) {
  Scene s = scenes::in_time();
  s.law.name = GetParam();
  expect_same_bits_scaled(s, scenes::in_time_steps);
}

INSTANTIATE_TEST_SUITE_P(Laws, ChangeOfUnits, testing::Values(LawName::spring_dashpot, LawName::hertz_mindlin),
                         [](const auto& p) {
                           return p.param == LawName::hertz_mindlin ? "hertz_mindlin" : "spring_dashpot";
                         });

}  // namespace
}  // namespace dem
