// The 120 shipped grains in both resolutions.
#include <filesystem>

#include "shapes/geometry.h"
#include "shapes/surface_file.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Frame;

class Grains : public testing::TestWithParam<const char*> {};

TEST_P(Grains, load_are_closed_and_have_unit_equivalent_diameter) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PROJECT_ROOT) + "/shapes/data/" + GetParam())) {
    SCOPED_TRACE(entry.path().filename().string());
    const Polyhedron p = shapes::polyhedron_from_file(entry.path().string(), Frame::principal);
    expect_canonical(p);
    const shapes::Surface file = shapes::read_surface(entry.path().string());
    EXPECT_LE(p.vertices.size(), file.vertices.size());
    EXPECT_GE(p.vertices.size() + 1, file.vertices.size());  // rounding to 5 decimals may sink a vertex into a face

    // Corners are off by up to √3/2 units of the fifth decimal, the volume by that times the area A; d = (6V/π)^(1/3).
    double area = 0;
    for (const auto& f : p.faces)
      for (std::uint32_t i = 1; i + 1 < f.count; ++i) {
        const auto corner = [&](std::uint32_t k) { return p.vertices[p.face_vertices[f.first + k]]; };
        area += 0.5 * norm(cross(corner(i) - corner(0), corner(i + 1) - corner(0)));
      }
    const double diameter = 2 * shapes::equivalent_radius(p.mass.volume);
    EXPECT_NEAR(diameter, 1, 0.87e-5 * area / (3 * p.mass.volume));
    EXPECT_LE(max_abs(p.frame.position), 2e-5);  // centred on the centre of mass, to the same decimals

    const auto again = shapes::polyhedron_from_points(p.vertices, Frame::as_given).mass;
    EXPECT_LE(max_abs(again.centre), 2 * eps * p.circumradius);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (i != j) {
          EXPECT_LE(std::fabs(again.inertia.row[i][j]), 1e-14 * again.inertia.row[2].z);
        }
    EXPECT_NEAR(p.mass.volume / again.volume, 1, 8 * eps);
    ++count;
  }
  EXPECT_EQ(count, 120);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Grains, testing::Values("ct_hull_coarse", "ct_hull_fine"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace shape_tests
