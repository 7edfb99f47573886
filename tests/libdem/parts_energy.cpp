// Energy of bodies of parts without friction or damping: they make none, no more than convex bodies do.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

Scene smooth(const std::string& shape, std::uint64_t count) {
  Scene s = scenes::bodies_of_parts(1);
  for (MaterialSpec& m : s.materials) {
    m.restitution = 1;
    m.friction = 0;
  }
  s.fills[0].count = count;
  s.fills[0].velocity = {};
  s.fills[0].items = {{shape, "soft", 1, 0.9, 1.0}};
  return s;
}

struct Course {
  double after, most;  // energy at the end, and the largest on the way, of that at the start
  std::uint64_t contact_steps;
};
Course course(World w, double time) {
  const auto energy = [&] {
    const Energies e = energies(w);
    return e.translational + e.rotational + e.potential + e.elastic;
  };
  const double start = energy();
  Course c{0, 1, 0};
  while (w.time() < time) {
    advance(w, 1);
    if (w.step % 8 == 0) c.most = std::max(c.most, energy() / start);
  }
  c.after = energy() / start;
  c.contact_steps = w.counters.contact_steps;
  return c;
}

// 64 bodies fall towards their middle and fly apart.
Course cloud(const std::string& shape) {
  Scene s = smooth(shape, 64);
  s.gravity = {};
  s.walls.clear();
  s.fills[0].lower = {-0.04, -0.04, -0.04};
  s.fills[0].upper = {0.04, 0.04, 0.04};
  World w = build_world(s);
  for (Motion& m : w.particles.motion) m.velocity = m.position * -5.0;
  return course(std::move(w), 0.25);
}

// What round parts and a convex block lose or win is what the step leaves. Contacts of several flat parts share one
// stiffness and have no potential of their own: they win up to 2 %.
TEST(PartsEnergy, CloudsKeepIt) {
  const Course block = cloud("stub");
  EXPECT_NEAR(block.after, 1, 5e-4);
  EXPECT_LT(block.most, 1 + 5e-4);
  EXPECT_GT(block.contact_steps, 10000u);
  const Course clump = cloud("clump");
  EXPECT_NEAR(clump.after, 1, 1e-4);
  EXPECT_LT(clump.most, 1 + 1e-4);
  EXPECT_GT(clump.contact_steps, 10000u);
  for (const char* shape : {"ell", "plus", "mushroom"}) {
    const Course c = cloud(shape);
    EXPECT_LT(c.most, 1.03) << shape;
    EXPECT_GT(c.after, 0.98) << shape;
    EXPECT_GT(c.contact_steps, 10000u) << shape;
  }
}

// Bouncing on a floor, about a hundred times each.
TEST(PartsEnergy, AFloorKeepsIt) {
  for (const auto& [shape, change] : {std::pair("dumbbell", 1e-3), std::pair("clump", 1e-2)}) {
    Scene s = smooth(shape, 8);
    s.walls.resize(1);
    s.fills[0].lower = {-0.2, -0.2, 0.02};
    s.fills[0].upper = {0.2, 0.2, 0.08};
    const Course c = course(build_world(s), 1);
    EXPECT_NEAR(c.after, 1, change) << shape;
    EXPECT_LT(c.most, 1 + change) << shape;
    EXPECT_GT(c.contact_steps, 5000u) << shape;
  }
}

}  // namespace
}  // namespace dem
