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

// A box, whole or of two pieces.
std::vector<ShapeSpec> plate(bool in_pieces) {
  if (!in_pieces) return {scenes::box("body", {4 * r, 2 * r, 2 * r})};
  return {scenes::box("piece", {2 * r, 2 * r, 2 * r}),
          scenes::union_of("body", {{"piece", {-r, 0, 0}, {}}, {"piece", {r, 0, 0}, {}}})};
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
