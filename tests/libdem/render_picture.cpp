// Pictures: exact silhouettes, same bytes, something to see.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>

#include "libdem/render/render.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace {

using dem::render::Image;
using dem::render::View;

#define NEEDS_EMBREE \
  if (!dem::render::available()) GTEST_SKIP() << "built without Embree"

std::uint32_t pixel(const Image& image, std::size_t i) {
  return static_cast<std::uint32_t>(image.rgb[3 * i] << 16 | image.rgb[3 * i + 1] << 8 | image.rgb[3 * i + 2]);
}
constexpr std::uint32_t white = 0xffffff;

std::size_t pixel_count(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

TEST(RenderPicture, ShowsColoursAndIsTheSameEveryTime) {
  NEEDS_EMBREE;
  const dem::World world = dem::io_test::small_world();
  View view;
  view.width = 160;
  view.height = 120;
  for (const std::string& by : dem::render::color_names()) {
    view.color_by = by;
    const Image image = draw(world, view);
    std::set<std::uint32_t> colors;
    std::size_t background = 0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) {
      colors.insert(pixel(image, i));
      background += pixel(image, i) == white;
    }
    EXPECT_GT(colors.size(), 500u) << by;
    EXPECT_LT(static_cast<double>(background), 0.95 * static_cast<double>(pixel_count(image))) << by;
    EXPECT_EQ(draw(world, view).rgb, image.rgb) << by;
  }
  view.color_by = "colour";
  EXPECT_THROW(draw(world, view), dem::RunError);
}

// Colours from elsewhere: in order of ids, grey where a body has none; as many as there are bodies.
TEST(RenderPicture, TakesColoursOfOthers) {
  NEEDS_EMBREE;
  const dem::World world = dem::io_test::small_world();
  const std::size_t count = world.particles.count();
  View view;
  view.width = 160;
  view.height = 120;
  view.legend = false;
  const auto of = [&](std::vector<std::string> names, std::vector<double> values) {
    view.colouring = dem::render::Colouring{"bands", std::move(names), std::move(values)};
    return draw(world, view);
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  // Whether every pixel is about as red as it is green and blue: walls are, and what is grey.
  const auto coloured = [](const Image& image) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) {
      const auto [least, most] = std::minmax({image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]});
      n += most - least > 60;
    }
    return n;
  };
  EXPECT_EQ(coloured(of({"a", "b"}, std::vector<double>(count, none))), 0u);
  EXPECT_EQ(coloured(of({}, std::vector<double>(count, none))), 0u);
  EXPECT_GT(coloured(of({"a", "b"}, std::vector<double>(count, 1))), 200u);
  EXPECT_NE(of({"a", "b"}, std::vector<double>(count, 1)).rgb, of({"a", "b"}, std::vector<double>(count, 0)).rgb);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i));
  view.range = dem::render::Range{0, static_cast<double>(count - 1)};
  const Image ordered = of({}, values);
  View by_id = view;
  by_id.colouring.reset();
  by_id.color_by = "id";
  const auto picture = dem::render::picture_of(world, by_id), other = dem::render::picture_of(world, view);
  for (std::size_t i = 1; i < count; ++i) {
    EXPECT_GT(picture.bodies[i].value, picture.bodies[i - 1].value);
    EXPECT_EQ(other.bodies[i].value, static_cast<double>(i));
  }
  EXPECT_GT(coloured(ordered), 200u);
  EXPECT_THROW(of({}, {1.0}), dem::RunError);
}

// Seen along an axis, an ellipsoid covers π times the other two semi-axes; a sphere and a turned box likewise.
TEST(RenderPicture, SilhouettesHaveTheirAreas) {
  NEEDS_EMBREE;
  dem::World world = dem::io_test::small_world();
  world.walls.clear();
  world.contacts = {};
  const double pi = std::numbers::pi;
  struct Case {
    std::uint32_t shape;
    dem::Quatd orientation;
    dem::Vec3d along;
    double area;
  };
  const double h = std::sqrt(0.5);
  const Case cases[] = {{1, {}, {0, 0, -1}, pi * 0.6 * 0.4}, {1, {}, {0, 1, 0}, pi * 0.6 * 0.3},
                        {1, {}, {-1, 0, 0}, pi * 0.4 * 0.3}, {1, {h, 0, 0, h}, {0, 1, 0}, pi * 0.4 * 0.3},
                        {0, {}, {1, 0, 0}, pi * 0.25},       {2, {}, {0, 1, 0}, 1.0 * 0.6}};
  for (const Case& c : cases) {
    world.particles = {};
    dem::io_test::add_body(world, c.shape, 0, 1, {3, 4, 5}, c.orientation);
    View view;
    view.width = view.height = 400;
    view.legend = false;
    view.orthographic = c.along;
    view.box.emplace();
    view.box->add({3, 4, 5}, 0.65);  // 1.3 m across and a margin of 6 %: 400 pixels
    const Image image = draw(world, view);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) covered += pixel(image, i) != white;
    const double side = 1.3 * 1.06 / 400;
    EXPECT_NEAR(static_cast<double>(covered) * side * side, c.area, 0.01 * c.area) << c.area;
  }
}

TEST(RenderPicture, ChangeOfUnitsGivesTheSamePicture) {
  NEEDS_EMBREE;
  dem::World world = dem::io_test::small_world();
  View view;
  view.width = 120;
  view.height = 90;
  view.color_by = "id";
  const Image image = draw(world, view);
  const double unit = 0x1p20;
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    world.particles.size[i] *= unit;
    world.particles.motion[i].position *= unit;
    world.particles.motion[i].bounding_radius *= unit;
  }
  dem::Vec3d corners[4];
  for (std::size_t k = 0; k < 4; ++k) corners[k] = world.walls[1].mesh->vertices[k] * unit;
  const std::uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
  world.walls[1].mesh = std::make_shared<const shapes::Mesh>(shapes::mesh_from_triangles(corners, triangles));
  EXPECT_EQ(draw(world, view).rgb, image.rgb);
}

// Two discs of 1 m between lines at x = -1 and x = 1, floor at y = 0.
dem::World plane_world() {
  dem::Scene s;
  s.dimension = 2;
  s.thickness = 1;
  s.law.name = dem::LawName::spring_dashpot;
  s.run.steps = 1;
  s.materials = {dem::scenes::material("soft", 1e6, 1000, 0.5, 0)};
  s.materials[0].stiffness = 1e6;
  s.shapes = {dem::scenes::sphere("disc", 0.5)};
  s.shapes[0].kind = "disc";
  const dem::Vec3d points[] = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}}, normals[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    s.walls.push_back(dem::scenes::plane("wall", "soft", points[k], normals[k]));
    s.walls.back().kind = "line";
    s.walls.back().name += std::to_string(k);
  }
  for (const double x : {-0.5, 0.5}) s.bodies.push_back(dem::scenes::body("disc", "soft", {x, 0.5, 0}));
  return build_world(s);
}

std::size_t ink_in_columns(const Image& image, int first, int last) {
  std::size_t n = 0;
  for (int j = 0; j < image.height; ++j)
    for (int i = first; i < last; ++i)
      n += pixel(image, static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(i)) != white
               ? 1u
               : 0u;
  return n;
}

TEST(RenderPicture, LinesOfThePlaneShowAsStrips) {
  NEEDS_EMBREE;
  dem::World world = plane_world();
  View view;
  view.width = view.height = 300;
  view.legend = false;
  const Image with = draw(world, view);
  world.walls.clear();
  const Image without = draw(world, view);
  // Strips of 2 % of the box's radius: about 3 pixels wide, 75 (sides) and 300 (floor) long; the discs are the same.
  const double strip = 0.02 * std::sqrt(1 + 0.25 + 0.25) * 300 / (2 * 1.06);
  const std::size_t more = ink_in_columns(with, 0, 300) - ink_in_columns(without, 0, 300);
  EXPECT_GT(static_cast<double>(more), 0.8 * strip * (2 * 140 + 280));
  EXPECT_LT(static_cast<double>(more), 1.5 * strip * (2 * 300 + 300));
  EXPECT_NE(pixel(with, 150 * 300 + 6), white);  // the west wall, half-way up
  EXPECT_EQ(pixel(without, 150 * 300 + 6), white);
}

TEST(RenderPicture, TheLegendStandsBesideTheScene) {
  NEEDS_EMBREE;
  const dem::World world = plane_world();
  View view;
  view.width = 600;
  view.height = 400;
  view.color_by = "id";
  const Image image = draw(world, view);
  // Bars and numbers of "0.5" and ">1" take less than 120 pixels; to their left is a gap, then the scene.
  int first = image.width;
  while (first > 0 && ink_in_columns(image, first - 1, first) > 0) --first;
  EXPECT_EQ(first, image.width);  // the legend keeps an edge
  int gap = image.width - 1;
  while (gap > 0 && ink_in_columns(image, gap - 1, gap) == 0) --gap;  // edge
  while (gap > 0 && ink_in_columns(image, gap - 9, gap) > 0) --gap;   // legend, up to 9 free columns
  EXPECT_GT(gap, 450);
  EXPECT_GT(ink_in_columns(image, 0, gap), 20000u);  // the scene
  view.legend = false;
  EXPECT_GT(ink_in_columns(draw(world, view), gap, image.width), 5000u);  // has all the width without it
}

TEST(RenderPicture, PngFile) {
  const dem::io_test::Folder folder("png");
  const Image image{2, 1, {255, 0, 0, 0, 0, 255}};
  write_png(folder / "two.png", image);
  std::ifstream in(folder / "two.png", std::ios::binary);
  char magic[8] = {};
  in.read(magic, 8);
  EXPECT_EQ(std::string(magic + 1, 3), "PNG");
  EXPECT_THROW(write_png(folder / "none/two.png", image), dem::RunError);
}

}  // namespace
