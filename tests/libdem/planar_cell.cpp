// Periodic boundaries and deforming boxes of the plane: as in space, with stress over the thickness of the prisms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

#include "libdem/deformation.h"
#include "libdem/io/surfaces.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.005, thickness = 0.01;  // m

Scene plane(const Vec3d& box, const std::string& axes = "xy") {
  Scene s;
  s.dimension = 2;
  s.thickness = thickness;
  s.law.name = LawName::spring_dashpot;
  s.run.steps = 1;
  s.run.max_initial_overlap = 0.2;
  MaterialSpec m = scenes::material("soft", 5e6, 2500, 0.4, 0.3);
  m.stiffness = 2e4;
  s.materials = {m};
  ShapeSpec disc = scenes::sphere("disc", radius);
  disc.kind = "disc";
  ShapeSpec ellipse;
  ellipse.name = "ellipse";
  ellipse.kind = "ellipse";
  ellipse.semi_axis_a = 1.2 * radius;
  ellipse.semi_axis_b = 0.8 * radius;
  ShapeSpec hexagon;
  hexagon.name = "hexagon";
  hexagon.kind = "regular_polygon";
  hexagon.sides = 6;
  hexagon.circumradius = radius;
  s.shapes = {disc, ellipse, hexagon};
  s.periodic.axes = axes;
  s.periodic.upper = box;
  return s;
}

FillSpec fill(const Vec3d& lower, const Vec3d& upper, std::uint64_t count, const Vec3d& velocity) {
  FillSpec f;
  f.lower = lower;
  f.upper = upper;
  f.count = count;
  f.velocity = velocity;
  f.items = {{"disc", "soft", 1, 0.6, 1.0}, {"ellipse", "soft", 1, 0.7, 1.0}, {"hexagon", "soft", 1, 0.6, 1.0}};
  return f;
}

constexpr double edge = 0.2;
constexpr std::uint64_t bodies = 200, steps = 1000;

// Two clouds that meet in a box which deforms, at the end by its stress.
Scene gas() {
  Scene s = plane({edge, edge, 0});
  s.fills = {fill({}, {edge, edge / 2, 0}, bodies / 2, {3, 5, 0}),
             fill({0, edge / 2, 0}, {edge, edge, 0}, bodies / 2, {-2, -6, 0})};
  DeformSpec first, second;
  first.strain_rates = {-24, -8, 0};
  second.start = 0.00390625;
  second.stress_axes = "xy";
  second.target_stress = {8e3, 6e3, 0};
  second.rate_limit = 24;
  s.periodic.deform = {first, second};
  return s;
}

// The same clouds in a box that keeps its form.
Scene still() {
  Scene s = gas();
  s.periodic.deform.clear();
  return s;
}

// Periodic along x; along y they fly between a floor and a roof.
Scene layer() {
  Scene s = still();
  s.periodic.axes = "x";
  s.gravity = {4, -9.81, 0};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 1, 0}),
             scenes::plane("roof", "soft", {0, edge, 0}, {0, -1, 0})};
  for (WallSpec& w : s.walls) w.kind = "line";
  return s;
}

const std::array scenes_of_the_plane{still, gas, layer};

TEST(PlanarCell, AHexagonalArrayBearsTheStressOfItsSprings) {
  const double pitch = 2 * radius * 1.001, row = pitch * std::sqrt(0.75);
  Scene s = plane({6 * pitch, 6 * row, 0});
  s.materials[0].restitution = 1;
  s.materials[0].friction = 0;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i)
      s.bodies.push_back(scenes::body("disc", "soft", {(i + 0.5 * (j % 2) + 0.25) * pitch, (j + 0.5) * row, 0}));
  DeformSpec d;
  d.strain_rates = {-3, -2, 0};
  s.periodic.deform = {d};
  World w = build_world(s);
  while (w.cell.lattice.length.x > 0.99 * 6 * pitch) advance(w, 1);
  const Vec3d a{w.cell.lattice.length.x / 6, 0, 0}, b{a.x / 2, w.cell.lattice.length.y / 6, 0};
  Mat3d expected;
  for (const Vec3d& n : {a, b, Vec3d{-b.x, b.y, 0}}) {
    const double force = w.pairs[0].stiffness_n * (2 * radius - norm(n));
    for (int k = 0; k < 3; ++k) expected.row[k] += n * (force / norm(n) * n[k] / (a.x * b.y * thickness));
  }
  const Mat3d got = cell_stress(w);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(got.row[k][k], expected.row[k][k], 1e-9 * expected.row[k][k]) << k;
  EXPECT_NEAR(got.row[0].y, 0, 1e-9 * got.row[0].x);
  EXPECT_EQ(got.row[2], Vec3d{});
  EXPECT_EQ(coordination(w).all, 6);
  EXPECT_NEAR(solid_fraction(w), std::numbers::pi * radius * radius / (a.x * b.y), 1e-12);
}

TEST(PlanarCell, NothingLeavesThePlaneOrIsLost) {
  for (const auto& make : scenes_of_the_plane) {
    const World w = scenes::run(make(), steps);
    EXPECT_EQ(w.particles.count(), bodies);
    EXPECT_GT(w.counters.contact_steps, 2000u);
    const io::Box box = io::cell_box(w);
    for (std::uint32_t i = 0; i < bodies; ++i) {
      const Motion& m = scenes::motion(w, i);
      EXPECT_EQ(m.position.z, 0);
      EXPECT_EQ(m.velocity.z, 0);
      EXPECT_EQ(m.spin.x, 0);
      EXPECT_EQ(m.spin.y, 0);
      for (int k = 0; k < 2; ++k) {
        EXPECT_GE(m.position[k], box.lower[k]);
        EXPECT_LE(m.position[k], box.upper[k]);
      }
    }
    EXPECT_EQ(w.cell.lattice.length.z, 0);
    // Momentum is that of the start and what walls, gravity and the flow of the box gave.
    double scale = 0;
    for (std::size_t i = 0; i < bodies; ++i) scale += w.particles.mass[i] * norm(w.particles.motion[i].velocity);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(momentum(w)[static_cast<int>(k)], w.balance.initial_momentum[k] + w.balance.impulse[k].value(),
                  1e-12 * scale);
  }
}

// Every pair that touches is one contact, over all images, and nothing else is.
TEST(PlanarCell, NoContactIsMissedOrDoubledAcrossAFace) {
  for (const auto& make : scenes_of_the_plane) {
    Scene s = make();
    for (FillSpec& f : s.fills) f.items.resize(1);  // discs: two of them touch where their centres are near
    const World w = scenes::run(s, steps);
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected, got;
    std::size_t across = 0;
    const auto& motion = w.particles.motion;
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t j = 0; j < bodies; ++j)
        for (int m = -1; m <= 1; ++m)
          for (int n = -1; n <= 1; ++n) {
            const Vec3d image = scaled(w.cell.lattice.length, {static_cast<double>(m), static_cast<double>(n), 0});
            if (w.particles.id[i] >= w.particles.id[j] || ((m != 0 || n != 0) && image == Vec3d{})) continue;
            const Vec3d d = motion[j].position + image - motion[i].position;
            if (norm(d) >= motion[i].bounding_radius + motion[j].bounding_radius) continue;
            expected.insert({w.particles.id[i], w.particles.id[j]});
            across += m != 0 || n != 0 ? 1 : 0;
          }
    for (const ContactReport& c : touching_contacts(w)) {
      if (c.wall) continue;
      EXPECT_TRUE(got.insert(std::minmax(c.a, c.b)).second);
    }
    EXPECT_EQ(got, expected);
    EXPECT_GT(got.size(), 5u);
    EXPECT_GT(across, 0u);
  }
}

TEST(PlanarCell, ThreadsSkinsRebuildsAndARestartDoNotMatter) {
  for (const auto& make : scenes_of_the_plane) {
    const Scene scene = make();
    const World reference = scenes::run(scene, steps);
    const std::uint64_t hash = state_hash(reference);
    EXPECT_EQ(state_hash(scenes::run(scene, steps, 3)), hash);
    for (const double factor : {0.2, 1.5}) {
      Scene s = scene;
      s.run.skin = factor * reference.skin;
      const World w = scenes::run(s, steps);
      EXPECT_NE(w.counters.rebuilds, reference.counters.rebuilds);
      EXPECT_EQ(state_hash(w), hash) << factor;
    }
    Scene s = scene;
    s.run.rebuild_every = 1;
    EXPECT_EQ(state_hash(scenes::run(s, steps)), hash);
    World second = build_world(scene);
    load_state(second, save_state(scenes::run(scene, 700)));
    while (second.step < steps) advance(second, 1);
    EXPECT_EQ(state_hash(second), hash);
  }
}

TEST(PlanarCell, OtherUnitsGiveTheSameBitsScaled) {
  const double length = 0x1p-10, mass = 0x1p20, time = 0x1p6;
  const Scene a = gas();
  Scene b = a;
  for (ShapeSpec& x : b.shapes)
    for (double* v : {&x.radius, &x.semi_axis_a, &x.semi_axis_b, &x.circumradius}) *v *= length;
  b.thickness *= length;
  b.materials[0].density *= mass / (length * length * length);
  b.materials[0].stiffness *= mass / (time * time);
  b.periodic.upper *= length;
  for (FillSpec& f : b.fills) {
    f.lower *= length;
    f.upper *= length;
    f.velocity *= length / time;
  }
  for (DeformSpec& d : b.periodic.deform) {
    d.start *= time;
    d.strain_rates *= 1 / time;
    d.rate_limit /= time;
    d.target_stress *= mass / (length * time * time);
  }
  const World u = scenes::run(a, steps), v = scenes::run(b, steps);
  for (std::uint64_t i = 0; i < bodies; ++i) {
    EXPECT_EQ(scenes::motion(u, i).position * length, scenes::motion(v, i).position);
    EXPECT_EQ(scenes::motion(u, i).velocity * (length / time), scenes::motion(v, i).velocity);
  }
  EXPECT_EQ(u.cell.lattice.rate * (1 / time), v.cell.lattice.rate);
  EXPECT_EQ(cell_stress(u).row[0] * (mass / (length * time * time)), cell_stress(v).row[0]);
}

TEST(PlanarCell, ACollisionAcrossAFaceIsThatInTheMiddle) {
  const auto meeting = [](const std::string& shape, const Vec3d& at, const std::string& axes) {
    Scene s = plane({0.125, 0.125, 0}, axes);
    const Vec3d half{0.0078125, 0.001953125, 0}, speed{1, 0.5, 0};
    s.bodies = {scenes::body(shape, "soft", at - half, speed, {0, 0, 20}, scenes::turn({0, 0, 1}, 0.4)),
                scenes::body(shape, "soft", at + half, -speed, {0, 0, -7}, scenes::turn({0, 0, 1}, 1.1))};
    const World w = scenes::run(s, 2000);
    EXPECT_GT(w.counters.contact_steps, 5u);
    return std::array<Motion, 2>{scenes::motion(w, 0), scenes::motion(w, 1)};
  };
  for (const char* shape : {"disc", "ellipse"}) {
    const auto a = meeting(shape, {0.0625, 0.0625, 0}, "xy");
    for (const auto& [at, axes] : {std::pair{Vec3d{0, 0.0625, 0}, "xy"}, std::pair{Vec3d{0.125, 0, 0}, "xy"},
                                   std::pair{Vec3d{0, 0.0625, 0}, "x"}, std::pair{Vec3d{0.0625, 0.125, 0}, "y"}}) {
      const auto b = meeting(shape, at, axes);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(norm(a[i].velocity - b[i].velocity), 1e-9) << shape;
        EXPECT_LT(std::abs(a[i].spin.z - b[i].spin.z), 1e-6) << shape;
      }
    }
  }
}

// A bed on a floor that goes on sideways for ever: the floor carries the weight.
TEST(PlanarCell, ABedOnAFloorRests) {
  Scene s = plane({0.1, 1, 0}, "x");
  s.gravity = {0, -9.81, 0};
  WallSpec floor = scenes::plane("floor", "soft", {0, 0, 0}, {0, 1, 0});
  floor.kind = "line";
  s.walls = {floor};
  s.fills = {fill({}, {0.1, 0.2, 0}, 60, {0.3, 0, 0})};
  s.run.dt_fraction = 0.3;
  World w = build_world(s);
  while (w.time() < 0.4) advance(w, 1);
  const double weight = w.balance.present.value() * 9.81;
  EXPECT_NEAR(-w.walls[0].force.y, weight, 0.1 * weight);
  std::size_t across = 0;
  for (const ContactReport& c : touching_contacts(w))
    if (!c.wall) across += std::abs(scenes::motion(w, c.a).position.x - scenes::motion(w, c.b).position.x) > 0.05;
  EXPECT_GT(across, 2u);
}

TEST(PlanarCell, ARandomPackingComesToItsPressure) {
  Scene s = plane({edge, edge, 0});
  s.materials[0].friction = 0;
  s.materials[0].restitution = 0.2;
  s.fills = {fill({}, {edge, edge / 2, 0}, 100, {0.2, 0.5, 0}),
             fill({0, edge / 2, 0}, {edge, edge, 0}, 100, {-0.2, -0.5, 0})};
  for (FillSpec& f : s.fills) f.items = {{"disc", "soft", 1, 0.7, 0.7}, {"disc", "soft", 1, 1, 1}};
  DeformSpec d;
  d.stress_axes = "xy";
  d.target_stress = {2e3, 2e3, 0};
  d.isotropic = true;
  d.rate_limit = 3;
  d.gain = 5;
  s.periodic.deform = {d};
  s.run.dt_fraction = 0.3;
  World w = build_world(s);
  while (w.time() < 0.8) advance(w, 1);
  const Mat3d stress = cell_stress(w);
  EXPECT_NEAR(0.5 * (stress.row[0].x + stress.row[1].y), 2e3, 20);
  EXPECT_NEAR(solid_fraction(w), 0.842, 0.012);  // discs of two sizes without friction: jammed at 0.842
  EXPECT_NEAR(coordination(w).backbone, 4.1, 0.2);
}

TEST(PlanarCell, ALayerOfSpheresHasNoStress) {
  Scene s = plane({edge, edge, 0});
  s.disc_model = DiscModel::sphere;
  s.thickness = 0;
  EXPECT_FALSE([&] {
    World w;
    w.scene = s;
    return is_whole(w);
  }());
}

TEST(PlanarCell, PicturesShowTheBox) {
  const World flat = build_world(gas());
  const auto faces = io::cell_surfaces(flat);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].ends.size(), 1u);
  const io::Box box = io::cell_box(flat);
  EXPECT_EQ(box.lower.x, 0);
  EXPECT_EQ(box.upper.y, edge);
  EXPECT_GT(box.upper.z, 0);  // in front of the bodies
  const World solid = build_world(scenes::every_shape_in_a_cell(10));
  EXPECT_EQ(io::cell_surfaces(solid)[0].ends.size(), 6u);
  EXPECT_TRUE(io::cell_surfaces(build_world(scenes::every_shape(3))).empty());
}

}  // namespace
}  // namespace dem
