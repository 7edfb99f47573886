// Walls driven by a table or a servo: places and velocities, forces reached, the same bits whoever computes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

Scene with_wall(const WallSpec& wall) {
  Scene s;
  s.materials = {scenes::material("m", 5e6, 2500, 0.5, 0.5)};
  s.shapes = {scenes::sphere("ball", 0.01)};
  s.walls = {wall};
  s.run.dt_auto = false;
  s.run.dt = 1e-4;
  s.run.steps = 1;
  return s;
}

void expect_near(const Vec3d& a, const Vec3d& b, double error) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], error) << "component " << k;
}

WallSpec table_wall() {
  WallSpec m = scenes::random_floor("w", "m", 0.1, 3, 0, 5);
  m.motion = WallMotion::table;
  m.start = 0.01;
  m.displacements = {{0.01, 0, 0, 0}, {0.02, 0.001, 0, 0.002}, {0.04, 0.001, -0.001, 0}};
  return m;
}

TEST(WallTable, IsStraightBetweenRowsAndAtRestOutside) {
  World w = build_world(with_wall(table_wall()));
  Vec3d before = w.walls[0].position, speed = w.walls[0].velocity;
  while (w.time() < 0.08) {
    advance(w, 1);
    const Wall& wall = w.walls[0];
    // Continuous, and the velocity is that of the way just gone or about to be gone.
    const Vec3d step = (wall.position - before) * (1 / w.time_step.dt);
    const bool corner = !(speed == wall.velocity);
    if (!corner) expect_near(step, wall.velocity, 1e-9);
    EXPECT_LT(scenes::length(wall.position - before), 0.3 * w.time_step.dt);
    before = wall.position;
    speed = wall.velocity;
  }
  expect_near(before, {0.001, -0.001, 0}, 1e-17);
  EXPECT_EQ(speed, Vec3d{});
  World half = build_world(with_wall(table_wall()));
  while (half.step < 250) advance(half, 1);  // 0.025 s: the middle of the first straight
  expect_near(half.walls[0].position, {0.0005, 0, 0.001}, 1e-15);
  expect_near(half.walls[0].velocity, {0.1, 0, 0.2}, 1e-12);
}

TEST(WallTable, OfOneStraightIsATranslation) {
  WallSpec a = table_wall(), b = table_wall();
  a.start = b.start = 0;
  a.displacements = {{0, 0, 0, 0}, {0.0625, 0.03125, 0, -0.0625}};
  b.motion = WallMotion::translation;
  b.velocity = {0.5, 0, -1};
  b.stop = 0.0625;
  World x = build_world(with_wall(a)), y = build_world(with_wall(b));
  for (int i = 0; i < 700; ++i) {
    advance(x, 1);
    advance(y, 1);
    expect_near(x.walls[0].position, y.walls[0].position, 1e-16);
    EXPECT_EQ(x.walls[0].velocity, y.walls[0].velocity) << x.time();
  }
}

TEST(WallTable, OfTurnsIsARotation) {
  WallSpec a = table_wall(), b = table_wall();
  a.start = b.start = 0;
  a.displacements.clear();
  a.turns = {{0, 0}, {1, 2}};
  a.axis = b.axis = {1, 2, 2};
  a.centre = b.centre = {0.3, 0, -0.1};
  b.motion = WallMotion::rotation;
  b.rate = 2;
  World x = build_world(with_wall(a)), y = build_world(with_wall(b));
  for (int i = 0; i < 700; ++i) {
    advance(x, 1);
    advance(y, 1);
    expect_near(x.walls[0].position, y.walls[0].position, 1e-15);
    expect_near(x.walls[0].velocity, y.walls[0].velocity, 1e-15);
    expect_near(x.walls[0].spin, y.walls[0].spin, 1e-15);
    EXPECT_NEAR(x.walls[0].orientation.w, y.walls[0].orientation.w, 1e-15);
  }
}

TEST(WallTable, FromAFileIsTheSame) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("motion" + std::to_string(::getpid()) + ".csv")).string();
  std::ofstream(path) << "# a motion\ntime,x,y,z\n0.01,0,0,0\n0.02,0.001,0,0.002\n0.04,0.001,-0.001,0\n";
  WallSpec m = table_wall();
  m.displacements.clear();
  m.table_file = path;
  World x = build_world(with_wall(m)), y = build_world(with_wall(table_wall()));
  for (int i = 0; i < 700; ++i) {
    advance(x, 1);
    advance(y, 1);
    ASSERT_EQ(x.walls[0].position, y.walls[0].position);
    ASSERT_EQ(x.walls[0].velocity, y.walls[0].velocity);
  }
  std::ofstream(path) << "time,x\n0,0\n1,2\n1,3\n";
  try {
    build_world(with_wall(m));
    FAIL() << "times that do not rise are accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(":4:1"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("rising times"), std::string::npos) << error.what();
  }
  std::remove(path.c_str());
}

// A column of `count` balls between a floor and a lid that keeps `force`; no gravity.
Scene column(int count, double force, double restitution) {
  WallSpec lid = scenes::plane("lid", "m", {0, 0, 0.02 * count + 0.002}, {0, 0, -1});
  lid.motion = WallMotion::servo;
  lid.axis = {0, 0, -3};
  lid.target_force = force;
  lid.speed_limit = 0.2;
  Scene s = with_wall(lid);
  s.materials[0].restitution = restitution;
  s.walls.push_back(scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1}));
  for (int i = 0; i < count; ++i) s.bodies.push_back(scenes::body("ball", "m", {0, 0, 0.01 + 0.02 * i}));
  return s;
}

TEST(WallServo, KeepsAForceOnAColumn) {
  for (const double restitution : {0.1, 0.5, 0.9})
    for (const double force : {0.01, 1.0, 50.0}) {
      const int count = 5;
      World w = build_world(column(count, force, restitution));
      double most = 0, at = 0;
      while (w.time() < 1.5) {
        advance(w, 1);
        most = std::max(most, w.walls[0].force.z);
        if (at == 0 && w.walls[0].force.z > 0) at = w.time();
      }
      EXPECT_NEAR(at, 0.01, 0.0002);  // 2 mm at the speed limit
      EXPECT_NEAR(w.walls[0].force.z / force, 1, 1e-4) << restitution << " " << force;
      // Hertz: δ = (3 F / (4 E* sqrt(R*)))^(2/3); R* = r at the walls, r/2 in between.
      const double e = w.pairs[0].young_eff;
      const auto overlap = [&](double radius) { return std::pow(0.75 * force / (e * std::sqrt(radius)), 2.0 / 3.0); };
      const double height = 0.02 * count - 2 * overlap(0.01) - (count - 1) * overlap(0.005);
      EXPECT_NEAR(w.walls[0].position.z, height, 1e-4 * (0.02 * count - height)) << restitution << " " << force;
      std::printf("  restitution %g, target %g N: largest force %.3f of it\n", restitution, force, most / force);
    }
}

TEST(WallServo, PressureActsOnTheAreaOfAMesh) {
  Scene s = column(1, 2, 0.5);
  s.walls[0] = WallSpec{};
  WallSpec& lid = s.walls[0];
  lid.name = "lid";
  lid.kind = "panel";
  lid.material = "m";
  lid.corner = {-0.02, -0.02, 0.021};
  lid.side_1 = {0.04, 0, 0};
  lid.side_2 = {0, 0.05, 0};
  lid.motion = WallMotion::servo;
  lid.axis = {0, 0, -1};
  lid.target_pressure = 1000;
  lid.speed_limit = 0.1;
  World w = build_world(s);
  EXPECT_NEAR(w.walls[0].target, 2, 1e-12);
  while (w.time() < 1) advance(w, 1);
  EXPECT_NEAR(w.walls[0].force.z / 2, 1, 1e-4);
}

TEST(WallServo, StartsAndStops) {
  Scene s = column(1, 1, 0.5);
  s.walls[0].start = 0.003;
  s.walls[0].stop = 0.008;
  World w = build_world(s);
  while (w.time() < 0.0025) advance(w, 1);
  EXPECT_EQ(w.walls[0].position.z, 0.022);
  while (w.time() < 0.02) advance(w, 1);
  EXPECT_NEAR(w.walls[0].position.z, 0.022 - 0.2 * 0.005, 1e-4);
  EXPECT_EQ(w.walls[0].velocity, Vec3d{});
}

// A tray of bodies of every shape with a servo and a table: the same bits for threads, skins, rebuilds and a restart.
class DrivenTray : public testing::Test {
 protected:
  static constexpr std::uint64_t bodies = 200, steps = 500;
  static Scene scene() { return scenes::every_shape_driven(bodies); }
  static const World& reference() {
    static const World w = scenes::run(scene(), steps);
    return w;
  }
  static void expect_same(const World& w) {
    EXPECT_EQ(state_hash(w), state_hash(reference()));
    for (std::size_t i = 0; i < w.walls.size(); ++i) {
      EXPECT_EQ(w.walls[i].position, reference().walls[i].position) << w.walls[i].name;
      EXPECT_EQ(w.walls[i].force, reference().walls[i].force) << w.walls[i].name;
    }
  }
};

TEST_F(DrivenTray, TheServoIsAtWork) {
  const Wall& press = reference().walls[3];
  EXPECT_GT(press.resistance, 0);
  EXPECT_LT(press.position.y, 0.0515);
  EXPECT_GT(press.force.y, 0);
}
TEST_F(DrivenTray, ThreadsDoNotMatter) {
  expect_same(scenes::run(scene(), steps, 2));
  expect_same(scenes::run(scene(), steps, 3));
}
TEST_F(DrivenTray, SkinAndRebuildDoNotMatter) {
  Scene s = scene();
  s.run.skin = 3 * reference().skin;
  expect_same(scenes::run(s, steps));
  s = scene();
  s.run.rebuild_every = 1;
  expect_same(scenes::run(s, steps));
}
TEST_F(DrivenTray, ARestartDoesNotMatter) {
  for (const std::uint64_t at : {std::uint64_t(220), std::uint64_t(431)}) {
    const World first = scenes::run(scene(), at);
    World second = build_world(scene());
    load_state(second, save_state(first));
    while (second.step < steps) advance(second, 1);
    expect_same(second);
  }
}

// A file of triangles turns as the same wall written out; a generated box slides as its triangles do.
TEST(MovingMesh, AFileMovesLikeItsTriangles) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("paddle" + std::to_string(::getpid()) + ".obj")).string();
  std::ofstream(path) << "v -0.03 -0.03 0\nv 0.03 -0.03 0\nv 0.03 0.03 0\nv -0.03 0.03 0\nf 1 2 3\nf 1 3 4\n";
  WallSpec file;
  file.name = "paddle";
  file.kind = "mesh";
  file.material = "m";
  file.file = path;
  file.motion = WallMotion::rotation;
  file.axis = {1, 0, 0};
  file.rate = 8;
  WallSpec listed = file;
  listed.file.clear();
  listed.vertices = {{-0.03, -0.03, 0}, {0.03, -0.03, 0}, {0.03, 0.03, 0}, {-0.03, 0.03, 0}};
  listed.triangles = {{0, 1, 2}, {0, 2, 3}};
  WallSpec panel = file;
  panel.kind = "panel";
  panel.file.clear();
  panel.corner = {-0.03, -0.03, 0};
  panel.side_1 = {0.06, 0, 0};
  panel.side_2 = {0, 0.06, 0};
  std::uint64_t hash = 0;
  for (const WallSpec& w : {listed, file, panel}) {
    Scene s = with_wall(w);
    s.bodies = {scenes::body("ball", "m", {0, 0.015, 0.011}, {0, 0, -0.05})};
    const World end = scenes::run(s, 400);
    EXPECT_GT(scenes::length(end.particles.motion[0].velocity), 0.1);  // it was hit
    if (hash == 0) hash = state_hash(end);
    EXPECT_EQ(state_hash(end), hash) << w.kind;
  }
  std::remove(path.c_str());
}

}  // namespace
}  // namespace dem
