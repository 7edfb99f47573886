// Shipped scenes in a short form: each begins, and the quick ones of the validations pass.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "libdem/deformation.h"
#include "libdem/run.h"
#include "libdem/scene/data_files.h"
#include "libdem/validate/list.h"

namespace {

using namespace dem::validate;
using dem::World;

std::string scene(const std::string& name) { return dem::scenes_folder() + "/" + name + ".toml"; }

void expect_passes(const std::string& name) {
  for (const Validation* v : validations()) {
    if (v->name != name) continue;
    const Result result = carry_out(*v, "", 1);
    EXPECT_TRUE(result.pass()) << name;
    for (const Row& row : result.rows)
      EXPECT_TRUE(row.pass) << row.criterion << ": " << row.got << ", expected " << row.expected;
    return;
  }
  FAIL() << "no validation is named " << name;
}

TEST(ShippedScenes, Begin) {
  for (const auto& entry : std::filesystem::directory_iterator(dem::scenes_folder())) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    World w = dem::build_world(dem::load_scene(entry.path().string(), {"run.steps=20"}));
    EXPECT_GT(w.particles.count(), 0u);
    EXPECT_NO_THROW(dem::run(w, {}, false));
    EXPECT_EQ(w.step, 20u);
  }
}

TEST(ShippedScenes, VibratedBedPasses) { expect_passes("vibrated_bed"); }
TEST(ShippedScenes, TheArrayOfDiscsPasses) { expect_passes("biaxial_2d"); }

// Before the top moves the servos keep their pressure, and the stress is near isotropic.
TEST(ShippedScenes, TheArrayOfSpheresStandsUnderItsPressure) {
  const World w = Runs(scene("triaxial_fcc"), "", 1).run({"run.time=0.01"});
  const double pressure = 1e4;
  for (const char* name : {"east", "north"}) {
    const dem::Wall& wall = wall_named(w, name);
    EXPECT_NEAR(wall.force.x + wall.force.y, pressure * wall.motion.area, 1e-3 * pressure * wall.motion.area);
  }
  const double top = wall_named(w, "top").force.z / wall_named(w, "east").motion.area;
  EXPECT_GT(top, 0.8 * pressure);
  EXPECT_LT(top, 1.2 * pressure);
  // No contact has opened: all the neighbours of n planes of spheres along each axis.
  const double n = 13, pairs = 3 * n * (n - 1) * (n - 1);
  EXPECT_EQ(dem::contacts_per_particle(w) * static_cast<double>(w.particles.count()), pairs);
}

// A tenth of the spheres: they jam, and bear the pressure that is asked for.
TEST(ShippedScenes, FrictionlessSpheresJamInTheirBox) {
  const World w = Runs(scene("isotropic_periodic"), "", 1)
                      .run({"fill[0].count=400", "fill[0].upper=[0.1, 0.1, 0.1]", "periodic.upper=[0.1, 0.1, 0.1]",
                            "periodic.deform[1].start=0.108", "run.time=1.7"});
  const dem::Mat3d stress = dem::cell_stress(w);
  EXPECT_NEAR((stress.row[0].x + stress.row[1].y + stress.row[2].z) / 3, 300, 6);
  EXPECT_NEAR(dem::solid_fraction(w), 0.641, 0.012);
  const dem::Coordination z = dem::coordination(w);
  EXPECT_NEAR(z.backbone, 6.4, 0.4);
  EXPECT_LT(z.rattlers, 0.06);
}

// A tenth of the spheres, at their highest pressure: far beyond jamming nearly all of them bear.
TEST(ShippedScenes, FrictionlessSpheresArePressedBeyondJamming) {
  const World w = Runs(scene("compaction"), "", 1)
                      .run({"fill[0].count=200", "fill[0].upper=[0.072, 0.072, 0.072]",
                            "periodic.upper=[0.072, 0.072, 0.072]", "run.time=0.55"});
  EXPECT_NEAR(dem::solid_fraction(w), 0.69, 0.012);
  const dem::Coordination z = dem::coordination(w);
  EXPECT_NEAR(z.backbone, 7.8, 0.4);
  EXPECT_LT(z.rattlers, 0.02);
}

// Three layers of grains, half of the way: most drop into the die, and none goes through its floor or the tables.
TEST(ShippedScenes, AShoeBringsGrainsToTheDie) {
  const World w = Runs(scene("die_filling_2d"), "", 1).run({"fill[0].count=60", "run.time=0.65"});
  std::size_t in_the_die = 0;
  for (const contact::Motion& m : w.particles.motion) {
    const dem::Vec3d& x = m.position;
    const bool over_the_die = x.x > 0 && x.x < 0.04;
    EXPECT_GT(x.y, over_the_die ? -0.09 : 0.0);
    if (over_the_die && x.y < 0) ++in_the_die;
  }
  EXPECT_EQ(w.particles.count(), 60u);
  EXPECT_GE(in_the_die, 30u);
}

}  // namespace
