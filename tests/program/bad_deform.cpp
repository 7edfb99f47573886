// Bad input of a periodic box that deforms: exit code 2, the place, the value, what is allowed; nothing written.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

struct BadDeform {
  const char* name;
  const char* text;  // stands before the law in the small scene
  std::vector<const char*> message;
};

void PrintTo(const BadDeform& b, std::ostream* out) { *out << b.name; }

#define BOX "[periodic]\naxes = \"xyz\"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\n[[periodic.deform]]\n"

// The key goes on in the table [world], before [law].
#define PLANE "dimension = 2\nthickness = 0.01\n[periodic]\n"

const std::vector<BadDeform> inputs{
    {"partly_periodic",
     "[periodic]\naxes = \"xy\"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\ndeform = [{ strain_rates = [1, 0, 0] }]\n",
     {"periodic.axes = \"xy\"", "a box that deforms is periodic along every axis", "\"xyz\""}},
    {"with_gravity", BOX "strain_rates = [1, 0, 0]\n", {"world.gravity", "allowed with periodic.deform: [0, 0, 0]"}},
    {"starts_fall",
     BOX "start = 0.5\n[[periodic.deform]]\nstart = 0.5\n",
     {"scene.toml:16:9", "periodic.deform.start = 0.5", "does not follow 0.5", "rising times"}},
    {"without_axes", "[periodic]\ndeform = [{ strain_rates = [1, 0, 0] }]\n", {"periodic.deform", "axes"}},
    {"rate_of_two",
     BOX "strain_rates = [1, 0]\n",
     {"periodic.deform.strain_rates = [1, 0]", "needs a list of 3 numbers"}},
    {"servo_without_target",
     BOX "stress_axes = \"xy\"\nrate_limit = 1\n",
     {"periodic.deform.target_stress is missing"}},
    {"servo_without_limit",
     BOX "stress_axes = \"xy\"\ntarget_stress = [1, 1, 0]\n",
     {"periodic.deform.rate_limit is missing"}},
    {"servo_that_pulls",
     BOX "stress_axes = \"xy\"\ntarget_stress = [1, -1, 0]\nrate_limit = 1\n",
     {"target_stress = [1, -1, 0]", "allowed in y: > 0, bodies bear compression only"}},
    {"servo_target_elsewhere",
     BOX "stress_axes = \"xy\"\ntarget_stress = [1, 1, 1]\nrate_limit = 1\n",
     {"target_stress = [1, 1, 1]", "allowed in z: 0"}},
    {"servo_and_rate",
     BOX "stress_axes = \"xy\"\nstrain_rates = [0, 1, 1]\ntarget_stress = [1, 1, 0]\nrate_limit = 1\n",
     {"strain_rates = [0, 1, 1]", "allowed in y: 0, it is one of stress_axes"}},
    {"servo_isotropic_apart",
     BOX "stress_axes = \"xy\"\nisotropic = true\ntarget_stress = [1, 2, 0]\nrate_limit = 1\n",
     {"target_stress = [1, 2, 0]", "the same along all stress_axes"}},
    {"servo_keys_without_servo", BOX "rate_limit = 1\n", {"periodic.deform.rate_limit", "stress_axes"}},
    {"plane_along_z",
     PLANE "axes = \"xz\"\nlower = [0, 0, 0]\nupper = [1, 1, 0]\n",
     {"periodic.axes = \"xz\"", "a 2-D scene allows none, x, y, xy"}},
    {"plane_with_height",
     PLANE "axes = \"x\"\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n",
     {"periodic.upper = [1, 1, 1]", "entry 3 must be 0"}},
    {"plane_partly",
     PLANE "axes = \"y\"\nlower = [0, 0, 0]\nupper = [1, 1, 0]\ndeform = [{ strain_rates = [1, 0, 0] }]\n",
     {"periodic.axes = \"y\"", "periodic along every axis: \"xy\""}},
    {"plane_rate_of_z",
     PLANE "axes = \"xy\"\nlower = [0, 0, 0]\nupper = [1, 1, 0]\ndeform = [{ strain_rates = [1, 0, 1] }]\n",
     {"strain_rates = [1, 0, 1]", "entry 3 must be 0 in a 2-D scene"}},
    {"plane_stress_of_z",
     PLANE "axes = \"xy\"\nlower = [0, 0, 0]\nupper = [1, 1, 0]\n[[periodic.deform]]\nstress_axes = \"xz\"\n"
           "target_stress = [1, 0, 1]\nrate_limit = 1\n",
     {"stress_axes = \"xz\"", "a 2-D scene allows none, x, y, xy"}},
    {"plane_of_spheres",
     "dimension = 2\ndisc_model = \"sphere\"\n[periodic]\naxes = \"xy\"\nlower = [0, 0, 0]\nupper = [1, 1, 0]\ndeform "
     "= [{ strain_rates = [1, 0, 0] }]\n",
     {"disc_model = \"sphere\"", "a layer of spheres has no thickness"}},
};

class BadDeformation : public testing::TestWithParam<BadDeform> {};

TEST_P(BadDeformation, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const Folder folder;
  const std::string text = program::replaced(program::small_scene, "[law]", GetParam().text + std::string("[law]"));
  const std::string scene = folder.write("scene.toml", text);
  const auto before = folder.files();
  const Outcome o = program::dem({"run", scene, "--out", folder.path("out")});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : GetParam().message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_EQ(folder.files(), before);
}

INSTANTIATE_TEST_SUITE_P(Table, BadDeformation, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

}  // namespace
