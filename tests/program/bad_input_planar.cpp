// Bad input of two-dimensional scenes: exit code 2, the place, the value, what is allowed; nothing written.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

const char* const plane_scene = R"([run]
steps = 20
[world]
dimension = 2
thickness = 0.01
gravity = [0, -9.81, 0]
[law]
name = "spring_dashpot"
[[material]]
name = "stone"
stiffness = 1e4
density = 2500
[[shape]]
name = "grain"
kind = "polygon"
vertices = [[0, 0, 0], [0.02, 0, 0], [0.01, 0.02, 0]]
[[wall]]
name = "floor"
kind = "line"
material = "stone"
point = [0, 0, 0]
normal = [0, 1, 0]
[[body]]
shape = "grain"
material = "stone"
position = [0, 0.1, 0]
)";

struct BadInput {
  const char* name;
  const char* from;
  const char* to;
  std::vector<const char*> message;
};

void PrintTo(const BadInput& b, std::ostream* out) { *out << b.name; }

#define CORNERS "[[0, 0, 0], [0.02, 0, 0], [0.01, 0.02, 0]]"

#define LINE "kind = \"line\"\nmaterial = \"stone\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]"
#define CHAIN "kind = \"polyline\"\nmaterial = \"stone\"\ndepth = 0.1\nvertices = "
#define BLOCK "kind = \"polygon\"\nmaterial = \"stone\"\nvertices = "

const std::vector<BadInput> inputs{
    {"wall_without_corners", LINE, "kind = \"polygon\"\nmaterial = \"stone\"", {"wall.vertices", "missing"}},
    {"wall_off_the_plane",
     LINE,
     BLOCK "[[0, 0, 0], [1, 0, 0], [0, 0, 1]]",
     {"scene.toml:21:12", "wall.vertices", "z of vertex 2 must be 0"}},
    {"wall_that_crosses_itself",
     LINE,
     BLOCK "[[-1, -1, 0], [1, -0.1, 0], [1, -1, 0], [-1, -0.1, 0]]",
     {"wall \"floor\"", "must not cross or touch itself"}},
    {"wall_of_two_corners",
     LINE,
     BLOCK "[[-1, -1, 0], [1, -1, 0]]",
     {"wall.vertices", "at least 3 vertices", "found 2"}},
    {"wall_with_corners_and_a_normal",
     LINE,
     BLOCK "[[-1, -1, 0], [1, -1, 0], [0, 0, 0]]\nnormal = [0, 1, 0]",
     {"wall.normal", "only"}},
    {"chain_of_one_vertex", LINE, CHAIN "[[0, 0, 0]]", {"wall.vertices", "at least 2 vertices", "found 1"}},
    {"closed_chain_of_two_vertices",
     LINE,
     CHAIN "[[0, 0, 0], [1, 0, 0]]\nclosed = true",
     {"scene.toml:22:12", "at least 3 vertices", "found 2"}},
    {"chain_without_depth",
     LINE,
     "kind = \"polyline\"\nmaterial = \"stone\"\nvertices = [[0, 0, 0], [1, 0, 0]]",
     {"wall.depth", "missing"}},
    {"chain_of_no_depth",
     LINE,
     "kind = \"polyline\"\nmaterial = \"stone\"\ndepth = 0\nvertices = [[0, 0, 0], [1, 0, 0]]",
     {"scene.toml:21:9", "wall.depth = 0", "allowed wall.depth > 0"}},
    {"chain_off_the_plane", LINE, CHAIN "[[0, 0, 0], [1, 0, 0.5]]", {"scene.toml:22:12", "z of vertex 1 must be 0"}},
    {"chain_with_a_vertex_twice",
     LINE,
     CHAIN "[[-1, 0, 0], [0, 0, 0], [0, 0, 0], [1, 1, 0]]",
     {"wall \"floor\"", "vertices 1 and 2 are one point"}},
    {"chain_that_ends_where_it_begins",
     LINE,
     CHAIN "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0]]",
     {"wall \"floor\"", "ends at vertex 3 where it begins; allowed: closed = true, without that vertex"}},
    {"chain_that_crosses_itself",
     LINE,
     CHAIN "[[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]]",
     {"the side from vertex 0 to 1 and the side from vertex 2 to 3 meet", "must not cross or touch itself"}},
    {"chain_that_turns_back",
     LINE,
     CHAIN "[[0, 0, 0], [2, 0, 0], [1, 0, 0]]",
     {"wall \"floor\"", "turns back on itself at vertex 1"}},
    {"chain_too_deep_for_its_bends",
     LINE,
     CHAIN "[[-1, 0, 0], [0, 0, 0], [0, -0.15, 0], [-1, -0.15, 0]]",
     {"depth is too large between the bends of the side from vertex 1 to 2; allowed: below 0.075 m"}},
    {"line_that_is_closed", LINE, LINE "\nclosed = true", {"wall.closed", "only"}},
    {"polygon_of_two", CORNERS, "[[0, 0, 0], [0.02, 0, 0]]", {"scene.toml:16:12", "at least 3 vertices", "found 2"}},
    {"polygon_without_corners", "vertices = " CORNERS "\n", "", {"scene.toml:15", "needs either vertices or pieces"}},
    {"polygon_with_corners_and_pieces",
     "vertices = " CORNERS,
     "vertices = " CORNERS "\npieces = [" CORNERS "]",
     {"scene.toml:17:10", "needs either vertices or pieces"}},
    {"pieces_of_one_piece_flat",
     "vertices = " CORNERS,
     "pieces = [" CORNERS ", [[0, 0, 0], [1, 0, 0]]]",
     {"shape.pieces", "at least 3 vertices are needed of piece 1, found 2"}},
    {"pieces_off_the_plane",
     "vertices = " CORNERS,
     "pieces = [" CORNERS ", [[0, 0, 0], [1, 0, 0], [0, 1, 2]]]",
     {"z of vertex 2 of piece 1 must be 0"}},
    {"pieces_not_lists", "vertices = " CORNERS, "pieces = [[0, 0, 0], [1, 0, 0]]", {"shape.pieces", "needs a list"}},
    {"pieces_apart",
     "vertices = " CORNERS,
     "pieces = [" CORNERS ", [[1, 0, 0], [2, 0, 0], [1, 1, 0]]]",
     {"\"grain\"", "are apart, overlap or enclose a hole"}},
    {"pieces_about_a_hole",
     "vertices = " CORNERS,
     "pieces = [[[0, 0, 0], [3, 0, 0], [3, 1, 0], [0, 1, 0]], [[0, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]], "
     "[[2, 1, 0], [3, 1, 0], [3, 2, 0], [2, 2, 0]], [[0, 2, 0], [3, 2, 0], [3, 3, 0], [0, 3, 0]]]",
     {"\"grain\"", "enclose a hole"}},
    {"pieces_that_overlap",
     "vertices = " CORNERS,
     "pieces = [" CORNERS ", [[0, 0.01, 0], [0.02, 0.01, 0], [0.01, -0.01, 0]]]",
     {"\"grain\"", "overlap"}},
    {"pieces_that_meet_in_a_point",
     "vertices = " CORNERS,
     "pieces = [" CORNERS ", [[0, 0, 0], [-0.02, 0, 0], [-0.01, -0.02, 0]]]",
     {"\"grain\"", "meet in a point only"}},
    {"pieces_of_a_polyhedron",
     "kind = \"polygon\"\nvertices = " CORNERS,
     "kind = \"disc\"\nradius = 0.01\npieces = [" CORNERS "]",
     {"shape.pieces", "only"}},
    {"polygon_off_the_plane",
     CORNERS,
     "[[0, 0, 0], [0.02, 0, 0], [0.01, 0.02, 0.1]]",
     {"scene.toml:16:12", "z of vertex 2 must be 0"}},
    {"polygon_on_a_line", CORNERS, "[[0, 0, 0], [1, 1, 0], [2, 2, 0]]", {"\"grain\"", "enclose no area"}},
    {"polygon_that_crosses_itself",
     CORNERS,
     "[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]",
     {"\"grain\"", "must not cross or touch itself"}},
    {"polygon_with_sides", "vertices = ", "sides = 5\nvertices = ", {"shape.sides", "only"}},
    {"regular_polygon_of_two_sides",
     "kind = \"polygon\"\nvertices = " CORNERS,
     "kind = \"regular_polygon\"\nsides = 2\ncircumradius = 0.01",
     {"shape.sides = 2", "allowed 3 <="}},
    {"regular_polygon_without_size",
     "kind = \"polygon\"\nvertices = " CORNERS,
     "kind = \"regular_polygon\"\nsides = 5",
     {"shape.circumradius", "missing"}},
    {"polygon_in_space", "dimension = 2\nthickness = 0.01\n", "", {"is for 2-D scenes: set world.dimension = 2"}},
    {"polygon_as_spheres",
     "thickness = 0.01",
     "disc_model = \"sphere\"",
     {"disc_model = \"sphere\" is for discs only"}},
    {"polygon_under_a_law_of_spheres",
     "name = \"spring_dashpot\"",
     "name = \"hertz_mindlin\"",
     {"is a law of spheres and the bodies are prisms"}},
    {"polygon_turned_out_of_the_plane",
     "position = [0, 0.1, 0]",
     "position = [0, 0.1, 0]\norientation = [0, 1, 0, 0]",
     {"body.orientation", "entry 2 must be 0"}},
};

class BadPlaneScene : public testing::TestWithParam<BadInput> {};

TEST(PlaneScene, is_accepted_as_it_stands) {
  const Folder folder;
  const Outcome o = program::dem({"check", folder.write("scene.toml", plane_scene)});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.out.find("polygon, 3 vertices"), std::string::npos) << o.out;
}

TEST(PlaneScene, knows_chains_and_refuses_them_in_space) {
  const Folder folder;
  const std::string text = program::replaced(plane_scene, LINE, CHAIN "[[-1, 0.1, 0], [0, 0, 0], [1, 0.1, 0]]");
  const Outcome o = program::dem({"check", folder.write("scene.toml", text)});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.out.find("polyline, fixed, 6 vertices, not convex: 2 convex parts"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("regions       on"), std::string::npos) << o.out;
  const std::string in_space = program::replaced(text, "dimension = 2\nthickness = 0.01\n", "");
  const Outcome refused = program::dem({"check", folder.write("space.toml", in_space)});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("wall.kind = \"polyline\": is for 2-D scenes"), std::string::npos) << refused.err;
}

TEST_P(BadPlaneScene, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const BadInput& bad = GetParam();
  const Folder folder;
  const std::string text = program::replaced(plane_scene, bad.from, bad.to);
  const std::vector<std::string> arguments{"run", folder.write("scene.toml", text), "--out", folder.path("out")};
  const auto before = folder.files();
  const Outcome o = program::dem(arguments);
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : bad.message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_EQ(folder.files(), before);
}

INSTANTIATE_TEST_SUITE_P(Table, BadPlaneScene, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

}  // namespace
