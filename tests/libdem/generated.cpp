// Shapes of a scene that stand for many grains made by random numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "libdem/build.h"
#include "shapes/form.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr std::uint64_t steps = 700;

ShapeSpec grains(const std::string& name, const std::string& kind, int variants) {
  ShapeSpec s;
  s.name = name;
  s.kind = kind;
  s.variants = variants;
  s.diameter = 0.008;
  if (kind == "generated") s.statistic = std::string(PROJECT_ROOT) + "/shapes/data/ct_dims/all.csv";
  return s;
}

Scene tray(std::uint64_t count) {
  Scene s = scenes::every_shape(count);
  s.shapes = {grains("gravel", "generated", 24), grains("chips", "voronoi", 10), grains("pebble", "voronoi", 5)};
  s.shapes[1].relaxations = 2;
  s.shapes[2].rounding = 0.0005;
  s.fills[0].items = {{"gravel", "soft", 2, 0.7, 1.0}, {"chips", "hard", 1, 0.7, 0.9}, {"pebble", "soft", 1, 0.8, 1.0}};
  return s;
}

TEST(Generated, BodiesTakeTheVariantsInEqualNumbers) {
  const World w = build_world(tray(192));
  ASSERT_EQ(w.shapes.size(), 24u + 10 + 5);
  EXPECT_EQ(w.shapes[0].name, "gravel#1");
  EXPECT_EQ(w.shapes[23].name, "gravel#24");
  EXPECT_EQ(w.shapes[24].family, "chips");
  std::map<std::uint32_t, int> count;
  std::map<std::string, int> of_family;
  for (const std::uint32_t s : w.particles.shape) {
    ++count[s];
    ++of_family[w.shapes[s].family];
  }
  EXPECT_EQ(of_family["gravel"], 96);  // by their weights, whatever the number of variants
  EXPECT_EQ(of_family["chips"], 48);
  for (std::uint32_t s = 0; s < 24; ++s) EXPECT_EQ(count[s], 4) << w.shapes[s].name;
  for (std::uint32_t s = 24; s < 34; ++s) EXPECT_NEAR(count[s], 4.8, 0.9) << w.shapes[s].name;
  for (const ShapeEntry& s : w.shapes) {
    EXPECT_NEAR(s.equivalent_radius, 0.004, 1e-9) << s.name;
    EXPECT_EQ(s.kind, s.family == "pebble" ? shapes::Kind::rounded_polyhedron : shapes::Kind::polyhedron);
  }
  EXPECT_NE(w.shapes[0].polyhedron->vertices, w.shapes[1].polyhedron->vertices);
}

// By the seed of the run and the place of the shape: another seed, other grains; another scene, the same ones.
TEST(Generated, GrainsFollowTheSeed) {
  Scene s = tray(8);
  const World a = build_world(s);
  s.fills[0].count = 16;
  s.run.steps = 7;
  const World b = build_world(s);
  s.run.seed += 1;
  const World c = build_world(s);
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    if (a.shapes[i].family == "pebble") continue;
    EXPECT_EQ(a.shapes[i].polyhedron->vertices, b.shapes[i].polyhedron->vertices);
    EXPECT_NE(a.shapes[i].polyhedron->vertices, c.shapes[i].polyhedron->vertices);
  }
}

TEST(Generated, BodiesByName) {
  Scene s = tray(8);
  s.fills.clear();
  for (const char* name : {"gravel", "gravel", "gravel#7", "chips"}) {
    BodySpec b;
    b.shape = name;
    b.material = "soft";
    b.position = {-0.03 + 0.02 * static_cast<double>(s.bodies.size()), 0, 0.03};
    s.bodies.push_back(b);
  }
  s.species = {{"stones", "", "", "gravel", {}}};
  const World w = build_world(s);
  EXPECT_EQ(w.shapes[w.particles.shape[0]].name, "gravel#1");
  EXPECT_EQ(w.shapes[w.particles.shape[1]].name, "gravel#2");
  EXPECT_EQ(w.shapes[w.particles.shape[2]].name, "gravel#7");
  EXPECT_EQ(w.shapes[w.particles.shape[3]].name, "chips#4");
  EXPECT_EQ(w.particles.species, (std::vector<std::uint32_t>{1, 1, 1, 0}));
  s.bodies[2].shape = "gravel#25";
  EXPECT_THROW(build_world(s), InputError);
}

TEST(Generated, TheSameBits) {
  Scene s = tray(60);
  s.fills[0].upper.z = 0.1;
  const World whole = scenes::run(s, steps);
  EXPECT_GT(whole.counters.contact_steps, 500u);
  EXPECT_EQ(state_hash(scenes::run(s, steps, 2)), state_hash(whole));
  World second = build_world(s);
  load_state(second, save_state(scenes::run(s, steps / 2)));
  while (second.step < steps) advance(second, 1);
  EXPECT_EQ(state_hash(second), state_hash(whole));
}

}  // namespace
}  // namespace dem
