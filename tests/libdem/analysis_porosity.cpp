// Porosity over the distance from planes and from the sides of containers, in exact slabs.
#include <gtest/gtest.h>

#include "libdem/analysis/porosity.h"
#include "libdem/analysis/wall_planes.h"
#include "tests/libdem/analysis_bodies.h"
#include "tests/libdem/analysis_lattices.h"

namespace dem::analysis {
namespace {

using shapes::HalfSpace;

TEST(AnalysisPorosity, LayersOfACubicLattice) {
  const Lattice l = lattices()[0];
  const Snapshot s = lattice_of(l, {3, 3, 3}, {0.5, 0.5, 0.5});
  const BoxShares shares(s);
  const std::vector<HalfSpace> floor{{{0, 0, -1}, 0}};
  const PorosityProfile p = porosity_from(s, shares, {{0, 0, 0}, {3, 3, 3}}, floor, 0.1, 30);
  const auto cap = [](double h) { return std::numbers::pi * h * h * (1.5 - h) / 3; };  // of a ball of diameter 1
  for (std::size_t k = 0; k < 30; ++k) {
    const double from = 0.1 * static_cast<double>(k % 10);
    EXPECT_NEAR(p.porosity[k], 1 - (cap(from + 0.1) - cap(from)) / 0.1, 1e-12);
    EXPECT_NEAR(p.volume[k], 0.9, 1e-14);
  }
}

TEST(AnalysisPorosity, SlabsHoldAllOfTheBodies) {
  std::size_t symmetric = 0;
  const Snapshot space = scenes::scattered(scenes::shapes_of_space(symmetric), 3, 4, 0.1, 3);
  const Snapshot flat = scenes::scattered(scenes::shapes_of_the_plane(), 2, 10, 0.1, 3);
  for (const Snapshot* s : {&space, &flat}) {
    const bool planar = s->dimension == 2;
    const BoxShares shares(*s);
    const Domain region{{-0.02, -0.02, planar ? 0 : -0.02}, {0.12, 0.12, planar ? 0 : 0.12}};
    // Planes of a corner and a slanted one.
    const Vec3d slant = normalized(Vec3d{1, 2, planar ? 0 : -1.5});
    const std::vector<HalfSpace> one{{slant, 0.5}}, several{{{-1, 0, 0}, 0.02}, {{0, 1, 0}, 0.12}, {slant, 0.18}};
    double volume = 0;
    for (const double v : s->volume) volume += v;
    for (const auto& planes : {one, several}) {
      const PorosityProfile p = porosity_from(*s, shares, region, planes, 0.004, 250);
      double solid = 0, room = 0;
      for (std::size_t k = 0; k < p.volume.size(); ++k) {
        EXPECT_LE(p.porosity[k], 1 + 1e-12);
        solid += (1 - p.porosity[k]) * p.volume[k];
        room += p.volume[k];
      }
      EXPECT_NEAR(room, Grid(*s, region, {1, 1, 1}).box_volume(), 1e-12 * room);
      EXPECT_NEAR(solid / volume, 1, 1e-10);
    }
  }
}

TEST(AnalysisPorosity, ImagesCountOnceAcrossPeriodicFaces) {
  Snapshot s = random_rounds(200, 0.03, 0.06, true);
  const BoxShares shares(s);
  double volume = 0;
  for (const double v : s.volume) volume += v;
  const std::vector<HalfSpace> face{{{0, -1, 0}, 0}};
  const PorosityProfile p = porosity_from(s, shares, {{0, 0, 0}, {1, 1, 1}}, face, 0.05, 20);
  double solid = 0;
  for (std::size_t k = 0; k < 20; ++k) solid += (1 - p.porosity[k]) * p.volume[k];
  EXPECT_NEAR(solid, volume, 1e-12);
}

// A cylinder of 24 facets with bottom and lid about spheres that stand at its side and on its axis.
Snapshot in_a_cylinder() {
  Scene scene;
  scene.run.steps = 1;
  scene.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  scene.shapes = {scenes::sphere("ball", 0.01)};
  WallSpec w;
  w.name = "tube";
  w.kind = "cylinder";
  w.material = "soft";
  w.base = {0, 0, 0};
  w.top = {0, 0, 0.04};
  w.radius = 0.05;
  w.segments = 24;
  scene.walls = {w};
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi / 12 * (2 * k + 1), apothem = 0.05 * std::cos(std::numbers::pi / 24);
    scene.bodies.push_back(scenes::body(
        "ball", "soft", {(apothem - 0.0101) * std::cos(angle), (apothem - 0.0101) * std::sin(angle), 0.02}));
  }
  scene.bodies.push_back(scenes::body("ball", "soft", {0, 0, 0.02}));
  return snapshot_of(build_world(scene));
}

TEST(AnalysisPorosity, ShellsFromTheSideOfACylinder) {
  const Snapshot s = in_a_cylinder();
  ASSERT_EQ(s.walls.size(), 1u);
  const std::vector<HalfSpace> planes = side_of(planes_of(s.walls[0], s));
  ASSERT_EQ(planes.size(), 24u);  // bottom and lid are not its side
  const BoxShares shares(s);
  const Domain region{{-0.06, -0.06, 0}, {0.06, 0.06, 0.04}};
  const double apothem = 0.05 * std::cos(std::numbers::pi / 24), width = apothem / 40;
  const PorosityProfile p = porosity_from(s, shares, region, planes, width, 40);
  double solid = 0;
  const double area = 24 * std::tan(std::numbers::pi / 24);  // of the polygon of apothem 1
  for (std::size_t k = 0; k < 40; ++k) {
    const double outer = 1 - static_cast<double>(k) / 40, inner = 1 - static_cast<double>(k + 1) / 40;
    EXPECT_NEAR(p.volume[k], 0.04 * area * apothem * apothem * (outer * outer - inner * inner), 1e-15);
    solid += (1 - p.porosity[k]) * p.volume[k];
  }
  EXPECT_NEAR(solid / (13 * s.volume[0]), 1, 1e-11);
  EXPECT_LT(p.porosity[8], 0.75);         // through the middle of the outer ring
  EXPECT_NEAR(p.porosity[25], 1, 1e-12);  // between it and the ball on the axis
}

TEST(AnalysisPorosity, ReportAndWhatItCannot) {
  EXPECT_EQ(report_porosity(Snapshot{}, {}).notes, std::vector<std::string>{"no bodies"});
  const Snapshot s = in_a_cylinder();
  const Result r = report_porosity(s, {});
  ASSERT_EQ(r.tables.size(), 4u);
  EXPECT_EQ(r.tables[3].name, "wall_tube");
  EXPECT_NEAR(r.scalars[0].value, 1 - 13 * s.volume[0] / (domain_of(s).volume(s)), 1e-11);
  Snapshot both = s;  // a plane between the bodies is not a wall of a bed
  both.walls[0].kind = shapes::Kind::plane;
  both.walls[0].orientation = scenes::turn({0, 1, 0}, 1.5);
  EXPECT_EQ(report_porosity(both, {}).notes.size(), 1u);
}

}  // namespace
}  // namespace dem::analysis
