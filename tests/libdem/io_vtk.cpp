// VTK frames: written here, read by VTK's own reader.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "libdem/io/io.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/vtk_read.h"

namespace {

using dem::io_test::Folder;
using dem::io_test::no_vtk;
using dem::io_test::read_with_vtk;
using Json = nlohmann::json;

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(IoVtk, ReadByVtk) {
  const dem::World world = dem::io_test::small_world();
  const Folder folder("vtk_read");
  dem::io::VtkSeries(folder.path()).write(world);

  int code = 0;
  const Json rounds = read_with_vtk(folder / "frames/spheres_000120.vtp", code);
  if (code == no_vtk) GTEST_SKIP() << "VTK for Python is not installed";
  ASSERT_EQ(code, 0);
  ASSERT_EQ(rounds["points"].size(), 4u);
  EXPECT_EQ(rounds["verts"], 4);
  for (const char* name : {"id", "shape", "material", "radius", "velocity", "spin", "quaternion", "tensor"})
    EXPECT_TRUE(rounds["point_data"].contains(name)) << name;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& motion = world.particles.motion[i];
    EXPECT_EQ(rounds["point_data"]["id"][i][0], i);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(rounds["points"][i][static_cast<std::size_t>(k)].get<double>(), motion.position[k]);
      EXPECT_EQ(rounds["point_data"]["velocity"][i][static_cast<std::size_t>(k)].get<float>(),
                static_cast<float>(motion.velocity[k]));
    }
    // The tensor maps each body axis, turned into the world, to its semi-axis times itself.
    const auto& tensor = rounds["point_data"]["tensor"][i];
    const dem::Mat3d r = rotation_matrix(world.particles.orientation[i]);
    for (int axis = 0; axis < 3; ++axis)
      for (int row = 0; row < 3; ++row) {
        double image = 0;
        for (int k = 0; k < 3; ++k)
          image += tensor[static_cast<std::size_t>(3 * row + k)].get<double>() * r.column(axis)[k];
        EXPECT_NEAR(image, world.particles.size[i][axis] * r.column(axis)[row], 1e-15);
      }
  }

  const Json polyhedra = read_with_vtk(folder / "frames/polyhedra_000120.vtp", code);
  ASSERT_EQ(code, 0);
  EXPECT_EQ(polyhedra["points"].size(), 8u + 12u);
  EXPECT_EQ(polyhedra["polys"], 6 + 8);
  int hexagons = 0;
  for (const auto& size : polyhedra["cell_sizes"]) hexagons += size == 6;
  EXPECT_EQ(hexagons, 2);
  for (const char* name : {"particle", "shape", "material", "speed"})
    EXPECT_TRUE(polyhedra["cell_data"].contains(name));
  EXPECT_EQ(polyhedra["cell_data"]["particle"][0][0], 4);
  EXPECT_EQ(polyhedra["cell_data"]["particle"][13][0], 5);

  const Json contacts = read_with_vtk(folder / "frames/contacts_000120.vtp", code);
  ASSERT_EQ(code, 0);
  EXPECT_EQ(contacts["lines"], 2);
  EXPECT_EQ(contacts["cell_data"]["force"][0][0], -12);
  EXPECT_EQ(contacts["cell_data"]["b"][1][0], -1);

  const Json walls = read_with_vtk(folder / "frames/walls_000120.vtp", code);
  ASSERT_EQ(code, 0);
  EXPECT_EQ(walls["polys"], 1 + 2);
}

TEST(IoVtk, EmptyPiecesAreLeftOut) {
  dem::World world = dem::io_test::small_world();
  world.walls.clear();
  world.contacts = {};
  const Folder folder("vtk_empty");
  dem::io::VtkSeries(folder.path()).write(world);
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/spheres_000120.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/walls_000120.vtp"));
  EXPECT_EQ(text_of(folder / "frames.pvd").find("walls"), std::string::npos);
}

TEST(IoVtk, SeriesGoesOnAndIsTruncated) {
  dem::World world = dem::io_test::small_world();
  const Folder folder("vtk_series");
  for (const std::uint64_t step : {0, 100, 200}) {
    world.step = step;
    dem::io::VtkSeries(folder.path()).write(world);  // a new object each time, as after a resume
  }
  const std::string all = text_of(folder / "frames.pvd");
  EXPECT_NE(all.find("timestep=\"0.02"), std::string::npos);
  EXPECT_NE(all.find("spheres_000000.vtp"), std::string::npos);

  dem::io::VtkSeries(folder.path()).truncate_after(100);
  const std::string fewer = text_of(folder / "frames.pvd");
  EXPECT_EQ(fewer.find("_000200.vtp"), std::string::npos);
  EXPECT_NE(fewer.find("_000100.vtp"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/spheres_000200.vtp"));
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/polyhedra_000100.vtp"));

  dem::io::VtkSeries(folder.path()).write(world);  // step 200 again
  EXPECT_EQ(text_of(folder / "frames.pvd"), all);
}

}  // namespace
