// What walls report: force, torque, power, impulse and work in walls.csv; pressure maps in the frames. Sums agree, the
// bits do not depend on threads, skin or a resume, and a feature that is off leaves no trace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "libdem/io/io.h"
#include "libdem/io/surfaces.h"
#include "libdem/run.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

using io_test::Folder;

constexpr std::size_t ridge = 4;  // the mesh of the tray: two facets of two triangles each
constexpr std::size_t floor_wall = 0, press = 3;
constexpr std::uint64_t per_frame = 64;  // steps

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// The tray of every shape that presses against its mesh, which moves along.
Scene tray() {
  Scene s = scenes::every_shape_driven(120);
  s.run.steps = 900;
  s.run.dt_auto = false;
  s.run.dt = 0x1p-16;
  s.output.interval = per_frame * s.run.dt;
  s.output.picture = s.output.hdf5 = false;
  WallSpec& w = s.walls[ridge];
  w.pressure_map = true;
  w.motion = WallMotion::translation;
  w.velocity = {-0.25, 0, 0.5};
  for (const std::size_t plane : {floor_wall, press}) {
    s.walls[plane].pressure_map = true;
    s.walls[plane].map_cell = 0.007;
  }
  return s;
}

Vec3d impulse(const Wall& w) {
  return {w.load.impulse[0].value(), w.load.impulse[1].value(), w.load.impulse[2].value()};
}

double area(const shapes::Mesh& m, std::size_t t) {
  const Vec3d &a = m.vertices[m.triangles[3 * t]], &b = m.vertices[m.triangles[3 * t + 1]],
              &c = m.vertices[m.triangles[3 * t + 2]];
  return 0.5 * norm(cross(b - a, c - a));
}

TEST(WallLoads, TractionsAddUpToTheMeanForceSinceTheFrame) {
  World w = build_world(tray());
  Vec3d before{}, sum{};
  int loaded = 0;
  while (w.step < 900) {
    if (w.step % per_frame == 0) before = impulse(w.walls[ridge]), sum = {};
    advance(w, 1);
    sum += w.walls[ridge].force * w.time_step.dt;
    if (w.step % 41 != 0 && w.step % per_frame != 0) continue;
    const Wall& wall = w.walls[ridge];
    const double duration = map_duration(w);
    EXPECT_EQ(duration, static_cast<double>((w.step - 1) % per_frame + 1) * w.time_step.dt);
    const auto map = tractions(w, wall);
    ASSERT_EQ(map.size(), 4u);
    Vec3d force{};
    double total = 0;
    for (std::size_t t = 0; t < map.size(); ++t) {
      force += map[t].traction * area(*wall.mesh, t);
      total += norm(map[t].traction) * area(*wall.mesh, t);
      loaded += map[t].pressure > 0 ? 1 : 0;
      EXPECT_GE(map[t].pressure, 0);
      // The traction is its normal and tangential parts: at most their sum.
      EXPECT_LE(norm(map[t].traction), (map[t].pressure + norm(map[t].shear)) * (1 + 1e-9));
    }
    EXPECT_LE(norm(force - sum * (1 / duration)), 1e-12 * total);
    EXPECT_LE(norm(impulse(wall) - before - sum), 1e-12 * norm(impulse(wall)) + 1e-12 * norm(sum));
  }
  EXPECT_GT(loaded, 20);
}

// A cube that rests on one of eight triangles of a floor, 1 m below which nothing else is.
TEST(WallLoads, OnlyTheTriangleUnderABodyBearsIt) {
  Scene s;
  s.run.steps = 4000;
  s.gravity = {0, 0, -8};
  s.materials = {scenes::material("soft", 1e7, 1000, 0.2, 0.5)};
  s.shapes = {scenes::box("cube", {0.0625, 0.0625, 0.0625})};
  WallSpec floor;
  floor.name = "floor";
  floor.kind = "mesh";
  floor.material = "soft";
  floor.pressure_map = true;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) floor.vertices.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (const std::uint32_t corner : {0u, 1u, 3u, 4u}) {
    floor.triangles.push_back({corner, corner + 1, corner + 4});
    floor.triangles.push_back({corner, corner + 4, corner + 3});
  }
  s.walls = {floor};
  s.bodies = {scenes::body("cube", "soft", {1.75, 1.25, 0.03125})};  // over the triangle 4, 5, 8
  World w = build_world(s);
  s.output.interval = 1000 * w.time_step.dt;
  w = scenes::run(s, 4000);
  ASSERT_EQ(w.walls[0].mesh->facets.size(), 1u);
  const auto map = tractions(w, w.walls[0]);
  const double weight = 8 * 1000 * 0.0625 * 0.0625 * 0.0625;
  for (std::size_t t = 0; t < map.size(); ++t) {
    const double expected = t == 6 ? weight / 0.5 : 0;
    EXPECT_NEAR(map[t].pressure, expected, 1e-3 * weight) << t;
    EXPECT_NEAR(map[t].traction.z, -expected, 1e-3 * weight) << t;
  }
}

// On planes too, the one that a servo moves included: Σ traction · area of the squares that were touched.
TEST(WallLoads, SquaresOfPlanesAddUpToTheMeanForceSinceTheFrame) {
  World w = build_world(tray());
  std::vector<Vec3d> sum(w.walls.size());
  std::size_t most = 0;
  while (w.step < 900) {
    if (w.step % per_frame == 0) std::fill(sum.begin(), sum.end(), Vec3d{});
    advance(w, 1);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += w.walls[i].force * w.time_step.dt;
    if (w.step % per_frame != 0) continue;
    for (const std::size_t plane : {floor_wall, press}) {
      const Wall& wall = w.walls[plane];
      const auto map = tractions(w, wall);
      ASSERT_EQ(map.size(), wall.load.squares.size());
      EXPECT_TRUE(std::is_sorted(wall.load.squares.begin(), wall.load.squares.end()));
      most = std::max(most, map.size());
      Vec3d force{};
      double total = 0;
      for (const MapTraction& t : map) {
        force += t.traction * (0.007 * 0.007);
        total += norm(t.traction) * (0.007 * 0.007);
        EXPECT_GE(t.pressure, 0);
      }
      EXPECT_LE(norm(force - sum[plane] * (1 / map_duration(w))), 1e-12 * total);
    }
  }
  EXPECT_GT(most, 20u);
}

// Cubes at rest on a leaning plane: each loads the square that its centre is over, by its weight, and no other.
TEST(WallLoads, OnlyTheSquaresUnderBodiesBearThem) {
  Scene s;
  s.gravity = {0, -4.8, -6.4};  // into the plane
  s.materials = {scenes::material("soft", 1e7, 1000, 0.2, 0.5)};
  s.shapes = {scenes::box("cube", {0.0625, 0.0625, 0.0625})};
  s.walls = {scenes::plane("slope", "soft", {0.5, 0, 0}, {0, 0.6, 0.8})};
  s.walls[0].pressure_map = true;
  s.walls[0].map_cell = 0.25;
  const World still = build_world(s);
  const Quatd turn = still.walls[0].orientation;
  const std::array<std::array<std::int64_t, 2>, 3> squares{{{-3, 2}, {0, -1}, {0, 7}}};
  for (const auto& [i, j] : squares)
    s.bodies.push_back(scenes::body(
        "cube", "soft",
        s.walls[0].point +
            rotate(turn, Vec3d{0.25 * (static_cast<double>(i) + 0.4), 0.25 * (static_cast<double>(j) + 0.7), 0.03125}),
        {}, {}, turn));
  World w = build_world(s);
  s.output.interval = 1000 * w.time_step.dt;
  w = scenes::run(s, 4000);
  const auto map = tractions(w, w.walls[0]);
  ASSERT_EQ(map.size(), 3u);
  const double pressure = 8 * 1000 * 0.0625 * 0.0625 * 0.0625 / (0.25 * 0.25);
  const io::WallSurface drawn = io::map_squares(w, 0);
  const std::vector<std::uint32_t> order = order_by_id(w);
  for (std::size_t t = 0; t < map.size(); ++t) {
    EXPECT_EQ(w.walls[0].load.squares[t], squares[t]);
    EXPECT_NEAR(map[t].pressure, pressure, 1e-3 * pressure);
    EXPECT_LT(norm(map[t].traction - Vec3d{0, -0.6, -0.8} * pressure), 1e-3 * pressure);
    Vec3d twice{};  // the square in the file is under its cube, of the right area
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3d a = drawn.vertices[4 * t + k] - w.particles.motion[order[t]].position;
      const Vec3d b = drawn.vertices[4 * t + (k + 1) % 4] - w.particles.motion[order[t]].position;
      twice += cross(a, b);
      EXPECT_GT(dot(cross(a, b), Vec3d{0, 0.6, 0.8}), 0);
    }
    EXPECT_NEAR(norm(twice - dot(twice, Vec3d{0, 0.6, 0.8}) * Vec3d{0, 0.6, 0.8}), 0, 1e-12);
    EXPECT_NEAR(dot(twice, Vec3d{0, 0.6, 0.8}), 2 * 0.25 * 0.25, 1e-12);
  }
}

bool same_loads(const World& a, const World& b) {
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    const WallLoad &x = a.walls[i].load, &y = b.walls[i].load;
    if (impulse(a.walls[i]) != impulse(b.walls[i]) || x.work.value() != y.work.value()) return false;
    if (x.map.size() != y.map.size() || x.squares != y.squares) return false;
    for (std::size_t t = 0; t < x.map.size(); ++t)
      if (x.map[t].force != y.map[t].force || x.map[t].tangential != y.map[t].tangential ||
          x.map[t].pressing != y.map[t].pressing)
        return false;
  }
  return true;
}

TEST(WallLoads, SameBitsForThreadsAndSkinsAndWithoutTheMap) {
  const Scene s = tray();
  const World reference = scenes::run(s, 600);
  EXPECT_GT(reference.walls[ridge].load.map[0].pressing, 0);
  EXPECT_GT(reference.walls[floor_wall].load.squares.size(), 10u);
  EXPECT_TRUE(same_loads(reference, scenes::run(s, 600, 3)));
  Scene other = s;
  other.run.skin = 0.3 * reference.skin;
  EXPECT_TRUE(same_loads(reference, scenes::run(other, 600)));
  other = s;
  for (WallSpec& x : other.walls) x.pressure_map = false;
  const World off = scenes::run(other, 600);
  EXPECT_TRUE(off.walls[ridge].load.map.empty());
  EXPECT_TRUE(off.walls[floor_wall].load.map.empty());
  EXPECT_EQ(state_hash(off), state_hash(reference));
}

// An undamped ball off a wall that comes towards it: what it takes is what the wall gives.
TEST(WallLoads, WorkOnTheWallIsWhatTheBodyLoses) {
  Scene s;
  s.run.steps = 20000;
  s.run.dt_fraction = 0.01;
  s.materials = {scenes::material("soft", 1e6, 1000, 1, 0)};
  s.shapes = {scenes::sphere("ball", 0.05)};
  s.walls = {scenes::plane("bat", "soft", {0, 0, 0}, {0, 0, 1})};
  s.walls[0].motion = WallMotion::translation;
  s.walls[0].velocity = {0.5, 0, 2};
  s.bodies = {scenes::body("ball", "soft", {0, 0, 0.051}, {0, 0, -1})};
  World w = build_world(s);
  const double first = energies(w).translational;
  bool touched = false, pushed = false;
  while (w.step < s.run.steps && !(touched && touching_contacts(w).empty())) {
    advance(w, 1);
    touched = touched || !touching_contacts(w).empty();
    pushed = pushed || wall_power(w.walls[0]) < 0;
  }
  ASSERT_TRUE(touched && pushed && touching_contacts(w).empty());
  const double gained = energies(w).translational - first;  // from 1 to 5 m/s
  EXPECT_NEAR(gained, 24 * first, 0.01 * gained);
  EXPECT_NEAR(w.walls[0].load.work.value(), -gained, 1e-4 * gained);
  EXPECT_NEAR(impulse(w.walls[0]).z, -momentum(w).z * 6 / 5, 1e-3 * norm(momentum(w)));
}

TEST(WallsCsv, HasARowPerTimeAndWall) {
  const Folder folder("walls");
  RunOptions options;
  options.folder = folder.path();
  World w = build_world(tray());
  run(w, options, false);
  const io::Table table = io::read_csv(folder / "walls.csv");
  const std::size_t walls = w.walls.size(), frames = 1 + 900 / per_frame + 1;
  ASSERT_EQ(table.row_count(), walls * frames);
  const std::size_t name = io::column(table, "wall");
  const auto value = [&](std::size_t row, const char* key) { return io::number(table, row, io::column(table, key)); };
  for (std::size_t i = 0; i < walls; ++i) {
    const std::size_t row = (frames - 1) * walls + i;
    const Wall& wall = w.walls[i];
    EXPECT_EQ(table.cell(row, name), wall.name);
    EXPECT_EQ(value(row, "time"), w.time());
    EXPECT_EQ(value(row, "x"), wall.position.x);
    EXPECT_EQ(value(row, "force_y"), wall.force.y);
    EXPECT_EQ(value(row, "torque_z"), wall.torque.z);
    EXPECT_EQ(value(row, "power"), wall_power(wall));
    EXPECT_EQ(value(row, "impulse_x"), impulse(wall).x);
    EXPECT_EQ(value(row, "work"), wall.load.work.value());
    EXPECT_EQ(table.cell(row, io::column(table, "area")).empty(), i != ridge);
  }
  double normal = 0;
  for (const ContactReport& c : touching_contacts(w))
    if (c.wall && c.b == ridge) normal -= dot(c.force, c.normal);
  const std::size_t row = (frames - 1) * walls + ridge;
  EXPECT_GT(normal, 0);
  EXPECT_DOUBLE_EQ(value(row, "mean_pressure") * value(row, "area"), normal);
}

TEST(WallsCsv, AResumedRunWritesTheSameBytes) {
  const Folder folder("walls");
  Scene s = tray();
  s.output.walls_interval = 16 * s.run.dt;
  RunOptions options;
  options.folder = folder / "whole";
  World whole = build_world(s);
  run(whole, options, false);
  EXPECT_EQ(io::read_csv(options.folder + "/walls.csv").row_count(), whole.walls.size() * (1 + 900 / 16 + 1));

  std::atomic<bool> stop = false;
  options.folder = folder / "parts";
  options.interrupt = &stop;
  options.observe = [&stop](const World& w) { stop = w.step == 601; };
  World first = build_world(s);
  ASSERT_EQ(run(first, options, false), RunEnd::interrupted);
  stop = false;
  options.observe = nullptr;
  World second = build_world(s);
  load_state(second, io::read_last_checkpoint(options.folder)->state);
  EXPECT_TRUE(same_loads(second, first));
  run(second, options, true);
  for (const char* name : {"/walls.csv", "/frames/walls_000640.vtp", "/frames/walls_000900.vtp"})
    EXPECT_EQ(text_of(folder / "whole" + name), text_of(options.folder + name)) << name;
  const std::string map = text_of(options.folder + "/frames/walls_000900.vtp");
  for (const char* array : {"Name=\"pressure\"", "Name=\"traction\"", "Name=\"shear\""})
    EXPECT_NE(map.find(array), std::string::npos) << array;
}

TEST(WallsCsv, WhatIsOffIsNotWritten) {
  const Folder folder("walls");
  Scene s = tray();
  s.run.steps = 3;
  s.output.walls = false;
  for (WallSpec& x : s.walls) x.pressure_map = false;
  RunOptions options;
  options.folder = folder.path();
  World w = build_world(s);
  run(w, options, false);
  EXPECT_FALSE(std::filesystem::exists(folder / "walls.csv"));
  EXPECT_EQ(text_of(folder / "frames/walls_000003.vtp").find("pressure"), std::string::npos);
}

}  // namespace
}  // namespace dem
