// Contacts of ellipsoids and of ellipses in lanes: whatever the law, the same bits for threads, skins, rebuilds and a
// restart; overlap and place are those of a query.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>

#include "libcontact/dispatch.h"
#include "libdem/build.h"
#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

constexpr double radius = 0.005;
constexpr std::uint64_t steps = 1500;

// Bodies of several sizes fall into a corner, along a direction with periods.
Scene heap(bool plane) {
  Scene s;
  s.run.dt_fraction = 0.3;
  s.gravity = plane ? Vec3d{20, -100, 0} : Vec3d{20, 0, -100};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4), scenes::material("hard", 8e6, 1500, 0.8, 0.2)};
  for (MaterialSpec& m : s.materials) m.rolling_friction = 0.1, m.rolling_damping = 0.3;
  const auto wall = [&](const char* name, const Vec3d& normal) {
    WallSpec w = scenes::plane(name, "soft", {}, normal);
    if (plane) w.kind = "line";
    s.walls.push_back(w);
  };
  FillSpec fill;
  fill.velocity = plane ? Vec3d{1, -2, 0} : Vec3d{1, 0, -2};
  if (plane) {
    s.dimension = 2;
    s.thickness = 0.01;
    s.law.map = LawMap::equivalent_radius;
    s.shapes = {scenes::ellipse("egg", 0.8 * radius, 1.5 * radius), scenes::ellipse("nut", 1.1 * radius, radius)};
    wall("floor", {0, 1, 0});
    wall("side", {-1, 0.2, 0});
    fill.lower = {-0.15, 0.03, 0};
    fill.upper = {0, 0.2, 0};
  } else {
    s.shapes = {scenes::ellipsoid("egg", {0.8 * radius, radius, 1.5 * radius}),
                scenes::ellipsoid("nut", {1.1 * radius, radius, radius})};
    wall("floor", {0, 0, 1});
    wall("side", {-1, 0, 0.2});
    s.periodic.axes = "y";
    s.periodic.lower = {0, 0, 0};
    s.periodic.upper = {1, 0.06, 1};
    fill.lower = {-0.08, 0, 0.02};
    fill.upper = {-0.01, 0.06, 0.12};
  }
  fill.count = plane ? 110 : 120;
  fill.items = {{"egg", "soft", 1, 0.7, 1.0}, {"nut", "hard", 1, 0.7, 1.0}};
  s.fills = {fill};
  return s;
}

struct Case {
  const char* name;
  Scene scene;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const bool plane : {false, true}) {
    all.push_back({plane ? "ellipses" : "ellipsoids", heap(plane)});  // the fused kernel
    all.push_back({plane ? "ellipses that roll" : "ellipsoids that roll", heap(plane)});
    all.back().scene.law.rolling = "spring";
    all.back().scene.law.ledger = true;
  }
  all.push_back({"R* of curvature", heap(false)});
  all.back().scene.law.map = LawMap::curvature;
  all.push_back({"a tolerance", heap(false)});
  all.back().scene.tolerance = 1e-6;
  return all;
}

class SmoothLanes : public testing::TestWithParam<Case> {};

TEST_P(SmoothLanes, ThreadsSkinsRebuildsAndARestartDoNotMatter) {
  const Scene& scene = GetParam().scene;
  const World w = scenes::run(scene, steps);
  const std::uint64_t hash = state_hash(w);
  std::size_t in_lanes = 0, cells = 0;
  for (const Bin& bin : w.contacts.bins)
    if (bin.smooth) in_lanes += bin.met.count, ++cells;
  EXPECT_EQ(cells, 1U);
  EXPECT_GT(in_lanes, 100U);
  EXPECT_EQ(w.counters.not_converged, 0U);
  EXPECT_EQ(state_hash(scenes::run(scene, steps, 3)), hash);
  for (const double factor : {0.1, 4.0}) {
    Scene s = scene;
    s.run.skin = factor * w.skin;
    EXPECT_EQ(state_hash(scenes::run(s, steps)), hash) << "skin " << factor;
  }
  Scene often = scene;
  often.run.rebuild_every = 3;
  EXPECT_EQ(state_hash(scenes::run(often, steps)), hash);
  const World first = scenes::run(scene, steps / 2 + 7);
  World second = build_world(scene);
  load_state(second, save_state(first));
  while (second.step < steps) advance(second, 1);
  EXPECT_EQ(state_hash(second), hash) << "resumed";
}

TEST_P(SmoothLanes, ContactsAreThoseOfAQuery) {
  const Scene& scene = GetParam().scene;
  const World w = scenes::run(scene, steps);
  const Contacts& c = w.contacts;
  const Particles& p = w.particles;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < c.count(); ++k) {
    if (c.touching[k] == 0 || c.key[k].b >= wall_base) continue;
    const auto body = [&](std::uint32_t i) {
      contact::Body b;
      b.kind = p.kind[i];
      b.size = p.size[i];
      b.rotation = shapes::rotation_matrix(p.orientation[i]);
      return b;
    };
    const std::uint32_t a = c.index_a[k], b = c.index_b[k];
    const Vec3d apart = p.motion[b].position - p.motion[a].position;
    const contact::Contact q =
        contact::query(body(a), body(b), w.cell.periodic ? w.cell.lattice.nearest(apart) : apart);
    const double slack = std::max(scene.tolerance, 1e-15) * radius;
    EXPECT_LE(q.gap_lower, -c.history_of(k).overlap + slack);
    EXPECT_GE(q.gap_upper, -c.history_of(k).overlap - slack);
    // The gap is second order in the direction.
    const double near = scene.tolerance > 0 ? 10 * std::sqrt(scene.tolerance) : 1e-12;
    EXPECT_LT(norm(c.history_of(k).normal - q.normal), near);
    EXPECT_LT(norm(contact_point(w, k) - p.motion[a].position - q.patch.centre), near * radius);
    ++seen;
  }
  EXPECT_GT(seen, 100U);
}

INSTANTIATE_TEST_SUITE_P(Every, SmoothLanes, testing::ValuesIn(cases()), [](const auto& of) {
  std::string name = of.param.name;
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
});

}  // namespace
}  // namespace dem
