// Rain, outlets that recycle, events: what they do, the books of mass and momentum, the same bits in every way of
// running.
#include <gtest/gtest.h>

#include <set>

#include "libdem/events/condition.h"
#include "tests/libdem/scene_in_time.h"

namespace dem {
namespace {

using scenes::in_time;
using scenes::in_time_steps;
using scenes::length;

struct Reference {
  Scene scene = in_time();
  World world = scenes::run(scene, in_time_steps);
  std::uint64_t hash = state_hash(world);
};
const Reference& reference() {
  static const Reference r;
  return r;
}

TEST(InTime, EverythingHappened) {
  const World& w = reference().world;
  for (const EventRecord& e : w.events) EXPECT_GT(e.done, 0u) << e.name;
  EXPECT_EQ(w.events[0].done, 150u);
  EXPECT_EQ(w.events[2].met % 10, 0u);
  EXPECT_EQ(w.events[2].done, w.events[2].met + 20);
  for (const RainRecord& r : w.rains) EXPECT_GT(r.count, 5u) << r.name;
  EXPECT_GT(w.outlets[0].count, 0u);
  EXPECT_GT(w.outlets[1].count, 5u);
  EXPECT_EQ(w.scene.gravity, (Vec3d{-40, 10, -120}));
  EXPECT_EQ(w.pairs[1].friction, 0.9);
  std::set<std::uint32_t> species(w.particles.species.begin(), w.particles.species.end());
  EXPECT_EQ(species.size(), 4u);
  EXPECT_EQ(w.walls[3].position.y, 0.05 - 0.5 * (200 + 60) * 0x1p-15);
  EXPECT_FALSE(w.walls[5].present);
}

TEST(InTime, TheBooksBalance) {
  const World& w = reference().world;
  const Balance& b = w.balance;
  double mass = 0;
  for (const std::uint32_t i : order_by_id(w)) mass += w.particles.mass[i];
  EXPECT_NEAR((mass + b.removed_mass) / (b.initial_mass + b.inserted_mass), 1, 1e-14);
  EXPECT_NEAR(b.present.value() / mass, 1, 1e-15);
  EXPECT_EQ(w.particles.count() + w.counters.deleted, 60 + b.inserted_count);
  EXPECT_EQ(b.inserted_count, w.rains[0].count + w.rains[1].count);
  EXPECT_EQ(w.counters.deleted, w.outlets[0].count);
  EXPECT_EQ(w.discharge.size(), w.outlets[0].count + w.outlets[1].count);
  for (const OutletRecord& o : w.outlets) {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : o.by_species) sum += n;
    EXPECT_EQ(sum, o.count);
  }
  Vec3d difference = momentum(w), scale{};
  for (std::size_t k = 0; k < 3; ++k) {
    difference[static_cast<int>(k)] +=
        b.removed_momentum[k].value() - b.initial_momentum[k] - b.inserted_momentum[k].value() - b.impulse[k].value();
    scale[static_cast<int>(k)] = b.impulse[k].value();
  }
  EXPECT_LT(length(difference), 1e-12 * length(scale));
  std::set<std::uint64_t> ids(w.particles.id.begin(), w.particles.id.end());
  EXPECT_EQ(ids.size(), w.particles.count());
  EXPECT_LT(*ids.rbegin(), 60 + b.inserted_count);
}

TEST(InTime, ThreadsDoNotMatter) {
  EXPECT_EQ(state_hash(scenes::run(reference().scene, in_time_steps, 3)), reference().hash);
}

TEST(InTime, SkinAndRebuildsDoNotMatter) {
  Scene s = reference().scene;
  s.run.skin = 0.2 * reference().world.skin;
  EXPECT_EQ(state_hash(scenes::run(s, in_time_steps)), reference().hash);
  s.run.skin = -1;
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, in_time_steps)), reference().hash);
}

// Among the stops: between a condition and its delayed actions, just before and just at events.
TEST(InTime, AResumeInsideTheEventsDoesNotMatter) {
  const std::uint64_t opens = reference().world.events[2].met;
  for (const std::uint64_t at :
       {std::uint64_t(149), std::uint64_t(150), opens + 7, std::uint64_t(430), std::uint64_t(530)}) {
    World first = scenes::run(reference().scene, at);
    const auto bytes = save_state(first);
    World second = build_world(reference().scene);
    load_state(second, bytes);
    EXPECT_EQ(state_hash(second), state_hash(first));
    EXPECT_EQ(save_state(second).size(), bytes.size());
    while (second.step < in_time_steps) advance(second, 1);
    EXPECT_EQ(state_hash(second), reference().hash) << "saved at step " << at;
    EXPECT_EQ(second.rains[0].tries, reference().world.rains[0].tries);
  }
}

Scene shower() {  // without gravity, into free space
  Scene s;
  s.run.steps = 1000;
  s.run.dt_auto = false;
  s.run.dt = 0x1p-10;
  s.materials = {scenes::material("soft", 5e3, 2500, 0.5, 0.4)};
  s.shapes = {scenes::sphere("ball", 0.005)};
  s.regions = {scenes::box_region("there", {0, 0, 0}, {0.1, 0.1, 0.1})};
  RainSpec r;
  r.name = "shower";
  r.region = "there";
  r.velocity = {0, 0, -8};
  r.items = {scenes::item("ball", "soft", 0.5, 1)};
  s.rains = {r};
  return s;
}

TEST(Rain, KeepsItsRateItsTimesAndItsLimits) {
  Scene s = shower();
  s.rains[0].rate = 128;
  World w = build_world(s);
  EXPECT_EQ(w.particles.count(), 0u);
  while (w.time() < 0.5) advance(w, 1);
  EXPECT_EQ(w.rains[0].count, 64u);
  EXPECT_EQ(w.particles.count(), 64u);
  s.rains[0].start = 0.25;
  s.rains[0].stop = 0.375;
  EXPECT_EQ(scenes::run(s, 1000).rains[0].count, 16u);
  s.rains[0].count = 10;
  EXPECT_EQ(scenes::run(s, 1000).rains[0].count, 10u);
  s = shower();
  s.rains[0].mass_rate = 0x1p-4;
  w = scenes::run(s, 512);
  EXPECT_LE(w.rains[0].mass, 0x1p-5);
  EXPECT_GT(w.rains[0].mass, 0x1p-5 - 1.4e-3);  // the next body did not fit in
  s.rains[0].mass = 0.01;
  w = scenes::run(s, 512);
  EXPECT_LE(w.rains[0].mass, 0.01);
  EXPECT_GT(w.rains[0].mass, 0.01 - 1.4e-3);
}

TEST(Rain, WaitsWhereThereIsNoRoomAndOverlapsNothing) {
  Scene s = shower();
  s.rains[0].rate = 4096;
  s.rains[0].velocity = {0, 0, -1};
  s.regions = {scenes::box_region("there", {0, 0, 0}, {0.03, 0.03, 0.02})};
  World w = build_world(s);
  std::uint64_t before = 0;
  for (int k = 0; k < 100; ++k) {
    advance(w, 1);
    const auto& m = w.particles.motion;
    for (std::size_t i = before; i < m.size(); ++i)  // new ones, at their places
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_GE(length(m[i].position - m[j].position), m[i].bounding_radius + m[j].bounding_radius);
    before = 0;
  }
  EXPECT_GT(w.rains[0].waits, 50u);
  EXPECT_LT(w.rains[0].count, 400u);
  EXPECT_GT(w.rains[0].count, 20u);
}

TEST(Rain, WhatComesLaterCountsForTheTimeStep) {
  Scene s = shower();
  s.rains[0].rate = 1;
  s.run.dt_auto = true;
  const World rain = build_world(s);
  s.bodies = {scenes::body("ball", "soft", {0, 0, 0})};
  s.bodies[0].scale = 0.5;
  s.rains.clear();
  EXPECT_EQ(rain.time_step.dt, build_world(s).time_step.dt);
  EXPECT_EQ(rain.skin, build_world(s).skin);
}

TEST(Recycling, ABodyGoesOnElsewhereUnderItsId) {
  Scene s = shower();
  s.rains.clear();
  s.gravity = {0, 0, -10};
  s.bodies = {scenes::body("ball", "soft", {0, 0, 0.5}, {1, 0, 0}, {3, 0, 0})};
  OutletSpec o;
  o.name = "back";
  o.normal = {0, 0, 1};
  o.recycle_to = "there";
  o.velocity = {0, 0, 2};
  s.outlets = {o};
  World w = build_world(s);
  while (w.outlets[0].count == 0) advance(w, 1);
  EXPECT_NEAR(w.time(), std::sqrt(0.1), 0x1p-9);
  EXPECT_EQ(w.particles.id[0], 0u);
  EXPECT_EQ(w.counters.deleted, 0u);
  EXPECT_EQ(w.counters.inserted, 1u);
  const Motion& m = w.particles.motion[0];
  EXPECT_EQ(m.spin, Vec3d{});
  EXPECT_NEAR(m.velocity.z, 2 - 5 * w.time_step.dt, 1e-15);
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(m.position[k] >= 0.005 && m.position[k] <= 0.095);
}

// --- conditions and events ---

std::string fault_of(const std::string& text, std::size_t* at = nullptr) {
  Condition c;
  ConditionFault f;
  if (parse_condition(text, in_time(), c, f)) return "";
  if (at) *at = f.at;
  return f.problem;
}

TEST(Conditions, AreReadOrRefusedAtTheLetter) {
  Condition c;
  ConditionFault f;
  ASSERT_TRUE(parse_condition("time>0.5 and outlet.drain.mass <= 1e-3 and wall.gate.force >= -2", in_time(), c, f));
  ASSERT_EQ(c.size(), 3u);
  EXPECT_EQ(c[1].quantity, Quantity::outlet_mass);
  EXPECT_EQ(c[1].comparison, Comparison::less_equal);
  EXPECT_EQ(c[1].value, 1e-3);
  EXPECT_EQ(c[2].index, 5u);
  const struct {
    const char* text;
    std::size_t at;
    const char* problem;
  } wrong[] = {{"", 0, "needs a quantity"},
               {"tiem > 1", 0, "did you mean time?"},
               {"nonsense > 1", 0, "known: time, step, count"},
               {"time > 1 and", 12, "needs a quantity"},
               {"time > 1 or step > 2", 9, "needs \"and\""},
               {"time = 1", 5, "needs <, <=, > or >="},
               {"time > x", 7, "needs a number"},
               {"time > 1e999", 7, "needs a number"},
               {"time > 1s", 8, "units are SI"},
               {"outlet.dran.mass > 1", 0, "did you mean drain?"},
               {"wall.gate.mass > 1", 0, "there are force and torque, not mass"},
               {"fill.a.count > 1", 0, "needs outlet.NAME"}};
  for (const auto& w : wrong) {
    std::size_t at = 99;
    EXPECT_NE(fault_of(w.text, &at).find(w.problem), std::string::npos) << w.text << ": " << fault_of(w.text);
    EXPECT_EQ(at, w.at) << w.text;
  }
}

double value(const World& w, const std::string& text) {
  Condition c;
  ConditionFault f;
  EXPECT_TRUE(parse_condition(text + " > 0", w.scene, c, f)) << f.problem;
  return measure(w, c.at(0));
}

TEST(Conditions, MeasureWhatTheySay) {
  const World& w = reference().world;
  const Energies e = energies(w);
  EXPECT_EQ(value(w, "kinetic_energy"), e.translational + e.rotational);
  EXPECT_EQ(value(w, "energy"), value(w, "kinetic_energy"));
  EXPECT_DOUBLE_EQ(value(w, "kinetic_energy_per_body") * value(w, "count"), value(w, "energy"));
  EXPECT_EQ(value(w, "time"), w.time());
  EXPECT_EQ(value(w, "step"), 700);
  EXPECT_EQ(value(w, "mass"), w.balance.present.value());
  EXPECT_EQ(value(w, "contacts"), static_cast<double>(touching_contacts(w).size()));
  EXPECT_EQ(value(w, "contacts_per_body"), value(w, "contacts") / value(w, "count"));
  double fastest = 0, sum = 0, deepest = 0;
  for (const Motion& m : w.particles.motion) {
    fastest = std::max(fastest, length(m.velocity));
    sum += length(m.velocity);
  }
  EXPECT_EQ(value(w, "max_speed"), fastest);
  EXPECT_NEAR(value(w, "mean_speed") / (sum / value(w, "count")), 1, 1e-14);
  for (const ContactReport& c : touching_contacts(w)) deepest = std::max(deepest, c.overlap);
  EXPECT_GE(value(w, "max_overlap"), deepest / 0.006);
  EXPECT_EQ(value(w, "discharged_count"), static_cast<double>(w.discharge.back().count));
  EXPECT_NEAR(value(w, "discharged_mass") / w.discharge.back().mass, 1, 1e-14);
  EXPECT_EQ(value(w, "inserted_count"), value(w, "rain.shower.count") + value(w, "rain.later.count"));
  EXPECT_NEAR(value(w, "inserted_mass"), value(w, "rain.shower.mass") + value(w, "rain.later.mass"), 1e-15);
  EXPECT_EQ(value(w, "outlet.conveyor.count"), static_cast<double>(w.outlets[1].count));
  EXPECT_EQ(value(w, "outlet.drain.mass"), w.outlets[0].mass);
  EXPECT_EQ(value(w, "wall.floor.force"), length(w.walls[0].force));
  EXPECT_EQ(value(w, "wall.floor.torque"), length(w.walls[0].torque));
}

// A ball at rest on a plane is in balance; one in flight is not.
TEST(Conditions, UnbalancedForce) {
  Scene s = shower();
  s.rains.clear();
  s.run.dt = 0x1p-13;
  s.gravity = {0, 0, -10};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.bodies = {scenes::body("ball", "soft", {0, 0, 0.005})};
  EXPECT_EQ(value(build_world(s), "unbalanced_force"), std::numeric_limits<double>::infinity());
  EXPECT_LT(value(scenes::run(s, 8000), "unbalanced_force"), 1e-6);
}

TEST(Events, UntilEndsARunAndAStopDoes) {
  Scene s = shower();
  s.rains[0].rate = 128;
  s.run.check_every = 50;
  s.run.until = "count >= 20";
  World w = build_world(s);
  while (!finished(w)) advance(w, 1);
  EXPECT_EQ(w.step, 200u);  // 160 steps make 20 bodies; the next look is at 200
  EXPECT_EQ(ended_by(w), "run.until: count >= 20");
  s.run.until.clear();
  s.events = {scenes::event("enough", 0.125)};
  s.events[0].stop = true;
  w = build_world(s);
  while (!finished(w)) advance(w, 1);
  EXPECT_EQ(w.step, 128u);
  EXPECT_EQ(ended_by(w), "event enough");
  s.events.clear();
  w = build_world(s);
  while (!finished(w)) advance(w, 1);
  EXPECT_EQ(w.step, 1000u);
  EXPECT_EQ(ended_by(w), "");
}

TEST(Events, AWallIsNotInsertedIntoBodies) {
  Scene s = shower();
  s.rains.clear();
  s.bodies = {scenes::body("ball", "soft", {0, 0, 0})};
  s.walls = {scenes::plane("lid", "soft", {0, 0, -0.004}, {0, 0, 1})};
  s.walls[0].present = false;
  s.events = {scenes::event("shut", 0.0625)};
  s.events[0].insert_wall = "lid";
  World w = build_world(s);
  EXPECT_TRUE(touching_contacts(w).empty());
  try {
    while (!finished(w)) advance(w, 1);
    ADD_FAILURE() << "not refused";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("\"lid\" was inserted where body 0 is"), std::string::npos) << e.what();
  }
  EXPECT_EQ(w.step, 65u);
  s.walls[0].point = {0, 0, -0.0055};
  w = scenes::run(s, 70);
  EXPECT_TRUE(w.walls[0].present);
}

TEST(Events, AServoThatIsNotThereWaits) {
  Scene s = shower();
  s.rains.clear();
  s.bodies = {scenes::body("ball", "soft", {1, 0, 0})};
  WallSpec lid = scenes::random_floor("lid", "soft", 0.1, 2, 0.3, 1);
  lid.motion = WallMotion::servo;
  lid.axis = {0, 0, -1};
  lid.target_force = 1;
  lid.speed_limit = 0.5;
  lid.present = false;
  s.walls = {lid};
  s.events = {scenes::event("shut", 0.125)};
  s.events[0].insert_wall = "lid";
  const World w = scenes::run(s, 128 + 64);
  EXPECT_EQ(w.walls[0].position.z, -0.5 * 0x1p-10 * 64);
}

TEST(Events, AMotionThatStartsAgainGoesOnWhereTheWallIs) {
  Scene s = shower();
  s.rains.clear();
  s.bodies = {scenes::body("ball", "soft", {1, 0, 0})};
  for (const WallMotion motion :
       {WallMotion::translation, WallMotion::rotation, WallMotion::oscillation, WallMotion::table}) {
    WallSpec wall = scenes::random_floor("plate", "soft", 0.1, 2, 0.3, 1);
    wall.motion = motion;
    wall.velocity = {1, 2, 3};
    wall.axis = {1, 1, 0};
    wall.centre = {0.2, 0, 0};
    wall.rate = 4;
    wall.amplitude = {0.1, 0, 0};
    wall.frequency = 3;
    wall.turns = {{0, 0.25}, {1, 4}};
    wall.displacements = {{0, 0, 0.125, 0}, {1, 1, 1, 2}};
    s.walls = {wall};
    s.events = {scenes::event("go", 0.125), scenes::event("halt", 0.25), scenes::event("go on", 0.5)};
    s.events[0].start_motion = s.events[1].stop_motion = s.events[2].start_motion = "plate";
    World w = build_world(s);
    Vec3d before = w.walls[0].position, facing = shapes::rotate(w.walls[0].orientation, Vec3d{1, 0, 0});
    double moved = 0;
    for (int i = 0; i < 800; ++i) {
      advance(w, 1);
      const Vec3d now = w.walls[0].position;
      EXPECT_LT(length(now - before), 8 * w.time_step.dt) << w.step;  // no jump
      const bool waits = w.time() <= 0.125 || (w.time() > 0.251 && w.time() <= 0.5);
      if (waits) {
        EXPECT_EQ(length(now - before), 0) << w.step;
      }
      moved += length(now - before);
      before = now;
      const Vec3d faces = shapes::rotate(w.walls[0].orientation, Vec3d{1, 0, 0});
      EXPECT_LT(length(faces - facing), 5 * w.time_step.dt) << w.step;
      facing = faces;
    }
    EXPECT_GT(moved, 0.2);
  }
}

}  // namespace
}  // namespace dem
