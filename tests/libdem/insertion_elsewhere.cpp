// Fills, rain, outlets and events in the plane and in periodic boxes: the same bits in every way of running, nothing on
// top of anything.
#include <gtest/gtest.h>

#include "tests/libdem/scene_in_time.h"

namespace dem {
namespace {

using scenes::length;

// Discs and ellipses rain on a shelf of a plane box and run out of it when it goes; some come back.
Scene plane_box() {
  constexpr double dt = 0x1p-15;
  Scene s;
  s.dimension = 2;
  s.thickness = 0.01;
  s.law.name = LawName::spring_dashpot;
  s.run.steps = 800;
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.run.check_every = 16;
  s.gravity = {20, -400, 0};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.materials[0].stiffness = 2e4;
  s.shapes = {scenes::sphere("ball", 0.005), scenes::sphere("egg", 0)};
  s.shapes[0].kind = "disc";
  s.shapes[1].kind = "ellipse";
  s.shapes[1].semi_axis_a = 0.004;
  s.shapes[1].semi_axis_b = 0.006;
  for (const auto& [name, point, normal] :
       {std::tuple{"floor", Vec3d{0, -0.03, 0}, Vec3d{0, 1, 0}}, std::tuple{"shelf", Vec3d{0, 0, 0}, Vec3d{0, 1, 0}},
        std::tuple{"left", Vec3d{-0.05, 0, 0}, Vec3d{1, 0, 0}},
        std::tuple{"right", Vec3d{0.05, 0, 0}, Vec3d{-1, 0, 0}}}) {
    s.walls.push_back(scenes::plane(name, "soft", point, normal));
    s.walls.back().kind = "line";
  }
  s.species = {{"rain", "", "", "", {}}};
  s.regions = {scenes::box_region("bed", {-0.05, 0, 0}, {0.05, 0.06, 0}),
               scenes::box_region("above", {-0.04, 0.07, 0}, {0.04, 0.12, 0}),
               scenes::box_region("drain", {-0.05, -0.03, 0}, {0, -0.01, 0})};
  RegionSpec disc;
  disc.name = "spout";
  disc.kind = "disc";
  disc.centre = {0.01, 0.1, 0};
  disc.radius = 0.015;
  s.regions.push_back(disc);
  FillSpec fill;
  fill.region = "bed";
  fill.solid_fraction = 0.35;
  fill.arrangement = Arrangement::random;
  fill.velocity = {0, -3, 0};
  fill.items = {scenes::item("ball", "soft", 0.6, 1), scenes::item("egg", "soft", 0.6, 1)};
  s.fills = {fill};
  RainSpec rain;
  rain.name = "shower";
  rain.region = "spout";
  rain.rate = 0x1p10;
  rain.velocity = {0, -3, 0};
  rain.items = {scenes::item("egg", "soft", 0.5, 0.8, "rain")};
  s.rains = {rain};
  OutletSpec out;
  out.name = "drain";
  out.region = "drain";
  out.recycle_to = "above";
  out.velocity = {1, -2, 0};
  s.outlets = {out};
  s.events = {scenes::event("open", 256 * dt), scenes::event("tilt", 500 * dt)};
  s.events[0].remove_wall = "shelf";
  s.events[0].stop_rain = "shower";
  s.events[1].gravity = {-100, -300, 0};
  return s;
}

// The scene of the plane's kin in space, periodic along x and y: rain over a floor, through whose faces bodies drift.
Scene periodic_box() {
  Scene s = scenes::in_time();
  s.walls = {s.walls[0], s.walls[0]};
  s.walls[1].name = "shelf";
  s.walls[1].point.z = 0;
  s.periodic.axes = "xy";
  s.periodic.lower = {-0.045, -0.045, 0};
  s.periodic.upper = {0.045, 0.045, 0};
  s.regions = {scenes::box_region("bed", {-0.045, -0.045, 0}, {0.045, 0.045, 0.05}),
               scenes::box_region("above", {-0.045, -0.045, 0.06}, {0.045, 0.045, 0.1}),
               scenes::box_region("drain", {-0.045, -0.045, -0.03}, {0, 0.045, -0.008})};
  s.species.clear();
  for (FillItem& item : s.fills[0].items) item.species.clear();
  s.fills[0].velocity = {8, -6, -4};
  s.rains.resize(1);
  s.rains[0].region = "above";
  s.rains[0].items[0].species.clear();
  s.rains[0].velocity = {-5, 8, -6};
  OutletSpec out;
  out.name = "drain";
  out.region = "drain";
  out.recycle_to = "above";
  out.velocity = {0, 0, -3};
  s.outlets = {out};
  s.events = {scenes::event("open", 200 * s.run.dt)};
  s.events[0].remove_wall = "shelf";
  return s;
}

class Elsewhere : public testing::TestWithParam<Scene (*)()> {};

TEST_P(Elsewhere, TheSameBitsInEveryWayOfRunning) {
  constexpr std::uint64_t steps = 800;
  const Scene scene = GetParam()();
  const World reference = scenes::run(scene, steps);
  const std::uint64_t hash = state_hash(reference);
  EXPECT_GT(reference.rains[0].count, 5u);
  EXPECT_GT(reference.outlets[0].count, 5u);
  for (const EventRecord& e : reference.events) EXPECT_GT(e.done, 0u);
  EXPECT_EQ(state_hash(scenes::run(scene, steps, 3)), hash);
  Scene other = scene;
  other.run.skin = 0.3 * reference.skin;
  EXPECT_EQ(state_hash(scenes::run(other, steps)), hash);
  other.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(other, steps)), hash);
  for (const std::uint64_t at : {std::uint64_t(199), std::uint64_t(300)}) {
    World second = build_world(scene);
    load_state(second, save_state(scenes::run(scene, at)));
    while (second.step < steps) advance(second, 1);
    EXPECT_EQ(state_hash(second), hash) << "saved at step " << at;
  }
}

TEST_P(Elsewhere, NothingBeginsOnTopOfAnything) {
  const Scene scene = GetParam()();
  World w = build_world(scene);
  std::uint64_t known = 0, recycled = 0;
  const auto expect_free = [&](std::size_t i) {
    const auto& m = w.particles.motion;
    for (std::size_t j = 0; j < m.size(); ++j)
      if (j != i) {
        EXPECT_GE(length(w.cell.lattice.nearest(m[i].position - m[j].position)),
                  (m[i].bounding_radius + m[j].bounding_radius) * (1 - 2e-9))
            << w.step;
      }
  };
  for (int step = 0; step <= 800; ++step) {
    for (std::size_t i = 0; i < w.particles.count(); ++i)
      if (w.particles.id[i] >= known) expect_free(i);
    if (w.outlets[0].count > recycled)
      for (std::size_t i = 0; i < w.particles.count(); ++i)
        if (const Motion& m = w.particles.motion[i];
            m.spin == Vec3d{} && length(m.velocity - w.scene.outlets[0].velocity) < 1e-2)
          expect_free(i);
    known = w.next_id;
    recycled = w.outlets[0].count;
    advance(w, 1);
  }
  EXPECT_GT(known, w.balance.inserted_count);
  EXPECT_GT(recycled, 5u);
  if (w.scene.dimension == 2)
    for (const Motion& m : w.particles.motion) {
      EXPECT_EQ(m.position.z, 0);
      EXPECT_EQ(m.velocity.z, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Boxes, Elsewhere, testing::Values(plane_box, periodic_box),
                         [](const auto& p) { return p.index == 0 ? "plane" : "periodic"; });

}  // namespace
}  // namespace dem
