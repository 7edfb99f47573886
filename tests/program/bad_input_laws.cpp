// Wrong and missing parameters of laws: exit code 2, file:line:column, what is read or allowed; nothing written. And
// for every law of every list: a scene that gives what it reads is taken, and again as a run writes it; what it does
// not read is refused.
#include <gtest/gtest.h>

#include <map>

#include "libcontact/laws/list.h"
#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

struct BadLaw {
  const char* name;
  const char* law;       // the lines of [law]
  const char* material;  // lines added to its only material
  std::vector<const char*> message;
};

void PrintTo(const BadLaw& b, std::ostream* out) { *out << b.name; }

// The table [law] begins in line 9, its keys in line 10; the material's own keys are in lines 12 to 17, what is added
// comes after.
const char* const own = "name = \"hertz_mindlin\"\n";
const char* const no_restitution = "restitution = 0.8\n";

const std::vector<BadLaw> inputs{
    {"restitution_of_linear_spring",
     "name = \"linear_spring\"\n",
     "stiffness = 1e4\n",
     {"scene.toml:16:15", "material.restitution = 0.8", "law linear_spring has no such parameter"}},
    {"restitution_of_thornton_ning",
     "name = \"thornton_ning\"\n",
     "yield_pressure = 1e6\n",
     {"scene.toml:16:15", "material.restitution = 0.8", "law thornton_ning has no such parameter"}},
    {"linear_without_stiffness",
     "name = \"spring_dashpot\"\n",
     "",
     {"scene.toml:11:1", "\"glass\" needs stiffness (N/m) for law spring_dashpot"}},
    {"reference_speed_of_hertz",
     "name = \"hertz_mindlin\"\nreference_speed = 1\n",
     "",
     {"scene.toml:11:19", "law.reference_speed = 1", "is for linear laws, found normal law hertz"}},
    {"reference_speed_and_stiffness",
     "name = \"spring_dashpot\"\nreference_speed = 1\n",
     "stiffness = 1e4\n",
     {"scene.toml:19:13", "material.stiffness", "give it or law.reference_speed, not both"}},
    {"unknown_combination",
     "name = \"hertz_mindlim\"\n",
     "",
     {"scene.toml:10:8", "law.name = \"hertz_mindlim\"", "did you mean hertz_mindlin?"}},
    {"unknown_normal",
     "name = \"hertz_mindlin\"\nnormal = \"jkrr\"\n",
     "",
     {"scene.toml:11:10", "law.normal = \"jkrr\"", "jkr"}},
    {"unknown_rolling",
     "name = \"hertz_mindlin\"\nrolling = \"sprung\"\n",
     "",
     {"scene.toml:11:11", "law.rolling = \"sprung\"", "did you mean spring?"}},
    {"unknown_cohesion",
     "name = \"hertz_mindlin\"\ncohesion = \"bridge\"\n",
     "",
     {"scene.toml:11:12", "law.cohesion = \"bridge\"", "liquid_bridge"}},
    {"tangential_with_a_normal_law_it_cannot_use",
     "name = \"spring_dashpot\"\ntangential = \"memory_diagram\"\n",
     "stiffness = 1e4\n",
     {"scene.toml:11:14",
      "tangential law memory_diagram goes with the normal laws hertz, viscoelastic_hertz, found linear"}},
    {"normal_with_a_tangential_law_that_cannot_use_it",
     "name = \"mindlin_deresiewicz_exact\"\nnormal = \"jkr\"\n",
     "work_of_adhesion = 0.1\n",
     {"scene.toml:11:10", "memory_diagram goes with", "found jkr"}},
    {"jkr_without_adhesion",
     "name = \"hertz_mindlin\"\nnormal = \"jkr\"\n",
     "",
     {"scene.toml:9:1", "law hertz_mindlin, normal jkr reads work_of_adhesion (J/m^2), which no material gives",
      "material.work_of_adhesion > 0"}},
    {"adhesion_twice",
     "name = \"hertz_mindlin\"\nnormal = \"jkr\"\n",
     "work_of_adhesion = 0.1\nsurface_energy = 0.05\n",
     {"scene.toml:20:18", "material.surface_energy = 0.05", "half the work of adhesion: give one of the two"}},
    {"adhesion_unread",
     own,
     "work_of_adhesion = 0.1\n",
     {"scene.toml:18:20", "material.work_of_adhesion = 0.1", "law hertz_mindlin does not read it; see dem list laws"}},
    {"surface_energy_unread", own, "surface_energy = 0.1\n", {"scene.toml:18:18", "does not read it"}},
    {"adhesion_negative",
     "name = \"dmt\"\n",
     "work_of_adhesion = -0.1\n",
     {"scene.toml:18:20", "material.work_of_adhesion = -0.1", ">= 0"}},
    {"dmt_without_adhesion", "name = \"dmt\"\n", "", {"scene.toml:9:1", "work_of_adhesion (J/m^2)"}},
    {"viscous_time_missing",
     "name = \"viscoelastic_hertz\"\n",
     no_restitution,
     {"viscous_time (s), which no material gives"}},
    {"yield_pressure_missing",
     "name = \"thornton_ning\"\n",
     no_restitution,
     {"yield_pressure (Pa), which no material gives"}},
    {"yield_pressure_zero",
     "name = \"thornton_ning\"\n",
     "yield_pressure = 0\n",
     {"scene.toml:18:18", "material.yield_pressure = 0", "> 0"}},
    {"plastic_stiffness_missing",
     "name = \"adhesive_plastic_spring\"\n",
     "stiffness = 1e4\nplastic_depth = 0.05\n",
     {"scene.toml:11:1", "\"glass\" needs plastic_stiffness (N/m) for law adhesive_plastic_spring"}},
    {"plastic_depth_missing",
     "name = \"adhesive_plastic_spring\"\n",
     "stiffness = 1e4\nplastic_stiffness = 5e4\n",
     {"\"glass\" needs plastic_depth"}},
    {"plastic_depth_above_one",
     "name = \"adhesive_plastic_spring\"\n",
     "stiffness = 1e4\nplastic_stiffness = 5e4\nplastic_depth = 2\n",
     {"scene.toml:20:17", "material.plastic_depth = 2", "<= 1"}},
    {"adhesive_stiffness_unread",
     "name = \"spring_dashpot\"\n",
     "stiffness = 1e4\nadhesive_stiffness = 10\n",
     {"scene.toml:19:22", "law spring_dashpot does not read it"}},
    {"rolling_friction_missing",
     "name = \"hertz_mindlin\"\nrolling = \"constant\"\n",
     "",
     {"rolling_friction, which no material gives"}},
    {"rolling_viscosity_missing",
     "name = \"hertz_mindlin\"\nrolling = \"viscous\"\n",
     "",
     {"rolling_viscosity (s/m), which no material gives"}},
    {"rolling_friction_unread", own, "rolling_friction = 0.1\n", {"scene.toml:18:20", "does not read it"}},
    {"twisting_friction_unread", own, "twisting_friction = 0.1\n", {"scene.toml:18:21", "does not read it"}},
    {"rolling_damping_of_constant",
     "name = \"hertz_mindlin\"\nrolling = \"constant\"\n",
     "rolling_friction = 0.1\nrolling_damping = 0.3\n",
     {"scene.toml:20:19", "law hertz_mindlin, rolling constant does not read it"}},
    {"cohesion_missing",
     "name = \"hertz_mindlin\"\ncohesion = \"constant\"\n",
     "",
     {"cohesion (N), which no material gives"}},
    {"cohesion_unread", own, "cohesion = 1\n", {"scene.toml:18:12", "does not read it"}},
    {"bridge_without_tension",
     "name = \"hertz_mindlin\"\ncohesion = \"liquid_bridge\"\nbridge_volume = 1e-12\n",
     "",
     {"scene.toml:9:1", "allowed law.surface_tension > 0 with cohesion liquid_bridge"}},
    {"bridge_without_volume",
     "name = \"hertz_mindlin\"\ncohesion = \"liquid_bridge_rabinovich\"\nsurface_tension = 0.07\n",
     "",
     {"allowed law.bridge_volume > 0 with cohesion liquid_bridge_rabinovich"}},
    {"tension_without_bridge",
     "name = \"hertz_mindlin\"\nsurface_tension = 0.07\n",
     "",
     {"scene.toml:11:19", "law hertz_mindlin does not read it"}},
    {"contact_angle_unread", own, "contact_angle = 0.3\n", {"scene.toml:18:17", "does not read it"}},
    {"contact_angle_beyond",
     "name = \"hertz_mindlin\"\ncohesion = \"liquid_bridge\"\nbridge_volume = 1e-12\nsurface_tension = 0.07\n",
     "contact_angle = 2\n",
     {"scene.toml:21:17", "material.contact_angle = 2", "<= 1.5"}},
    {"pair_adhesion_unread",
     own,
     "[[material_pair]]\na = \"glass\"\nb = \"glass\"\nwork_of_adhesion = 0.1\n",
     {"scene.toml:21:20", "law hertz_mindlin does not read it"}},
    {"pair_rolling_unread",
     own,
     "[[material_pair]]\na = \"glass\"\nb = \"glass\"\nrolling_friction = 0.1\n",
     {"scene.toml:21:20", "does not read it"}},
    {"pair_restitution_of_linear_spring",
     "name = \"linear_spring\"\n",
     "stiffness = 1e4\n[[material_pair]]\na = \"glass\"\nb = \"glass\"\nrestitution = 0.5\n",
     {"law linear_spring has no such parameter"}},
    {"ledger_not_a_boolean", "name = \"hertz_mindlin\"\nledger = 1\n", "", {"scene.toml:11:10", "law.ledger = 1"}},
};

std::string scene_of(const std::string& law, const std::string& material, bool restitution) {
  std::string text = program::replaced(program::small_scene, "name = \"hertz_mindlin\"\n", law);
  if (!restitution) text = program::replaced(text, "restitution = 0.8\n", "");
  return program::replaced(text, "friction = 0.5\n", "friction = 0.5\n" + material);
}

Outcome check(const std::string& text) {
  const Folder folder;
  return program::dem({"check", folder.write("scene.toml", text)});
}

class BadLawScene : public testing::TestWithParam<BadLaw> {};

TEST_P(BadLawScene, IsRefusedWithItsPlace) {
  const BadLaw& bad = GetParam();
  const bool keeps = bad.material != no_restitution;
  const Folder folder;
  const std::string text = scene_of(bad.law, keeps ? bad.material : "", keeps);
  const Outcome o = program::dem({"run", folder.write("scene.toml", text), "--out", folder.path("out")});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : bad.message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_TRUE(o.out.empty()) << o.out;
  EXPECT_EQ(folder.files().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Table, BadLawScene, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

// A value for every parameter that a law of the lists reads.
const std::map<std::string, std::string>& values() {
  static const std::map<std::string, std::string> all{
      {"stiffness", "1e4"},        {"viscous_time", "1e-6"},     {"yield_pressure", "1e6"},
      {"work_of_adhesion", "0.1"}, {"plastic_stiffness", "5e4"}, {"adhesive_stiffness", "10"},
      {"plastic_depth", "0.05"},   {"rolling_friction", "0.1"},  {"rolling_viscosity", "1"},
      {"rolling_damping", "0.3"},  {"twisting_friction", "0.1"}, {"cohesion", "1e-4"},
      {"contact_angle", "0.3"},
  };
  return all;
}

std::vector<std::string> words_of(std::string_view list) {
  std::vector<std::string> words;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(", "), list.size());
    words.emplace_back(list.substr(0, std::min(list.find(' '), end)));
    list.remove_prefix(std::min(end + 2, list.size()));
  }
  return words;
}

// In place of its family's law in hertz_mindlin, or in spring_dashpot where it needs a stiffness.
template <class List>
void expect_parameters_are_known(const char* family) {
  contact::each_law<List>([&](auto law, std::size_t) {
    std::vector<std::string> reads = words_of(law.parameters);
    const auto has = [&](std::string_view word) { return std::find(reads.begin(), reads.end(), word) != reads.end(); };
    const bool linear = has("stiffness");
    std::string lines = std::string("name = \"") + (linear ? "spring_dashpot" : "hertz_mindlin") + "\"\n" + family +
                        " = \"" + law.name + "\"\n";
    for (const contact::Partners& p : contact::partners)
      if (p.law == law.name) {
        const std::string normal(p.normal.substr(0, p.normal.find(',')));
        lines += "normal = \"" + normal + "\"\n";
        contact::each_law<contact::NormalLaws>([&](auto partner, std::size_t) {
          if (normal == partner.name)
            for (const std::string& word : words_of(partner.parameters)) reads.push_back(word);
        });
      }
    if (std::string_view(law.name).starts_with("liquid_bridge"))
      lines += "surface_tension = 0.07\nbridge_volume = 1e-12\n";
    std::string given;
    for (const auto& [key, value] : values())
      if (has(key)) given += key + " = " + value + "\n";
    const bool damped = std::string_view(family) != "normal" || has("restitution");
    const Outcome good = check(scene_of(lines, given, damped));
    EXPECT_EQ(good.exit_code, 0) << family << " " << law.name << "\n" << good.err;
    const Folder folder;
    const std::string scene = folder.write("scene.toml", scene_of(lines, given, damped));
    ASSERT_EQ(program::dem({"run", scene, "--out", folder.path("out"), "--set", "run.steps=1"}).exit_code, 0);
    const Outcome again = program::dem({"check", folder.path("out/scene.toml")});  // states every key
    EXPECT_EQ(again.exit_code, 0) << family << " " << law.name << "\n" << again.err;
    for (const auto& [key, value] : values()) {
      if (has(key) || key == "stiffness") continue;  // stiffness may stand in any library of materials
      const Outcome bad = check(scene_of(lines, given + key + " = " + value + "\n", damped));
      EXPECT_EQ(bad.exit_code, 2) << family << " " << law.name << " with " << key;
      EXPECT_NE(bad.err.find("material." + key), std::string::npos) << bad.err;
    }
  });
}

TEST(LawParameters, OfNormalLaws) { expect_parameters_are_known<contact::NormalLaws>("normal"); }
TEST(LawParameters, OfTangentialLaws) { expect_parameters_are_known<contact::TangentialLaws>("tangential"); }
TEST(LawParameters, OfRollingLaws) { expect_parameters_are_known<contact::RollingLaws>("rolling"); }
TEST(LawParameters, OfCohesion) { expect_parameters_are_known<contact::CohesionLaws>("cohesion"); }

}  // namespace
