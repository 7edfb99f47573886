// What laws take of the shapes that meet: law.map.
#include <gtest/gtest.h>

#include <numbers>

#include "libdem/broad_phase/candidates.h"
#include "libdem/forces.h"
#include "libdem/law_map.h"
#include "libdem/scene/where.h"
#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

constexpr double pi = std::numbers::pi;

Scene elastic(const std::vector<ShapeSpec>& shapes, LawMap map) {
  Scene s;
  s.law.map = map;
  s.materials = {scenes::material("glass", 7e10, 2500, 1, 0)};
  s.materials[0].poisson = 0.3;
  s.shapes = shapes;
  s.run.steps = 1;
  s.run.dt = 1e-9;
  s.run.dt_auto = false;
  s.run.max_initial_overlap = 1;
  s.run.skin = 2 * shapes[0].radius;
  return s;
}
// E* of two of them.
constexpr double young_eff = 7e10 / (2 * (1 - 0.3 * 0.3));

// Moves a body by hand and asks for the forces as they stand.
void place(World& w, std::size_t i, const Vec3d& position, const Quatd& orientation) {
  w.particles.motion[i].position = position;
  w.particles.orientation[i] = orientation;
}
void answer(World& w) {
  rebuild_candidates(w, 1);
  compute_forces(w, 1, 0);
}

// A body that goes round a closed path: of time u in [0, 1), with its rates.
struct Pose {
  Vec3d position, velocity;
  Quatd orientation;
  Vec3d spin;
};
struct Lap {
  double work = 0;    // of the force on the body, J: what the contact gives
  double stored = 0;  // largest, J
};
// `before` is called before each look at the forces. The rule of trapezoids: of a smooth closed path its error falls
// faster than any power.
template <class Path, class Before>
Lap lap(World& w, std::size_t moving, const Path& path, int steps, const Before& before) {
  Lap out;
  for (int i = 0; i < steps; ++i) {
    const Pose p = path(static_cast<double>(i) / steps);
    place(w, moving, p.position, p.orientation);
    before(w);
    answer(w);
    const Vec3d& f = w.particles.force[moving];
    out.work += (dot(f, p.velocity) + dot(w.particles.torque[moving], p.spin)) / steps;
    out.stored = std::max(out.stored, energies(w).elastic);
  }
  return out;
}
const auto as_it_is = [](World&) {};

// A 2:1:1 ellipsoid, tilted between 0.2 and 0.5 rad and pressed in more and less, a quarter lap behind, while it rolls
// along its shape: over a floor, or over the middle of another one that lies there.
struct Rolling {
  double floor;  // m, height of what it rolls over
  Pose operator()(double u) const {
    const double w = 2 * pi, angle = 0.35 + 0.15 * std::sin(w * u), rate = 0.15 * w * std::cos(w * u);
    const double s = std::sin(angle), c = std::cos(angle), a2 = 4e-6, b2 = 1e-6;
    const double h = std::sqrt(a2 * s * s + b2 * c * c), dh = (a2 - b2) * s * c / h;  // to the lowest point, of angle
    const double x = (a2 - b2) * s * c / h, dx = (a2 - b2) * (c * c - s * s) / h - x * dh / h;  // how far before it
    const double deep = 1e-5 * (1 + 0.7 * std::cos(w * u)), sinks = -0.7e-5 * w * std::sin(w * u);
    return {
        {-x, 0, floor + h - deep}, {-dx * rate, 0, dh * rate - sinks}, scenes::turn({0, 1, 0}, angle), {0, rate, 0}};
  }
};

TEST(LawMaps, FixedCurvatureGivesNothing) {
  for (const bool pair : {false, true}) {
    Scene s = elastic({scenes::ellipsoid("egg", {0.002, 0.001, 0.001})}, LawMap::curvature);
    s.run.skin = 0.004;
    const Rolling path{pair ? 0.001 : 0};
    s.bodies = {scenes::body("egg", "glass", {0, 0, 0.1})};
    if (pair) s.bodies.push_back(scenes::body("egg", "glass", {}));
    if (!pair) s.walls = {scenes::plane("floor", "glass", {}, {0, 0, 1})};
    World w = build_world(s);
    const std::size_t moving = scenes::place(w, 0);
    const Lap fixed = lap(w, moving, path, 256, as_it_is);
    ASSERT_EQ(std::count(w.contacts.touching.begin(), w.contacts.touching.end(), 1), 1);
    EXPECT_NEAR(fixed.work / fixed.stored, 0, 1e-10);
    const Lap finer = lap(w, moving, path, 512, as_it_is);
    EXPECT_NEAR(finer.work / finer.stored, 0, 1e-10);
    // Read anew at every step it gives or takes work: the test can see that.
    const auto forget = [](World& world) {
      std::fill(world.contacts.memory.begin(), world.contacts.memory.end(), 0.0);
    };
    const Lap naive = lap(w, moving, path, 256, forget);
    EXPECT_GT(std::abs(naive.work), 0.1 * naive.stored);
    RecordProperty(pair ? "pair, fixed" : "floor, fixed", std::to_string(fixed.work / fixed.stored));
    RecordProperty(pair ? "pair, naive" : "floor, naive", std::to_string(naive.work / naive.stored));
  }
}

// Johnson's ellipse, by the figures of an ellipsoid (2, 1, 1) mm pressed on a rigid flat along a short axis and on its
// tip: 10 N at these overlaps.
TEST(LawMaps, EllipticalHertz) {
  for (const auto& [overlap, turn, height] :
       {std::tuple(2.60050e-6, 0.0, 0.001), std::tuple(4.23687e-6, pi / 2, 0.002)}) {
    Scene s = elastic({scenes::ellipsoid("egg", {0.002, 0.001, 0.001})}, LawMap::curvature);
    s.materials[0].young = 38.46e9 * (1 - 0.3 * 0.3);
    s.materials.push_back(scenes::material("rigid", 0, 2500, 1, 0));
    s.materials[1].rigid = true;
    s.walls = {scenes::plane("floor", "rigid", {}, {0, 0, 1})};
    s.bodies = {scenes::body("egg", "glass", {0, 0, height - overlap}, {}, {}, scenes::turn({0, 1, 0}, turn))};
    const World w = build_world(s);
    EXPECT_NEAR(w.particles.force[0].z, 10, 10 * 1.5 * 0.5e-11 / overlap);
    EXPECT_NEAR(energies(w).elastic, 0.4 * w.particles.force[0].z * overlap, 1e-12 * overlap);
  }
}

// Where all that meets is a sphere or a flat wall, not a bit changes; in stages too, when another shape is there.
TEST(LawMaps, SpheresKeepTheirBits) {
  for (const bool others : {false, true}) {
    Scene s = scenes::every_shape(40);
    s.fills[0].items = {{"ball", "soft", 1, 0.7, 1.0}};
    if (!others) s.shapes.resize(1);
    s.law.map = LawMap::automatic;
    const World before = scenes::run(s, 400);
    s.law.map = LawMap::curvature;
    const World after = scenes::run(s, 400);
    EXPECT_EQ(after.contacts.words > 0, others);
    EXPECT_GT(before.counters.contact_steps, 1000u);
    EXPECT_EQ(before.counters.contact_steps, after.counters.contact_steps);
    for (std::uint64_t id = 0; id < 40; ++id) {
      EXPECT_EQ(scenes::motion(before, id).position, scenes::motion(after, id).position);
      EXPECT_EQ(scenes::motion(before, id).spin, scenes::motion(after, id).spin);
    }
  }
}

// The word of the map lives with the record: the same bits for any list, thread count and restart.
TEST(LawMaps, CurvatureIsPartOfTheState) {
  Scene s = scenes::every_shape(60);
  s.law.map = LawMap::curvature;
  s.fills[0].items = {{"ball", "soft", 1, 0.7, 1.0}, {"egg", "hard", 2, 0.7, 1.0}};
  const World one = scenes::run(s, 400);
  EXPECT_GT(one.counters.contact_steps, 1000u);
  const std::uint64_t hash = state_hash(one);
  World resumed = build_world(s);
  load_state(resumed, save_state(scenes::run(s, 200)));
  for (int i = 0; i < 200; ++i) advance(resumed, 1);
  EXPECT_EQ(state_hash(resumed), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 400, 2)), hash);
}

TEST(LawMaps, EdgeRadius) {
  constexpr double edge = 1e-4, overlap = 1e-6;
  const double hertz = 4.0 / 3.0 * young_eff * overlap * std::sqrt(overlap);
  const auto force = [&](const std::vector<ShapeSpec>& shapes, const std::string& a, const std::string& b,
                         double distance) {
    Scene s = elastic(shapes, LawMap::edge_radius);
    s.law.edge_radius = edge;
    s.run.skin = 0.002;
    s.bodies = {scenes::body(a, "glass", {0, 0, 0}), scenes::body(b, "glass", {0, 0, distance - overlap})};
    return build_world(s).particles.force[1].z;
  };
  const std::vector<ShapeSpec> shapes = {scenes::box("cube", {0.002, 0.002, 0.002}), scenes::sphere("ball", 0.001)};
  EXPECT_NEAR(force(shapes, "cube", "cube", 0.002), hertz * std::sqrt(edge / 2), 1e-9 * hertz);
  EXPECT_NEAR(force(shapes, "cube", "ball", 0.002), hertz * std::sqrt(edge * 0.001 / (edge + 0.001)), 1e-9 * hertz);
  EXPECT_NEAR(force(shapes, "ball", "ball", 0.002), hertz * std::sqrt(0.0005), 1e-9 * hertz);
  // Prisms 10 mm thick that touch along it, by the same law.
  Scene s = scenes::plane_scene(1, 0);
  s.law.name = LawName::hertz_mindlin;
  s.law.map = LawMap::edge_radius;
  s.law.edge_radius = edge;
  s.gravity = {};
  s.materials[0].young = 7e10;
  s.materials[0].poisson = 0.3;
  s.shapes = {scenes::regular_polygon("square", 4, 0.001 * std::sqrt(2))};
  s.walls = {scenes::line("floor", {}, {0, 1, 0})};
  s.run.max_initial_overlap = 1;
  double least = 1;  // one of both lies on a side
  for (const double angle : {0.0, pi / 4}) {
    s.bodies = {scenes::body("square", "soft", {0, 0.001 - overlap, 0}, {}, {}, scenes::turn({0, 0, 1}, angle))};
    const double deep = hertz * std::sqrt(edge);
    least = std::min(least, std::abs(build_world(s).particles.force[0].y / deep - 1));
  }
  EXPECT_LT(least, 1e-9);
}

// Two glass spheres by the volume of their lens against Hertz, figures of the literature's potential to their digits;
// and the force in closed form.
TEST(LawMaps, VolumeOfSpheres) {
  for (const auto& [depth, ratio, digits] :
       {std::tuple(1e-3, 0.99971, 5e-6), std::tuple(1e-2, 0.9971, 5e-5), std::tuple(5e-2, 0.9854, 5e-5)}) {
    Scene s = elastic({scenes::sphere("ball", 0.001)}, LawMap::volume);
    const double overlap = depth * 0.001;
    s.bodies = {scenes::body("ball", "glass", {}), scenes::body("ball", "glass", {0, 0, 0.002 - overlap})};
    const World w = build_world(s);
    const double force = w.particles.force[scenes::place(w, 1)].z;
    EXPECT_NEAR(force / (4.0 / 3.0 * young_eff * std::sqrt(0.0005) * overlap * std::sqrt(overlap)), ratio, digits);
    const double h = 0.5 * overlap, volume = 2 * pi / 3 * h * h * (0.003 - h), section = pi * h * (0.002 - h);
    const double energy = 8.0 / 15.0 * young_eff * std::sqrt(0.0005) * std::pow(volume / (pi * 0.0005), 1.25);
    EXPECT_NEAR(force, 1.25 * energy / volume * section, 1e-10 * force);
    EXPECT_NEAR(energies(w).elastic, energy, 1e-10 * energy);
  }
}

// A body led round and round: shifts and a turn about a fixed axis, all of them closed.
struct Wander {
  Vec3d middle, swing, phase;  // m, m, turns
  Vec3d axis;
  double angle, sway;  // rad
  Pose operator()(double u) const {
    const double w = 2 * pi;
    Pose p;
    for (int k = 0; k < 3; ++k) {
      p.position[k] = middle[k] + swing[k] * std::sin(w * (u + phase[k]));
      p.velocity[k] = w * swing[k] * std::cos(w * (u + phase[k]));
    }
    p.orientation = scenes::turn(axis, angle + sway * std::sin(w * u + 0.5));
    p.spin = axis * (w * sway * std::cos(w * u + 0.5));
    return p;
  }
};

// What meets: faces with faces, edges and corners, with and without an edge of another face across them.
struct Meeting {
  const char* name;
  ShapeSpec moving, resting;  // no name: a floor
  Wander path;
};
std::vector<Meeting> meetings() {
  const ShapeSpec cube = scenes::box("cube", {0.002, 0.002, 0.002});
  ShapeSpec four = scenes::points(
      "four", {{0.001, 0.001, 0.001}, {0.001, -0.001, -0.001}, {-0.001, 0.001, -0.001}, {-0.001, -0.001, 0.001}});
  const Vec3d tilted = Vec3d{1, 2, 0.5} * (1 / std::sqrt(5.25));
  return {
      {"face on face", cube, cube, {{0.0004, 0.0003, 0.00197}, {2e-4, 3e-4, 1e-5}, {0, 0.2, 0.6}, {0, 0, 1}, 0.1, 0.3}},
      {"edge, face, corner",
       cube,
       cube,
       {{0.0004, 0.0003, 0.0021}, {5e-4, 3e-4, 1.2e-4}, {0, 0.3, 0.1}, tilted, 0.1, 0.25}},
      {"edge over edge", four, four, {{0.0001, 0, 0.00193}, {3e-4, 2e-4, 4e-5}, {0, 0.2, 0.4}, tilted, 0.05, 0.15}},
      {"tetrahedra", four, four, {{0.0006, 0.0004, 0.0009}, {2e-4, 2e-4, 2e-4}, {0, 0.3, 0.15}, tilted, 0.4, 0.3}},
      {"cube on a floor", cube, {}, {{0, 0, 0.0012}, {5e-4, 3e-4, 2e-4}, {0, 0.3, 0.1}, tilted, 0.2, 0.25}},
      {"egg on a floor",
       scenes::ellipsoid("egg", {0.002, 0.001, 0.0014}),
       {},
       {{0, 0, 0.0013}, {5e-4, 3e-4, 1e-4}, {0, 0.3, 0.1}, tilted, 0.3, 0.25}},
  };
}
World world_of(const Meeting& m) {
  Scene s = elastic({m.moving}, LawMap::volume);
  s.run.skin = 0.002;
  s.bodies = {scenes::body(m.moving.name, "glass", {0, 0, 0.1})};
  if (m.resting.name.empty()) {
    s.walls = {scenes::plane("floor", "glass", {}, {0, 0, 1})};
  } else {
    if (m.resting.name != m.moving.name) s.shapes.push_back(m.resting);
    s.bodies.push_back(scenes::body(m.resting.name, "glass", {}));
  }
  return build_world(s);
}

// Force and torque are minus the slope of the energy, in place and angle.
TEST(LawMaps, VolumeForceIsASlope) {
  for (const Meeting& m : meetings()) {
    World w = world_of(m);
    const std::size_t moving = scenes::place(w, 0);
    int touching = 0;
    double worst = 0, most = 0;
    for (int i = 0; i < 40; ++i) {
      const Pose pose = m.path(i / 40.0);
      place(w, moving, pose.position, pose.orientation);
      answer(w);
      const Vec3d force = w.particles.force[moving], torque = w.particles.torque[moving];
      if (dot(force, force) == 0) continue;
      ++touching;
      most = std::max(most, scenes::length(force));
      const auto energy = [&](const Vec3d& shift, const Vec3d& axis, double angle) {
        place(w, moving, pose.position + shift, scenes::turn(axis, angle) * pose.orientation);
        answer(w);
        return energies(w).elastic;
      };
      for (int k = 0; k < 3; ++k) {
        Vec3d e{};
        e[k] = 1;
        const double h = 1e-8;
        worst = std::max(worst, std::abs((energy(e * h, e, 0) - energy(e * -h, e, 0)) / (2 * h) + force[k]));
        const double turn = 1e-5;
        worst =
            std::max(worst, std::abs((energy({}, e, turn) - energy({}, e, -turn)) / (2 * turn) + torque[k]) / 0.001);
      }
    }
    EXPECT_GT(touching, 8) << m.name;
    EXPECT_LT(worst, 1e-7 * most) << m.name;
  }
}

// Work per lap over the largest stored energy: what the rule of trapezoids leaves where corners come into faces, which
// is of second order at the least.
TEST(LawMaps, VolumeGivesNothing) {
  for (const Meeting& m : meetings()) {
    World w = world_of(m);
    const Lap l = lap(w, scenes::place(w, 0), m.path, 8000, as_it_is);
    EXPECT_NEAR(l.work / l.stored, 0, 2e-9) << m.name;
    RecordProperty(m.name, std::to_string(l.work / l.stored));
  }
}

Scene falling_together() {
  Scene s = scenes::every_shape(1);
  s.law.map = LawMap::volume;
  s.gravity = {};
  s.walls.clear();
  s.fills[0].count = 27;
  s.fills[0].velocity = {};
  s.fills[0].items = {{"brick", "soft", 2, 0.6, 0.8}, {"wedge", "hard", 1, 0.7, 0.9}};
  s.fills[0].lower = {-0.025, -0.025, -0.025};
  s.fills[0].upper = {0.025, 0.025, 0.025};
  return s;
}
// The largest change of the energy, with what the ledger has booked as lost, over that at the start.
double largest_change(const Scene& s, double& lost) {
  World w = build_world(s);
  for (Motion& m : w.particles.motion) m.velocity = m.position * -10.0;
  const auto energy = [&] {
    const Energies e = energies(w);
    lost = 0;
    for (const double x : dissipated(w)) lost += x;
    return e.translational + e.rotational + e.elastic + lost;
  };
  const double start = energy();
  double most = 0;
  while (w.time() < 0.05) {
    advance(w, 1);
    most = std::max(most, std::abs(energy() / start - 1));
  }
  EXPECT_GT(w.counters.contact_steps, 10000u);
  lost /= start;
  return most;
}

// Bricks that fall together without friction and fly apart: what is left of the energy is that of the step, where by
// their depth alone they win three in a hundred.
TEST(LawMaps, VolumeKeepsTheEnergyOfBricks) {
  Scene s = falling_together();
  for (MaterialSpec& m : s.materials) m.restitution = 1, m.friction = 0;
  double lost = 0;
  const double most = largest_change(s, lost);
  EXPECT_LT(most, 1e-6);
  RecordProperty("most", std::to_string(most));
}

// With dashpots and friction what is lost is what the ledger says.
TEST(LawMaps, VolumeLedgerCloses) {
  Scene s = falling_together();
  s.law.ledger = true;
  double lost = 0;
  const double most = largest_change(s, lost);
  EXPECT_GT(lost, 0.1);
  EXPECT_LT(most, 2e-4);
}

// Prisms: a square on a line, and discs as they are by their depth where that is small.
TEST(LawMaps, VolumeOfPrisms) {
  Scene s = scenes::plane_scene(1, 0);
  s.law.name = LawName::hertz_mindlin;
  s.law.map = LawMap::volume;
  s.gravity = {};
  s.materials[0].young = 7e10;
  s.materials[0].poisson = 0.3;
  s.run.max_initial_overlap = 1;
  s.shapes = {
      scenes::polygon("square", {{-0.001, -0.001, 0}, {0.001, -0.001, 0}, {0.001, 0.001, 0}, {-0.001, 0.001, 0}}),
      scenes::disc("disc", 0.001)};
  s.walls = {scenes::line("floor", {}, {0, 1, 0})};
  const double overlap = 1e-6, radius = 0.002 / std::sqrt(pi), area = 0.002 * overlap;
  s.bodies = {scenes::body("square", "soft", {0, 0.001 - overlap, 0})};
  const World square = build_world(s);
  const double equal = std::cbrt(9 * area * area / (32 * radius));  // δ_eq
  const double energy = 8.0 / 15.0 * young_eff * std::sqrt(radius) * std::pow(equal, 2.5);
  EXPECT_NEAR(energies(square).elastic, energy, 1e-8 * energy);
  EXPECT_NEAR(square.particles.force[0].y, 5.0 / 3.0 * energy / overlap, 1e-8 * energy / overlap);
  s.bodies = {scenes::body("disc", "soft", {0, 0.001 - overlap, 0})};
  const World disc = build_world(s);
  EXPECT_NEAR(disc.particles.force[0].y / (4.0 / 3.0 * young_eff * std::sqrt(0.001) * std::pow(overlap, 1.5)), 1, 1e-3);
}

// Corners, sides and both of two prisms, over and under each other's.
TEST(LawMaps, VolumeOfPrismsGivesNothing) {
  Scene s = scenes::plane_scene(1, 0);
  s.law.name = LawName::hertz_mindlin;
  s.law.map = LawMap::volume;
  s.gravity = {};
  s.materials[0].young = 7e10;
  s.run.skin = 0.002;
  s.shapes = {scenes::regular_polygon("four", 4, 0.001), scenes::regular_polygon("five", 5, 0.001)};
  s.bodies = {scenes::body("four", "soft", {0, 0.1, 0}), scenes::body("five", "soft", {})};
  World w = build_world(s);
  const std::size_t moving = scenes::place(w, 0);
  const Wander path{{0.0003, 0.0015, 0}, {4e-4, 1.5e-4, 0}, {0, 0.3, 0}, {0, 0, 1}, 0.2, 0.7};
  const Lap l = lap(w, moving, path, 16000, as_it_is);
  EXPECT_GT(l.stored, 0);
  const Lap coarse = lap(w, moving, path, 4000, as_it_is);
  EXPECT_LT(std::abs(l.work), 2e-7 * l.stored);
  EXPECT_LT(std::abs(l.work), 0.15 * std::abs(coarse.work));  // of second order, as the corners that come and go
}

TEST(LawMaps, VolumeIsPartOfTheState) {
  Scene s = scenes::every_shape(40);
  s.law.map = LawMap::volume;
  s.walls.resize(4);
  s.walls[3].motion = WallMotion::fixed;
  s.fills[0].items = {{"brick", "soft", 1, 0.6, 0.8}, {"wedge", "hard", 1, 0.7, 0.9}};
  const World one = scenes::run(s, 2000);
  EXPECT_GT(one.counters.contact_steps, 1000u);
  const std::uint64_t hash = state_hash(one);
  World resumed = build_world(s);
  load_state(resumed, save_state(scenes::run(s, 1000)));
  for (int i = 0; i < 1000; ++i) advance(resumed, 1);
  EXPECT_EQ(state_hash(resumed), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 2000, 2)), hash);
}

// Refused before the run, by names of shape and map.
std::string refusal(const Scene& s) {
  try {
    build_world(s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(LawMaps, Refusals) {
  Scene s = elastic({scenes::box("brick", {0.002, 0.002, 0.002}), scenes::ellipsoid("egg", {0.002, 0.001, 0.001})},
                    LawMap::curvature);
  s.bodies = {scenes::body("egg", "glass", {}), scenes::body("brick", "glass", {0, 0, 1})};
  const std::string found = refusal(s);
  for (const char* word : {"law.map = \"curvature\"", "shape \"brick\"", "no curvature", "dem list maps"})
    EXPECT_NE(found.find(word), std::string::npos) << found;
  s.bodies.pop_back();
  EXPECT_EQ(refusal(s), "");
  const auto expect = [&](const std::vector<const char*>& words) {
    const std::string message = refusal(s);
    for (const char* word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
  };
  s.law.map = LawMap::volume;
  EXPECT_EQ(refusal(s), "");  // one body, no wall: nothing to meet
  s.bodies.push_back(s.bodies[0]);
  s.bodies[1].position = {0, 0, 1};
  expect({"law.map = \"volume\"", "shape \"egg\" (ellipsoid)", "no closed form"});
  s.bodies[1].shape = s.bodies[0].shape = "brick";
  EXPECT_EQ(refusal(s), "");
  s.method = "clip_volume";
  expect({"law.map = \"volume\"", "contact.method", "clip_volume"});
  s.method = "auto";
  s.law.normal = "jkr";
  s.materials[0].work_of_adhesion = 0.1;
  expect({"law.map = \"volume\"", "jkr", "across a gap"});
  s.law.normal = "";
  s.law.cohesion = "dmt";
  expect({"law.map = \"volume\"", "dmt", "not of the volume"});
  s.law.cohesion = "";
  s.walls = {scenes::random_floor("tray", "glass", 0.01, 2, -1, 1)};
  expect({"law.map = \"volume\"", "wall \"tray\" (mesh)", "no inside"});
}

}  // namespace
}  // namespace dem
