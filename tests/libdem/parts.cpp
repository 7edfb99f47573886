// Bodies of parts in the loop: clumps of spheres and non-convex solids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double gravity = 9.81;
constexpr double quarter = std::numbers::pi / 2;

Scene on_the_floor(const std::vector<ShapeSpec>& shapes, double friction = 0.5) {
  Scene s;
  s.gravity = {0, 0, -gravity};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.3, friction)};
  s.materials[0].stiffness = 1e3;
  s.shapes = shapes;
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 1;
  s.run.dt_fraction = 0.3;
  return s;
}

Vec3d total_force(const World& w) {  // on body 0
  Vec3d f{};
  for (const ContactReport& c : touching_contacts(w))
    if (c.a == 0) f += c.force;
  return f;
}

TEST(Parts, AClumpOfOneSphereIsThatSphere) {
  const auto hash = [](const ShapeSpec& first) {
    Scene s = on_the_floor({first, scenes::box("brick", {0.01, 0.012, 0.014})});
    s.bodies = {scenes::body("ball", "soft", {0, 0, 0.03}, {0.1, 0, 0}, {3, 2, 1}),
                scenes::body("brick", "soft", {0.002, 0, 0.012}), scenes::body("ball", "soft", {0.015, 0, 0.01})};
    return state_hash(scenes::run(s, 3000));
  };
  const auto expected = hash(scenes::sphere("ball", 0.004));
  EXPECT_EQ(hash(scenes::clump("ball", {{0, 0, 0, 0.004}})), expected);
  EXPECT_EQ(hash(scenes::clump("ball", {{0.25, 0.5, 0, 0.004}, {0.25, 0.5, 0.001, 0.003}})), expected);
}

// Another numbering of the corners, the same body: what remains is round-off.
TEST(Parts, ABoxInPiecesIsTheBox) {
  const auto end_of = [](const std::vector<ShapeSpec>& shapes) {
    Scene s = on_the_floor(shapes);
    s.bodies = {
        scenes::body("body", "soft", {0, 0, 0.03}, {0.3, 0.1, -0.2}, {3, 2, 1}, scenes::turn({0.6, 0.8, 0}, 0.7))};
    return scenes::run(s, 4000);
  };
  const Vec3d whole{1.0 / 64, 1.0 / 128, 1.0 / 64};
  const World expected = end_of({scenes::box("body", whole)});
  EXPECT_GT(expected.counters.contact_steps, 100u);
  const double x = whole.x / 2, y = whole.y / 2, z = whole.z / 2;  // along a diagonal
  const std::vector<std::vector<ShapeSpec>> cuts{
      {scenes::union_of("body", {{"left", {-1.0 / 256, 0, 0}, {}}, {"left", {1.0 / 256, 0, 0}, {}}}),
       scenes::box("left", {1.0 / 128, 1.0 / 128, 1.0 / 64})},
      {scenes::union_of("body", {{"one", {}, {}}, {"two", {}, {}}}),
       scenes::points("one", {{-x, -y, -z}, {x, -y, -z}, {x, -y, z}, {-x, y, -z}, {x, y, -z}, {x, y, z}}),
       scenes::points("two", {{-x, -y, -z}, {-x, -y, z}, {x, -y, z}, {-x, y, -z}, {-x, y, z}, {x, y, z}})}};
  for (const auto& shapes : cuts) {
    const World w = end_of(shapes);
    EXPECT_EQ(w.shapes[0].kind, shapes::Kind::polyhedron);
    EXPECT_EQ(w.counters.contact_steps, expected.counters.contact_steps);
    EXPECT_LT(scenes::length(scenes::motion(w, 0).position - scenes::motion(expected, 0).position), 1e-13);
    EXPECT_LT(scenes::length(scenes::motion(w, 0).spin - scenes::motion(expected, 0).spin), 1e-9);
  }
}

const std::vector<ShapeSpec> ell_shapes{scenes::box("long", {0.03, 0.01, 0.01}),
                                        scenes::box("stub", {0.01, 0.02, 0.01}), scenes::box("cut", {0.02, 0.01, 0.01}),
                                        scenes::box("tall", {0.01, 0.03, 0.01})};
// An L, 0.03 m on its sides, from either cut.
ShapeSpec ell(int cut) {
  if (cut == 0) return scenes::union_of("ell", {{"long", {0, 0, 0}, {}}, {"stub", {-0.01, 0.015, 0}, {}}});
  return scenes::union_of("ell", {{"cut", {0.005, 0, 0}, {}}, {"tall", {-0.01, 0.01, 0}, {}}});
}

TEST(Parts, AnLInEitherCutIsTheSameBody) {
  std::vector<World> worlds;
  for (const int cut : {0, 1}) {
    auto shapes = ell_shapes;
    shapes.push_back(ell(cut));
    Scene s = on_the_floor(shapes);
    s.run.dt_auto = false;
    s.run.dt = 5e-6;
    s.bodies = {
        scenes::body("ell", "soft", {0, 0, 0.03}, {0.3, 0.1, -0.2}, {3, 2, 1}, scenes::turn({0.6, 0.8, 0}, 0.7)),
        scenes::body("ell", "soft", {0.003, 0.002, 0.075}, {0, 0, -0.5}, {}, scenes::turn({0, 0.6, 0.8}, 1.9))};
    worlds.push_back(build_world(s));
  }
  double most = 0;
  bool met = false;
  while (worlds[0].time() < 0.15) {
    for (World& w : worlds) advance(w, 1);
    for (const std::uint64_t id : {0u, 1u})
      most = std::max(most,
                      scenes::length(scenes::motion(worlds[0], id).position - scenes::motion(worlds[1], id).position));
    if (worlds[0].step % 16 == 0)
      for (const ContactReport& c : touching_contacts(worlds[0])) met = met || !c.wall;
  }
  std::printf("  an L in two cuts, two of them, %llu steps: apart by %.1e m at most\n",
              static_cast<unsigned long long>(worlds[0].step), most);
  EXPECT_TRUE(met);
  EXPECT_LT(most, 1e-9);
}

TEST(Parts, AnLComesToRestFlatAndCarriesItsWeight) {
  auto shapes = ell_shapes;
  shapes.push_back(ell(0));
  Scene s = on_the_floor(shapes);
  s.bodies = {scenes::body("ell", "soft", {0, 0, 0.0051}, {0.02, 0, 0}, {}, {})};
  World w = build_world(s);
  while (w.time() < 0.6) advance(w, 1);
  const double weight = w.particles.mass[0] * gravity;
  const Vec3d before = w.particles.motion[0].position;
  double worst = 0;
  while (w.time() < 0.8) {
    advance(w, 1);
    const Energies e = energies(w);
    worst = std::max(worst, (e.translational + e.rotational) / (weight * 0.01));
  }
  EXPECT_NEAR(total_force(w).z / weight, 1, 1e-6);
  const double overlap = touching_contacts(w).at(0).overlap;
  const double drift = scenes::length(w.particles.motion[0].position - before) / overlap;
  const auto r = shapes::rotation_matrix(w.particles.orientation[0]);
  std::printf("  L at rest: kinetic energy <= %.1e m g L, drift %.1e of the overlap, 1 - cos(tilt) %.1e\n", worst,
              drift, 1 - std::abs(r.row[2].z));
  EXPECT_LT(worst, 1e-10);
  EXPECT_LT(drift, 0.01);
  EXPECT_LT(1 - std::max({std::abs(r.row[2].x), std::abs(r.row[2].y), std::abs(r.row[2].z)}), 1e-6);
}

// The stiffness of a contact does not depend on how many parts it is with: a block that stands on a flat side of bars
// that cross feels what it feels on one plate.
TEST(Parts, OneStiffnessWhereverItStands) {
  const auto force = [](double x, double y, bool crossed) {
    Scene s;
    s.law.name = LawName::spring_dashpot;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
    s.materials[0].stiffness = 1e3;
    s.run.steps = 1;
    s.shapes = {scenes::box("block", {0.004, 0.004, 0.004}), scenes::box("plate", {0.06, 0.06, 0.01}),
                scenes::box("bar", {0.06, 0.01, 0.01}), scenes::sphere("ball", 0.004),
                scenes::union_of("plus", {{"bar", {}, {}}, {"bar", {}, scenes::turn({0, 0, 1}, quarter)}})};
    s.bodies = {scenes::body("block", "soft", {x, y, 0.00699}), scenes::body(crossed ? "plus" : "plate", "soft", {})};
    const World w = build_world(s);
    return total_force(w);
  };
  const Vec3d expected = force(0.001, 0.002, false);
  EXPECT_NEAR(expected.z, 1e3 * 1e-5, 1e-9);
  for (double x = -0.028; x < 0.028; x += 0.0007) {
    const Vec3d f = force(x, 0.0003, true);
    EXPECT_LT(scenes::length(f - expected), 1e-9 * expected.z) << x << " " << f.x << " " << f.y << " " << f.z;
  }
}

// A ball over the flat side: inner edges give no contact, wherever the ball is.
TEST(Parts, InnerEdgesAreNotThere) {
  const auto forces = [](double x, double y) {
    Scene s;
    s.law.name = LawName::spring_dashpot;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
    s.materials[0].stiffness = 1e3;
    s.run.steps = 1;
    s.shapes = {scenes::sphere("ball", 0.004), scenes::box("bar", {0.06, 0.01, 0.01}),
                scenes::union_of("plus", {{"bar", {}, {}}, {"bar", {}, scenes::turn({0, 0, 1}, quarter)}})};
    s.bodies = {scenes::body("ball", "soft", {x, y, 0.008995}), scenes::body("plus", "soft", {})};
    return total_force(build_world(s));
  };
  const double expected = 1e3 * 5e-6;
  for (double x = -0.029; x < 0.029; x += 0.00021) {
    const Vec3d f = forces(x, 0.0012);
    EXPECT_NEAR(f.z / expected, 1, 1e-9) << x;
    EXPECT_NEAR(f.x / expected, 0, 1e-6) << x;
    EXPECT_NEAR(f.y / expected, 0, 1e-6) << x;
  }
  // on the outer edge that both bars have a share of, and in the corner between the bars
  const Vec3d corner = forces(0.0085, 0.0085);
  EXPECT_EQ(corner.x, 0);  // too far from both
  for (const double x : {0.006, 0.0051, 0.0049, 0.0}) {
    Scene s;
    s.law.name = LawName::spring_dashpot;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
    s.materials[0].stiffness = 1e3;
    s.run.steps = 1;
    s.shapes = {scenes::sphere("ball", 0.004), scenes::box("bar", {0.06, 0.01, 0.01}),
                scenes::box("stub", {0.01, 0.02, 0.01}),
                scenes::union_of("tee", {{"bar", {}, {}}, {"stub", {0, 0.015, 0}, {}}})};
    // beside the edge y = -0.005 of the bar, which the stem's reach ends at as well
    const Vec3d at = Vec3d{x, -0.005, 0.005} + shapes::normalized(Vec3d{0, -1, 1}) * 0.003995;
    World w;
    s.bodies = {scenes::body("tee", "soft", {}), scenes::body("ball", "soft", {})};
    // positions are those of the centres of mass: put the ball relative to the bar
    const double shift = (0.02 * 0.015) / (0.06 + 0.02);
    s.bodies[1].position = at - Vec3d{0, shift, 0};
    w = build_world(s);
    const Vec3d f = total_force(w);
    EXPECT_NEAR(scenes::length(f) / expected, 1, 1e-9) << x;
    EXPECT_NEAR(f.y / scenes::length(f), std::sqrt(0.5), 1e-9) << x;
  }
}

TEST(Parts, ADumbbellTouchesAtBothEnds) {
  Scene s = on_the_floor({scenes::clump("dumbbell", {{-0.01, 0, 0, 0.005}, {0.01, 0, 0, 0.005}})});
  s.law.name = LawName::spring_dashpot;
  s.bodies = {scenes::body("dumbbell", "soft", {0, 0, 0.00499})};
  const World w = build_world(s);
  const auto contacts = touching_contacts(w);
  ASSERT_EQ(contacts.size(), 2u);
  for (const ContactReport& c : contacts) EXPECT_NEAR(c.force.z, 1e3 * 1e-5, 1e-12);
  EXPECT_NE(contacts[0].part_a, contacts[1].part_a);
}

// Lying dumbbell, axis along y, sliding across: it ends rolling as a cylinder of two wheels with I = 2/5 r² m about
// its axis: v = v0 / (1 + I/(m r²)) = 5/7 v0, whatever the friction on the way.
TEST(Parts, ADumbbellSlidesUntilItRolls) {
  const double r = 0.005, v0 = 0.1;
  Scene s = on_the_floor({scenes::clump("dumbbell", {{0, -0.01, 0, r}, {0, 0.01, 0, r}})}, 0.3);
  s.materials[0].restitution = 0.9;
  s.bodies = {scenes::body("dumbbell", "soft", {0, 0, r - 1e-6}, {v0, 0, 0}, {}, {})};
  World w = build_world(s);
  while (w.time() < 0.2) advance(w, 1);
  const Motion& m = w.particles.motion[0];
  std::printf("  dumbbell: v %.6f of v0 (5/7 = %.6f), spin r / v %.6f\n", m.velocity.x / v0, 5.0 / 7,
              m.spin.y * r / m.velocity.x);
  EXPECT_NEAR(m.velocity.x / (5.0 / 7 * v0), 1, 2e-3);  // the balls sink in by 1.7e-3 of their radius
  EXPECT_NEAR(m.spin.y * r / m.velocity.x, 1, 2e-3);
  EXPECT_LT(std::abs(m.spin.x) + std::abs(m.spin.z), 1e-6 * m.spin.y);
}

// A dumbbell falls flat: two contacts, each with the effective mass at its place, give the restitution asked for.
TEST(Parts, AFlatFallHasItsRestitution) {
  for (const double e : {0.9, 0.5}) {
    Scene s = on_the_floor({scenes::clump("dumbbell", {{-0.02, 0, 0, 0.004}, {0.02, 0, 0, 0.004}})});
    s.gravity = {};
    s.materials[0].restitution = e;
    s.run.dt_fraction = 0.05;
    s.bodies = {scenes::body("dumbbell", "soft", {0, 0, 0.00401}, {0, 0, -0.1})};
    World w = build_world(s);
    while (w.time() < 0.01) advance(w, 1);
    // the parts of the mass at the ends move alone: half of it each, but for what turns with the balls themselves
    EXPECT_NEAR(w.particles.motion[0].velocity.z / 0.1, e, 0.01);
  }
}

// Momentum of a heap of bodies of parts that meet without gravity or walls.
TEST(Parts, MomentumIsKept) {
  Scene s = scenes::bodies_of_parts(60);
  s.gravity = {};
  s.walls.clear();
  s.fills[0].lower = {-0.03, -0.03, -0.03};
  s.fills[0].upper = {0.035, 0.035, 0.035};
  s.fills[0].velocity = {};
  World w = build_world(s);
  for (std::size_t i = 0; i < w.particles.count(); ++i)
    w.particles.motion[i].velocity = w.particles.motion[i].position * -20.0;
  const auto angular = [&] {
    Vec3d l{};
    for (std::size_t i = 0; i < w.particles.count(); ++i)
      l += w.particles.angular_momentum[i] +
           cross(w.particles.motion[i].position, w.particles.motion[i].velocity) * w.particles.mass[i];
    return l;
  };
  double scale = 0;
  for (std::size_t i = 0; i < w.particles.count(); ++i)
    scale += w.particles.mass[i] * scenes::length(w.particles.motion[i].velocity);
  const Vec3d p = momentum(w), l = angular();
  for (int i = 0; i < 1500; ++i) advance(w, 1);
  EXPECT_GT(w.counters.contact_steps, 1000u);
  EXPECT_LT(scenes::length(momentum(w) - p), 1e-13 * scale);
  EXPECT_LT(scenes::length(angular() - l), 1e-12 * scale * 0.05);
}

}  // namespace
}  // namespace dem
