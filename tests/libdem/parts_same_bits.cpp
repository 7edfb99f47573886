// The same bits for bodies of parts as for any other: threads, skin, rebuild, resume, units, a periodic box.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr std::uint64_t bodies = 120, steps = 700;

struct Reference {
  Scene scene = scenes::bodies_of_parts(bodies);
  World world = scenes::run(scene, steps);
  std::uint64_t hash = state_hash(world);
};
const Reference& reference() {
  static const Reference r;
  return r;
}

TEST(PartsSameBits, TheSceneHasThem) {
  const World& w = reference().world;
  std::size_t parts = 0, shared = 0, both = 0, mesh = 0;
  for (std::size_t k = 0; k < w.contacts.count(); ++k) {
    if (w.contacts.touching[k] == 0) continue;
    const Key& key = w.contacts.key[k];
    parts += key.part_a != 0 || (key.b < wall_base && key.part != 0) ? 1 : 0;
    both += key.part_a != 0 && key.b < wall_base && key.part != 0 ? 1 : 0;
    shared += w.contacts.share[k] < 1 ? 1 : 0;
    mesh += key.b >= wall_base && w.walls[w.contacts.index_b[k]].mesh && key.part_a != 0 ? 1 : 0;
  }
  std::printf(
      "  contacts of a later part %zu, on both sides %zu, on a mesh %zu, shared %zu; %.2f contacts per particle\n",
      parts, both, mesh, shared, contacts_per_particle(w));
  EXPECT_GT(parts, 10u);
  EXPECT_GT(both, 0u);
  EXPECT_GT(shared, 5u);
  EXPECT_GT(mesh, 0u);
  EXPECT_EQ(w.counters.not_converged, 0u);
}

TEST(PartsSameBits, Threads) {
  for (const int threads : {2, 3})
    EXPECT_EQ(state_hash(scenes::run(reference().scene, steps, threads)), reference().hash);
}

TEST(PartsSameBits, SkinAndRebuild) {
  for (const double factor : {0.1, 4.0}) {
    Scene s = reference().scene;
    s.run.skin = factor * reference().world.skin;
    const World w = scenes::run(s, steps);
    EXPECT_NE(w.counters.rebuilds, reference().world.counters.rebuilds);
    EXPECT_EQ(state_hash(w), reference().hash) << "skin times " << factor;
  }
  Scene s = reference().scene;
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, steps)), reference().hash);
}

TEST(PartsSameBits, Restart) {
  const World first = scenes::run(reference().scene, 333);
  World second = build_world(reference().scene);
  load_state(second, save_state(first));
  EXPECT_EQ(state_hash(second), state_hash(first));
  EXPECT_EQ(energies(second).elastic, energies(first).elastic);
  EXPECT_EQ(contacts_per_particle(second), contacts_per_particle(first));
  while (second.step < steps) advance(second, 1);
  EXPECT_EQ(state_hash(second), reference().hash);
}

// Rain brings the first bodies of parts into a world without any; they leave by an outlet and come back.
TEST(PartsSameBits, RainAndRecycling) {
  Scene s = reference().scene;
  s.fills[0].count = 30;
  s.fills[0].items = {{"ball", "soft", 1, 0.7, 1.0}};
  RegionSpec above, west;
  above.name = "above";
  above.lower = {-0.045, -0.045, 0.1};
  above.upper = {0.045, 0.045, 0.15};
  west.name = "west half";
  west.lower = {-0.06, -0.06, -0.02};
  west.upper = {-0.01, 0.06, 0.01};
  s.regions = {above, west};
  RainSpec rain;
  rain.name = "rain";
  rain.region = "above";
  rain.rate = 4096;
  rain.velocity = {0, 0, -3};
  rain.items = {{"ell", "hard", 1, 0.7, 0.9}, {"clump", "soft", 1, 0.8, 1.0}};
  s.rains = {rain};
  OutletSpec conveyor;
  conveyor.name = "conveyor";
  conveyor.region = "west half";
  conveyor.recycle_to = "above";
  s.outlets = {conveyor};
  const World whole = scenes::run(s, steps);
  EXPECT_GT(whole.rains[0].count, 20u);
  EXPECT_GT(whole.outlets[0].count, 5u);
  EXPECT_EQ(whole.particles.count(), 30 + whole.rains[0].count);
  EXPECT_EQ(state_hash(scenes::run(s, steps, 2)), state_hash(whole));
  Scene fresh = s;
  fresh.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(fresh, steps)), state_hash(whole));
  World second = build_world(s);
  load_state(second, save_state(scenes::run(s, steps / 2)));
  while (second.step < steps) advance(second, 1);
  EXPECT_EQ(state_hash(second), state_hash(whole));
}

TEST(PartsSameBits, OtherUnits) {
  const auto restated = [](Scene s, int length) {
    const double unit = std::ldexp(1.0, length);
    s.gravity *= unit;
    for (MaterialSpec& m : s.materials) {
      m.young /= unit;  // kg and s stay
      m.density /= unit * unit * unit;
    }
    for (ShapeSpec& x : s.shapes) {
      x.radius *= unit;
      x.semi_axes *= unit;
      x.extents *= unit;
      for (Vec3d& v : x.vertices) v *= unit;
      for (auto& ball : x.spheres)
        for (double& v : ball) v *= unit;
      for (PartSpec& part : x.parts) part.position *= unit;
    }
    for (WallSpec& w : s.walls) {
      w.point *= unit;
      w.amplitude *= unit;
      for (Vec3d& v : w.vertices) v *= unit;
    }
    for (FillSpec& f : s.fills)
      for (Vec3d* v : {&f.lower, &f.upper, &f.velocity}) *v *= unit;
    return s;
  };
  for (const int length : {-20, 13}) {
    const World w = scenes::run(restated(reference().scene, length), steps);
    const double unit = std::ldexp(1.0, length);
    for (std::uint64_t id = 0; id < w.next_id; ++id) {
      EXPECT_TRUE(scenes::motion(w, id).position == scenes::motion(reference().world, id).position * unit) << id;
      EXPECT_TRUE(scenes::motion(w, id).spin == scenes::motion(reference().world, id).spin) << id;
    }
    EXPECT_EQ(w.counters.contact_steps, reference().world.counters.contact_steps);
  }
}

// In a box that deforms the list grows old in its own way: the skin still does not matter.
TEST(PartsSameBits, ADeformingCell) {
  Scene s = scenes::every_shape_in_a_cell(160);
  const Scene parts = scenes::bodies_of_parts(160);
  s.shapes = parts.shapes;
  for (FillSpec& f : s.fills) f.items = parts.fills[0].items;
  World w = scenes::run(s, steps);
  const auto expected = state_hash(w);
  std::size_t later = 0;
  for (const Key& key : w.contacts.key) later += key.part_a > 0 ? 1 : 0;
  EXPECT_GT(later, 10u);
  EXPECT_GT(w.counters.contact_steps, 500u);
  s.run.skin = 0.1 * w.skin;
  EXPECT_EQ(state_hash(scenes::run(s, steps, 2)), expected);
  s.run.skin = 2 * w.skin;
  EXPECT_EQ(state_hash(scenes::run(s, steps)), expected);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, steps)), expected);
}

// A clump that meets another across the face of a periodic box does what it does in the middle of it.
TEST(PartsSameBits, AcrossAPeriodicFace) {
  const auto run = [](double shift) {
    Scene s;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
    s.shapes = {scenes::clump("dumbbell", {{-0.25, 0, 0, 0.25}, {0.25, 0, 0, 0.25}}),
                scenes::box("bar", {1, 0.25, 0.25}), scenes::box("stub", {0.25, 0.5, 0.25}),
                scenes::union_of("ell", {{"bar", {}, {}}, {"stub", {0.375, 0.375, 0}, {}}})};
    s.periodic.axes = "xyz";
    s.periodic.lower = {0, 0, 0};
    s.periodic.upper = {8, 8, 8};
    s.run.steps = 1;
    const auto at = [shift](double x, double y, double z) { return Vec3d{x + shift, y + shift, z}; };
    s.bodies = {scenes::body("dumbbell", "soft", at(3.25, 4, 4), {1, 0, 0}, {0, 0.5, 0}, scenes::turn({0, 1, 0}, 0.4)),
                scenes::body("ell", "soft", at(5.25, 4, 4), {-1, 0, 0}, {0.25, 0, 0}, scenes::turn({0, 0, 1}, 0.7))};
    World w = build_world(s);
    while (w.time() < 1.5) advance(w, 1);
    return w;
  };
  const World middle = run(0), across = run(4);
  EXPECT_GT(middle.counters.contact_steps, 10u);
  EXPECT_EQ(across.counters.contact_steps, middle.counters.contact_steps);
  for (const std::uint64_t id : {0u, 1u})
    EXPECT_LT(scenes::length(scenes::motion(across, id).velocity - scenes::motion(middle, id).velocity), 1e-9);
}

}  // namespace
}  // namespace dem
