// Walls along chains of sides: where the chain is straight they are lines, its joints give no normal of their own, both
// sides of a corner are met; at rest and in motion, open and closed, and the bits depend on nothing but the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "libdem/io/surfaces.h"
#include "tests/libdem/same_bits.h"
#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

using Chain = std::vector<Vec3d>;

Scene bodies_of_every_kind() {
  Scene s = scenes::plane_scene();
  s.shapes = {scenes::disc("disc", 0.004), scenes::ellipse("egg", 0.005, 0.0035),
              scenes::polygon("brick", {{0, 0, 0}, {0.009, 0, 0}, {0.009, 0.006, 0}, {0, 0.006, 0}}),
              scenes::polygon("arch", {{0, 0, 0},
                                       {0.002, 0, 0},
                                       {0.002, 0.003, 0},
                                       {0.006, 0.003, 0},
                                       {0.006, 0, 0},
                                       {0.008, 0, 0},
                                       {0.008, 0.005, 0},
                                       {0, 0.005, 0}})};
  return s;
}

void add_grid(Scene& s, const std::vector<std::string>& shapes, const Vec3d& from, int columns, int rows) {
  for (int i = 0; i < columns * rows; ++i) {
    const int row = i / columns;
    s.bodies.push_back(scenes::body(shapes[static_cast<std::size_t>(i) % shapes.size()], "soft",
                                    from + Vec3d{0.012 * (i % columns), 0.012 * row, 0}, {0.1 * (i % 3) - 0.1, -1, 0},
                                    {0, 0, 5.0 * (i % 2)}));
  }
}

const std::vector<std::string> every_kind{"disc", "egg", "brick", "arch"};

// Straight chains of many vertices, level and leaning, with a bend out of reach that keeps the wall from being convex:
// a body that lands, bounces, turns and slides over the joints moves as over a line, to round-off.
TEST(PolylineWalls, AStraightChainIsALine) {
  const double slope = 0.75;
  for (const std::string& shape : every_kind)
    for (const bool leaning : {false, true}) {
      const auto at = [&](double x) { return Vec3d{x, leaning ? slope * x : 0, 0}; };
      Scene s = bodies_of_every_kind();
      s.bodies = {scenes::body(shape, "soft", at(0.004) + Vec3d{0, 0.011, 0}, {0.3, -0.4, 0}, {0, 0, 9},
                               scenes::turn({0, 0, 1}, 0.3))};
      s.walls = {scenes::polyline(
          "chain", {at(-0.5), at(-0.01), at(0.003), at(0.0055), at(0.008), at(0.02), at(0.5), {0.6, 1, 0}}, 0.05)};
      const World chain = scenes::run(s, 12000);
      EXPECT_EQ(chain.walls[0].polygon->parts.size(), 2u);
      s.walls = {scenes::line("line", {0, 0, 0}, leaning ? Vec3d{-slope, 1, 0} : Vec3d{0, 1, 0})};
      const World line = scenes::run(s, 12000);
      EXPECT_GT(chain.counters.contact_steps, 150u) << shape;
      EXPECT_EQ(chain.counters.contact_steps, line.counters.contact_steps) << shape;
      EXPECT_EQ(chain.time_step.dt, line.time_step.dt);
      const Motion &a = chain.particles.motion[0], &b = line.particles.motion[0];
      EXPECT_GT(norm(a.position - s.bodies[0].position), 0.01) << shape;
      EXPECT_LT(norm(a.position - b.position), 1e-9 * 0.01) << shape;
      EXPECT_LT(norm(a.velocity - b.velocity), 1e-9) << shape;
      EXPECT_LT(norm(a.spin - b.spin), 1e-6) << shape;
    }
}

// A disc in a concave corner is held by both sides, each with its own normal and depth.
TEST(PolylineWalls, BothSidesOfAConcaveCornerAreMet) {
  Scene s = bodies_of_every_kind();
  s.run.max_initial_overlap = 0.1;
  s.walls = {scenes::polyline("corner", {{-0.04, 0.03, 0}, {0, 0, 0}, {0.03, 0.04, 0}}, 0.01)};
  const Vec3d left{0.6, 0.8, 0}, right{-0.8, 0.6, 0};
  s.bodies = {scenes::body("disc", "soft", (0.004 - 2e-5) * left + (0.004 - 1e-5) * right)};
  const auto contacts = touching_contacts(build_world(s));
  ASSERT_EQ(contacts.size(), 2u);
  for (const ContactReport& c : contacts) {
    const bool of_left = c.normal.x < 0;
    EXPECT_LT(norm(c.normal + (of_left ? left : right)), 1e-12);
    EXPECT_NEAR(c.overlap, of_left ? 2e-5 : 1e-5, 1e-15);
  }
}

// Over a convex corner the normal turns from one side's to the other's, with one contact at all times.
TEST(PolylineWalls, AConvexCornerIsPassedWithOneContact) {
  Scene s = bodies_of_every_kind();
  s.run.max_initial_overlap = 0.1;
  s.walls = {scenes::polyline("ridge", {{-0.04, -0.03, 0}, {0, 0, 0}, {0.03, -0.04, 0}}, 0.01)};
  for (int i = 0; i <= 40; ++i) {  // from the normal of the left side to that of the right
    const double first = std::atan2(0.8, -0.6), last = std::atan2(0.6, 0.8), angle = first + (last - first) * i / 40;
    const Vec3d n{std::cos(angle), std::sin(angle), 0};
    s.bodies = {scenes::body("disc", "soft", (0.004 - 1e-5) * n)};
    const auto contacts = touching_contacts(build_world(s));
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_LT(norm(contacts[0].normal + n), 1e-9);
    EXPECT_NEAR(contacts[0].overlap, 1e-5, 1e-13);
  }
}

Scene hopper() {
  Scene s = bodies_of_every_kind();
  s.walls = {scenes::polyline(
      "hopper", {{-0.04, 0.1, 0}, {-0.04, 0.04, 0}, {-0.012, 0, 0}, {0.012, 0, 0}, {0.04, 0.04, 0}, {0.04, 0.1, 0}},
      0.004)};
  add_grid(s, every_kind, {-0.03, 0.036, 0}, 6, 6);
  return s;
}

TEST(PolylineWalls, AHopperOfOneChainHoldsABedAndItsWeight) {
  Scene s = hopper();
  s.materials[0].friction = 0.2;
  const World w = scenes::run(s, 60000);
  double weight = 0;
  for (const double m : w.particles.mass) weight += 9.81 * m;
  EXPECT_NEAR(-w.walls[0].force.y, weight, 0.02 * weight);
  EXPECT_NEAR(w.walls[0].force.x, 0, 0.02 * weight);
  EXPECT_EQ(w.counters.not_converged + w.counters.uncertified, 0u);
  for (const Motion& m : w.particles.motion) {
    EXPECT_GT(m.position.y, 0.0024);
    EXPECT_LT(m.position.y, 0.09);
    EXPECT_GT(m.position.y, (std::abs(m.position.x) - 0.012) * (0.04 / 0.028));
  }
}

// A drum is a closed chain: it turns the bodies within it and keeps them.
Scene drum(const std::vector<std::string>& shapes) {
  Scene s = bodies_of_every_kind();
  Chain circle;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2 * 3.14159265358979324 * i / 20;
    circle.push_back({0.01 + 0.04 * std::cos(angle), 0.02 + 0.04 * std::sin(angle), 0});
  }
  s.walls = {scenes::polyline("drum", circle, 0.005, true)};
  s.walls[0].motion = WallMotion::rotation;
  s.walls[0].axis = {0, 0, 1};
  s.walls[0].centre = {0.01, 0.02, 0};
  s.walls[0].rate = 5;
  add_grid(s, shapes, {-0.014, -0.004, 0}, 5, 5);
  return s;
}

TEST(PolylineWalls, ADrumIsAClosedChainThatTurns) {
  const Scene s = drum(every_kind);
  const World w = scenes::run(s, 60000);
  EXPECT_EQ(w.walls[0].polygon->parts.size(), 20u);
  EXPECT_LT(norm(w.walls[0].reference - Vec3d{0.01, 0.02, 0}), 1e-15);
  Vec3d centre{};
  double mass = 0;
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Motion& m = w.particles.motion[i];
    EXPECT_LT(norm(m.position - s.walls[0].centre), 0.04 - 0.0024);
    centre += w.particles.mass[i] * m.position;
    mass += w.particles.mass[i];
  }
  centre *= 1 / mass;
  EXPECT_GT(centre.x, 0.012) << "a drum that turns counter-clockwise carries its bed up on the right";
  EXPECT_LT(centre.y, 0.02);
  EXPECT_LT(w.walls[0].torque.z, 0) << "the bed hangs back";
}

// A servo presses the lid of a box, both of them chains, onto a bed: the lid bears what it was told to.
TEST(PolylineWalls, AServoPressesWithAChain) {
  Scene s = bodies_of_every_kind();
  s.gravity = {};
  s.walls = {scenes::polyline("box", {{-0.03, 0.08, 0}, {-0.03, 0, 0}, {0.03, 0, 0}, {0.03, 0.08, 0}}, 0.005),
             scenes::polyline("lid", {{0.0299, 0.06, 0}, {0, 0.061, 0}, {-0.0299, 0.06, 0}}, 0.005)};
  s.walls[1].motion = WallMotion::servo;
  s.walls[1].axis = {0, -1, 0};
  s.walls[1].target_force = 20;
  s.walls[1].speed_limit = 0.5;
  add_grid(s, every_kind, {-0.024, 0.006, 0}, 5, 4);
  const World w = scenes::run(s, 40000);
  EXPECT_NEAR(w.walls[1].force.y, 20, 0.2);
  EXPECT_NEAR(w.walls[0].force.y, -20, 0.2);
}

TEST(PolylineWalls, SameBitsForThreadsSkinsRebuildsAndAResume) {
  scenes::expect_same_bits(hopper(), 6000);
  const World w = scenes::expect_same_bits(drum(every_kind), 6000);
  EXPECT_GT(norm(w.walls[0].force), 0);
}

// What files and pictures show of such a wall is its area, a ring's without its hole.
TEST(PolylineWalls, TheSurfaceIsTheWholeBand) {
  for (const Scene& s : {hopper(), drum({"disc"})}) {
    const World w = build_world(s);
    const io::WallSurface surface = io::wall_surfaces(w, {}).front();
    double area = 0, outline = 0, border = 0;
    for (std::size_t p = 0, first = 0; p < surface.ends.size(); first = surface.ends[p++]) {
      const std::size_t last = surface.ends[p];
      const auto at = [&](std::size_t k) { return surface.vertices[surface.corners[k == last ? first : k]]; };
      Vec3d twice{};
      for (std::size_t k = first; k < last; ++k) {
        twice += cross(at(k), at(k + 1));
        if (surface.outline[k] != 0) outline += norm(at(k + 1) - at(k));
      }
      area += 0.5 * norm(twice);
    }
    const shapes::Polygon& p = *w.walls[0].polygon;
    for (std::uint32_t i = 0; i < p.vertices.size(); ++i) border += norm(p.vertices[p.next(i)] - p.vertices[i]);
    EXPECT_NEAR(area, p.area, 1e-12 * area);
    EXPECT_NEAR(outline, border, 1e-12 * border);
  }
}

// Discs alone: no shape meets in regions, the wall does.
TEST(PolylineWalls, SameBitsWhereOnlyTheWallIsNotConvex) { scenes::expect_same_bits(drum({"disc"}), 6000); }

TEST(PolylineWalls, UnitsScaleBitForBit) {
  for (const Scene& s : {hopper(), drum(every_kind)}) {
    const World a = scenes::run(s, 4000), b = scenes::run(scenes::planar_restated(s, 10, 6, 3), 4000);
    EXPECT_GT(a.counters.contact_steps, 2000u);
    EXPECT_EQ(a.counters.contact_steps, b.counters.contact_steps);
    EXPECT_EQ(b.time_step.dt, a.time_step.dt * 8);
    for (std::size_t i = 0; i < a.particles.count(); ++i) {
      EXPECT_EQ(b.particles.motion[i].position, a.particles.motion[i].position * 1024.0);
      EXPECT_EQ(b.particles.motion[i].spin, a.particles.motion[i].spin * 0.125);
    }
    EXPECT_EQ(b.walls[0].force, a.walls[0].force * (0x1p16 / 64));
  }
}

// A polygon that is not convex serves as a wall as well: a disc in the corner of an L touches both legs.
TEST(PolylineWalls, APolygonWallNeedNotBeConvex) {
  Scene s = bodies_of_every_kind();
  s.run.max_initial_overlap = 0.1;
  s.walls = {scenes::polyline(
      "l", {{-0.05, -0.05, 0}, {0.05, -0.05, 0}, {0.05, 0, 0}, {0, 0, 0}, {0, 0.05, 0}, {-0.05, 0.05, 0}}, 0)};
  s.walls[0].kind = "polygon";
  s.bodies = {scenes::body("disc", "soft", {0.004 - 1e-5, 0.004 - 2e-5, 0})};
  const auto contacts = touching_contacts(build_world(s));
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_NEAR(contacts[0].overlap + contacts[1].overlap, 3e-5, 1e-14);
}

}  // namespace
}  // namespace dem
