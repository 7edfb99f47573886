// Energies and velocities of a snapshot against the loop's own and closed forms.
#include <gtest/gtest.h>

#include <fstream>

#include "libdem/analysis/energy.h"
#include "libdem/analysis/frames.h"
#include "libdem/analysis/velocity.h"
#include "libdem/io/io.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"
#include "tests/libdem/scenes_planar.h"

namespace {

using namespace dem;
using namespace dem::analysis;

bool has(const Result& r, const std::string& name) {
  return std::any_of(r.scalars.begin(), r.scalars.end(), [&](const Scalar& s) { return s.name == name; });
}

TEST(AnalysisEnergy, AsTheLoopHasIt) {
  Scene prisms = scenes::planar_tray({scenes::disc("coin", 0.004), scenes::ellipse("egg", 0.003, 0.006)}, 30);
  Scene spheres = scenes::planar_tray({scenes::disc("coin", 0.004)}, 30);
  spheres.disc_model = DiscModel::sphere;
  for (const Scene& scene : {scenes::every_shape(60), scenes::bodies_of_parts(60), prisms, spheres}) {
    const World world = scenes::run(scene, 300);
    const Energies e = energies(world);
    const Result r = report_energy(snapshot_of(world), {});
    EXPECT_NEAR(scalar(r, "translational"), e.translational, 1e-12 * e.translational);
    EXPECT_NEAR(scalar(r, "rotational"), e.rotational, 1e-9 * e.rotational);
    EXPECT_NEAR(scalar(r, "potential"), e.potential, 1e-12 * e.translational);
    EXPECT_EQ(scalar(r, "elastic"), e.elastic);
    EXPECT_FALSE(has(r, "lost_friction"));
  }
}

TEST(AnalysisEnergy, LossesWhereTheSceneKeepsBooks) {
  Scene scene = scenes::every_shape(60);
  scene.law.ledger = true;
  const World world = scenes::run(scene, 400);
  const Result r = report_energy(snapshot_of(world), {});
  EXPECT_GT(scalar(r, "lost_friction"), 0);
  EXPECT_EQ(scalar(r, "lost_friction"), dissipated(world)[1]);
  World filled = io_test::small_world();  // no running world: nobody knows what its contacts store
  EXPECT_FALSE(has(report_energy(snapshot_of(filled), {}), "elastic"));
}

// A frame of a record stores what the world did, with a memory of contacts (the ledger asks for one) and without.
TEST(AnalysisEnergy, OfARecordAsOfTheWorld) {
  std::vector<Scene> all{scenes::every_shape(60), scenes::bodies_of_parts(60), scenes::every_shape_in_a_cell(150)};
  all.push_back(scenes::every_shape(60));
  all.back().law.ledger = true;
  for (const Scene& scene : all) {
    const io_test::Folder folder("analysis_energy");
    const World world = scenes::run(scene, 300);
    std::ofstream(folder / "scene.toml") << scene_to_toml(world.scene);
    io::Record(folder / "record.h5", world, false).write(world);
    const Result r = report_energy(open_frames(folder.path(), {}).read(0), {});
    const double elastic = energies(world).elastic;
    EXPECT_NEAR(scalar(r, "elastic"), elastic, 1e-12 * elastic);  // sizes are read, radii made of them anew
    EXPECT_GT(scalar(r, "elastic"), 0);
    EXPECT_FALSE(has(r, "lost_friction"));
  }
}

TEST(AnalysisVelocity, MeanAndTemperature) {
  Snapshot s = snapshot_of(io_test::small_world());
  for (std::size_t i = 0; i < s.count(); ++i) {
    s.mass[i] = 1;
    s.velocity[i] = {i % 2 == 0 ? 1.0 : 5.0, 2, 0};
    s.spin[i] = {0, 0, i < 3 ? -6.0 : 6.0};
  }
  const Velocities v = velocities_of(s, {});
  EXPECT_EQ(v.count, 6u);
  EXPECT_NEAR(norm(v.mean - Vec3d{3, 2, 0}), 0, 1e-15);
  EXPECT_NEAR(v.temperature, 4.0 / 3, 1e-15);
  EXPECT_NEAR(v.spin_temperature, 12, 1e-14);
  EXPECT_NEAR(v.largest_speed, std::sqrt(29), 1e-15);
  Settings settings;
  settings.bins = 4;
  const Result r = report_velocity(s, settings);
  double bodies = 0, whole = 0;
  for (const double n : r.tables[0].columns[1].values) bodies += n;
  for (const double d : r.tables[0].columns[2].values) whole += d * std::sqrt(29) / 4;
  EXPECT_EQ(bodies, 6);
  EXPECT_NEAR(whole, 1, 1e-14);
  settings.region = Domain{s.position[1] - Vec3d{0.1, 0.1, 0.1}, s.position[1] + Vec3d{0.1, 0.1, 0.1}};
  EXPECT_EQ(velocities_of(s, settings).count, 1u);
  EXPECT_EQ(velocities_of(s, settings).temperature, 0);
  EXPECT_EQ(velocities_of(s, settings).mean.x, 5);
}

TEST(AnalysisVelocity, NothingToReport) {
  const Result none = report_velocity(Snapshot{}, {});
  ASSERT_EQ(none.scalars.size(), 1u);
  EXPECT_EQ(none.scalars[0].value, 0);
  EXPECT_EQ(none.notes, std::vector<std::string>{"no bodies"});
  EXPECT_EQ(scalar(report_energy(Snapshot{}, {}), "translational"), 0);
}

}  // namespace
