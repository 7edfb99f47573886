// Files: the three formats, full precision, and what is refused.
#include <cstring>
#include <fstream>

#include "shapes/mesh_build.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;
using shapes::polyhedron_from_file;

std::string written(const std::string& name, const std::string& content) {
  const std::string path = testing::TempDir() + "shape_files_" + name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}
std::string refused(const std::string& name, const std::string& content) {
  return refusal([&] { polyhedron_from_file(written(name, content), Frame::as_given); });
}

const std::string corners = "0.1 0 0\n1 0 0\n1 1 0\n0.1 1 0\n0.1 0 1\n1 0 1\n1 1 1\n0.1 1 1\n";
const std::string sides = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

TEST(Files, off_with_comments_and_colours) {
  const Polyhedron p = polyhedron_from_file(written("a.off", "# a box\nOFF # header\n\n8 6 0\n" + corners +
                                                                 "  # faces\n4 0 3 2 1 255 0 0\n" + sides.substr(10)),
                                            Frame::as_given);
  expect_canonical(p);
  EXPECT_EQ(p.faces.size(), 6u);
  EXPECT_EQ(p.vertices[0].x, 0.1);  // to the last bit: single precision would give 0.100000001
  EXPECT_NEAR(p.mass.volume, 0.9, 2 * eps);
}

TEST(Files, obj_indices_and_precision) {
  std::string vertices = "mtllib x\no box\n";
  for (std::size_t at = 0; at < corners.size(); at = corners.find('\n', at) + 1)
    vertices += "v " + corners.substr(at, corners.find('\n', at) + 1 - at);
  const std::string faces =
      "vn 0 0 1\nf 1//1 4//1 3//1 2//1\nf 5/1/1 6/2/1 7/1/1 8/1/1\nf -8 -7 -3 -4\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Polyhedron p = polyhedron_from_file(written("a.OBJ", vertices + faces), Frame::as_given);
  const Polyhedron q = polyhedron_from_file(written("b.off", "OFF\n8 6 12\n" + corners + sides), Frame::as_given);
  EXPECT_EQ(fingerprint(p), fingerprint(q));
}

TEST(Files, off_and_obj_read_every_digit) {
  const auto points = random_points(41, 4);
  std::string off = "OFF 4 4 6\n";
  for (const Vec3d& v : points) {
    char line[120];
    std::snprintf(line, sizeof line, "%.17g %+.17g %.17e\n", v.x, v.y, v.z);
    off += line;
  }
  const bool turned = dot(cross(points[1] - points[0], points[2] - points[0]), points[3] - points[0]) < 0;
  off += turned ? "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n" : "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const Polyhedron p = polyhedron_from_file(written("digits.off", off), Frame::as_given);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(p.vertices[i] == points[i]);
}

// Triangles of a box, for STL.
std::vector<std::array<Vec3d, 3>> box_triangles() {
  const Polyhedron p = shapes::make_box({1, 0.5, 0.25});
  std::vector<std::array<Vec3d, 3>> triangles;
  for (const auto& f : p.faces)
    for (std::uint32_t i = 1; i + 1 < f.count; ++i)
      triangles.push_back({p.vertices[p.face_vertices[f.first]], p.vertices[p.face_vertices[f.first + i]],
                           p.vertices[p.face_vertices[f.first + i + 1]]});
  return triangles;
}

TEST(Files, stl_ascii_and_binary) {
  std::string ascii = "solid box\n", binary(80, ' ');
  const auto triangles = box_triangles();
  const auto put = [&](const auto& value) { binary.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& t : triangles) {
    ascii += "facet normal 0 0 0\nouter loop\n";
    for (int i = 0; i < 3; ++i) put(0.0f);
    for (const Vec3d& v : t) {
      ascii += "vertex " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
      for (int i = 0; i < 3; ++i) put(static_cast<float>(v[i]));
    }
    ascii += "endloop\nendfacet\n";
    put(std::uint16_t{0});
  }
  ascii += "endsolid box\n";
  const auto reference = fingerprint(shapes::make_box({1, 0.5, 0.25}));
  for (const std::string& path : {written("ascii.stl", ascii), written("binary.stl", binary)}) {
    EXPECT_EQ(fingerprint(polyhedron_from_file(path, Frame::principal)), reference);
    const shapes::Mesh mesh = shapes::mesh_from_file(path, 2);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.facets.size(), 6u);
    EXPECT_EQ(mesh.edges.size(), 12u);
    EXPECT_EQ(max_abs(mesh.vertices[0]), 1);
  }
}

TEST(Files, refused_surfaces_name_what_is_wrong) {
  const std::string head = "OFF\n8 6 12\n";
  EXPECT_TRUE(holds(refused("open.off", "OFF\n8 5 0\n" + corners + sides), "has 1 face(s); allowed: 2"));
  EXPECT_TRUE(holds(refused("turned.off", head + corners + "4 1 2 3 0\n" + sides.substr(10)), "oriented alike"));
  EXPECT_TRUE(holds(refused("dent.off", "OFF\n9 9 0\n" + corners + "0.5 0.5 0.75\n" + sides.substr(0, 10) +
                                            sides.substr(20) + "3 4 5 8\n3 5 6 8\n3 6 7 8\n3 7 4 8\n"),
                    "not convex: face 5 lies 0.25 m inside"));
  EXPECT_TRUE(holds(refused("dent_small.off", "OFF\n9 9 0\n" + corners + "0.5 0.5 0.9999\n" + sides.substr(0, 10) +
                                                  sides.substr(20) + "3 4 5 8\n3 5 6 8\n3 6 7 8\n3 7 4 8\n"),
                    "not convex"));
  EXPECT_TRUE(holds(refused("nan.off", head + "nan" + corners.substr(3) + sides), "nan.off:3: coordinate 'nan'"));
  EXPECT_TRUE(holds(refused("inf.off", head + "1e999" + corners.substr(3) + sides), ":3: coordinate '1e999'"));
  EXPECT_TRUE(holds(refused("word.off", head + "zero" + corners.substr(3) + sides), "'zero'"));
  EXPECT_TRUE(
      holds(refused("index.off", head + corners + "4 0 3 2 8\n" + sides.substr(10)), "index.off:11: vertex index '8'"));
  EXPECT_TRUE(holds(refused("twice.off", head + corners + "4 0 3 3 1\n" + sides.substr(10)), "face 0"));
  EXPECT_TRUE(holds(refused("short.off", "OFF\n8 7 0\n" + corners + sides), "end of file"));
  EXPECT_TRUE(holds(refused("empty.off", "OFF\n0 0 0\n"), "0 faces"));
  EXPECT_TRUE(holds(refused("blank.off", ""), "allowed: OFF"));
  EXPECT_TRUE(holds(refused("flat.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"), "flat.off"));
  EXPECT_TRUE(holds(refused("none.obj", "v 0 0 0\n"), "0 faces"));
  EXPECT_TRUE(holds(refused("zero.obj", "v 0 0 0\nf 0 1 2\n"), "zero.obj:2"));
  EXPECT_TRUE(holds(refused("bad.stl", "nothing"), "bad.stl"));
  EXPECT_TRUE(holds(refused("solid.ply", "ply"), ".ply'; allowed: .off, .obj, .stl"));
  EXPECT_TRUE(holds(refusal([] { polyhedron_from_file("/no/such/file.off", Frame::as_given); }),
                    "/no/such/file.off: cannot be opened"));
  EXPECT_TRUE(holds(refusal([] { shapes::mesh_from_file("/no/such/file.stl"); }), "cannot be opened"));
}

}  // namespace
}  // namespace shape_tests
