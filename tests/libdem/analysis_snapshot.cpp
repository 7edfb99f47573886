// What an analysis sees of a world: order, senses, nearest images, the domain; the same from a record.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdem/analysis/snapshot.h"
#include "libdem/io/io.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"
#include "tests/libdem/scenes_planar.h"

namespace {

using namespace dem;
using analysis::Domain;
using analysis::Snapshot;
using analysis::SnapshotContact;

std::tuple<std::uint32_t, bool, std::uint32_t, std::uint32_t> order_of(const SnapshotContact& c) {
  return {c.a, c.wall, c.b, c.part};
}

// Contacts in order, one to one with those of the world, and their forces on each body add to what the world found.
void expect_contacts_of(const World& world, const Snapshot& s) {
  ASSERT_EQ(s.contacts.size(), touching_contacts(world).size());
  ASSERT_GT(s.contacts.size(), 0u);
  std::vector<Vec3d> sum(s.count());
  double largest = 0;
  for (std::size_t k = 0; k < s.contacts.size(); ++k) {
    const SnapshotContact& c = s.contacts[k];
    if (k > 0) {
      EXPECT_LE(order_of(s.contacts[k - 1]), order_of(c));
    }
    sum[c.a] += c.force;
    largest = std::max(largest, norm(c.force));
    if (!c.wall) {
      ASSERT_LT(c.a, c.b);
      sum[c.b] -= c.force;
      EXPECT_LT(norm(c.branch), s.bounding_radius[c.a] + s.bounding_radius[c.b]);
    }
    EXPECT_NEAR(norm(c.normal), 1, 1e-12);
    EXPECT_LT(norm(s.between(s.position[c.a], c.point)), 1.001 * s.bounding_radius[c.a]);
  }
  const std::vector<std::uint32_t> order = order_by_id(world);
  for (std::size_t i = 0; i < s.count(); ++i)
    EXPECT_LT(norm(sum[i] - world.particles.force[order[i]]), 1e-12 * largest) << "body " << s.id[i];
}

TEST(AnalysisSnapshot, EveryShapeInATray) {
  for (const Scene& scene : {scenes::every_shape(80), scenes::bodies_of_parts(80)}) {
    const World world = scenes::run(scene, 300);
    const Snapshot s = analysis::snapshot_of(world);
    ASSERT_EQ(s.count(), 80u);
    for (std::size_t i = 0; i < s.count(); ++i) {
      EXPECT_EQ(s.id[i], i);
      EXPECT_NEAR(s.mass[i], s.volume[i] * world.materials[s.material[i]].density, 1e-12 * s.mass[i]);
      EXPECT_NEAR(s.volume[i], 4.0 / 3.0 * std::numbers::pi * std::pow(s.radius[i], 3), 1e-12 * s.volume[i]);
    }
    EXPECT_EQ(s.time, world.time());
    expect_contacts_of(world, s);
  }
}

TEST(AnalysisSnapshot, AcrossTheFacesOfACell) {
  const World world = scenes::run(scenes::every_shape_in_a_cell(150), 250);
  const Snapshot s = analysis::snapshot_of(world);
  expect_contacts_of(world, s);
  std::size_t across = 0;
  for (const SnapshotContact& c : s.contacts)
    if (norm(s.position[c.b] - s.position[c.a] - c.branch) > 1e-9) ++across;
  EXPECT_GT(across, 0u);
  const Domain domain = domain_of(s);
  EXPECT_EQ(domain.lower, world.cell.lower);
  EXPECT_NEAR(norm(domain.upper - domain.lower - world.cell.lattice.length), 0, 1e-15);
}

TEST(AnalysisSnapshot, OfARecordAsOfTheWorld) {
  const io_test::Folder folder("analysis_record");
  Scene scene = scenes::bodies_of_parts(60);
  World world = scenes::run(scene, 300);
  io::Record(folder / "record.h5", world, false).write(world);
  World read = build_world(scene);
  io::load_frame(folder / "record.h5", read, 0);
  const Snapshot a = analysis::snapshot_of(world), b = analysis::snapshot_of(read);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.rotation, b.rotation);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    EXPECT_EQ(order_of(a.contacts[k]), order_of(b.contacts[k]));
    EXPECT_EQ(a.contacts[k].force, b.contacts[k].force);
    EXPECT_EQ(a.contacts[k].normal, b.contacts[k].normal);
    EXPECT_EQ(a.contacts[k].point, b.contacts[k].point);
    EXPECT_EQ(a.contacts[k].branch, b.contacts[k].branch);
  }
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t w = 0; w < a.walls.size(); ++w) EXPECT_EQ(a.walls[w].position, b.walls[w].position);
}

TEST(AnalysisSnapshot, SensesOfTwoBallsOnAFloor) {
  const Snapshot s = analysis::snapshot_of(io_test::small_world());
  ASSERT_EQ(s.contacts.size(), 2u);
  EXPECT_FALSE(s.contacts[0].wall);
  EXPECT_EQ(s.contacts[0].pressing(), 12);
  EXPECT_NEAR(norm(s.contacts[0].branch - Vec3d{0.999, 0, 0.001}), 0, 1e-12);
  EXPECT_TRUE(s.contacts[1].wall);
  EXPECT_EQ(s.contacts[1].b, 0u);
  EXPECT_EQ(s.contacts[1].pressing(), 30);
  EXPECT_NEAR(norm(s.contacts[1].branch - Vec3d{0, 0, -0.5}), 0, 1e-12);
}

// Prisms and, with disc_model "sphere", the discs of a layer of spheres.
TEST(AnalysisSnapshot, VolumesOfThePlane) {
  for (const DiscModel model : {DiscModel::prism, DiscModel::sphere}) {
    Scene scene = scenes::planar_tray({scenes::disc("coin", 0.004)}, 20);
    scene.disc_model = model;
    const World world = scenes::run(scene, 1500);
    const Snapshot s = analysis::snapshot_of(world);
    EXPECT_EQ(s.dimension, 2);
    for (std::size_t i = 0; i < s.count(); ++i)
      EXPECT_NEAR(s.volume[i], std::numbers::pi * s.size[i].x * s.size[i].x * scene.thickness, 1e-12 * s.volume[i]);
    expect_contacts_of(world, s);
    const Domain domain = domain_of(s);
    EXPECT_EQ(domain.lower.y, 0);  // the floor; the sides lean and cut nothing
    EXPECT_EQ(domain.lower.z, 0);
    EXPECT_EQ(domain.upper.z, 0);
    EXPECT_GT(domain.volume(s), 0);
    EXPECT_TRUE(domain.holds(s.position[0]));
  }
}

TEST(AnalysisSnapshot, DomainIsCutByWalls) {
  World world = io_test::small_world();
  Domain d = domain_of(analysis::snapshot_of(world));
  EXPECT_EQ(d.lower.z, 0);  // the floor; brick and grains reach below
  const double low = d.lower.x;
  EXPECT_GT(low, -2);               // the side stands at x = −2, farther out than any body
  world.walls[1].position.x = 1.5;  // now at x = −0.5: within the brick and the pebble, outside of all centres
  d = domain_of(analysis::snapshot_of(world));
  EXPECT_EQ(d.lower.x, -0.5);
  EXPECT_LT(low, -0.5);
  world.walls[1].position.x = 2.5;  // amid the bodies
  EXPECT_EQ(domain_of(analysis::snapshot_of(world)).lower.x, low);
  world.walls[1].position.x = 1.5;
  world.walls[1].present = false;
  EXPECT_EQ(domain_of(analysis::snapshot_of(world)).lower.x, low);
  world.walls[0].orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // no longer level: its normal is along −y
  world.walls[0].position = {0, 1.4, 0};
  d = domain_of(analysis::snapshot_of(world));
  EXPECT_LT(d.lower.z, 0.5);
  EXPECT_EQ(d.upper.y, 1.4);
}

TEST(AnalysisSnapshot, NothingAndOneBody) {
  World world = io_test::small_world();
  world.contacts = {};
  world.particles = {};
  const Snapshot none = analysis::snapshot_of(world);
  EXPECT_EQ(none.count(), 0u);
  EXPECT_EQ(domain_of(none).volume(none), 0);
  world.walls.clear();
  io_test::add_body(world, 0, 0, 2, {1, 2, 3});
  const Snapshot one = analysis::snapshot_of(world);
  EXPECT_NEAR(domain_of(one).volume(one), 8, 1e-12);
  EXPECT_TRUE(domain_of(one).holds({1, 2, 3}));
  EXPECT_FALSE(domain_of(one).holds({2, 2, 3}));
}

}  // namespace
