// Bad input is refused with the place, the value, what is allowed and the nearest known name; exit code 2; nothing
// written.
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

const char* const open_mesh = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n";
// A tetrahedron whose base is pushed in beyond the apex's side: vertex 4 dents the face 0 1 2.
const char* const dented_mesh =
    "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.2 0.2 0.2\n3 4 1 0\n3 4 2 1\n3 4 0 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

#define POLYHEDRON(file) "[[shape]]\nname = \"rock\"\nkind = \"polyhedron\"\n" file

const std::vector<BadInput> inputs{
    {"syntax", "steps = 200", "steps = = 200", nullptr, {"scene.toml:3:9:", "TOML syntax"}},
    {"key_twice", "steps = 200", "steps = 200\nsteps = 300", nullptr, {"scene.toml:4:9:", "TOML syntax", "steps"}},
    {"unknown_key",
     "dt = 1e-5",
     "dtt = 1e-5",
     nullptr,
     {"scene.toml:4:1:", "unknown key run.dtt", "did you mean run.dt?", "    4 | dtt", "      | ^"}},
    {"unknown_table",
     "[world]",
     "[wrld]",
     nullptr,
     {"scene.toml:7:", "unknown key wrld", "did you mean world?", "[world] is missing"}},
    {"key_of_another_table",
     "steps = 200",
     "steps = 200\ngravity = [0, 0, 0]",
     nullptr,
     {"unknown key run.gravity", "did you mean world.gravity?"}},
    {"wrong_type",
     "radius = 0.005",
     "radius = \"5 mm\"",
     nullptr,
     {"shape.radius = \"5 mm\"", "needs a number, found text", "scene.toml:21:10"}},
    {"wrong_length",
     "gravity = [0, 0, -9.81]",
     "gravity = [0, -9.81]",
     nullptr,
     {"world.gravity = [0, -9.81]", "needs a list of 3 numbers", "found 2 entries"}},
    {"not_an_integer",
     "steps = 200",
     "steps = 200.5",
     nullptr,
     {"scene.toml:3:9", "run.steps = 200.5", "needs an integer"}},
    {"a_date", "dt = 1e-5", "dt = 2024-01-01", nullptr, {"run.dt", "found a date or time"}},
    {"out_of_range",
     "dt = 1e-5",
     "dt_fraction = 1.5",
     nullptr,
     {"scene.toml:4:15: run.dt_fraction = 1.5: allowed 0 < run.dt_fraction <= 0.5", "      |               ^"}},
    {"negative_step", "dt = 1e-5", "dt = -1e-5", nullptr, {"run.dt = -1e-05", "allowed run.dt > 0"}},
    {"restitution_zero",
     "restitution = 0.8",
     "restitution = 0",
     nullptr,
     {"scene.toml:16:15: material.restitution = 0", "allowed 0.01 <= material.restitution <= 1",
      "with law.clip = false"}},
    {"restitution_below_what_a_clipped_contact_is_asked_for",
     "restitution = 0.8",
     "restitution = 0.0099",
     nullptr,
     {"material.restitution = 0.0099", "allowed 0.01 <= material.restitution <= 1", "with law.clip = false"}},
    {"negative_restitution",
     "restitution = 0.8",
     "restitution = -0.1",
     nullptr,
     {"material.restitution = -0.1", "allowed 0 <= material.restitution <= 1"}},
    {"poisson", "poisson = 0.25", "poisson = 0.6", nullptr, {"allowed 0 <= material.poisson <= 0.5"}},
    {"negative_friction",
     "friction = 0.5",
     "friction = -0.5",
     nullptr,
     {"material.friction = -0.5", "allowed material.friction >= 0"}},
    {"friction_that_is_no_number", "friction = 0.5", "friction = nan", nullptr, {"material.friction = nan", "must be"}},
    {"friction_below_all_numbers",
     "friction = 0.5",
     "friction = -inf",
     nullptr,
     {"material.friction = -inf", "must be"}},
    {"nan", "young = 1e7", "young = nan", nullptr, {"scene.toml:13:9", "material.young = nan", "must be finite"}},
    {"infinity", "density = 2500", "density = inf", nullptr, {"material.density = inf", "must be finite"}},
    {"nan_in_a_list",
     "velocity = [-1, 0, -0.5]",
     "velocity = [-1, nan, -0.5]",
     nullptr,
     {"body.velocity", "must be finite"}},
    {"gravity_is_required", "gravity = [0, 0, -9.81]", "", nullptr, {"world.gravity is missing", "m/s^2"}},
    {"missing_key", "radius = 0.005", "", nullptr, {"scene.toml:18:1", "shape.radius is missing"}},
    {"unknown_word",
     "kind = \"sphere\"",
     "kind = \"shpere\"",
     nullptr,
     {"shape.kind = \"shpere\"", "did you mean sphere?"}},
    {"key_of_another_kind",
     "radius = 0.005",
     "radius = 0.005\nheight = 1",
     nullptr,
     {"shape.height: applies only where kind = prism", "\"sphere\""}},
    {"unknown_law",
     "\"hertz_mindlin\"",
     "\"hertz\"",
     nullptr,
     {"law.name = \"hertz\"", "spring_dashpot, hertz_mindlin"}},
    {"unknown_material",
     "material = \"glass\"\nposition = [0, 0",
     "material = \"glas\"\nposition = [0, 0",
     nullptr,
     {"body.material = \"glas\"", "no [[material]] has this name", "did you mean glass?"}},
    {"unknown_shape", "shape = \"egg\"", "shape = \"eg\"", nullptr, {"body.shape = \"eg\"", "did you mean egg?"}},
    {"name_twice", "name = \"egg\"", "name = \"ball\"", nullptr, {"shape.name = \"ball\"", "taken already"}},
    {"table_for_array", "[[wall]]", "[wall]", nullptr, {"wall: is an array of tables: write [[wall]]"}},
    {"time_and_steps",
     "steps = 200",
     "steps = 200\ntime = 1",
     nullptr,
     {"scene.toml:3:9", "give run.time or run.steps, not both"}},
    {"neither_time_nor_steps", "steps = 200\n", "", nullptr, {"give run.time (s) or run.steps"}},
    {"method_of_other_pairs",
     "",
     "[contact]\nmethod = \"sat\"\n",
     nullptr,
     {"contact.method = \"sat\" does not answer the pair sphere", "allowed: \"auto\"", "dem list pairs"}},
    {"unknown_method",
     "",
     "[contact]\nmethod = \"analitic\"\n",
     nullptr,
     {"contact.method = \"analitic\"", "did you mean analytic?"}},
    {"no_young", "young = 1e7\n", "", nullptr, {"\"glass\" needs young (Pa) for law hertz_mindlin"}},
    {"no_stiffness",
     "\"hertz_mindlin\"",
     "\"spring_dashpot\"",
     nullptr,
     {"\"glass\" needs stiffness (N/m) for law spring_dashpot"}},
    {"no_density", "density = 2500\n", "", nullptr, {"\"glass\" needs density", "bodies are made of it"}},
    {"two_rigid", "young = 1e7", "rigid = true", nullptr, {"both rigid and can meet"}},
    {"zero_normal",
     "normal = [0, 0, 1]",
     "normal = [0, 0, 0]",
     nullptr,
     {"wall.normal", "must not be the zero vector"}},
    {"quaternion", "[0.8, 0.6, 0, 0]", "[0.8, 0.8, 0, 0]", nullptr, {"body.orientation", "= 1 within 0.001", "1.28"}},
    {"pair_twice",
     "",
     "[[material_pair]]\na=\"glass\"\nb=\"glass\"\n[[material_pair]]\na=\"glass\"\nb=\"glass\"\n",
     nullptr,
     {"glass, glass stands here twice"}},
    {"missing_file", "", POLYHEDRON("file = \"rock.off\"\n"), nullptr, {"shape.file = \"rock.off\"", "no such file"}},
    {"unknown_grain",
     "",
     POLYHEDRON("file = \"grain:ma165_99\"\ndiameter = 0.01\n"),
     nullptr,
     {"grain:ma165_99", "did you mean grain:ma165_"}},
    {"grain_without_size",
     "",
     POLYHEDRON("file = \"grain:ma165_01\"\n"),
     nullptr,
     {"a shipped shape has no size of its own", "shape.diameter"}},
    {"open_mesh", "", POLYHEDRON("file = \"open.off\"\n"), nullptr, {"open.off"}},
    {"dented_mesh", "", POLYHEDRON("file = \"dented.off\"\n"), nullptr, {"dented.off", "convex"}},
    {"flat_polyhedron", "", POLYHEDRON("vertices = [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]\n"), nullptr, {"scene.toml:"}},
    {"two_sources",
     "",
     POLYHEDRON("file = \"open.off\"\nvertices = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]\n"),
     nullptr,
     {"exactly one of vertices, half_spaces and file"}},
    {"triangle_index",
     "",
     "[[wall]]\nname = \"w\"\nkind = \"mesh\"\nmaterial = \"glass\"\nvertices = "
     "[[0,0,-1],[1,0,-1],[0,1,-1]]\ntriangles = [[0,1,3]]\n",
     nullptr,
     {"wall.triangles", "vertex 3 does not exist"}},
    {"stop_before_start",
     "normal = [0, 0, 1]",
     "normal = [0, 0, 1]\nmotion = \"translation\"\nvelocity = [1,0,0]\nstart = 2\nstop = 1",
     nullptr,
     {"wall.stop = 1", "allowed wall.stop > wall.start = 2"}},
    {"servo_without_target",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"servo\"\naxis = [0,0,1]\nspeed_limit = 1\n",
     nullptr,
     {"\"w\" needs either target_force (N) or target_pressure (Pa)"}},
    {"servo_without_speed_limit",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"servo\"\naxis = [0,0,1]\ntarget_force = 1\n",
     nullptr,
     {"wall.speed_limit is missing"}},
    {"servo_plane_without_area",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"servo\"\naxis = [0,0,1]\nspeed_limit = 1\ntarget_pressure = 1\n",
     nullptr,
     {"\"w\" needs area (m^2)"}},
    {"servo_without_axis",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"servo\"\nspeed_limit = 1\ntarget_force = 1\n",
     nullptr,
     {"wall.axis is missing"}},
    {"table_times_fall",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"table\"\ndisplacements = [[0,0,0,0],[1,0,0,0],[0.5,0,0,0]]\n",
     nullptr,
     {"wall.displacements", "time 0.5 of row 3 does not follow 1"}},
    {"table_without_rows",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"table\"\n",
     nullptr,
     {"needs either table_file, or displacements or turns"}},
    {"table_turns_without_axis",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"plane\"\npoint = [0,0,-9]\nnormal = [0,0,1]\nmotion = "
     "\"table\"\nturns = [[0,0],[1,1]]\n",
     nullptr,
     {"\"w\" turns: it needs axis and centre"}},
    {"box_face_unknown",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"box\"\nlower = [-9,-9,-9]\nupper = [9,9,9]\nopen = "
     "[\"top\"]\n",
     nullptr,
     {"a box has no face top; allowed -x, +x"}},
    {"box_of_no_size",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"box\"\nlower = [-9,-9,-9]\nupper = [9,-9,9]\n",
     nullptr,
     {"allowed wall.upper > wall.lower in x, y and z"}},
    {"cylinder_of_no_length",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"cylinder\"\nbase = [0,0,1]\ntop = [0,0,1]\nradius = 9\n",
     nullptr,
     {"wall.top", "must not be the point wall.base"}},
    {"v_arms_too_short",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"v_shell\"\nbase = [0,0,0]\nangle = 1.2\nradius = "
     "9\nlength = 9\n",
     nullptr,
     {"the arms end inside their joint"}},
    {"panel_without_area",
     "",
     "[[wall]]\nname = \"w\"\nmaterial = \"glass\"\nkind = \"panel\"\ncorner = [0,0,-9]\nside_1 = [1,0,0]\nside_2 = "
     "[2,0,0]\n",
     nullptr,
     {"wall.side_2", "must not be parallel to wall.side_1"}},
    {"empty_box",
     "",
     "[[fill]]\nlower = [0,0,1]\nupper = [1,1,1]\ncount = 1\nitems = [{shape = \"ball\", material = \"glass\"}]\n",
     nullptr,
     {"fill.upper", "allowed fill.upper > fill.lower"}},
    {"item_key",
     "",
     "[[fill]]\nlower = [0,0,1]\nupper = [1,1,2]\ncount = 1\nitems = [{shape = \"ball\", materials = \"glass\"}]\n",
     nullptr,
     {"unknown key fill.items.materials", "did you mean fill.items.material?"}},
    {"scale_range",
     "",
     "[[fill]]\nlower = [0,0,1]\nupper = [1,1,2]\ncount = 1\nitems = [{shape = \"ball\", material = \"glass\", scale = "
     "[2, 1]}]\n",
     nullptr,
     {"fill.items.scale", "min <= max"}},
    {"initial_overlap",
     "position = [0.001, 0, 0.0155]",
     "position = [0.001, 0, 0.013]",
     nullptr,
     {"scene.toml:", "overlaps", "max_initial_overlap"}},
    {"bad_csv",
     "",
     "[[bodies_csv]]\nfile = \"bad.csv\"\nshape = \"ball\"\nmaterial = \"glass\"\n",
     nullptr,
     {"bad.csv:3:"}},
    {"set_out_of_range", "steps = 200", "steps = 200", "run.dt=0", {"--set: run.dt = 0: allowed run.dt > 0"}},
    {"set_unknown_key", "steps = 200", "steps = 200", "run.stps=5", {"--set run.stps=5", "did you mean run.steps?"}},
    {"set_without_value", "steps = 200", "steps = 200", "run.steps", {"--set run.steps", "key=value"}},
    {"set_unknown_name",
     "steps = 200",
     "steps = 200",
     "material.glas.young=1",
     {"no [[material]] is named \"glas\"", "did you mean glass?"}},
    {"set_no_key", "steps = 200", "steps = 200", "material[0]=1", {"names no key of material"}},
    {"set_index", "steps = 200", "steps = 200", "material[7].young=1", {"material[7]", "the scene has 1"}},
    {"plane_scene_with_bodies_of_space",
     "steps = 200",
     "steps = 200",
     "world.dimension=2",
     {"a 2-D scene allows disc, ellipse", "a 2-D scene allows line", "world.thickness: is missing"}},
    {"dimension_4", "steps = 200", "steps = 200", "world.dimension=4", {"world.dimension = 4", "allowed 2 <="}},
    {"thickness_in_space", "steps = 200", "steps = 200", "world.thickness=0.1", {"set world.dimension = 2"}},
    {"disc_model_in_space", "steps = 200", "steps = 200", "world.disc_model=sphere", {"set world.dimension = 2"}},
    {"periodic_axes",
     "[law]",
     "[periodic]\naxes = \"yx\"\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n[law]",
     nullptr,
     {"periodic.axes = \"yx\"", "allowed", "xy"}},
    {"periodic_reversed",
     "[law]",
     "[periodic]\naxes = \"xy\"\nlower = [0, 0, 0]\nupper = [1, 0, 1]\n[law]",
     nullptr,
     {"scene.toml:12:9", "periodic.upper = [1, 0, 1]", "allowed periodic.upper > periodic.lower in y"}},
    {"periodic_without_box",
     "[law]",
     "[periodic]\naxes = \"x\"\n[law]",
     nullptr,
     {"periodic.lower is missing", "periodic.upper is missing"}},
    {"periodic_box_without_axes",
     "[law]",
     "[periodic]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n[law]",
     nullptr,
     {"periodic.lower", "axes"}},
    {"periodic_across_a_wall",
     "[law]",
     "[periodic]\naxes = \"xyz\"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\n[law]",
     nullptr,
     {"wall.normal = [0, 0, 1]", "allowed: 0 along periodic.axes = \"xyz\""}},
    {"periodic_too_short",
     "[law]",
     "[periodic]\naxes = \"xy\"\nlower = [0, 0, 0]\nupper = [1, 0.01, 1]\n[law]",
     nullptr,
     {"scene.toml:", "too short", "allowed: from", "in y"}},
    {"periodic_outlet",
     "[law]",
     "[periodic]\naxes = \"x\"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\n[[outlet]]\nname = \"drain\"\npoint = [0, 0, "
     "0]\nnormal = [1, 0, 0]\n[law]",
     nullptr,
     {"outlet.normal = [1, 0, 0]", "allowed: 0 along periodic.axes = \"x\""}},
    {"periodic_fill",
     "[law]",
     "[periodic]\naxes = \"x\"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\n[[fill]]\nlower = [0, 0, 0.1]\nupper = [1.5, "
     "1, 1]\ncount = 2\n[[fill.items]]\nshape = \"ball\"\nmaterial = \"glass\"\n[law]",
     nullptr,
     {"fill.upper = [1.5, 1, 1]", "allowed within the periodic box", "x = -1 to 1"}},
    {"cell_interval",
     "steps = 200",
     "steps = 200",
     "output.cell_interval=-1",
     {"output.cell_interval = -1", "allowed"}},
    {"walls_interval",
     "steps = 200",
     "steps = 200",
     "output.walls_interval=-1",
     {"output.walls_interval = -1", "allowed"}},
    {"map_of_a_plane",
     "normal = [0, 0, 1]",
     "normal = [0, 0, 1]\npressure_map = true",
     nullptr,
     {"wall.pressure_map = true", "of a plane needs map_cell (m)"}},
    {"cells_of_no_map",
     "normal = [0, 0, 1]",
     "normal = [0, 0, 1]\nmap_cell = 0.1",
     nullptr,
     {"wall.map_cell = 0.1", "only goes with wall.pressure_map = true"}},
};

class BadScene : public testing::TestWithParam<BadInput> {};

TEST_P(BadScene, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const BadInput& bad = GetParam();
  const Folder folder;
  folder.write("open.off", open_mesh);
  folder.write("dented.off", dented_mesh);
  folder.write("bad.csv", "x,y,z,radius\n1,1,1,0.005\n2,2,two,0.005\n");
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

INSTANTIATE_TEST_SUITE_P(Table, BadScene, testing::ValuesIn(inputs), [](const auto& info) { return info.param.name; });

TEST(BadInput, EveryMistakeOfAFileIsReported) {
  const Folder folder;
  std::string text = program::replaced(program::small_scene, "radius = 0.005", "radius = -1");
  text = program::replaced(text, "friction", "fricton");
  const Outcome o = program::dem({"check", folder.write("scene.toml", text)});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("shape.radius = -1"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("did you mean material.friction?"), std::string::npos) << o.err;
}

TEST(BadInput, NoBodies) {
  const Folder folder;
  const std::string scene = program::small_scene;
  const Outcome o = program::dem({"check", folder.write("scene.toml", scene.substr(0, scene.find("[[body]]")))});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("the scene has no bodies"), std::string::npos) << o.err;
}

TEST(BadInput, CommandLine) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene);
  EXPECT_EQ(program::dem({}).exit_code, 2);
  EXPECT_EQ(program::dem({"runn", scene}).exit_code, 2);
  EXPECT_EQ(program::dem({"run", scene}).exit_code, 2);  // no --out
  EXPECT_EQ(program::dem({"run", folder.path("none.toml"), "--out", folder.path("out")}).exit_code, 2);
  EXPECT_EQ(program::dem({"run", scene, "--out", folder.path("out"), "--threads", "0"}).exit_code, 2);
  EXPECT_EQ(program::dem({"resume", folder.path("out")}).exit_code, 2);
  EXPECT_EQ(program::dem({"list", "shape"}).exit_code, 2);
  const Outcome o = program::dem({"explain", "run.dtfraction"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("run.dt_fraction"), std::string::npos) << o.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"scene.toml"});
}

TEST(BadInput, CaseFiles) {
  const Folder folder;
  const auto refused = [&](const char* text, const char* message) {
    const Outcome o = program::dem({"contact", folder.write("cases.json", text)});
    EXPECT_EQ(o.exit_code, 2) << text;
    EXPECT_NE(o.err.find(message), std::string::npos) << message << "\nnot in\n" << o.err;
  };
  const std::string pose = R"({"position": [0, 0, 0], "quaternion": [1, 0, 0, 0]})";
  const auto with = [&](const std::string& shape) {
    return R"({"cases": [{"id": "x", "shape_a": {"type": "sphere", "radius": 1}, "shape_b": )" + shape +
           R"(, "pose_a": )" + pose + R"(, "pose_b": )" + pose + "}]}";
  };
  refused("{\"cases\": [\n}", "cases.json:2:1: JSON syntax");
  refused("{}", "cases: is missing");
  refused(R"({"cases": [{"id": "x"}]})", "shape_a: is missing");
  refused(with(R"({"type": "spere", "radius": 1})").c_str(), "did you mean sphere?");
  refused(with(R"({"type": "sphere", "radius": -1})").c_str(), "allowed > 0");
  refused(with(R"({"type": "box", "size": [1, 2]})").c_str(), "needs 3 numbers");
}

}  // namespace
