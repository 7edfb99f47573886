// Further bad input: materials by name, published friction, values of every type in the wrong place, and words that are
// near misses. Exit code 2, the place, the value, what is allowed; nothing written.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

struct BadInput {
  const char* name;
  const char* from;  // of the small scene …
  const char* to;    // … replaced by this; from = "" appends
  const char* set;   // an override, or nullptr
  std::vector<const char*> message;
};

void PrintTo(const BadInput& b, std::ostream* out) { *out << b.name; }

#define PAIR(rest) "[[material_pair]]\na = \"glass\"\nb = \"glass\"\n" rest
#define PLANE(rest) \
  "[[wall]]\nname = \"lid\"\nkind = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 9]\nnormal = [0, 0, -1]\n" rest
#define SHAPE(rest) "[[shape]]\nname = \"rock\"\n" rest
#define FILL(rest) "[[fill]]\nlower = [1, 1, 1]\nupper = [1.1, 1.1, 1.1]\n" rest

const std::vector<BadInput> inputs{
    {"like_unknown",
     "poisson = 0.25",
     "like = \"stel\"",
     nullptr,
     {"scene.toml:14:8", "material.like = \"stel\": no named material", "did you mean steel?", "dem list materials"}},
    {"like_not_text", "poisson = 0.25", "like = 3", nullptr, {"material.like = 3", "needs text, found a number"}},
    {"like_empty", "poisson = 0.25", "like = \"\"", nullptr, {"material.like = \"\"", "is empty"}},
    {"like_without_density",
     "poisson = 0.25\ndensity = 2500",
     "like = \"nylon_66\"",
     nullptr,
     {"\"glass\" needs density", "bodies are made of it"}},
    {"like_set",
     "steps = 200",
     "steps = 200",
     "material.glass.like=granit",
     {"--set: material.like = \"granit\"", "did you mean granite?"}},
    {"published_unknown",
     "",
     PAIR("published = \"glas ball - glass plate\"\n"),
     nullptr,
     {"no published pair", "did you mean glass ball - glass plate?", "dem list friction"}},
    {"published_twice_reported",
     "",
     PAIR("published = \"cellulose acetate - cellulose acetate\"\n"),
     nullptr,
     {"reported more than once", "Foerster 1994", "Mullier 1991"}},
    {"published_and_friction",
     "",
     PAIR("friction = 0.3\npublished = \"glass ball - glass plate\"\n"),
     nullptr,
     {"material_pair.friction = 0.3", "published says 0.155 (Li 2005)"}},
    {"published_wrong_reference",
     "",
     PAIR("published = \"glass ball - glass plate (Li 2006)\"\n"),
     nullptr,
     {"no published pair"}},
    {"pair_unknown_material",
     "",
     "[[material_pair]]\na = \"glass\"\nb = \"steel\"\n",
     nullptr,
     {"material_pair.b = \"steel\"", "no [[material]] has this name"}},
    {"pair_restitution",
     "",
     PAIR("restitution = 1.2\n"),
     nullptr,
     {"material_pair.restitution = 1.2", "allowed 0.01 <="}},
    {"pair_stiffness_of_hertz",
     "",
     PAIR("stiffness = 1e5\n"),
     nullptr,
     {"hertz_mindlin takes the stiffness from young"}},
    {"pair_without_b", "", "[[material_pair]]\na = \"glass\"\n", nullptr, {"material_pair.b is missing"}},
    {"include_nothing", "title = \"three bodies\"", "include = []", nullptr, {"scene.toml:1:11", "include: is empty"}},
    {"include_missing",
     "title = \"three bodies\"",
     "include = [\"walls.toml\"]",
     nullptr,
     {"scene.toml:1:12", "include = \"walls.toml\"", "no such file"}},
    {"include_itself",
     "title = \"three bodies\"",
     "include = [\"scene.toml\"]",
     nullptr,
     {"scene.toml:1:12", "the file includes itself"}},
    {"include_a_folder", "title = \"three bodies\"", "include = [\".\"]", nullptr, {"no such file"}},
    {"include_in_a_table", "steps = 200", "steps = 200\ninclude = [\"a.toml\"]", nullptr, {"unknown key run.include"}},
    {"include_broken",
     "title = \"three bodies\"",
     "include = [\"broken.toml\"]",
     nullptr,
     {"broken.toml:2:9", "TOML syntax"}},
    {"include_wrong_value",
     "title = \"three bodies\"",
     "include = [\"wrong.toml\"]",
     nullptr,
     {"wrong.toml:2:11", "material.density = -1"}},
    {"include_same_name",
     "title = \"three bodies\"",
     "include = [\"same.toml\"]",
     nullptr,
     {"scene.toml:12:8", "material.name = \"glass\"", "taken already"}},
    {"text_for_flag",
     "picture = false",
     "picture = \"no\"",
     nullptr,
     {"output.picture = \"no\"", "needs true or false, found text"}},
    {"number_for_text",
     "name = \"hertz_mindlin\"",
     "name = 1",
     nullptr,
     {"law.name = 1", "needs text, found a number"}},
    {"list_for_number",
     "radius = 0.005",
     "radius = [0.005]",
     nullptr,
     {"shape.radius = [0.005]", "needs a number, found a list"}},
    {"number_for_tables",
     "title = \"three bodies\"",
     "outlet = 1",
     nullptr,
     {"outlet = 1", "needs an array of tables"}},
    {"numbers_for_tables",
     "title = \"three bodies\"",
     "outlet = [1]",
     nullptr,
     {"outlet", "needs tables, found a number"}},
    {"text_in_a_vector", "point = [0, 0, 0]", "point = [0, \"0\", 0]", nullptr, {"scene.toml:30:13", "found text"}},
    {"semi_axis_zero",
     "semi_axes = [0.004, 0.005, 0.006]",
     "semi_axes = [0.004, 0, 0.006]",
     nullptr,
     {"shape.semi_axes", "allowed shape.semi_axes > 0"}},
    {"density_zero",
     "density = 2500",
     "density = 0",
     nullptr,
     {"material.density = 0", "allowed material.density > 0"}},
    {"young_negative",
     "young = 1e7",
     "young = -1e7",
     nullptr,
     {"material.young = -10000000.0", "allowed material.young > 0"}},
    {"steps_zero", "steps = 200", "steps = 0", nullptr, {"run.steps = 0", "allowed run.steps >= 1"}},
    {"skin_negative", "dt = 1e-5", "skin = -1", nullptr, {"run.skin = -1", "allowed run.skin > 0"}},
    {"skin_word", "dt = 1e-5", "skin = \"none\"", nullptr, {"run.skin = \"none\"", "a number or \"auto\""}},
    {"contacts_of_dt", "dt = 1e-5", "dt_contacts = 101", nullptr, {"allowed 1 <= run.dt_contacts <= 100"}},
    {"interval_negative",
     "picture = false",
     "interval = -1",
     nullptr,
     {"output.interval = -1", "allowed output.interval >= 0"}},
    {"share_above_one",
     "",
     "[contact]\nmax_uncertified_share = 2\n",
     nullptr,
     {"contact.max_uncertified_share = 2", "<= 1"}},
    {"prism_of_two_sides",
     "",
     SHAPE("kind = \"prism\"\nsides = 2\ncircumradius = 1\nheight = 1\n"),
     nullptr,
     {"shape.sides = 2", "allowed 3 <= shape.sides"}},
    {"prism_without_height",
     "",
     SHAPE("kind = \"prism\"\nsides = 5\ncircumradius = 1\n"),
     nullptr,
     {"shape.height is missing"}},
    {"three_points",
     "",
     SHAPE("kind = \"polyhedron\"\nvertices = [[0,0,0],[1,0,0],[0,1,0]]\n"),
     nullptr,
     {"shape.vertices", "at least 4 points, found 3"}},
    {"point_of_two_numbers",
     "",
     SHAPE("kind = \"polyhedron\"\nvertices = [[0,0,0],[1,0],[0,1,0],[0,0,1]]\n"),
     nullptr,
     {"shape.vertices", "found 2 entries"}},
    {"half_space_without_normal",
     "",
     SHAPE("kind = \"polyhedron\"\nhalf_spaces = [[0,0,0,1]]\n"),
     nullptr,
     {"shape.half_spaces", "must not be the zero vector"}},
    {"half_spaces_unbounded",
     "",
     SHAPE("kind = \"polyhedron\"\nhalf_spaces = [[1,0,0,1],[-1,0,0,1],[0,1,0,1],[0,-1,0,1],[0,0,1,1]]\n"),
     nullptr,
     {"scene.toml:48:1"}},
    {"rotation_without_axis",
     "",
     PLANE("motion = \"rotation\"\ncentre = [0,0,0]\nrate = 1\n"),
     nullptr,
     {"wall.axis is missing"}},
    {"axis_zero",
     "",
     PLANE("motion = \"rotation\"\naxis = [0,0,0]\ncentre = [0,0,0]\nrate = 1\n"),
     nullptr,
     {"wall.axis", "must not be the zero vector"}},
    {"velocity_of_a_fixed_wall",
     "",
     PLANE("velocity = [0,0,1]\n"),
     nullptr,
     {"wall.velocity: applies only where motion = translation", "\"fixed\""}},
    {"frequency_zero",
     "",
     PLANE("motion = \"oscillation\"\namplitude = [0,0,1]\nfrequency = 0\n"),
     nullptr,
     {"wall.frequency = 0", "allowed wall.frequency > 0"}},
    {"wall_of_unknown_material",
     "",
     "[[wall]]\nname = \"lid\"\nkind = \"plane\"\nmaterial = \"gless\"\npoint = [0,0,9]\nnormal = [0,0,-1]\n",
     nullptr,
     {"wall.material = \"gless\"", "did you mean glass?"}},
    {"outlet_normal",
     "",
     "[[outlet]]\nname = \"out\"\npoint = [0,0,-1]\nnormal = [0,0,0]\n",
     nullptr,
     {"outlet.normal", "must not be the zero vector"}},
    {"fill_too_small",
     "",
     FILL("count = 5000\nitems = [{shape = \"ball\", material = \"glass\"}]\n"),
     nullptr,
     {"scene.toml:48:1"}},
    {"fill_weight",
     "",
     FILL("count = 1\nitems = [{shape = \"ball\", material = \"glass\", weight = 0}]\n"),
     nullptr,
     {"fill.items.weight = 0", "> 0"}},
    {"fill_without_items", "", FILL("count = 1\n"), nullptr, {"[[fill.items]] is missing"}},
    {"fill_unknown_shape",
     "",
     FILL("count = 1\nitems = [{shape = \"bal\", material = \"glass\"}]\n"),
     nullptr,
     {"fill.items.shape = \"bal\"", "did you mean ball?"}},
    {"csv_without_column",
     "",
     "[[bodies_csv]]\nfile = \"short.csv\"\nshape = \"ball\"\nmaterial = \"glass\"\n",
     nullptr,
     {"short.csv:1"}},
    {"set_table", "steps = 200", "steps = 200", "run=5", {"run = 5", "is a table"}},
    {"set_inside_a_value", "steps = 200", "steps = 200", "run.dt.x=5", {"run.dt has no keys inside"}},
    {"set_include", "steps = 200", "steps = 200", "include=[\"a.toml\"]", {"--set include", "read before overrides"}},
    {"set_bad_index", "steps = 200", "steps = 200", "body[x].scale=2", {"needs a number from 0 in [ ]"}},
};

class FurtherBadScene : public testing::TestWithParam<BadInput> {};

TEST_P(FurtherBadScene, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const BadInput& bad = GetParam();
  const Folder folder;
  folder.write("broken.toml", "[run]\nsteps = = 1\n");
  folder.write("wrong.toml", "[[material]]\ndensity = -1\nname = \"x\"\n");
  folder.write("same.toml", "[[material]]\nname = \"glass\"\nyoung = 1e7\n");
  folder.write("short.csv", "x,y\n1,1\n");
  const std::string base = program::small_scene;
  const std::string text = *bad.from ? program::replaced(base, bad.from, bad.to) : base + bad.to;
  std::vector<std::string> arguments{"run", folder.write("scene.toml", text), "--out", folder.path("out")};
  if (bad.set) arguments.insert(arguments.end(), {"--set", bad.set});
  const auto before = folder.files();
  const Outcome o = program::dem(arguments);
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : bad.message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_EQ(folder.files(), before);
  EXPECT_TRUE(o.out.empty()) << o.out;
}

INSTANTIATE_TEST_SUITE_P(Table, FurtherBadScene, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

}  // namespace
