// Bad fills, rains, outlets, species and events: refused with the place, the value and what is allowed.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

struct BadInsertion {
  const char* name;
  const char* text;  // behind the small scene and the names below
  std::vector<const char*> message;
};

void PrintTo(const BadInsertion& b, std::ostream* out) { *out << b.name; }

// What the cases refer to.
const char* const names = R"([[region]]
name = "place"
lower = [0, 0, 1]
upper = [0.1, 0.1, 1.1]
[[species]]
name = "red"
)";

#define ITEMS "items = [{shape = \"ball\", material = \"glass\"}]\n"
#define FILL(keys) "[[fill]]\nregion = \"place\"\n" keys
#define RAIN(keys) "[[rain]]\nname = \"shower\"\nregion = \"place\"\n" keys ITEMS
#define EVENT(keys) "[[event]]\nname = \"now\"\n" keys

const std::vector<BadInsertion> inputs{
    {"region_unknown",
     "[[fill]]\nregion = \"plce\"\ncount = 1\n" ITEMS,
     {"fill.region = \"plce\"", "did you mean place?"}},
    {"region_and_box",
     FILL("lower = [0,0,0]\nupper = [1,1,1]\ncount = 1\n" ITEMS),
     {"fill.region = \"place\"", "give region, or lower and upper"}},
    {"no_place", "[[fill]]\ncount = 1\n" ITEMS, {"give region, or lower and upper"}},
    {"half_a_box", "[[fill]]\nlower = [0,0,1]\ncount = 1\n" ITEMS, {"give lower and upper"}},
    {"region_upside_down",
     "[[region]]\nname = \"r\"\nlower = [0,0,0]\nupper = [1,1,-1]\n",
     {"region.upper = [1, 1, -1]", "allowed region.upper > region.lower"}},
    {"region_axis",
     "[[region]]\nname = \"r\"\nkind = \"cylinder\"\ncentre = [0,0,0]\nradius = 1\nheight = 1\naxis = [0,0,0]\n",
     {"region.axis = [0, 0, 0]", "zero vector"}},
    {"region_without_radius",
     "[[region]]\nname = \"r\"\nkind = \"sphere\"\ncentre = [0,0,0]\n",
     {"region.radius is missing"}},
    {"region_disc",
     "[[region]]\nname = \"r\"\nkind = \"disc\"\ncentre = [0,0,0]\nradius = 1\n",
     {"set world.dimension = 2"}},
    {"no_amount", FILL(ITEMS), {"give one of count, solid_fraction and mass"}},
    {"two_amounts", FILL("count = 3\nmass = 0.1\n" ITEMS), {"fill.mass = 0.1", "give one of count"}},
    {"too_solid", FILL("solid_fraction = 1.2\n" ITEMS), {"0 < fill.solid_fraction <= 1"}},
    {"a_hundred_million", FILL("count = 100000000\n" ITEMS), {"fill.count = 100000000", "<= 50000000"}},
    {"more_than_the_region", FILL("count = 40000000\n" ITEMS), {"bounding spheres of 40000000 bodies alone are"}},
    {"a_thousand_tons", FILL("mass = 1e6\n" ITEMS), {"mass = 1000000", "more bodies than the region holds"}},
    {"spacing_too_small",
     FILL("arrangement = \"cubic\"\nspacing = 1e-4\n" ITEMS),
     {"fill.spacing = 0.0001", "would overlap"}},
    {"does_not_fit", FILL("solid_fraction = 0.7\n" ITEMS), {"bodies found a place", "tries at random"}},
    {"spacing_of_no_lattice",
     FILL("count = 1\nspacing = 0.1\n" ITEMS),
     {"fill.spacing: applies only where arrangement ="}},
    {"lattice_too_small",
     FILL("count = 1800\narrangement = \"fcc\"\n" ITEMS),
     {"1800 bodies asked for, the lattice has"}},
    {"given_without_orientation", FILL("count = 1\nturned = \"given\"\n" ITEMS), {"fill.orientation is missing"}},
    {"lognormal_without_scale",
     FILL("count = 1\nitems = [{shape=\"ball\", material=\"glass\", distribution=\"lognormal\", median=1, "
          "sigma=0.2}]\n"),
     {"fill.items.scale is missing"}},
    {"lognormal_cut_to_nothing",
     FILL("count = 1\nitems = [{shape=\"ball\", material=\"glass\", distribution=\"lognormal\", median=1, sigma=0.2, "
          "scale=1}]\n"),
     {"needs scale = [min, max] with min < max"}},
    {"lognormal_far_from_its_scales",
     FILL("count = 1\nitems = [{shape=\"ball\", material=\"glass\", distribution=\"lognormal\", median=1, sigma=0.01, "
          "scale=[2, 3]}]\n"),
     {"next to nothing between the scales"}},
    {"table_without_shares",
     FILL("count = 1\nitems = [{shape=\"ball\", material=\"glass\", distribution=\"table\", table=[[1], [2]]}]\n"),
     {"fill.items.table", "lists of 2 numbers"}},
    {"rain_without_rate", RAIN(""), {"give rate or mass_rate"}},
    {"rain_with_two_rates", RAIN("rate = 1\nmass_rate = 1\n"), {"rain.mass_rate = 1", "give rate or mass_rate"}},
    {"rain_ends_before_it_begins", RAIN("rate = 1\nstart = 2\nstop = 1\n"), {"allowed rain.stop > rain.start = 2"}},
    {"rain_too_large",
     "[[rain]]\nname = \"s\"\nregion = \"place\"\nrate = 1\nitems = [{shape=\"ball\", material=\"glass\", scale=11}]\n",
     {"has no room for its largest body"}},
    {"rain_of_no_density",
     "[[material]]\nname = \"void\"\nyoung = 1e7\n[[rain]]\nname = \"s\"\nregion = \"place\"\nrate = 1\n"
     "items = [{shape=\"ball\", material=\"void\"}]\n",
     {"\"void\" needs density"}},
    {"outlet_of_both",
     "[[outlet]]\nname=\"o\"\nregion=\"place\"\npoint=[0,0,0]\nnormal=[0,0,1]\n",
     {"give region, or point and normal"}},
    {"outlet_of_neither", "[[outlet]]\nname=\"o\"\n", {"give region, or point and normal"}},
    {"outlet_without_normal", "[[outlet]]\nname=\"o\"\npoint=[0,0,0]\n", {"give point and normal"}},
    {"outlet_into_itself",
     "[[outlet]]\nname=\"o\"\nregion=\"place\"\nrecycle_to=\"place\"\n",
     {"must not be the region of the outlet"}},
    {"outlet_velocity",
     "[[outlet]]\nname=\"o\"\nregion=\"place\"\nvelocity=[1,0,0]\n",
     {"applies only where recycle_to is given"}},
    {"recycled_into_nothing",
     "[[region]]\nname = \"slit\"\nlower = [0,0,0]\nupper = [1,1,0.001]\n"
     "[[outlet]]\nname=\"o\"\nregion=\"place\"\nrecycle_to=\"slit\"\n",
     {"region \"slit\" has no room for the largest body"}},
    {"species_none", "[[species]]\nname = \"none\"\n", {"what bodies without a species have"}},
    {"species_unknown", EVENT("at = 1\nspecies = \"rde\"\n"), {"event.species = \"rde\"", "did you mean red?"}},
    {"species_left_out", EVENT("at = 1\nstop = true\nregion = \"place\"\n"), {"says which bodies get a species"}},
    {"event_without_time", EVENT("stop = true\n"), {"give at (s) or when"}},
    {"event_with_two_times", EVENT("at = 1\nwhen = \"time > 1\"\nstop = true\n"), {"give at (s) or when"}},
    {"event_of_nothing", EVENT("at = 1\n"), {"\"now\" does nothing"}},
    {"event_delay", EVENT("at = 1\ndelay = 1\nstop = true\n"), {"event.delay = 1", "add it to event.at"}},
    {"condition_misspelt",
     EVENT("when = \"time > 1 and max_sped < 2\"\nstop = true\n"),
     {"scene.toml:56:22: event.when", "did you mean max_speed?"}},
    {"condition_with_unit", EVENT("when = \"time > 1s\"\nstop = true\n"), {"scene.toml:56:17:", "units are SI"}},
    {"condition_empty", EVENT("when = \"\"\nstop = true\n"), {"event.when = \"\"", "is empty"}},
    {"condition_of_no_rain",
     EVENT("when = \"rain.shower.count > 3\"\nstop = true\n"),
     {"no [[rain]] is named \"shower\""}},
    {"event_friction_without_pair", EVENT("at = 1\nfriction = 0.3\n"), {"go together"}},
    {"event_pair_without_friction", EVENT("at = 1\nstop = true\na = \"glass\"\nb = \"glass\"\n"), {"go together"}},
    {"event_moves_a_fixed_wall", EVENT("at = 1\nstart_motion = \"floor\"\n"), {"wall \"floor\" has no motion"}},
    {"event_both",
     EVENT("at = 1\ninsert_wall = \"floor\"\nremove_wall = \"floor\"\n"),
     {"is the wall that this event removes"}},
    {"event_and_start",
     "[[wall]]\nname=\"lid\"\nkind=\"plane\"\nmaterial=\"glass\"\npoint=[0,0,9]\nnormal=[0,0,-1]\nmotion="
     "\"translation\"\n"
     "velocity=[0,0,-1]\nstart=0.1\n" EVENT("at = 1\nstart_motion = \"lid\"\n"),
     {"wall.start = 0.1", "event \"now\" starts this wall"}},
    {"event_and_stop",
     "[[wall]]\nname=\"lid\"\nkind=\"plane\"\nmaterial=\"glass\"\npoint=[0,0,9]\nnormal=[0,0,-1]\nmotion="
     "\"translation\"\n"
     "velocity=[0,0,-1]\nstop=0.1\n" EVENT("at = 1\nstart_motion = \"lid\"\n"),
     {"wall.stop = 0.1", "stop it by an event too"}},
    {"event_inserts_what_is_removed",
     "[[wall]]\nname=\"lid\"\nkind=\"plane\"\nmaterial=\"glass\"\npoint=[0,0,9]\nnormal=[0,0,-1]\nremove_at = "
     "0.5\n" EVENT("at = 1\ninsert_wall = \"lid\"\n"),
     {"wall.remove_at = 0.5", "remove it by an event too"}},
    {"in_a_box_that_deforms",
     "[periodic]\naxes = \"xyz\"\nlower = [-9, -9, -9]\nupper = [9, 9, 9]\n[[periodic.deform]]\nstrain_rates = [1, "
     "0, 0]\n[[outlet]]\nname=\"o\"\nregion=\"place\"\n" RAIN("rate = 1\n") EVENT("at = 1\ngravity = [0, 0, 1]\n"),
     {"event.gravity = [0, 0, 1]", "rain = { name = \"shower\"",
      "region = \"place\" }: a box that deforms keeps its bodies"}},
    {"outside_a_periodic_box",
     "[periodic]\naxes = \"x\"\nlower = [-0.05, 0, 0]\nupper = [0.05, 0, 0]\n" RAIN("rate = 1\n"),
     {"rain.region = \"place\"", "allowed within the periodic box, x = -0.05 to 0.05"}},
    {"event_and_rain_start",
     RAIN("rate = 1\nstart = 1\n") EVENT("at = 1\nstart_rain = \"shower\"\n"),
     {"event \"now\" starts this rain"}},
};

class BadInsertionScene : public testing::TestWithParam<BadInsertion> {};

TEST_P(BadInsertionScene, IsRefusedAndNothingIsWritten) {
  const BadInsertion& bad = GetParam();
  const Folder folder;
  const std::string text = std::string(program::small_scene) + names + bad.text;
  const std::string scene = folder.write("scene.toml", text);
  const Outcome o = program::dem({"run", scene, "--out", folder.path("out")});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : bad.message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_NE(o.err.find("scene.toml"), std::string::npos) << o.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"scene.toml"});
}

INSTANTIATE_TEST_SUITE_P(Table, BadInsertionScene, testing::ValuesIn(inputs),
                         [](const auto& info) { return info.param.name; });

TEST(Until, IsRefusedAtItsLetterAndFromTheCommandLine) {
  const Folder folder;
  const std::string text = program::replaced(program::small_scene, "steps = 200", "steps = 200\nuntil = \"enrgy < 1\"");
  Outcome o = program::dem({"check", folder.write("scene.toml", text)});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("scene.toml:4:10: run.until"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("did you mean energy?"), std::string::npos) << o.err;
  o = program::dem({"check", folder.write("scene.toml", program::small_scene), "--set", "run.until=time = 3"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("needs <, <=, > or >= here"), std::string::npos) << o.err;
}

}  // namespace
