// The scene format inside the library: round trip, overrides, schema.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/schema.h"
#include "tests/program/program.h"

namespace {

using namespace dem;
using program::Folder;

// Every table and every kind of value, with numbers that need 17 digits.
const char* const full_scene = R"(title = "a \"quoted\" title\twith a tab"
[run]
time = 0.1
dt = "auto"
dt_fraction = 0.30000000000000004
skin = 1.0000000000000002e-3
seed = 9007199254740993
[output]
interval = 1e-3
vtk = false
[world]
gravity = [-0.0, 1e-300, -9.8066499999999994]
[contact]
max_uncertified_share = 0
[law]
name = "spring_dashpot"
clip = false
[[material]]
name = "a"
stiffness = 1e5
density = 2600
[[material]]
name = "b"
rigid = true
restitution = 0
friction = inf
[[material_pair]]
a = "a"
b = "b"
friction = 0.1
[[shape]]
name = "p"
kind = "polyhedron"
half_spaces = [[1,0,0,1],[-1,0,0,1],[0,1,0,1],[0,-1,0,1],[0,0,1,1],[0,0,-1,1]]
[[shape]]
name = "v"
kind = "polyhedron"
vertices = [[0,0,0],[1,0,0],[0,1,0],[0,0,0.1]]
diameter = 0.1
[[shape]]
name = "g"
kind = "polyhedron"
file = "grain-fine:sacci425_07"
diameter = 0.1
[[shape]]
name = "o"
kind = "octahedron"
circumradius = 0.1
[[shape]]
name = "prism"
kind = "prism"
sides = 7
circumradius = 0.1
height = 0.2
[[wall]]
name = "shaker"
kind = "mesh"
material = "b"
vertices = [[0,0,0],[1,0,0],[0,1,0]]
triangles = [[0,1,2]]
motion = "oscillation"
amplitude = [0, 0, 0.001]
frequency = 50
start = 0.01
remove_at = 0.05
[[wall]]
name = "drum"
kind = "plane"
material = "b"
point = [0,0,-5]
normal = [0,0,2]
motion = "rotation"
axis = [0,0,1]
centre = [0,0,0]
rate = 3
[[wall]]
name = "press"
kind = "box"
material = "b"
lower = [-9, -9, 7]
upper = [9, 9, 8]
open = ["+z", "-x"]
motion = "servo"
axis = [0,0,-1]
target_pressure = 0.1
speed_limit = 0.01
[[wall]]
name = "arm"
kind = "cone"
material = "b"
base = [9, 9, 7]
top = [9, 9, 8]
base_radius = 0
top_radius = 0.5
segments = 12
motion = "table"
turns = [[0, 0], [1, 0.30000000000000004]]
displacements = [[0, 0, 0, 0], [1, 0, 0, 0.1]]
axis = [0,0,1]
[[fill]]
lower = [0,0,1]
upper = [2,2,5]
count = 5
items = [{shape = "p", material = "a", scale = 0.1}, {shape = "o", material = "a", scale = [0.5, 1.1], weight = 3}]
[[body]]
shape = "g"
material = "a"
position = [0.1, 0.2, 0.30000000000000004]
orientation = [0.5000001, 0.5, 0.5, 0.5]
[[bodies_csv]]
file = "bodies.csv"
shape = "v"
material = "a"
[[outlet]]
name = "out"
point = [0,0,-4]
normal = [0,0,1]
recycle_to = "hole"
velocity = [0, 0.1, 0]
[[region]]
name = "hole"
kind = "cylinder"
centre = [0,0,9]
axis = [0.1, 0, 1]
radius = 3
height = 6
[[species]]
name = "s"
region = "hole"
[[fill]]
region = "hole"
mass = 1.5
arrangement = "fcc"
spacing = 0.9
turned = "given"
orientation = [0.5, 0.5, 0.5, 0.5]
items = [{shape = "p", material = "a", species = "s", distribution = "lognormal", median = 0.1, sigma = 0.2, scale = [0.05, 0.2]}, {shape = "p", material = "a", distribution = "table", table = [[0.1, 1], [0.2, 2.5]], share_by = "mass"}]
[[rain]]
name = "r"
region = "hole"
mass_rate = 0.1
stop = 4
count = 7
tries = 3
items = [{shape = "p", material = "a", scale = 0.1}]
[[event]]
name = "e1"
when = "time > 0.1 and rain.r.count > 3"
delay = 0.1
remove_wall = "arm"
friction = 0.1
a = "a"
b = "b"
[[event]]
name = "e2"
at = 0.3
gravity = [0, 0, 1]
start_rain = "r"
species = "s"
material = "a"
stop = true
)";

std::string bits(const Vec3d& v) { return to_toml(Node::array_of({Node::of(v.x), Node::of(v.y), Node::of(v.z)})); }

TEST(SceneFormat, WrittenSceneReadsBackTheSame) {
  const Folder folder;
  folder.write("bodies.csv", "x,y,z,scale\n");
  const Scene first = load_scene(folder.write("scene.toml", full_scene));
  const std::string text = scene_to_toml(first);
  const Scene second = load_scene(folder.write("again.toml", text));
  EXPECT_EQ(scene_to_toml(second), text);

  EXPECT_EQ(first.title, "a \"quoted\" title\twith a tab");
  EXPECT_EQ(second.title, first.title);
  EXPECT_EQ(second.run.dt_fraction, 0.30000000000000004);
  EXPECT_EQ(second.run.skin, 1.0000000000000002e-3);
  EXPECT_EQ(second.run.seed, 9007199254740993u);
  EXPECT_TRUE(second.run.dt_auto);
  EXPECT_TRUE(std::signbit(second.gravity.x));
  EXPECT_EQ(bits(second.gravity), bits(first.gravity));
  EXPECT_EQ(second.gravity.z, -9.8066499999999994);
  EXPECT_EQ(second.run.max_uncertified_share, 0);
  EXPECT_EQ(second.law.name, LawName::spring_dashpot);
  EXPECT_FALSE(second.law.clip);
  EXPECT_EQ(second.materials[1].restitution, 0);
  EXPECT_EQ(second.materials[1].friction, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(second.pairs[0].restitution));
  EXPECT_EQ(second.pairs[0].friction, 0.1);
  EXPECT_EQ(second.shapes[2].file, first.shapes[2].file);
  EXPECT_TRUE(std::filesystem::exists(second.shapes[2].file));
  EXPECT_EQ(second.csv[0].file, first.csv[0].file);
  EXPECT_EQ(second.walls[0].motion, WallMotion::oscillation);
  EXPECT_TRUE(std::isinf(second.walls[0].stop));
  EXPECT_EQ(second.walls[0].remove_at, 0.05);
  EXPECT_EQ(second.walls[2].open, (std::vector<std::string>{"+z", "-x"}));
  EXPECT_EQ(second.walls[2].target_pressure, 0.1);
  EXPECT_EQ(second.walls[3].turns, first.walls[3].turns);
  EXPECT_EQ(second.walls[3].turns[1][1], 0.30000000000000004);
  EXPECT_EQ(second.walls[3].displacements[1][3], 0.1);
  EXPECT_EQ(second.walls[3].segments, 12u);
  EXPECT_EQ(second.fills[0].items[0].scale_max, 0.1);
  EXPECT_EQ(second.fills[0].items[1].scale_max, 1.1);
  EXPECT_EQ(second.regions[0].axis, (Vec3d{0.1, 0, 1}));
  EXPECT_EQ(second.fills[1].items[0].sigma, 0.2);
  EXPECT_EQ(second.fills[1].items[1].table, first.fills[1].items[1].table);
  EXPECT_EQ(second.fills[1].items[1].share_by, ShareBy::mass);
  EXPECT_EQ(second.rains[0].mass_rate, 0.1);
  EXPECT_EQ(second.outlets[0].recycle_to, "hole");
  EXPECT_EQ(second.events[0].when, "time > 0.1 and rain.r.count > 3");
  EXPECT_TRUE(std::isnan(second.events[0].gravity.x) && std::isnan(second.events[1].friction));
  const Quatd &p = first.bodies[0].orientation, &q = second.bodies[0].orientation;
  EXPECT_TRUE(p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z);
  EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 0x1p-50);
}

TEST(SceneFormat, Overrides) {
  const Folder folder;
  const std::string path = folder.write("scene.toml", program::small_scene);
  const Scene s =
      load_scene(path, {"run.time=0.5", "run.dt=auto", "material.glass.young=2e7", "body[1].velocity=[1,2,3]",
                        "output.hdf5=false", "title=5", "contact.max_uncertified_share=0.5"});
  EXPECT_EQ(s.run.time, 0.5);
  EXPECT_EQ(s.run.steps, 0u);  // time takes the place of steps
  EXPECT_TRUE(s.run.dt_auto);
  EXPECT_EQ(s.materials[0].young, 2e7);
  EXPECT_EQ(s.bodies[1].velocity, (Vec3d{1, 2, 3}));
  EXPECT_FALSE(s.output.hdf5);
  EXPECT_EQ(s.title, "5");
  EXPECT_EQ(s.run.max_uncertified_share, 0.5);
  EXPECT_THROW(load_scene(path, {"run.time=1", "run.steps=1"}), InputError);
}

TEST(SceneFormat, PositionsStayWithTheBodies) {
  const Folder folder;
  const Scene s = load_scene(folder.write("scene.toml", program::small_scene));
  EXPECT_EQ(s.materials[0].where.line, 11);
  EXPECT_EQ(s.bodies[2].where.line, 43);
  EXPECT_EQ(s.bodies[2].where.file, folder.path("scene.toml"));
}

TEST(SceneFormat, ShippedScenesLoad) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder())) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(load_scene(entry.path().string())) << entry.path();
    ++scenes;
  }
  EXPECT_GT(scenes, 0);
}

// A default with a unit would break a change of units: only 0, unset and auto may stand there.
TEST(Schema, NoDefaultCarriesAUnit) {
  for (const std::string& path : key_paths()) {
    const Key& key = *find_key(path);
    const std::string value = default_text(path);
    if (key.unit.empty() || value.empty()) continue;
    EXPECT_TRUE(value == "0.0" || value == "\"auto\"" || value == "[0.0, 0.0, 0.0]") << path << " = " << value;
  }
}

TEST(Schema, EveryKeyIsExplained) {
  for (const std::string& path : key_paths()) {
    const Key& key = *find_key(path);
    EXPECT_FALSE(key.sentence.empty()) << path;
    EXPECT_TRUE(key.section || (key.set && key.get)) << path;
    EXPECT_NE(explain(path).find(key.sentence), std::string::npos);
  }
}

TEST(Nearest, Names) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("form", "from"), 1);
  EXPECT_EQ(nearest_name("fricton", {"friction", "fraction"}), "friction");
  EXPECT_EQ(nearest_name("x", {"friction"}), "");
}

}  // namespace
