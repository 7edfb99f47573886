// Voronoi cells: lattices, cells that fill the domain, set-Voronoi cells that go over into plain and radical ones.
#include <gtest/gtest.h>

#include <cmath>

#include "libdem/analysis/quantities.h"
#include "libdem/analysis/single_cell.h"
#include "libdem/analysis/surface_points.h"
#include "libdem/analysis/voronoi.h"
#include "libdem/analysis/write.h"
#include "tests/libdem/analysis_bodies.h"
#include "tests/libdem/analysis_lattices.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/vtk_read.h"

namespace dem::analysis {
namespace {

double sum(const Cells& cells) {
  double v = 0;
  for (const double x : cells.volume) v += x;
  return v;
}

class AnalysisVoronoi : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_voronoi()) GTEST_SKIP() << "built without Voro++";
  }
};

TEST_F(AnalysisVoronoi, LatticesHaveTheirCells) {
  for (const Lattice& l : lattices()) {
    Snapshot s = lattice_of(l, {4, 4, 4}, {0.1, 0.2, 0.3});
    const Cells cells = radical_cells(s, container_of(s));
    const double depth = l.dimension == 2 ? s.thickness : 1;
    for (const double v : cells.volume) EXPECT_NEAR(v / depth, l.voronoi_volume, 1e-9) << l.name;
    const Result r = report_voronoi(s, {});
    EXPECT_NEAR(scalar(r, "solid_fraction"), l.solid_fraction, 1e-9) << l.name;
    EXPECT_NEAR(scalar(r, "mean_local_density"), l.solid_fraction, 1e-9) << l.name;
  }
}

TEST_F(AnalysisVoronoi, CellsFillTheDomain) {
  for (const bool periodic : {true, false})
    for (const double least : {0.02, 0.005}) {  // equal spheres, and all sizes
      const Snapshot s = random_rounds(1500, least, 0.02, periodic, 3, 4);
      const Container c = container_of(s);
      EXPECT_NEAR(sum(radical_cells(s, c)) / c.box.volume, 1, 1e-10);
      EXPECT_NEAR(sum(set_voronoi_cells(s, c, 16)) / c.box.volume, 1, 1e-10);
    }
  const Snapshot flat = scenes::scattered(scenes::shapes_of_the_plane(), 2, 20, 0.2);
  const Container c = container_of(flat);
  const double area = domain_of(flat).volume(flat);
  EXPECT_NEAR(sum(radical_cells(flat, c)) / area, 1, 1e-10);
  EXPECT_NEAR(sum(set_voronoi_cells(flat, c, 40)) / area, 1, 1e-10);
}

TEST_F(AnalysisVoronoi, UnitsChangeNothing) {
  Snapshot s = random_rounds(300, 0.02, 0.05, true, 3, 6);
  const Cells metres = radical_cells(s, container_of(s));
  const double micro = std::ldexp(1.0, -20);
  for (auto* field : {&s.position, &s.size})
    for (Vec3d& x : *field) x *= micro;
  for (auto* field : {&s.radius, &s.bounding_radius})
    for (double& x : *field) x *= micro;
  s.length *= micro;
  const Cells small = radical_cells(s, container_of(s));
  for (std::size_t i = 0; i < s.count(); ++i) EXPECT_EQ(small.volume[i], metres.volume[i] * micro * micro * micro);
}

TEST_F(AnalysisVoronoi, CellsAreThoseOfTheDefinition) {
  for (const bool periodic : {true, false})
    for (const bool radical : {true, false}) {
      const Snapshot s = random_rounds(150, 0.01, 0.08, periodic, 3, 12);
      const Container c = container_of(s);
      const Seeds seeds{s.position, radical ? s.radius : std::vector<double>{}, {}};
      const Cells cells = cells_of(c.box, seeds, s.count(), false);
      for (std::size_t i = 0; i < s.count(); ++i)
        EXPECT_NEAR(cells.volume[i], single_cell_volume(c.box, seeds, {}, i), 1e-12);
    }
}

// In these 30000 points Voro++ 0.4.6 leaves out a cut, by which the sum would be off by 1e-7.
TEST_F(AnalysisVoronoi, CellsThatLackACutAreMended) {
  const Snapshot s = random_rounds(400, 0.07, 0.07, true, 3, 29);
  const Container c = container_of(s);
  const Cells cells = set_voronoi_cells(s, c, 75);
  EXPECT_NEAR(sum(cells) / c.box.volume, 1, 1e-12);
  EXPECT_LT(cells.mended, 100u);
  RecordProperty("mended", static_cast<int>(cells.mended));
}

// Points of a lattice in the box go to the body that is nearest by the definition.
TEST_F(AnalysisVoronoi, RadicalCellsByCounting) {
  const Snapshot s = random_rounds(40, 0.02, 0.12, false, 3, 2);
  const Container c = container_of(s);
  const Cells cells = radical_cells(s, c);
  std::vector<double> count(s.count());
  const int n = 60;
  const Vec3d size = c.box.upper - c.box.lower;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3d x = c.box.lower + scaled(size, Vec3d{(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n});
        std::size_t best = 0;
        double least = 1e300;
        for (std::size_t b = 0; b < s.count(); ++b) {
          const Vec3d d = x - s.position[b];
          const double power = dot(d, d) - s.radius[b] * s.radius[b];
          if (power < least) least = power, best = b;
        }
        count[best] += c.box.volume / (n * n * n);
      }
  for (std::size_t b = 0; b < s.count(); ++b) EXPECT_NEAR(cells.volume[b], count[b], 3e-2 * count[b] + 5e-5);
}

TEST_F(AnalysisVoronoi, SetVoronoiGoesOverIntoPlainCellsOfEqualSpheres) {
  const Snapshot s = [] {
    Snapshot t = lattice_of(lattices()[1], {3, 3, 3}, {0.1, 0.2, 0.3});
    Random random(4, 0, 0);
    for (Vec3d& x : t.position)  // a disordered packing without overlap
      for (int k = 0; k < 3; ++k) x[k] = 1.1 * x[k] + random.uniform(-0.04, 0.04);
    t.length *= 1.1;
    return t;
  }();
  const Container c = container_of(s);
  const Cells plain = radical_cells(s, c);
  double before = 0;
  for (const std::size_t n : {30u, 120u, 480u}) {
    const Cells cells = set_voronoi_cells(s, c, n);
    double squares = 0;
    for (std::size_t i = 0; i < s.count(); ++i) squares += std::pow(cells.volume[i] / plain.volume[i] - 1, 2);
    const double rms = std::sqrt(squares / static_cast<double>(s.count()));
    if (n > 30) {
      EXPECT_LT(rms, before / 2.5);
    }
    before = rms;
  }
  EXPECT_LT(before, 2e-3);
}

// Between two spheres of radii R and r at distance L on the axis of a long box, the set-Voronoi face is where the
// distances to the surfaces are equal; along the axis at (L + R − r)/2 from the first.
TEST_F(AnalysisVoronoi, SetVoronoiOfTwoUnequalSpheres) {
  Snapshot s;
  add_round(s, {0, 0, -2}, 1.5);
  add_round(s, {0, 0, 2}, 0.5);
  const Container c = container_of(s);
  const Cells cells = set_voronoi_cells(s, c, 4000);
  // By counting: distance to a sphere's surface.
  double first = 0;
  const int n = 120;
  const Vec3d size = c.box.upper - c.box.lower;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3d x = c.box.lower + scaled(size, Vec3d{(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n});
        const double d0 = std::fabs(norm(x - s.position[0]) - 1.5), d1 = std::fabs(norm(x - s.position[1]) - 0.5);
        if (d0 < d1) first += c.box.volume / (n * n * n);
      }
  EXPECT_NEAR(cells.volume[0], first, 2e-3 * first);
}

TEST_F(AnalysisVoronoi, SurfacePointsLieOnTheSurfaceOfEveryShape) {
  std::size_t symmetric = 0;
  for (const Snapshot& s : {scenes::scattered(scenes::shapes_of_space(symmetric), 3, 1, 0.1),
                            scenes::scattered(scenes::shapes_of_the_plane(), 2, 1, 0.1)}) {
    const double n = 200;
    const SurfacePoints on(s, 200);
    double mean = 0;
    for (const double r : s.radius) mean += std::pow(r, s.dimension - 1) / static_cast<double>(s.count());
    for (std::size_t i = 0; i < s.count(); ++i) {
      std::vector<Vec3d> points = on.of(i);
      if (!s.shape_of(i).compound && s.shape_of(i).name != "arrow") {  // convex: the centre comes last
        EXPECT_LT(norm(points.back() - s.position[i]), 1e-15);
        points.pop_back();
      }
      // As many as give one spacing on all bodies, within a half power of two; evenly.
      const double power = s.dimension - 1, expected = n * std::pow(s.radius[i], power) / mean;
      EXPECT_NEAR(std::log2(static_cast<double>(points.size()) / expected), 0, 0.3) << s.shape_of(i).name;
      double total = 0, least = 1e300;
      for (const Vec3d& x : points) {
        double nearest = 1e300;
        for (const Vec3d& y : points)
          if (!(x == y)) nearest = std::min(nearest, norm(x - y));
        total += nearest;
        least = std::min(least, nearest);
      }
      if (s.dimension == 3) {  // of the plane the two sides of a tip are near
        EXPECT_GT(least, 0.5 * total / static_cast<double>(points.size())) << s.shape_of(i).name;
      }
      const Mat3d turn = rotation_matrix(s.orientation[i]);
      const bool scaled_shape = s.shape_of(i).kind != shapes::Kind::ellipsoid && !is_round(s.shape_of(i).kind) &&
                                s.shape_of(i).kind != shapes::Kind::ellipse;
      for (const Vec3d& x : points) {
        Vec3d body = transposed_times(turn, x - s.position[i]);
        if (scaled_shape) body = body * (1 / s.size[i].x);
        // A step to the inside along some direction is in the body, the same to the outside is not: along the radius of
        // shapes that are seen from their centre.
        const bool star = !s.shape_of(i).compound && s.shape_of(i).name != "arrow";
        if (!star) continue;
        const Vec3d& about = s.shape_of(i).potential ? s.shape_of(i).potential->centre : Vec3d{};
        EXPECT_TRUE(scenes::holds(s, i, about + (1 - 1e-9) * (body - about))) << s.shape_of(i).name;
        EXPECT_FALSE(scenes::holds(s, i, about + (1 + 1e-9) * (body - about))) << s.shape_of(i).name;
      }
    }
  }
}

TEST_F(AnalysisVoronoi, CellsEndAtSlantedWallsAndInContainers) {
  Snapshot s = random_rounds(200, 0.02, 0.02, false, 3, 8);
  SnapshotWall w;
  w.name = "slope";
  w.kind = shapes::Kind::plane;
  w.orientation = scenes::turn({1, 0, 0}, -0.5);
  w.position = {0, 0, -0.8};
  s.walls = {w};
  // Cut so that a corner of the domain is lost.
  for (Vec3d& x : s.position) {
    const double h = dot(w.normal(), x - w.position);
    if (h < 0.02) x += (0.04 - 2 * h) * w.normal();
  }
  const Container c = container_of(s);
  ASSERT_EQ(c.box.planes.size(), 1u);
  const Vec3d d = c.box.upper - c.box.lower;
  EXPECT_LE(c.box.volume, d.x * d.y * d.z);
  EXPECT_NEAR(sum(radical_cells(s, c)) / c.box.volume, 1, 1e-10);
  EXPECT_NEAR(sum(set_voronoi_cells(s, c, 20)) / c.box.volume, 1, 1e-10);
}

TEST_F(AnalysisVoronoi, FacesOfCellsEncloseThem) {
  const Snapshot s = random_rounds(60, 0.02, 0.05, false, 3, 9);
  const Container c = container_of(s);
  for (const bool by_surface : {false, true}) {
    const Cells cells = by_surface ? set_voronoi_cells(s, c, 24, true) : radical_cells(s, c, true);
    std::vector<double> volume(s.count());
    std::int32_t first = 0;
    for (std::size_t f = 0; f < cells.surface.ends.size(); ++f) {
      const std::int32_t end = cells.surface.ends[f];
      const auto corner = [&](std::int32_t k) {
        return cells.surface.points[static_cast<std::size_t>(cells.surface.corners[static_cast<std::size_t>(k)])];
      };
      for (std::int32_t k = first + 1; k + 1 < end; ++k)
        volume[static_cast<std::size_t>(cells.surface.columns[0].values[f])] +=
            dot(corner(first), cross(corner(k), corner(k + 1))) / 6;
      first = end;
    }
    for (std::size_t i = 0; i < s.count(); ++i) EXPECT_NEAR(volume[i] / cells.volume[i], 1, 1e-9);
  }
}

TEST_F(AnalysisVoronoi, FacesAreReadByVtk) {
  const Snapshot s = lattice_of(lattices()[0], {2, 2, 2}, {0.5, 0.5, 0.5});
  const io_test::Folder folder("voronoi_faces");
  const Quantity* voronoi = find_quantity("voronoi");
  Writer writer(folder.path(), "a lattice", {voronoi}, true);
  writer.begin_frame(0, s);
  writer.add(*voronoi, voronoi->of(s, {}));
  int code = 0;
  const nlohmann::json file = io_test::read_with_vtk(folder / "voronoi_cells.vtp", code);
  if (code == io_test::no_vtk) GTEST_SKIP() << "VTK for Python is not installed";
  ASSERT_EQ(code, 0);
  EXPECT_EQ(file["polys"], 8 * 6);
  for (const auto& size : file["cell_sizes"]) EXPECT_EQ(size, 4);
  for (const auto& volume : file["cell_data"]["cell_volume"]) EXPECT_NEAR(volume[0].get<double>(), 1, 1e-12);
  for (const char* name : {"particle", "local_density"}) EXPECT_EQ(file["cell_data"][name].size(), 48u);
}

TEST_F(AnalysisVoronoi, ReportOfEveryShape) {
  std::size_t symmetric = 0;
  const Snapshot s = scenes::scattered(scenes::shapes_of_space(symmetric), 3, 3, 0.15, 7);
  Settings settings;
  settings.voronoi_points = 64;
  const Result r = report_set_voronoi(s, settings);
  EXPECT_NEAR(scalar(r, "sum_of_cells_over_domain"), 1, 1e-10);
  EXPECT_EQ(scalar(r, "surface_points"), 64);
  EXPECT_GT(scalar(r, "relative_error"), 0);
  EXPECT_LT(scalar(r, "relative_error"), 0.1);
  EXPECT_GT(scalar(r, "radical_difference"), scalar(r, "relative_error"));  // needles and bricks
  ASSERT_EQ(r.surfaces.size(), 1u);
  for (const Table& t : r.tables)
    for (const Column& c : t.columns) EXPECT_EQ(c.values.size(), t.columns[0].values.size()) << t.name << c.name;
  double bodies = 0;
  for (const double n : r.tables[0].columns[1].values) bodies += n;
  EXPECT_GT(bodies, 0.9 * static_cast<double>(s.count()));
}

TEST_F(AnalysisVoronoi, NothingAndOneBody) {
  EXPECT_EQ(report_voronoi(Snapshot{}, {}).notes, std::vector<std::string>{"no bodies"});
  EXPECT_EQ(report_set_voronoi(Snapshot{}, {}).notes, std::vector<std::string>{"no bodies"});
  Snapshot s;
  add_round(s, {1, 2, 3}, 0.5);
  EXPECT_NEAR(scalar(report_voronoi(s, {}), "mean_cell_volume"), 1, 1e-12);
  EXPECT_NEAR(scalar(report_set_voronoi(s, {}), "mean_cell_volume"), 1, 1e-10);
  add_round(s, {1, 2, 3}, 0.5);  // at the same place
  const Result r = report_voronoi(s, {});
  EXPECT_EQ(scalar(r, "bodies"), 1);
  EXPECT_NEAR(scalar(r, "sum_of_cells_over_domain"), 1, 1e-12);
}

}  // namespace
}  // namespace dem::analysis
