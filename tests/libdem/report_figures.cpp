// Figures of whole analyses: which there are, that gnuplot takes every script, and what maps show.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "libdem/analysis/in_run.h"
#include "libdem/analysis/write.h"
#include "libdem/io/programs.h"
#include "libdem/report/figures.h"
#include "tests/libdem/analysis_sets.h"
#include "tests/libdem/io_world.h"

namespace {

using namespace dem;
using namespace dem::analysis;
using io_test::Folder;
using report::Figure;

// Spheres (discs) thrown into a box between walls, sheared a little from frame to frame.
Snapshot sheared(int dimension, int frame) {
  Snapshot s = sets::thrown(dimension == 2 ? 150 : 400, false, 3, dimension);
  s.gravity = dimension == 2 ? Vec3d{0, -9.81, 0} : Vec3d{0, 0, -9.81};
  s.step = 100 * static_cast<std::uint64_t>(frame);
  s.time = 0.1 * frame;
  s.walls.resize(1);
  s.walls[0].name = "left side";
  s.walls[0].kind = dimension == 2 ? shapes::Kind::line : shapes::Kind::plane;
  const double h = std::sqrt(0.5);
  s.walls[0].orientation = dimension == 2 ? Quatd{h, 0, 0, -h} : Quatd{h, 0, h, 0};  // normal along x
  for (std::size_t i = 0; i < s.count(); ++i) {
    const double up = dimension == 2 ? s.position[i].y : s.position[i].z;
    s.velocity[i] = {up, 0.1 * s.position[i].x, 0};
    s.position[i].x += 0.1 * up * frame;
    if (i % 9 == 0) sets::touch_wall(s, i, 0, {-1, 0, 0}, 2 - up);
  }
  return s;
}

report::Listing analysed(const Folder& folder, int dimension) {
  std::vector<const analysis::Quantity*> what;
  for (const analysis::Quantity& q : quantities())
    if (!q.costly) what.push_back(&q);
  Writer writer(folder.path(), "in a test", what, false);
  const Snapshot first = sheared(dimension, 0);
  Snapshot before;
  analysis::Settings settings;
  settings.reference = &first;
  settings.split = "layers";
  for (int frame = 0; frame < 3; ++frame) {
    const Snapshot now = sheared(dimension, frame);
    writer.begin_frame(static_cast<std::size_t>(frame), now);
    for (const analysis::Quantity* q : what) writer.add(*q, result_of(*q, now, settings));
    before = now;
    settings.before = &before;
  }
  writer.finish();
  return report::read_listing(folder.path());
}

std::set<std::string> names_of(const std::vector<Figure>& figures) {
  std::set<std::string> names;
  for (const Figure& f : figures) names.insert(f.name);
  return names;
}

const Figure& figure(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& f : figures)
    if (f.name == name) return f;
  ADD_FAILURE() << "no figure " << name;
  return figures.at(0);
}

class ReportFigures : public ::testing::TestWithParam<int> {};

TEST_P(ReportFigures, OfAWholeAnalysis) {
  const int dimension = GetParam();
  const Folder folder("report_figures");
  const report::Listing listing = analysed(folder, dimension);
  std::ofstream(folder / "discharge.csv") << "time,count,mass,outlet\n0.1,1,0.5,slot\n0.2,2,0.9,slot\n";
  const std::vector<Figure> figures = report::figures_of(listing, {"..", "..", folder.path()});
  const std::set<std::string> names = names_of(figures);
  EXPECT_EQ(names.size(), figures.size());  // each name once
  for (const char* name : {"series_energy_translational", "rdf", "density_envelope", "density_map_solid_fraction",
                           "coordination_distribution", "forces_network", "forces_normal", "rose_xy",
                           "series_fabric_fabric_deviator", "series_stress_stress_xx", "stress_map_pressure",
                           "series_walls_left_side_normal_force", "walls_height", "discharge", "density_map_speed",
                           "series_mixing_lacey", "displacement_map_shear_strain", "repose_surface", "voronoi_map"})
    EXPECT_TRUE(names.count(name)) << name;
  EXPECT_EQ(names.count("rose_sphere"), dimension == 3 ? 1u : 0u);
  EXPECT_FALSE(names.count("series_flow_discharge_rate"));  // nothing leaves: zero throughout
  EXPECT_FALSE(names.count("series_velocity_bodies"));      // nor changes
  for (const Figure& f : figures) EXPECT_FALSE(f.group.empty()) << f.name;
  if (!io::installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  std::vector<std::string> notes;
  const std::vector<Figure> drawn = report::draw_figures(figures, folder / "figures", notes);
  for (const std::string& n : notes) ADD_FAILURE() << n;
  EXPECT_EQ(drawn.size(), figures.size());
  for (const Figure& f : drawn) EXPECT_NE(f.svg.find("<svg"), std::string::npos) << f.name;
  // A map is as many filled boxes as the layer has boxes with bodies, and its key.
  const std::string& map = figure(drawn, "density_map_solid_fraction").svg;
  EXPECT_NE(map.find("solid fraction"), std::string::npos);
  EXPECT_NE(map.find("<polygon"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ReportFigures, ::testing::Values(2, 3));

TEST(ReportMaps, OfSpaceShowOneLayer) {
  const Folder folder("report_layer");
  const report::Listing listing = analysed(folder, 3);
  const std::vector<Figure> figures = report::figures_of(listing, {"..", "", ""});
  const Figure& map = figure(figures, "stress_map_pressure");
  EXPECT_NE(map.title.find(", layer at y = "), std::string::npos) << map.title;
  EXPECT_NE(map.script.find("set xlabel 'x (m)'"), std::string::npos);
  EXPECT_NE(map.script.find("set ylabel 'z (m)'"), std::string::npos);
  EXPECT_FALSE(names_of(figures).count("discharge"));  // no run
}

}  // namespace
