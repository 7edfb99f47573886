// Packing density in boxes: lattices, envelopes over box sizes, and what the bodies in a box do.
#include <gtest/gtest.h>

#include "libdem/analysis/density.h"
#include "tests/libdem/analysis_bodies.h"
#include "tests/libdem/analysis_lattices.h"
#include "tests/libdem/analysis_result.h"

namespace dem::analysis {
namespace {

Domain cell_of(const Snapshot& s) { return {s.lower, s.lower + s.length}; }

TEST(AnalysisDensity, BoxesOfWholeUnitCellsHaveTheDensityOfTheLattice) {
  for (const Lattice& l : lattices())
    for (const Vec3d& offset : {Vec3d{}, Vec3d{0.25, 0.31, 0.17}, Vec3d{0.5, 0.5, 0.5}}) {
      const Snapshot s = lattice_of(l, {4, 4, 4}, offset);
      const BoxShares shares(s);
      for (const int boxes : {1, 2, 4}) {
        const Grid grid(s, cell_of(s), {boxes, boxes, boxes});
        for (const double d : solid_fractions(shares, grid)) EXPECT_NEAR(d, l.solid_fraction, 1e-12) << l.name;
      }
    }
}

TEST(AnalysisDensity, EnvelopeShrinksToTheWholeRegion) {
  const Snapshot s = random_rounds(2000, 0.02, 0.03, true);
  const BoxShares shares(s);
  const auto points = density_envelope(s, shares, cell_of(s));
  ASSERT_GT(points.size(), 4u);
  double volume = 0;
  for (const double v : s.volume) volume += v;
  for (const EnvelopePoint& p : points) {
    EXPECT_NEAR(p.mean, volume, 1e-12);  // whatever the boxes
    EXPECT_LE(p.least, p.mean + 1e-12);
    EXPECT_GE(p.greatest, p.mean - 1e-12);
  }
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    EXPECT_LT(points[k - 1].edge, points[k].edge);
    EXPECT_GT(points[k - 1].deviation, points[k].deviation);
    EXPECT_NEAR(points[k].error, points[k].deviation / std::sqrt(points[k].boxes), 1e-15);
  }
  EXPECT_EQ(points.back().boxes, 1u);
  EXPECT_EQ(points.back().deviation, 0);
}

TEST(AnalysisDensity, DeviationIsThatOfTheValues) {
  const Grid grid(Snapshot{}, {{0, 0, 0}, {2, 2, 1}}, {2, 2, 1});
  const EnvelopePoint p = envelope_point({1, 2, 3, 6}, grid);
  EXPECT_NEAR(p.mean, 3, 1e-15);
  EXPECT_NEAR(p.deviation, std::sqrt((4.0 + 1 + 0 + 9) / 3), 1e-15);
  EXPECT_NEAR(p.error, p.deviation / 2, 1e-15);
  EXPECT_EQ(p.least, 1);
  EXPECT_EQ(p.greatest, 6);
  EXPECT_NEAR(p.edge, 1, 1e-15);
}

TEST(AnalysisDensity, MeansOfTheBodiesInABox) {
  Snapshot s;
  for (const double x : {0.25, 0.3, 1.5}) add_round(s, {x, 0.5, 0.5}, 0.1);
  s.rotation = {{1, 0, 0}, {3, 0, 6}, {0, 5, 0}};
  s.spin = {{0, 0, 1}, {0, 0, 2}, {7, 0, 0}};
  s.velocity = {{1, 0, 0}, {4, 0, 0}, {0, 0, -2}};
  SnapshotContact c;
  c.a = 0, c.b = 1;
  c.normal = {1, 0, 0};
  s.contacts = {c, c};  // in two places: one contact
  const BoxShares shares(s);
  const Grid grid(s, {{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
  const BoxFields f = box_fields(s, shares, grid);
  EXPECT_EQ(f.bodies, (std::vector<double>{2, 1, 0}));
  EXPECT_EQ(f.rotation[0], (Vec3d{2, 0, 3}));
  EXPECT_EQ(f.rotation[1], (Vec3d{0, 5, 0}));
  EXPECT_EQ(f.spin[0], (Vec3d{0, 0, 1.5}));
  EXPECT_EQ(f.velocity[0], (Vec3d{2.5, 0, 0}));
  EXPECT_NEAR(f.granular_temperature[0], (1.5 * 1.5 + 1.5 * 1.5) / 2 / 3, 1e-15);
  EXPECT_EQ(f.coordination, (std::vector<double>{1, 0, 0}));
  EXPECT_NEAR(f.flux[0].x, s.volume[0] * 5, 1e-15);
  EXPECT_NEAR(f.flux[1].z, s.volume[2] * -2, 1e-15);
  EXPECT_EQ(f.rotation[2], Vec3d{});
}

TEST(AnalysisDensity, FluxTakesTheShareOfACutBody) {
  Snapshot s;
  add_round(s, {1, 0.5, 0.5}, 0.2);
  s.velocity[0] = {0, 3, 0};
  const Grid grid(s, {{0, 0, 0}, {2, 1, 1}}, {2, 1, 1});
  const BoxFields f = box_fields(s, BoxShares(s), grid);
  for (const int b : {0, 1}) EXPECT_NEAR(f.flux[static_cast<std::size_t>(b)].y, 1.5 * s.volume[0], 1e-15);
}

TEST(AnalysisDensity, ReportOfEveryShape) {
  std::size_t symmetric = 0;
  Snapshot s = scenes::scattered(scenes::shapes_of_space(symmetric), 3, 5, 0.1);
  Settings settings;
  settings.region = Domain{{-0.02, -0.02, -0.02}, {0.12, 0.12, 0.12}};
  settings.boxes = {5, 4, 3};
  const Result r = report_density(s, settings);
  double volume = 0;
  for (const double v : s.volume) volume += v;
  EXPECT_NEAR(scalar(r, "solid_volume") / volume, 1, 1e-10);
  EXPECT_NEAR(scalar(r, "solid_fraction") * std::pow(0.14, 3) / volume, 1, 1e-10);
  for (const Table& t : r.tables)
    for (const Column& c : t.columns) {
      EXPECT_EQ(c.values.size(), t.columns[0].values.size()) << c.name;
      for (const double v : c.values) EXPECT_TRUE(std::isfinite(v)) << c.name;
    }
  ASSERT_EQ(r.tables[0].columns[0].values.size(), 60u);
}

TEST(AnalysisDensity, ThePlaneHasFractionsOfArea) {
  const Snapshot s = scenes::scattered(scenes::shapes_of_the_plane(), 2, 10, 0.1);
  Settings settings;
  settings.region = Domain{{-0.05, -0.05, 0}, {0.15, 0.15, 0}};
  const Result r = report_density(s, settings);
  double area = 0;
  for (const double v : s.volume) area += v / s.thickness;
  EXPECT_NEAR(scalar(r, "solid_fraction"), area / 0.04, 1e-11);
}

TEST(AnalysisDensity, NothingAndOneBodyAreAnsweredHonestly) {
  const Result none = report_density(Snapshot{}, Settings{});
  EXPECT_TRUE(none.scalars.empty());
  EXPECT_EQ(none.notes, std::vector<std::string>{"no bodies"});
  Snapshot s;
  add_round(s, {1, 2, 3}, 0.5);
  const Result one = report_density(s, Settings{});
  EXPECT_NEAR(scalar(one, "solid_fraction"), std::numbers::pi / 6, 1e-14);
  Settings flat;
  flat.region = Domain{{0, 0, 0}, {1, 0, 1}};
  EXPECT_EQ(report_density(s, flat).notes, std::vector<std::string>{"the region has no volume"});
}

}  // namespace
}  // namespace dem::analysis
