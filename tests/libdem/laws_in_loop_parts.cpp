// Laws that hold on across gaps, pull, or remember how deep they were, on bodies of parts: a body in pieces acts as the
// whole one, no bond is lost or doubled where pieces join, and nothing gains energy by rolling from piece to piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "libdem/scene/errors.h"
#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

constexpr double r = law_loop::radius;

// A plate with knobs on two sides, so that it is no convex body; the plate whole or of two pieces.
std::vector<ShapeSpec> plate(bool in_pieces) {
  std::vector<ShapeSpec> shapes{scenes::box("knob", {r, r, r}), scenes::box("whole", {4 * r, 2 * r, 2 * r}),
                                scenes::box("piece", {2 * r, 2 * r, 2 * r})};
  std::vector<PartSpec> parts{{"knob", {0.2 * r, 1.5 * r, 0}, {}}, {"knob", {-0.2 * r, -1.5 * r, 0}, {}}};
  if (in_pieces) {
    parts.push_back({"piece", {-r, 0, 0}, {}});
    parts.push_back({"piece", {r, 0, 0}, {}});
  } else {
    parts.push_back({"whole", {}, {}});
  }
  shapes.push_back(scenes::union_of("body", parts));
  return shapes;
}

Scene above_the_floor(const LawSpec& law, const std::vector<ShapeSpec>& shapes, double restitution = 1) {
  Scene s;
  s.law = law;
  s.law.ledger = true;
  s.materials = {law_loop::material()};
  s.materials[0].restitution = restitution;
  s.shapes = shapes;
  s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 1;
  s.run.dt_fraction = 0.1;
  return s;
}

class LawParts : public testing::TestWithParam<std::size_t> {
 protected:
  LawSpec law() const { return law_loop::every_law()[GetParam()]; }
};

// Thrown at the floor flat and a little askew: the pieces rebound, stick or let go as the whole does.
TEST_P(LawParts, APlateInPiecesActsAsTheWhole) {
  for (const double tilt : {0.0, 0.02}) {
    Vec3d speed[2], spin[2];
    std::uint64_t steps[2];
    for (const bool in_pieces : {false, true}) {
      Scene s = above_the_floor(law(), plate(in_pieces));
      s.bodies = {scenes::body("body", "m", {0, 0, r * (1 + 2.2 * std::sin(tilt))}, {0.02, 0.03, -0.2}, {},
                               scenes::turn({0, 1, 0}, tilt))};
      World w = build_world(s);
      ASSERT_EQ(w.particles.kind[0], shapes::Kind::compound);
      bool met = false;
      std::uint64_t last = 0;
      for (int i = 0; i < 1500; ++i) {
        advance(w, 1);
        const bool touching = !touching_contacts(w).empty();
        if (touching) last = w.step;
        met = met || touching;
        if (met && w.step > last + 20) break;
      }
      EXPECT_TRUE(met);
      speed[in_pieces ? 1 : 0] = w.particles.motion[0].velocity;
      spin[in_pieces ? 1 : 0] = w.particles.motion[0].spin;
      steps[in_pieces ? 1 : 0] = last;
    }
    std::printf("  tilt %.2f: %.6f %.6f m/s, %.3f %.3f rad/s, until step %llu %llu\n", tilt, speed[0].z, speed[1].z,
                spin[0].y, spin[1].y, static_cast<unsigned long long>(steps[0]),
                static_cast<unsigned long long>(steps[1]));
    EXPECT_LT(scenes::length(speed[0] - speed[1]), 2e-3 * 0.2) << tilt;
    EXPECT_LT(scenes::length(spin[0] - spin[1]) * r, 2e-3 * 0.2) << tilt;
  }
}

// An L flat on the floor, of bars that cross or of others: what its parts feel adds to the force on one contact.
TEST_P(LawParts, AnLOnItsSideIsOneContact) {
  const double overlap = 2e-3 * r;
  for (const int cut : {0, 1}) {
    std::vector<ShapeSpec> shapes{scenes::box("long", {3 * r, r, r}), scenes::box("stub", {r, 2 * r, r}),
                                  scenes::box("tall", {r, 3 * r, r})};
    const std::vector<PartSpec> other = cut == 0 ? std::vector<PartSpec>{{"stub", {-r, 1.5 * r, 0}, {}}}
                                                 : std::vector<PartSpec>{{"tall", {-r, r, 0}, {}}};
    std::vector<PartSpec> parts{{"long", {}, {}}};
    parts.insert(parts.end(), other.begin(), other.end());
    shapes.push_back(scenes::union_of("body", parts));
    Scene s = above_the_floor(law(), shapes);
    s.bodies = {scenes::body("body", "m", {0, 0, 0.5 * r - overlap})};
    const World w = build_world(s);
    const auto touching = touching_contacts(w);
    Vec3d force{};
    for (const ContactReport& c : touching) force += c.force;
    const double expected = law_loop::force_of(w, w.particles.motion[0].equivalent_radius, overlap);
    EXPECT_NEAR(force.z / expected, 1, 1e-9) << "cut " << cut << ", parts that touch: " << touching.size();
  }
}

// A ball of two that nearly coincide, latched by an impact, turns on the spot in its dent: where the contact passes
// from one to the other, the new one has been as deep as the old one. Otherwise it would yield afresh and lift the
// ball.
TEST(LawsOnParts, PlasticMemoryPassesFromPartToPart) {
  for (const LawName name : {LawName::partially_latching_spring, LawName::thornton_ning}) {
    Scene s = above_the_floor(law_loop::combination(name),
                              {scenes::clump("body", {{-0.01 * r, 0, 0, r}, {0.01 * r, 0, 0, r}})}, 0.3);
    s.materials[0].friction = 0;
    s.materials[0].yield_pressure = 2e4;
    s.gravity = {0, 0, -200};
    s.bodies = {scenes::body("body", "m", {0, 0, 1.0101 * r}, {0, 0, -0.2}, {0, 100, 0}, scenes::turn({0, 1, 0}, 1.5))};
    World w = build_world(s);
    std::size_t both = 0;
    double least = 1;
    while (w.particles.rotation[0].y < 2.4) {
      advance(w, 1);
      const Contacts& c = w.contacts;
      if (touching_contacts(w).size() < 2) continue;
      ++both;
      const double one = c.memory[0], other = c.memory[c.words];  // of both laws the largest overlap comes first
      least = std::min(least, std::min(one, other) / std::max(one, other));
    }
    std::printf("  on both parts for %zu steps, their largest overlaps in the ratio %.4f\n", both, least);
    EXPECT_GT(both, 100u);
    EXPECT_GT(least, 0.98);
  }
}

// A clump of three balls that join, kept on the floor by forty times gravity, rolls and tumbles over its joints: it
// gains no energy but what a bond that forms has in advance (laws/ledger.h).
TEST_P(LawParts, RollingFromPieceToPieceGainsNoEnergy) {
  Scene s = above_the_floor(
      law(), {scenes::clump("body", {{-0.6 * r, 0, 0, r}, {0.6 * r, 0, 0, r}, {0, 0.5 * r, 0.3 * r, 0.9 * r}})});
  s.gravity = {0, 0, -400};
  s.bodies = {
      scenes::body("body", "m", {0, 0, 1.7 * r}, {0.1, 0.05, -0.05}, {40, 80, 20}, scenes::turn({0.6, 0.8, 0}, 1))};
  World w = build_world(s);
  const auto total = [&] {
    double sum = 0;
    for (const double lost : dissipated(w)) sum += lost;
    const Energies e = energies(w);
    return std::pair(e.translational + e.rotational + e.potential + e.elastic, sum);
  };
  const double start = total().first, moving = start - w.particles.mass[0] * 400 * r;
  double least = start, gained = 0, worst = 0;
  for (int i = 0; i < 6000; ++i) {
    advance(w, 1);
    const auto [energy, lost] = total();
    gained = std::max(gained, energy - least);
    least = std::min(least, energy);
    worst = std::max(worst, std::abs(energy + lost - start));
  }
  std::printf("  gained %.1e, off by %.1e of the energy; %llu contact steps\n", gained / moving, worst / moving,
              static_cast<unsigned long long>(w.counters.contact_steps));
  EXPECT_GT(w.counters.contact_steps, 500u);
  EXPECT_LT(gained, 5e-3 * moving);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& p) {
  return law_loop::test_name(law_loop::every_law()[p.param]);
}
INSTANTIATE_TEST_SUITE_P(Every, LawParts, testing::Range(std::size_t(0), law_loop::every_law().size()), name_of);

// Bodies of parts that stick: the same bits for any list and across a restart, with bonds across gaps.
class StickyParts : public testing::TestWithParam<std::size_t> {};

TEST_P(StickyParts, SameBits) {
  Scene s =
      above_the_floor(law_loop::every_law()[GetParam()],
                      {scenes::clump("dumbbell", {{-0.5 * r, 0, 0, 0.5 * r}, {0.4 * r, 0, 0, 0.6 * r}}),
                       scenes::box("bar", {1.6 * r, 0.5 * r, 0.5 * r}), scenes::box("stub", {0.5 * r, r, 0.5 * r}),
                       scenes::union_of("ell", {{"bar", {0, 0, 0}, {}}, {"stub", {-0.5 * r, 0.7 * r, 0}, {}}})});
  s.gravity = {0, 0, -9.81};
  s.walls.push_back(scenes::plane("west", "m", {0, 0, 0}, {1, 0, 0}));
  s.walls.push_back(scenes::plane("east", "m", {7.2 * r, 0, 0}, {-1, 0, 0}));
  for (int i = 0; i < 18; ++i) {
    Random random(17, 0, static_cast<std::uint64_t>(i));
    const Vec3d at{(i % 3 + 0.5) * 2.4 * r, (i / 3 % 3) * 2.4 * r, (i / 9 + 0.5) * 2.4 * r};
    s.bodies.push_back(scenes::body(i % 2 == 0 ? "dumbbell" : "ell", "m", at,
                                    {random.uniform(-1, 1), 0.5 * (1 - i / 3 % 3), random.uniform(-1, 0)},
                                    {random.uniform(-200, 200), 50, 100}, random.rotation()));
  }
  constexpr std::uint64_t steps = 700;
  World reference = build_world(s);
  std::vector<std::uint8_t> saved;
  std::size_t gaps = 0;
  while (reference.step < steps) {
    advance(reference, 1);
    std::size_t now = 0;
    for (const ContactReport& c : touching_contacts(reference)) now += c.overlap < 0 ? 1 : 0;
    if (now <= gaps || reference.step < steps / 3) continue;
    gaps = now;
    saved = save_state(reference);
  }
  std::printf("  %zu bonds across gaps, %llu contact steps\n", gaps,
              static_cast<unsigned long long>(reference.counters.contact_steps));
  const auto expect_same = [&](const World& w, const char* how) {
    EXPECT_EQ(state_hash(w), state_hash(reference)) << how;
    EXPECT_EQ(dissipated(w), dissipated(reference)) << how;
  };
  expect_same(scenes::run(s, steps, 2), "two threads");
  Scene other = s;
  other.run.rebuild_every = 1;
  expect_same(scenes::run(other, steps), "a rebuild at every step");
  other.run.rebuild_every = 0;
  other.run.skin = 0.1 * reference.skin;
  expect_same(scenes::run(other, steps), "a small skin");
  if (saved.empty()) saved = save_state(scenes::run(s, steps / 2));
  World resumed = build_world(s);
  load_state(resumed, saved);
  while (resumed.step < steps) advance(resumed, 1);
  expect_same(resumed, "a restart");
}

INSTANTIATE_TEST_SUITE_P(Every, StickyParts, testing::ValuesIn(law_loop::laws_that_hold_on()), name_of);

TEST(LawsOnOutlines, BondsAreRefusedWhereBodiesMayTouchInSeveralRegions) {
  Scene s;
  s.dimension = 2;
  s.law = law_loop::combination(LawName::hertz_mindlin);
  s.law.map = LawMap::equivalent_radius;
  s.materials = {law_loop::material()};
  ShapeSpec ell;
  ell.name = "ell";
  ell.kind = "polygon";
  ell.vertices = {{0, 0, 0}, {2 * r, 0, 0}, {2 * r, r, 0}, {r, r, 0}, {r, 2 * r, 0}, {0, 2 * r, 0}};
  s.shapes = {ell};
  s.run.steps = 1;
  s.bodies = {scenes::body("ell", "m", {0, 0, 0})};
  EXPECT_NO_THROW(build_world(s));
  for (const std::size_t i : law_loop::laws_that_hold_on()) {
    const LawMap map = s.law.map;
    s.law = law_loop::every_law()[i];
    s.law.map = map;
    try {
      build_world(s);
      ADD_FAILURE() << law_title(s.law);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("\"ell\" is not convex"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace dem
