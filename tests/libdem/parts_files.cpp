// Bodies of parts in what a run writes: VTK pieces, the record, pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "libdem/io/io.h"
#include "libdem/render/render.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

using Json = nlohmann::json;

// A ball, a clump of three balls, an L of two bars, a mushroom of a box and an egg, each scaled by 2, apart.
World world_of_parts() {
  Scene s;
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = {scenes::sphere("ball", 0.1),
              scenes::clump("three", {{0, 0, 0, 0.2}, {0.3, 0, 0, 0.15}, {0, 0.25, 0, 0.1}}),
              scenes::box("bar", {0.6, 0.2, 0.2}),
              scenes::box("stub", {0.2, 0.4, 0.2}),
              scenes::union_of("ell", {{"bar", {}, {}}, {"stub", {-0.2, 0.3, 0}, {}}}),
              scenes::ellipsoid("egg", {0.3, 0.2, 0.1}),
              scenes::union_of("mushroom", {{"bar", {}, {}}, {"egg", {0.3, 0, 0}, scenes::turn({0, 0, 1}, 0.5)}})};
  s.run.steps = 1;
  for (int i = 0; const char* shape : {"ball", "three", "ell", "mushroom"}) {
    s.bodies.push_back(
        scenes::body(shape, "soft", {4.0 * i++, 1, 2}, {1, 0, 0}, {0, 0, 2}, scenes::turn({0.6, 0, 0.8}, 1)));
    s.bodies.back().scale = 2;
  }
  return build_world(s);
}

TEST(PartsFiles, EachPartIsAPieceWithTheBodysId) {
  const World world = world_of_parts();
  const io_test::Folder folder("vtk_parts");
  io::VtkSeries(folder.path()).write(world);
  const auto read = [&](const std::string& piece, int& code) {
    const std::string command = "/usr/bin/python3 '" PROJECT_ROOT "/tests/vtk_reader.py' '" +
                                (folder / ("frames/" + piece + "_000000.vtp")) + "'";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    char chunk[4096];
    while (const std::size_t n = std::fread(chunk, 1, sizeof chunk, pipe)) text.append(chunk, n);
    code = WEXITSTATUS(pclose(pipe));
    return code == 0 ? Json::parse(text) : Json();
  };
  int code = 0;
  const Json rounds = read("spheres", code);
  if (code == 77) GTEST_SKIP() << "VTK for Python is not installed";
  ASSERT_EQ(code, 0);
  ASSERT_EQ(rounds["points"].size(), 1u + 3u + 1u);
  const int ids[] = {0, 1, 1, 1, 3};
  const double radius[] = {0.2, 0.4, 0.3, 0.2, 2 * std::cbrt(0.3 * 0.2 * 0.1)};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(rounds["point_data"]["id"][i][0], ids[i]);
    EXPECT_NEAR(rounds["point_data"]["radius"][i][0].get<double>(), radius[i], 1e-7);
    // each moves with its body: v + ω × arm
    const Motion& m = world.particles.motion[static_cast<std::size_t>(ids[i])];
    const auto& x = rounds["points"][i];
    const Vec3d arm = Vec3d{x[0], x[1], x[2]} - m.position, v = m.velocity + cross(m.spin, arm);
    EXPECT_NEAR(rounds["point_data"]["velocity"][i][1].get<double>(), v.y, 1e-6);
  }
  const auto& a = rounds["points"][1];
  const auto& b = rounds["points"][2];
  const Vec3d d{b[0].get<double>() - a[0].get<double>(), b[1].get<double>() - a[1].get<double>(),
                b[2].get<double>() - a[2].get<double>()};
  EXPECT_NEAR(norm(d), 0.6, 1e-14);
  const Json solids = read("polyhedra", code);
  ASSERT_EQ(code, 0);
  EXPECT_EQ(solids["polys"], 3 * 6);
  EXPECT_EQ(solids["cell_data"]["particle"][0][0], 2);
  EXPECT_EQ(solids["cell_data"]["particle"][17][0], 3);
}

TEST(PartsFiles, TheRecordReadsBack) {
  const World world = scenes::run(scenes::bodies_of_parts(60), 400);
  const io_test::Folder folder("record_parts");
  const std::string path = folder / "record.h5";
  io::Record(path, world, false).write(world);
  World read = build_world(world.scene);
  io::load_frame(path, read, 0);
  const auto expected = touching_contacts(world), got = touching_contacts(read);
  ASSERT_EQ(got.size(), expected.size());
  std::size_t later = 0;
  for (const ContactReport& c : expected) {
    const auto same = std::find_if(got.begin(), got.end(), [&](const ContactReport& o) {
      return o.a == c.a && o.b == c.b && o.wall == c.wall && o.part == c.part && o.part_a == c.part_a;
    });
    ASSERT_NE(same, got.end());
    EXPECT_TRUE(same->force == c.force);
    EXPECT_TRUE(same->point == c.point);
    later += c.part_a > 0 ? 1 : 0;
  }
  EXPECT_GT(later, 0u);
  EXPECT_EQ(contacts_per_particle(read), contacts_per_particle(world));
  EXPECT_NEAR(energies(read).elastic / energies(world).elastic, 1, 1e-12);
}

// Seen along z: two discs that overlap, and an L.
TEST(PartsFiles, PicturesShowTheirOutlines) {
  if (!render::available()) GTEST_SKIP() << "built without Embree";
  const double pi = std::numbers::pi, half = std::acos(0.6);  // discs of radius 0.25, centres 0.3 apart
  const std::pair<ShapeSpec, double> cases[] = {
      {scenes::clump("body", {{-0.15, 0, 0, 0.25}, {0.15, 0, 0, 0.25}}), 0.0625 * (2 * pi - 2 * half + 2 * 0.6 * 0.8)},
      {scenes::union_of("body", {{"bar", {}, {}}, {"stub", {-0.2, 0.3, 0}, {}}}), 0.12 + 0.08}};
  for (const auto& [shape, area] : cases) {
    Scene s;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
    s.shapes = {scenes::box("bar", {0.6, 0.2, 0.2}), scenes::box("stub", {0.2, 0.4, 0.2}), shape};
    s.run.steps = 1;
    s.bodies = {scenes::body("body", "soft", {3, 4, 5})};
    render::View view;
    view.width = view.height = 400;
    view.legend = false;
    view.orthographic = Vec3d{0, 0, -1};
    view.box.emplace();
    view.box->add({3, 4, 5}, 0.65);
    const render::Image image = draw(build_world(s), view);
    double covered = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
      covered += image.rgb[i] == 255 && image.rgb[i + 1] == 255 && image.rgb[i + 2] == 255 ? 0 : 1;
    const double side = 1.3 * 1.06 / 400;
    EXPECT_NEAR(covered * side * side / area, 1, 0.015);
  }
}

}  // namespace
}  // namespace dem
