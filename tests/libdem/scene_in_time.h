// A scene in which all comes and goes: an eggs-and-balls bed in a tray, rain on it from two sources, a conveyor outlet
// that brings bodies back, a drain that deletes them, and events that open a gate, start and stop walls, turn gravity,
// change friction and tag bodies. Everything has happened after 700 steps.
#pragma once

#include "tests/libdem/scenes_in_code.h"

namespace dem::scenes {

inline RegionSpec box_region(const std::string& name, const Vec3d& lower, const Vec3d& upper) {
  RegionSpec r;
  r.name = name;
  r.lower = lower;
  r.upper = upper;
  return r;
}

inline EventSpec event(const std::string& name, double at) {
  EventSpec e;
  e.name = name;
  e.at = at;
  return e;
}

inline FillItem item(const std::string& shape, const std::string& material, double low, double high,
                     const std::string& species = "") {
  FillItem i;
  i.shape = shape;
  i.material = material;
  i.scale_min = low;
  i.scale_max = high;
  i.species = species;
  return i;
}

// Steps of 2^-15 s, so that times of events are exact.
inline Scene in_time() {
  constexpr double dt = 0x1p-15;
  Scene s;
  s.run.steps = 900;
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.run.check_every = 10;
  s.gravity = {30, 0, -500};
  s.materials = {material("soft", 5e6, 2500, 0.5, 0.4), material("hard", 8e6, 1500, 0.8, 0.2)};
  s.materials[0].stiffness = 2e4;
  s.materials[1].stiffness = 3e4;
  s.shapes = {sphere("ball", 0.005), ellipsoid("egg", {0.004, 0.005, 0.0075})};
  s.walls = {plane("floor", "soft", {0, 0, -0.02}, {0, 0, 1}), plane("west", "hard", {-0.05, 0, 0}, {1, 0, 0}),
             plane("south", "hard", {0, -0.05, 0}, {0, 1, 0}), plane("north", "soft", {0, 0.05, 0}, {0, -1, 0}),
             plane("east", "hard", {0.05, 0, 0}, {-1, 0, 0})};
  WallSpec gate;  // a shelf above the floor
  gate.name = "gate";
  gate.kind = "mesh";
  gate.material = "hard";
  gate.vertices = {{-0.06, -0.06, 0}, {0.06, -0.06, 0}, {0.06, 0.06, 0}, {-0.06, 0.06, 0}};
  gate.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.walls.push_back(gate);
  s.walls[3].motion = WallMotion::translation;
  s.walls[3].velocity = {0, -0.5, 0};
  s.regions = {box_region("bed", {-0.05, -0.05, 0}, {0.05, 0.05, 0.06}),
               box_region("above", {-0.045, -0.045, 0.07}, {0.045, 0.045, 0.13}),
               box_region("left", {-0.06, -0.06, -0.02}, {0, 0.06, 0.2}),
               box_region("drain", {-0.06, -0.06, -0.03}, {0, 0.06, -0.008})};
  RegionSpec pipe;
  pipe.name = "pipe";
  pipe.kind = "cylinder";
  pipe.centre = {0.01, 0.02, 0.1};
  pipe.axis = {0, 0.3, 1};
  pipe.radius = 0.02;
  pipe.height = 0.03;
  s.regions.push_back(pipe);
  s.species = {{"first", "", "", "", {}}, {"second", "", "", "", {}}, {"left", "", "", "", {}}};
  FillSpec fill;
  fill.region = "bed";
  fill.count = 60;
  fill.arrangement = Arrangement::random;
  fill.velocity = {0, 0, -4};
  fill.items = {item("ball", "soft", 0.7, 1.0, "first"), item("egg", "hard", 0.7, 1.0, "first")};
  fill.items[0].distribution = SizeDistribution::lognormal;
  fill.items[0].median = 0.85;
  fill.items[0].sigma = 0.2;
  s.fills = {fill};
  RainSpec rain;
  rain.name = "shower";
  rain.region = "pipe";
  rain.rate = 0x1p11;
  rain.velocity = {0, 0, -2};
  rain.items = {item("ball", "hard", 0.6, 0.9, "second"), item("egg", "soft", 0.6, 0.8)};
  RainSpec later = rain;
  later.name = "later";
  later.region = "above";
  later.rate = 0;
  later.mass_rate = 0x1p-1;
  later.count = 15;
  later.items[0].distribution = SizeDistribution::table;
  later.items[0].table = {{0.5, 1}, {0.75, 2}, {1, 0.5}};
  later.items[0].share_by = ShareBy::mass;
  s.rains = {rain, later};
  OutletSpec conveyor, drain;
  conveyor.name = "conveyor";
  conveyor.point = {0, 0, -0.005};
  conveyor.normal = {-1, 0, 2};
  conveyor.recycle_to = "above";
  conveyor.velocity = {0, 0.5, -1};
  drain.name = "drain";
  drain.region = "drain";
  s.outlets = {drain, conveyor};
  const auto at = [&](const std::string& name, int step) { return event(name, step * dt); };
  EventSpec slip = at("slip", 150);
  slip.friction = 0.9;
  slip.a = "soft";
  slip.b = "hard";
  EventSpec push = at("push", 200);
  push.start_motion = "north";
  EventSpec open;
  open.name = "open";
  open.when = "contacts_per_body > 0.05 and step > 250";
  open.delay = 20 * dt;
  open.remove_wall = "gate";
  EventSpec hold = at("hold", 400);
  hold.stop_motion = "north";
  hold.start_rain = "later";
  hold.stop_rain = "shower";
  hold.species = "left";
  hold.region = "left";
  EventSpec turn = at("turn", 450);
  turn.gravity = {-40, 10, -120};
  EventSpec again = at("again", 500);
  again.start_motion = "north";
  again.start_rain = "shower";
  EventSpec shut = at("shut", 560);
  shut.stop_motion = "north";
  s.events = {slip, push, open, hold, turn, again, shut};
  s.events[5].start_rain.clear();  // "shower" rains from the start: an event that starts it would hold it back
  return s;
}
constexpr std::uint64_t in_time_steps = 700;

}  // namespace dem::scenes
