// Every law in the loop gives the same bits for any number of threads, skin and rebuild, and across a restart in the
// middle: spheres in a box of planes, and a mixed lot with ellipsoids and cubes, stirred so that contacts come and go
// and bonds hold across gaps.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

constexpr std::uint64_t steps = 320;

// Bodies on a lattice in a box that is a little too small, thrown about.
Scene stirred(const LawSpec& law, bool mixed) {
  Scene s;
  s.law = law;
  s.law.ledger = true;
  s.gravity = {1, -2, -9.81};
  s.run.steps = steps;
  s.run.dt_fraction = 0.25;
  s.materials = {law_loop::material(), law_loop::material()};
  s.materials[0].work_of_adhesion = 1;
  s.materials[1].name = "other";
  s.materials[1].young = 2e7;
  s.materials[1].stiffness = 2e3;
  s.materials[1].friction = 0.2;
  const double r = law_loop::radius, pitch = (mixed ? 1.99 : 2.04) * r;
  s.shapes = {scenes::sphere("ball", r), scenes::ellipsoid("egg", {0.85 * r, 0.8 * r, 0.95 * r}),
              scenes::box("cube", {1.15 * r, 1.2 * r, 1.1 * r})};
  const int nx = 4, ny = mixed ? 3 : 4, nz = mixed ? 3 : 4;
  for (int i = 0; i < nx * ny * nz; ++i) {
    Random random(11, 0, static_cast<std::uint64_t>(i));
    const auto any = [&](double most) {
      const double x = random.uniform(-most, most), y = random.uniform(-most, most), z = random.uniform(-most, most);
      return Vec3d{x, y, z};
    };
    const char* shape = !mixed || i % 9 == 4 ? "ball" : i % 3 == 0 ? "cube" : "egg";
    const Vec3d at{(i % nx + 0.5) * pitch, (i / nx % ny + 0.5) * pitch, (i / (nx * ny) + 0.5) * pitch};
    const Vec3d speed = any(mixed ? 1.0 : 0.4), spin = any(40);
    s.bodies.push_back(scenes::body(shape, i % 2 == 0 ? "m" : "other", at, speed, spin, random.rotation()));
    s.bodies.back().scale = random.uniform(0.9, mixed && i % 9 == 4 ? 0.92 : 1.0);
  }
  const Vec3d far = Vec3d{nx * pitch, ny * pitch, nz * pitch};
  s.walls = {scenes::plane("west", "m", {0, 0, 0}, {1, 0, 0}),      scenes::plane("east", "m", far, {-1, 0, 0}),
             scenes::plane("south", "other", {0, 0, 0}, {0, 1, 0}), scenes::plane("north", "other", far, {0, -1, 0}),
             scenes::plane("bottom", "m", {0, 0, 0}, {0, 0, 1}),    scenes::plane("top", "m", far, {0, 0, -1})};
  return s;
}

std::size_t across_a_gap(const World& w) {
  std::size_t n = 0;
  for (const ContactReport& c : touching_contacts(w)) n += c.overlap < 0 ? 1 : 0;
  return n;
}

class LawBits : public testing::TestWithParam<std::tuple<std::size_t, bool>> {};

TEST_P(LawBits, ThreadsSkinRebuildAndRestartDoNotMatter) {
  const LawSpec law = law_loop::every_law()[std::get<0>(GetParam())];
  const Scene s = stirred(law, std::get<1>(GetParam()));
  World reference = build_world(s);
  std::vector<std::uint8_t> saved;
  std::uint64_t at = 0, saved_hash = 0;
  std::size_t gaps = 0;
  while (reference.step < steps) {
    advance(reference, 1);
    if (reference.step < steps / 2 || across_a_gap(reference) <= gaps) continue;
    gaps = across_a_gap(reference);  // where most bonds are stretched
    saved = save_state(reference);
    saved_hash = state_hash(reference);
    at = reference.step;
  }
  const std::uint64_t hash = state_hash(reference);
  const auto lost = dissipated(reference);
  std::printf("  %llu contact steps, %zu bonds across gaps, %zu words\n",
              static_cast<unsigned long long>(reference.counters.contact_steps), gaps, reference.contacts.words);
  EXPECT_GT(reference.counters.contact_steps, 2000u);
  if (!std::get<1>(GetParam())) {
    EXPECT_EQ(gaps > 0, law_loop::holds_on(law));
  }
  const auto expect_same = [&](const World& w, const char* how) {
    EXPECT_EQ(state_hash(w), hash) << how;
    EXPECT_EQ(dissipated(w), lost) << how;
  };
  expect_same(scenes::run(s, steps, 2), "two threads");
  Scene other = s;
  other.run.skin = 0.1 * reference.skin;
  expect_same(scenes::run(other, steps), "a small skin");
  other.run.skin = 3 * reference.skin;
  other.run.rebuild_every = 7;
  expect_same(scenes::run(other, steps, 2), "a large skin");
  other = s;
  other.run.rebuild_every = 1;
  expect_same(scenes::run(other, steps), "a rebuild at every step");
  if (saved.empty()) {
    const World half = scenes::run(s, steps / 2);
    saved = save_state(half);
    saved_hash = state_hash(half);
    at = steps / 2;
  }
  World resumed = build_world(s);
  load_state(resumed, saved);
  EXPECT_EQ(state_hash(resumed), saved_hash);
  EXPECT_EQ(resumed.step, at);
  while (resumed.step < steps) advance(resumed, 1);
  expect_same(resumed, "a restart");
}

// A word of memory more or less is another hash.
TEST_P(LawBits, TheHashSeesTheMemory) {
  World w = scenes::run(stirred(law_loop::every_law()[std::get<0>(GetParam())], std::get<1>(GetParam())), 60);
  const std::uint64_t hash = state_hash(w);
  Contacts& c = w.contacts;
  std::size_t k = 0;
  while (k < c.count() && c.touching[k] == 0) ++k;
  ASSERT_LT(k, c.count());
  for (std::size_t j = 0; j < c.words; ++j) {
    double& word = c.memory[k * c.words + j];
    const double kept = word;
    word = kept + 1;
    EXPECT_NE(state_hash(w), hash) << "word " << j;
    word = kept;
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::size_t, bool>>& p) {
  return law_loop::test_name(law_loop::every_law()[std::get<0>(p.param)]) +
         (std::get<1>(p.param) ? "_mixed" : "_spheres");
}

INSTANTIATE_TEST_SUITE_P(Every, LawBits,
                         testing::Combine(testing::Range(std::size_t(0), law_loop::every_law().size()),
                                          testing::Bool()),
                         name_of);

}  // namespace
}  // namespace dem
