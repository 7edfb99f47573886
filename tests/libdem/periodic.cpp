// Periodic boundaries: what happens across a face is what happens in the middle of the box; nothing is lost there; the
// same bits for any number of threads, skin and rebuild, across a restart and in other units.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double edge = 0.125;  // of the box, m

PeriodicSpec box(const std::string& axes, double length = edge) {
  PeriodicSpec p;
  p.axes = axes;
  p.upper = {length, length, length};
  return p;
}

// Bodies of every shape thrown at each other in a box without walls and gravity.
Scene gas(std::uint64_t count, LawName law = LawName::hertz_mindlin) {
  Scene s = scenes::every_shape(0);
  s.law.name = law;
  s.gravity = {};
  s.walls.clear();
  s.periodic = box("xyz");
  s.fills[0].lower = {};
  s.fills[0].upper = {edge, edge, edge};
  s.fills[0].count = count / 2;
  s.fills[0].velocity = {3, 2, 1};
  s.fills[0].upper.z = edge / 2;
  s.fills.push_back(s.fills[0]);
  s.fills[1].lower.z = edge / 2;
  s.fills[1].upper.z = edge;
  s.fills[1].velocity = {-2, -3, -4};
  return s;
}
constexpr std::uint64_t bodies = 240, steps = 600;

struct Reference {
  Scene scene = gas(bodies);
  World world = scenes::run(scene, steps);
  std::uint64_t hash = state_hash(world);
};
const Reference& reference() {
  static const Reference r;
  return r;
}

// Two bodies of a shape meet obliquely and spinning about `at`; their state afterwards.
std::array<Motion, 2> meeting(const std::string& shape, const Vec3d& at, std::uint64_t& contacts) {
  Scene s = gas(2);
  s.fills.clear();
  const Vec3d half{0.0078125, 0.001953125, 0.0009765625}, speed{1, 0.5, 0.25};
  s.bodies = {scenes::body(shape, "soft", at - half, speed, {10, -20, 5}, scenes::turn({0, 0, 1}, 0.4)),
              scenes::body(shape, "hard", at + half, -speed, {-3, 2, 40}, scenes::turn({0, 1, 0}, 1.1))};
  const World w = scenes::run(s, 400);
  contacts = w.counters.contact_steps;
  return {scenes::motion(w, 0), scenes::motion(w, 1)};
}

TEST(Periodic, ACollisionAcrossAFaceIsThatInTheMiddle) {
  for (const char* shape : {"ball", "egg", "brick", "wedge", "grain"}) {
    std::uint64_t contacts = 0, across = 0;
    const Vec3d middle{edge / 2, edge / 2, edge / 2};
    const auto a = meeting(shape, middle, contacts);
    EXPECT_GT(contacts, 5u) << shape;
    for (const Vec3d& at : {Vec3d{0, edge / 2, edge / 2}, Vec3d{edge / 2, 0, edge / 2}, Vec3d{edge / 2, edge / 2, edge},
                            Vec3d{0, edge, 0}}) {
      const auto b = meeting(shape, at, across);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(norm(a[i].velocity - b[i].velocity), 1e-9) << shape;
        EXPECT_LT(norm(a[i].spin - b[i].spin), 1e-6) << shape;
        const Vec3d d = (b[i].position - at) - (a[i].position - middle);
        for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(d[k] - edge * std::round(d[k] / edge)), 1e-12) << shape;
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(b[i].position[k] >= 0 && b[i].position[k] <= edge) << shape;
      }
      EXPECT_NEAR(static_cast<double>(across), static_cast<double>(contacts), 1) << shape;
    }
  }
}

TEST(Periodic, NoBodyAndNoMomentumIsLost) {
  const World& w = reference().world;
  const World start = build_world(reference().scene);
  EXPECT_EQ(w.particles.count(), bodies);
  EXPECT_GT(w.counters.contact_steps, 1000u);
  std::vector<std::uint64_t> id = w.particles.id;
  std::sort(id.begin(), id.end());
  for (std::uint64_t i = 0; i < bodies; ++i) EXPECT_EQ(id[i], i);
  double scale = 0;
  for (std::size_t i = 0; i < bodies; ++i) scale += w.particles.mass[i] * norm(start.particles.motion[i].velocity);
  EXPECT_LT(norm(momentum(w) - momentum(start)), 1e-13 * scale);
  EXPECT_LT(energies(w).translational, energies(start).translational);  // they did collide
  std::size_t wrapped = 0, across = 0;
  for (const Motion& m : w.particles.motion)
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(m.position[k] >= 0 && m.position[k] <= edge);
  const auto order = order_by_id(w), first = order_by_id(start);
  for (std::size_t i = 0; i < bodies; ++i)
    wrapped += norm(w.particles.motion[order[i]].position - start.particles.motion[first[i]].position) > 0.5 * edge;
  for (const ContactReport& c : touching_contacts(w)) {
    const Motion &a = w.particles.motion[order[c.a]], &b = w.particles.motion[order[c.b]];
    across += norm(a.position - b.position) > 0.5 * edge ? 1 : 0;
    EXPECT_LT(norm(c.point - a.position), a.bounding_radius);
  }
  EXPECT_GT(wrapped, 0u);
  EXPECT_GT(across, 0u);
}

TEST(Periodic, TheBookOfMomentumClosesOverAFloor) {
  Scene s = gas(bodies);
  s.periodic = box("xy");
  s.gravity = {16, 0, -64};
  s.fills[0].velocity.z = -4;
  s.walls = {scenes::plane("floor", "hard", {0, 0, 0}, {0, 0, 1})};
  const World w = scenes::run(s, steps);
  EXPECT_GT(w.balance.impulse[2].value(),
            -64 * w.balance.present.value() * w.time() * (1 - 1e-6));  // the floor was hit
  const Vec3d now = momentum(w);
  double scale = 0;
  for (std::size_t i = 0; i < bodies; ++i) scale += w.particles.mass[i] * norm(w.particles.motion[i].velocity);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(now[static_cast<int>(k)], w.balance.initial_momentum[k] + w.balance.impulse[k].value(), 1e-12 * scale);
}

// The list against every pair of bodies and every image.
TEST(Periodic, EveryNearPairIsACandidateOnce) {
  for (const char* axes : {"x", "yz", "xyz"}) {
    Scene s = gas(bodies);
    s.periodic = box(axes);
    s.run.rebuild_every = 1;
    const World w = scenes::run(s, 150);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> listed, near;
    for (const Key& k : w.contacts.key) listed.emplace_back(k.a, k.b);
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t j = 0; j < bodies; ++j) {
        const Motion &a = w.particles.motion[i], &b = w.particles.motion[j];
        if (w.particles.id[i] >= w.particles.id[j]) continue;
        for (int image = 0; image < 27; ++image) {
          const int n[3] = {image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1};
          Vec3d d = b.position - a.position;
          bool present = true;
          for (int k = 0; k < 3; ++k) {
            d[k] += n[k] * edge;
            present = present && (n[k] == 0 || s.periodic.along(k));
          }
          if (present &&
              norm(d) < a.bounding_radius + b.bounding_radius + w.contacts.allowance[i] + w.contacts.allowance[j])
            near.emplace_back(w.particles.id[i], w.particles.id[j]);
        }
      }
    std::sort(listed.begin(), listed.end());
    std::sort(near.begin(), near.end());
    EXPECT_FALSE(near.empty());
    EXPECT_EQ(listed, near) << axes;
  }
}

TEST(Periodic, ThreadsSkinsAndRebuildsDoNotMatter) {
  EXPECT_EQ(state_hash(scenes::run(reference().scene, steps, 3)), reference().hash);
  for (const double factor : {0.1, 1.5}) {
    Scene s = reference().scene;
    s.run.skin = factor * reference().world.skin;
    const World w = scenes::run(s, steps);
    EXPECT_NE(w.counters.rebuilds, reference().world.counters.rebuilds);
    EXPECT_EQ(state_hash(w), reference().hash) << factor;
  }
  Scene s = reference().scene;
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, steps)), reference().hash);
  EXPECT_LT(reference().world.counters.rebuilds, steps);
}

TEST(Periodic, ARestartDoesNotMatter) {
  World first = scenes::run(reference().scene, 347);
  World second = build_world(reference().scene);
  load_state(second, save_state(first));
  EXPECT_EQ(state_hash(second), state_hash(first));
  while (second.step < steps) advance(second, 1);
  EXPECT_EQ(state_hash(second), reference().hash);
}

TEST(Periodic, OtherUnitsOfLengthGiveTheSameBitsScaled) {
  const double f = 0x1p-20;
  Scene s = gas(bodies), t = s;
  for (ShapeSpec& x : t.shapes) {
    x.radius *= f;
    x.semi_axes *= f;
    x.extents *= f;
    for (Vec3d& v : x.vertices) v *= f;
  }
  for (FillSpec& x : t.fills) {
    x.lower *= f;
    x.upper *= f;
    x.velocity *= f;
  }
  for (MaterialSpec& m : t.materials) {
    m.young /= f;
    m.density /= f * f * f;
  }
  t.periodic.upper *= f;
  const World a = scenes::run(s, steps), b = scenes::run(t, steps);
  EXPECT_GT(a.counters.contact_steps, 500u);
  EXPECT_EQ(a.time_step.dt, b.time_step.dt);
  for (std::uint64_t i = 0; i < bodies; ++i) {
    EXPECT_EQ(scenes::motion(a, i).position * f, scenes::motion(b, i).position);
    EXPECT_EQ(scenes::motion(a, i).velocity * f, scenes::motion(b, i).velocity);
  }
}

TEST(Periodic, ABodyThatStandsOutsideStartsAtItsImage) {
  Scene s = gas(2);
  s.fills.clear();
  s.bodies = {scenes::body("ball", "soft", {-0.25 * edge, 2.5 * edge, 0.5 * edge})};
  const World w = build_world(s);
  EXPECT_EQ(w.particles.motion[0].position, (Vec3d{0.75 * edge, 0.5 * edge, 0.5 * edge}));
}

std::string refusal(const Scene& s) {
  try {
    build_world(s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Periodic, ATooShortBoxIsRefused) {
  Scene s = gas(2);
  s.fills.clear();
  s.bodies = {scenes::body("ball", "soft", {0.005, 0.005, 0.005})};
  s.run.skin = 0.001;
  s.periodic = box("y", 0.0219);
  EXPECT_NE(refusal(s).find("too short"), std::string::npos) << refusal(s);
  s.periodic = box("y", 0.0221);
  EXPECT_EQ(refusal(s), "");
}

TEST(Periodic, AnOverlapAcrossAFaceIsRefused) {
  Scene s = gas(2);
  s.fills.clear();
  s.bodies = {scenes::body("ball", "soft", {0.001, 0.01, 0.01}),
              scenes::body("ball", "soft", {edge - 0.001, 0.01, 0.01})};
  EXPECT_NE(refusal(s).find("body 0 overlaps body 1"), std::string::npos) << refusal(s);
}

}  // namespace
}  // namespace dem
