// Polygons that are not convex, in files and pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "libdem/io/io.h"
#include "libdem/render/render.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

// Two feet of 3 × 5 under a bridge of 12 × 3: 66 mm², and the notch between the feet is 30 mm².
World arch() {
  Scene s = scenes::plane_scene();
  const double mm = 0.001;
  std::vector<Vec3d> corners{{0, 0, 0}, {3, 0, 0}, {3, 5, 0}, {9, 5, 0}, {9, 0, 0}, {12, 0, 0}, {12, 8, 0}, {0, 8, 0}};
  for (Vec3d& v : corners) v *= mm;
  s.shapes = {scenes::polygon("arch", corners)};
  s.bodies = {scenes::body("arch", "soft", {0.5, 0.25, 0}, {}, {}, scenes::turn({0, 0, 1}, 0.4))};
  return build_world(s);
}

TEST(PolygonFiles, TheFrameHoldsTheOutlineAsOneCell) {
  const World world = arch();
  const io_test::Folder folder("arch");
  io::VtkSeries(folder.path()).write(world);
  std::ifstream in(folder / "frames/polyhedra_000000.vtp", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("NumberOfPoints=\"8\""), std::string::npos);
  EXPECT_NE(text.find("NumberOfPolys=\"1\""), std::string::npos);
}

TEST(PolygonFiles, ThePictureShowsTheNotch) {
  if (!render::available()) GTEST_SKIP() << "built without Embree";
  const World world = arch();
  render::View view;
  view.width = view.height = 400;
  view.legend = false;
  view.orthographic = {0, 0, -1};
  view.box.emplace();
  view.box->add({0.5, 0.25, 0}, 0.009);  // 18 mm across and a margin of 6 %: 400 pixels
  const render::Image image = draw(world, view);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < 400 * 400; ++i)
    covered += image.rgb[3 * i] != 255 || image.rgb[3 * i + 1] != 255 || image.rgb[3 * i + 2] != 255 ? 1 : 0;
  const double side = 0.018 * 1.06 / 400, area = 66e-6;
  EXPECT_NEAR(static_cast<double>(covered) * side * side, area, 0.02 * area);  // half a pixel along the rim
}

}  // namespace
}  // namespace dem
