// Polygons that are not convex, in the loop: how a body was cut does not matter, a region is one contact with one
// stiffness and one memory, the same bits for threads, skins, resume and units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

using Pieces = std::vector<std::vector<Vec3d>>;
using scenes::line;
using scenes::plane_scene;
using scenes::polygon;

constexpr double mm = 0.001;

std::vector<Vec3d> scaled_by(double s, std::vector<Vec3d> v) {
  for (Vec3d& x : v) x *= s;
  return v;
}
Pieces scaled_by(double s, Pieces p) {
  for (auto& v : p) v = scaled_by(s, v);
  return p;
}
const std::vector<Vec3d> ell{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {4, 4, 0}, {4, 10, 0}, {0, 10, 0}};
const std::vector<Vec3d> arch{{0, 0, 0}, {3, 0, 0}, {3, 5, 0}, {9, 5, 0}, {9, 0, 0}, {12, 0, 0}, {12, 8, 0}, {0, 8, 0}};

std::vector<Vec3d> star() {
  std::vector<Vec3d> v;
  for (int i = 0; i < 10; ++i) {
    const double r = (i % 2 == 0 ? 7 : 3.5) * mm, angle = 3.14159265358979324 * i / 5;
    v.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return v;
}

// Two of the bodies meet in the air, turning, and fall on the floor.
std::uint64_t fate(const ShapeSpec& shape) {
  Scene s = plane_scene();
  s.shapes = {shape};
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0})};
  for (const double side : {-1.0, 1.0})
    s.bodies.push_back(scenes::body(shape.name, "soft", {9 * mm * side, (12 + side) * mm, 0}, {-0.5 * side, -0.2, 0},
                                    {0, 0, 20 * side}, scenes::turn({0, 0, 1}, side)));
  World w = build_world(s);
  while (w.time() < 0.06) advance(w, 1);
  EXPECT_GT(w.counters.contact_steps, 500u);
  return state_hash(w);
}

TEST(PolygonRegionsInTheLoop, HowABodyWasCutDoesNotMatter) {
  const std::vector<Vec3d> square{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  const std::uint64_t of_square = fate(polygon("body", scaled_by(mm, square)));
  for (const Pieces& cut : {Pieces{{square[0], square[1], square[2]}, {square[0], square[2], square[3]}},
                            Pieces{{square[3], square[0], square[1]}, {square[3], square[1], square[2]}}})
    EXPECT_EQ(fate(scenes::pieces("body", scaled_by(mm, cut))), of_square);
  const std::uint64_t of_ell = fate(polygon("body", scaled_by(mm, ell)));
  for (const Pieces& cut :
       {Pieces{{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {0, 4, 0}}, {{0, 4, 0}, {4, 4, 0}, {4, 10, 0}, {0, 10, 0}}},
        Pieces{{{0, 0, 0}, {4, 0, 0}, {4, 10, 0}, {0, 10, 0}}, {{4, 0, 0}, {10, 0, 0}, {10, 4, 0}, {4, 4, 0}}},
        Pieces{{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {4, 4, 0}}, {{0, 0, 0}, {4, 4, 0}, {4, 10, 0}, {0, 10, 0}}}})
    EXPECT_EQ(fate(scenes::pieces("body", scaled_by(mm, cut))), of_ell);
}

World at_rest(Scene s, double time) {
  World w = build_world(s);
  while (w.time() < time) advance(w, 1);
  return w;
}

TEST(PolygonRegionsInTheLoop, AnLOnALineHasTheStiffnessOfOneContact) {
  Scene s = plane_scene(0.1);
  s.shapes = {polygon("ell", scaled_by(mm, ell))};
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0})};
  // Of 64 mm²: 40 mm² at 2 mm and 24 mm² at 7 mm above the sole.
  s.bodies = {scenes::body("ell", "soft", {0, (40 * 2 + 24 * 7) / 64.0 * mm + 1e-6, 0})};
  const World w = at_rest(s, 0.5);
  const auto contacts = touching_contacts(w);
  ASSERT_EQ(contacts.size(), 1u);
  const double weight = 2500 * 0.01 * 64 * mm * mm * 9.81;
  EXPECT_NEAR(contacts[0].force.y, weight, 1e-6 * weight);
  EXPECT_LE(norm(w.particles.motion[0].velocity), 1e-8);
  // Its centre of mass is not over the middle of its sole: it leans until the patch is under it.
  EXPECT_NEAR(contacts[0].point.x, w.particles.motion[0].position.x, 1e-9);
  // Its sole is under by F/k in the middle, as two springs at its ends would have it.
  const Quatd& q = w.particles.orientation[0];
  const double turn = 2 * std::atan2(q.z, q.w);
  const Vec3d sole{5 * mm - 3.875 * mm, -3.875 * mm, 0};  // its middle, from the centre of mass
  const double deep = -(w.particles.motion[0].position.y + std::sin(turn) * sole.x + std::cos(turn) * sole.y);
  EXPECT_NEAR(deep, weight / 2e4, 1e-6 * weight / 2e4);
  const double ends = std::sin(turn) * 5 * mm;  // how far they lie above and below
  EXPECT_NEAR(contacts[0].overlap, std::hypot(deep, ends), 1e-6 * deep);
}

// Each foot keeps its own memory: held by friction on a slope of 0.3 with μ = 0.4.
TEST(PolygonRegionsInTheLoop, FeetOnASlopeHoldByTheirOwnFriction) {
  Scene s = plane_scene(0.1, 0.4);
  s.gravity = {0.3 * 9.81, -9.81, 0};
  s.shapes = {polygon("arch", scaled_by(mm, arch))};
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0})};
  // Of 66 mm²: two feet of 15 mm² at 2.5 mm and the bridge of 36 mm² at 6.5 mm.
  s.bodies = {scenes::body("arch", "soft", {0, (30 * 2.5 + 36 * 6.5) / 66 * mm + 1e-6, 0})};
  World w = at_rest(s, 0.3);
  const double start = w.particles.motion[0].position.x, weight = w.particles.mass[0] * 9.81;
  EXPECT_LE(std::abs(start), 1e-5);
  while (w.time() < 0.6) advance(w, 1);
  EXPECT_LE(std::abs(w.particles.motion[0].position.x - start), 1e-9);
  const auto contacts = touching_contacts(w);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_NEAR(contacts[0].force.y + contacts[1].force.y, weight, 1e-5 * weight);
  EXPECT_NEAR(contacts[0].force.x + contacts[1].force.x, -0.3 * weight, 1e-5 * weight);
  for (const ContactReport& c : contacts) EXPECT_LT(c.force.x, -0.05 * weight);
}

Scene tray() {
  return scenes::planar_tray(
      {scenes::disc("disc", 0.004), scenes::ellipse("egg", 0.003, 0.005), scenes::regular_polygon("five", 5, 0.005),
       polygon("ell", scaled_by(mm, ell)), polygon("arch", scaled_by(mm, arch)), polygon("star", star())},
      42);
}

TEST(PolygonRegionsInTheLoop, AMixedBedStaysInThePlaneAndWithinItsWalls) {
  const World w = scenes::run(tray(), 4000);
  EXPECT_GT(w.counters.contact_steps, 100000u);
  EXPECT_EQ(w.counters.not_converged, 0u);
  std::size_t pairs = 0, several = 0;
  const auto contacts = touching_contacts(w);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const bool again = k > 0 && contacts[k].a == contacts[k - 1].a && contacts[k].b == contacts[k - 1].b &&
                       contacts[k].wall == contacts[k - 1].wall;
    several += again ? 1 : 0;
    pairs += !again && !contacts[k].wall ? 1 : 0;
    EXPECT_LE(contacts[k].overlap, 1e-3) << k;
  }
  EXPECT_GT(several, 3u);
  EXPECT_DOUBLE_EQ(contacts_per_particle(w), static_cast<double>(pairs) / 42);
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Motion& m = w.particles.motion[i];
    EXPECT_TRUE(m.position.z == 0 && m.velocity.z == 0 && m.spin.x == 0 && m.spin.y == 0) << i;
    EXPECT_GT(m.position.y, 0) << i;
  }
}

TEST(PolygonRegionsInTheLoop, SameBitsForThreadsSkinsAndResume) {
  Scene s = tray();
  const std::uint64_t hash = state_hash(scenes::run(s, 1500));
  EXPECT_EQ(state_hash(scenes::run(s, 1500, 3)), hash);
  const World first = scenes::run(s, 900);
  World second = build_world(s);
  load_state(second, save_state(first));
  while (second.step < 1500) advance(second, 1);
  EXPECT_EQ(state_hash(second), hash);
  s.run.skin = 0.003;
  EXPECT_EQ(state_hash(scenes::run(s, 1500)), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 1500)), hash);
}

// Across the face of a periodic box bodies meet as anywhere: no two of them interpenetrate and the bits are the same
// for threads, skins and resume.
TEST(PolygonRegionsInTheLoop, APeriodicBedOfTheSameBits) {
  Scene s = tray();
  s.gravity = {0, -250, 0};
  s.walls.resize(1);  // the floor
  s.periodic.axes = "x";
  s.periodic.lower = {-0.055, 0, 0};
  s.periodic.upper = {0.055, 0, 0};
  World w = build_world(s);
  std::size_t across = 0;
  while (w.step < 1500) {
    advance(w, 1);
    if (w.step % 50 != 0) continue;
    for (const ContactReport& c : touching_contacts(w)) {
      EXPECT_LE(c.overlap, 1e-3);
      if (c.wall) continue;
      across += std::abs(scenes::motion(w, c.a).position.x - scenes::motion(w, c.b).position.x) > 0.05 ? 1 : 0;
    }
  }
  const std::uint64_t hash = state_hash(w);
  EXPECT_GT(across, 0u);
  EXPECT_EQ(state_hash(scenes::run(s, 1500, 3)), hash);
  World second = build_world(s);
  load_state(second, save_state(scenes::run(s, 800)));
  while (second.step < 1500) advance(second, 1);
  EXPECT_EQ(state_hash(second), hash);
  s.run.skin = 0.003;
  EXPECT_EQ(state_hash(scenes::run(s, 1500)), hash);
}

TEST(PolygonRegionsInTheLoop, UnitsScaleBitForBit) {
  const Scene s = tray();
  const World a = scenes::run(s, 1200), b = scenes::run(scenes::planar_restated(s, 10, 6, 3), 1200);
  EXPECT_GT(a.counters.contact_steps, 10000u);
  EXPECT_EQ(a.counters.contact_steps, b.counters.contact_steps);
  for (std::uint64_t id = 0; id < a.particles.count(); ++id) {
    const Motion &x = scenes::motion(a, id), &y = scenes::motion(b, id);
    EXPECT_TRUE(x.position * 0x1p10 == y.position) << id;
    EXPECT_EQ(x.spin.z / 0x1p3, y.spin.z) << id;
  }
}

}  // namespace
}  // namespace dem
