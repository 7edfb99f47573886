// Shipped scenes in a short form: each begins, and the quick ones of the validations pass.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "libdem/run.h"
#include "libdem/scene/data_files.h"
#include "libdem/validate/list.h"

namespace {

using namespace dem::validate;
using dem::World;

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

}  // namespace
