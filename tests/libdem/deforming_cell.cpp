// A periodic box that deforms: what a lattice of bodies bears is known in closed form; work and energy close; no bit
// depends on threads, skins, rebuilds or a restart.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "libcontact/laws/law.h"
#include "libdem/deformation.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.005;  // m

// Spheres on the sites of a lattice of cubes with edge `edge`, `cells` of them along each side of the box.
Scene lattice(const std::vector<Vec3d>& sites, double edge, int cells, LawName law, double restitution = 1) {
  Scene s;
  s.run.steps = 1000;
  s.run.max_initial_overlap = 0.2;
  s.law.name = law;
  s.materials = {scenes::material("glass", 5e6, 2500, restitution, 0.3)};
  s.materials[0].stiffness = 2e4;
  s.shapes = {scenes::sphere("ball", radius)};
  s.periodic.axes = "xyz";
  s.periodic.upper = Vec3d{edge, edge, edge} * static_cast<double>(cells);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k)
        for (const Vec3d& site : sites)
          s.bodies.push_back(scenes::body(
              "ball", "glass",
              (site + Vec3d{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}) * edge));
  return s;
}

DeformSpec rates(double start, const Vec3d& r) {
  DeformSpec d;
  d.start = start;
  d.strain_rates = r;
  return d;
}

// Force of two of the lattice's spheres at a distance of their centres, N.
double force(const World& w, double distance) {
  const double overlap = 2 * radius - distance;
  if (overlap <= 0) return 0;
  const PairParameters& q = w.pairs[0];
  if (w.scene.law.name == LawName::spring_dashpot) return q.stiffness_n * overlap;
  return 4.0 / 3.0 * q.young_eff * std::sqrt(0.5 * radius) * std::pow(overlap, 1.5);
}

// ½ Σ f d⊗d/|d| over the neighbours of one site, over the volume of that site.
Mat3d expected_stress(const World& w, const std::vector<Vec3d>& neighbours, double sites) {
  Mat3d s;
  const Vec3d edge = w.cell.lattice.length * 0.25;
  for (const Vec3d& n : neighbours) {
    const Vec3d d = scaled(n, edge);
    const double f = force(w, norm(d)) / norm(d);
    for (int k = 0; k < 3; ++k) s.row[k] += d * (0.5 * f * d[k] * sites / (edge.x * edge.y * edge.z));
  }
  return s;
}

void expect_same_stress(const Mat3d& got, const Mat3d& expected, double relative) {
  double scale = 0;
  for (const Vec3d& row : expected.row) scale = std::max(scale, max_abs(row));
  ASSERT_GT(scale, 0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(got.row[i][j], expected.row[i][j], relative * scale) << i << j;
}

const std::vector<Vec3d> cubic_sites{{0.5, 0.5, 0.5}};
const std::vector<Vec3d> cubic_neighbours{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Vec3d> fcc_sites{{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
std::vector<Vec3d> fcc_neighbours() {
  std::vector<Vec3d> list;
  for (const double a : {-0.5, 0.5})
    for (const double b : {-0.5, 0.5})
      for (const Vec3d& d : {Vec3d{a, b, 0}, Vec3d{a, 0, b}, Vec3d{0, a, b}}) list.push_back(d);
  return list;
}

TEST(DeformingCell, ALatticeBearsTheStressOfItsSprings) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin})
    for (const bool fcc : {false, true}) {
      Scene s = fcc ? lattice(fcc_sites, 2 * std::sqrt(2.0) * radius * 1.001, 4, law)
                    : lattice(cubic_sites, 2 * radius * 1.001, 4, law);
      s.materials[0].friction = 0;
      s.periodic.deform = {rates(0, {-2, -3, -4})};
      World w = build_world(s);
      const Vec3d first = w.cell.lattice.length;
      while (w.cell.lattice.length.z > 0.98 * first.z) advance(w, 1);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(w.cell.lattice.length[k], first[k] * std::exp(s.periodic.deform[0].strain_rates[k] * w.time()),
                    1e-9 * first[k]);
      expect_same_stress(cell_stress(w), expected_stress(w, fcc ? fcc_neighbours() : cubic_neighbours, fcc ? 4 : 1),
                         1e-9);
      EXPECT_EQ(w.counters.rebuilds, 1u);  // the bodies follow the box: their neighbours stay the same
      for (const Motion& m : w.particles.motion) EXPECT_LT(norm(m.velocity), 1e-9);
      EXPECT_EQ(coordination(w).all, fcc ? 12 : 6);
      EXPECT_NEAR(solid_fraction(w),
                  static_cast<double>(w.particles.count()) * 4.0 / 3.0 * 3.14159265358979 * std::pow(radius, 3) /
                      cell_volume(w),
                  1e-12);
    }
}

// Bodies that rest relative to the flow of the box approach each other: the dashpots feel it, across faces as inside.
TEST(DeformingCell, DashpotsFeelTheFlow) {
  const double edge = 2 * radius * 0.99, rate = -5;
  Scene s = lattice(cubic_sites, edge, 4, LawName::spring_dashpot, 0.5);
  s.periodic.deform = {rates(0, {rate, 0, 0})};
  World damped = build_world(s);
  s.materials[0].restitution = 1;
  World free = build_world(s);
  free.time_step.dt = damped.time_step.dt;
  for (int i = 0; i < 20; ++i) {
    advance(damped, 1);
    advance(free, 1);
  }
  const double log_e = std::log(0.5), beta = -log_e / std::sqrt(log_e * log_e + 9.869604401089358);
  const double damping = 2 * beta * std::sqrt(0.5 * damped.particles.mass[0] * damped.pairs[0].stiffness_n);
  const double length = damped.cell.lattice.length.x / 4;
  const double expected = damping * -rate * length / (edge * edge);
  const Mat3d a = cell_stress(damped), b = cell_stress(free);
  EXPECT_NEAR(a.row[0].x - b.row[0].x, expected, 0.2 * expected);  // the law lessens its dashpot by a step's lag
  EXPECT_NEAR(a.row[1].y, b.row[1].y, 1e-9 * b.row[1].y);
  double largest = 0, smallest = 1e300;
  for (const ContactReport& c : touching_contacts(damped)) {
    if (std::abs(c.normal.x) < 0.5) continue;
    largest = std::max(largest, norm(c.force));
    smallest = std::min(smallest, norm(c.force));
  }
  EXPECT_NEAR(largest, smallest, 1e-9 * largest);
}

TEST(DeformingCell, AFreeBodyIsSlowedAsTheBoxGrows) {
  Scene s = lattice({}, 0.05, 1, LawName::spring_dashpot);
  s.bodies = {scenes::body("ball", "glass", {0.01, 0.02, 0.03}, {3, -2, 1})};
  s.periodic.deform = {rates(0, {4, -3, 0}), rates(0.05, {0, 8, -2})};
  s.run.dt_auto = false;
  s.run.dt = 0x1p-13;
  World w = build_world(s);
  const Vec3d first = scaled(w.particles.motion[0].velocity, w.cell.lattice.length);
  const auto share = [&] {
    const Vec3d x = w.particles.motion[0].position - w.cell.lower;
    return scaled(x, w.cell.lattice.inverse);
  };
  Vec3d way = share();
  double faces = 0;
  while (w.time() < 0.1) {
    const Vec3d a = scaled(w.particles.motion[0].velocity, w.cell.lattice.inverse);
    advance(w, 1);
    const Vec3d b = scaled(w.particles.motion[0].velocity, w.cell.lattice.inverse);
    way += (a + b) * (0.5 * w.time_step.dt);
  }
  const Vec3d last = scaled(w.particles.motion[0].velocity, w.cell.lattice.length);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(last[k], first[k], 1e-6 * std::abs(first[k])) << k;
    faces += std::floor(way[k]) != 0 ? 1 : 0;
    EXPECT_NEAR(share()[k], way[k] - std::floor(way[k]), 1e-6) << k;
  }
  EXPECT_GT(faces, 1);
}

Scene gas(std::uint64_t count, LawName law) {
  Scene s = scenes::every_shape_in_a_cell(count);
  s.law.name = law;
  return s;
}
constexpr std::uint64_t bodies = 216, steps = 600;

double energy(const World& w) {
  const Energies e = energies(w);
  return e.translational + e.rotational + e.elastic;
}

TEST(DeformingCell, TheWorkOfTheCellIsTheGainOfEnergy) {
  for (const double fraction : {0.2, 0.1, 0.05}) {
    Scene s = gas(bodies, LawName::hertz_mindlin);
    for (MaterialSpec& m : s.materials) {
      m.restitution = 1;
      m.friction = 0;
    }
    for (FillSpec& f : s.fills) f.items.resize(2);  // spheres and ellipsoids: their contacts are springs of the overlap
    s.run.dt_fraction = fraction;
    World w = build_world(s);
    const double start = energy(w);
    while (w.time() < 0.016) advance(w, 1);
    EXPECT_GT(w.counters.contact_steps, 1000u);
    const double work = w.cell.work.value();
    EXPECT_GT(work, 0.1 * start);
    EXPECT_LT(std::abs(energy(w) - start - work), 0.03 * fraction * fraction * work) << fraction;  // of second order
  }
}

TEST(DeformingCell, TheBookOfMomentumCloses) {
  const World w = scenes::run(gas(bodies, LawName::hertz_mindlin), steps);
  const Vec3d now = momentum(w);
  double scale = 0;
  for (std::size_t i = 0; i < bodies; ++i) scale += w.particles.mass[i] * norm(w.particles.motion[i].velocity);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_NEAR(now[k], w.balance.initial_momentum[i] + w.balance.impulse[i].value(), 1e-12 * scale);
    const double factor = 1 / (w.cell.lattice.length[k] / 0.1);
    EXPECT_NEAR(now[k], w.balance.initial_momentum[i] * factor, 1e-4 * scale);  // as a free body
  }
}

// Two bodies meet obliquely about `at`.
std::array<Motion, 2> meeting(const std::string& shape, const Vec3d& at) {
  Scene s = gas(2, LawName::hertz_mindlin);
  s.fills.clear();
  s.periodic.deform = {rates(0, {-40, 20, -10})};
  const Vec3d half{0.0078125, 0.001953125, 0.0009765625}, speed{1, 0.5, 0.25};
  s.bodies = {scenes::body(shape, "soft", at - half, speed, {10, -20, 5}, scenes::turn({0, 0, 1}, 0.4)),
              scenes::body(shape, "hard", at + half, -speed, {-3, 2, 40}, scenes::turn({0, 1, 0}, 1.1))};
  const World w = scenes::run(s, 400);
  EXPECT_GT(w.counters.contact_steps, 5u);
  return {scenes::motion(w, 0), scenes::motion(w, 1)};
}

TEST(DeformingCell, ACollisionAcrossAFaceIsThatInTheMiddle) {
  for (const char* shape : {"ball", "egg", "brick", "grain"}) {
    const auto a = meeting(shape, {0.0625, 0.0625, 0.0625});
    for (const Vec3d& at : {Vec3d{0, 0.0625, 0.0625}, Vec3d{0.0625, 0.125, 0}}) {
      const auto b = meeting(shape, at);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(norm(a[i].velocity - b[i].velocity), 1e-9) << shape;
        EXPECT_LT(norm(a[i].spin - b[i].spin), 1e-6) << shape;
      }
    }
  }
}

// No pair of touching bodies is missed while bodies follow the box.
TEST(DeformingCell, ThreadsSkinsRebuildsAndARestartDoNotMatter) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin}) {
    const Scene scene = gas(bodies, law);
    const World reference = scenes::run(scene, steps);
    const std::uint64_t hash = state_hash(reference);
    EXPECT_GT(reference.time(),
              1.5 * scene.periodic.deform[1].start);  // both entries of the deformation took their turn
    EXPECT_GT(reference.counters.contact_steps, 2000u);
    EXPECT_LT(reference.counters.rebuilds, 2 * steps / 3);
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
    const World first = scenes::run(scene, 347);
    load_state(second, save_state(first));
    EXPECT_EQ(state_hash(second), state_hash(first));
    EXPECT_EQ(cell_stress(second).row[0], cell_stress(first).row[0]);
    while (second.step < steps) advance(second, 1);
    EXPECT_EQ(state_hash(second), hash);
  }
}

// The stress that is carried along is the one of the state, to the bit, also from a state without lists.
TEST(DeformingCell, TheStressIsThatOfTheState) {
  World w = scenes::run(gas(bodies, LawName::hertz_mindlin), steps);
  World read = build_world(w.scene);
  load_state(read, save_state(w));
  const Mat3d carried = cell_stress(w);
  w.cell.deforms = read.cell.deforms = false;
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(cell_stress(w).row[k], carried.row[k]);
    EXPECT_EQ(cell_stress(read).row[k], carried.row[k]);
  }
}

TEST(DeformingCell, ABoxThatBecomesTooShortStops) {
  Scene s = lattice({}, 0.03, 1, LawName::spring_dashpot);
  s.bodies = {scenes::body("ball", "glass", {0.01, 0.02, 0.02})};
  s.periodic.deform = {rates(0, {0, -10, 0})};
  std::vector<std::uint64_t> stopped;
  for (const double skin : {0.0005, 0.002}) {
    s.run.skin = skin;
    World w = build_world(s);
    try {
      while (w.step < 100000) advance(w, 1);
      FAIL() << "not stopped";
    } catch (const RunError& e) {
      EXPECT_NE(std::string(e.what()).find("long in y, too short for one image"), std::string::npos) << e.what();
    }
    EXPECT_NEAR(w.cell.lattice.length.y, 4 * radius, 1e-3 * radius);
    stopped.push_back(w.step);
  }
  EXPECT_EQ(stopped[0], stopped[1]);
}

TEST(DeformingCell, ARateTooFastForTheTimeStepIsRefused) {
  Scene s = lattice(cubic_sites, 2 * radius * 1.01, 4, LawName::spring_dashpot);
  s.run.dt_auto = false;
  s.run.dt = 1e-4;
  s.periodic.deform = {rates(0, {0, 101, 0})};
  EXPECT_THROW(build_world(s), InputError);
  s.periodic.deform = {rates(0, {0, 99, 0})};
  EXPECT_NO_THROW(build_world(s));
}

TEST(DeformingCell, RattlersAreLeftOutOfTheBackbone) {
  Scene s = lattice(cubic_sites, 2 * radius * 0.999, 4, LawName::spring_dashpot);
  s.materials[0].friction = 0;
  s.bodies.erase(s.bodies.begin());  // a site is empty
  s.bodies.push_back(scenes::body("ball", "glass", Vec3d{0.5, 0.5, 0.5} * (2 * radius * 0.999)));
  s.bodies.back().scale = 0.5;  // a small one in its place touches nothing
  const Coordination z = coordination(build_world(s));
  EXPECT_EQ(z.pairs, 3u * 64u - 6u);
  EXPECT_DOUBLE_EQ(z.all, 2.0 * (3 * 64 - 6) / 64);
  EXPECT_DOUBLE_EQ(z.rattlers, 1.0 / 64);
  EXPECT_DOUBLE_EQ(z.backbone, 2.0 * (3 * 64 - 6) / 63);
}

}  // namespace
}  // namespace dem
