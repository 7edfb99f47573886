// Grids of boxes: every point in one box, images along periodic axes, the boxes that a body reaches.
#include <gtest/gtest.h>

#include "libdem/analysis/grid.h"
#include "libdem/random.h"
#include "libdem/scene/where.h"

namespace dem::analysis {
namespace {

bool holds(const Grid::Box& b, const Vec3d& x) {
  for (int k = 0; k < 3; ++k)
    if (x[k] < b.lower[k] || x[k] > b.upper[k]) return false;
  return true;
}

TEST(AnalysisGrid, EveryPointIsInTheBoxThatHoldsIt) {
  const Snapshot s;
  const Grid grid(s, {{-0.1, 0.3, 1}, {0.6, 0.7, 1.9}}, {7, 3, 10});
  EXPECT_EQ(grid.size(), 210u);
  EXPECT_NEAR(grid.box_volume(), 0.7 * 0.4 * 0.9 / 210, 1e-16);
  Random random(1, 0, 0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d x{random.uniform(-0.1, 0.6), random.uniform(0.3, 0.7), random.uniform(1, 1.9)};
    ASSERT_LT(grid.index(x), grid.size());
    EXPECT_TRUE(holds(grid.box(grid.index(x)), x));
  }
  // Faces belong to the box above, the last one to the last box; beyond there is none.
  for (int i = 0; i <= 7; ++i)
    EXPECT_EQ(grid.index({grid.face(0, i), 0.3, 1}), static_cast<std::size_t>(std::min(i, 6)));
  EXPECT_EQ(grid.index({0.6000001, 0.5, 1.5}), Grid::none);
  EXPECT_EQ(grid.index({0.5, 0.5, 0.9999999}), Grid::none);
}

TEST(AnalysisGrid, PlacesAndCellsAreInverse) {
  const Grid grid(Snapshot{}, {{0, 0, 0}, {1, 1, 1}}, {3, 4, 5});
  for (std::size_t p = 0; p < grid.size(); ++p) {
    const auto c = grid.cell(p);
    EXPECT_EQ(grid.place(c[0], c[1], c[2]), p);
    EXPECT_EQ(grid.index(grid.centre(p)), p);
  }
}

TEST(AnalysisGrid, PeriodicPointsAreWrapped) {
  Snapshot s;
  s.periodic = {true, false, false};
  s.length = {2, 0, 0};
  const Grid grid(s, {{0, 0, 0}, {2, 1, 1}}, {4, 1, 1});
  EXPECT_EQ(grid.index({2, 0.5, 0.5}), 0u);
  EXPECT_EQ(grid.index({-0.1, 0.5, 0.5}), 3u);
  EXPECT_EQ(grid.index({4.6, 0.5, 0.5}), 1u);
  EXPECT_EQ(grid.index({1, 1.1, 0.5}), Grid::none);
  // A region that is half the cell sees the images in it and no others.
  const Grid half(s, {{1.5, 0, 0}, {2.5, 1, 1}}, {2, 1, 1});
  EXPECT_EQ(half.index({0.2, 0.5, 0.5}), 1u);
  EXPECT_EQ(half.index({0.7, 0.5, 0.5}), Grid::none);
}

TEST(AnalysisGrid, TouchedBoxesAreThoseThatTheBodyReaches) {
  Snapshot s;
  s.periodic = {true, true, false};
  s.length = {1, 1.5, 0};
  const Grid grid(s, {{0, -0.5, 0}, {1, 1, 2}}, {5, 4, 3});
  Random random(2, 0, 0);
  for (int t = 0; t < 300; ++t) {
    const Vec3d x{random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(0, 2)};
    const double r = random.uniform(0.01, 0.7);
    const Vec3d m{r, r, r};
    double sum = 0;
    grid.each_touched(x - m, x + m, [&](std::size_t place, const Vec3d& shift) {
      const Grid::Box b = grid.box(place);
      double v = 1;
      for (int k = 0; k < 3; ++k)
        v *= std::max(0.0, std::min(b.upper[k], x[k] + shift[k] + r) - std::max(b.lower[k], x[k] + shift[k] - r));
      sum += v;
    });
    const double along_z = std::min(2.0, x.z + r) - std::max(0.0, x.z - r);
    EXPECT_NEAR(sum, 4 * r * r * along_z, 1e-13);  // the images' shares make up the whole body
  }
}

TEST(AnalysisGrid, ThePlaneHasOneBoxAlongZ) {
  Snapshot s;
  s.dimension = 2;
  s.thickness = 0.5;
  const Grid grid(s, {{0, 0, 0}, {2, 1, 0}}, {4, 2, 9});
  EXPECT_EQ(grid.size(), 8u);
  EXPECT_NEAR(grid.box_volume(), 0.125, 1e-16);
  EXPECT_EQ(grid.index({1.9, 0.9, 0}), 7u);
}

TEST(AnalysisGrid, BoxesNotAskedForAreAboutFourDiametersWide) {
  Snapshot s;
  s.id = {0, 1};
  s.radius = {0.01, 0.03};  // mean diameter 0.04
  const auto boxes = boxes_of(s, {{0, 0, 0}, {1, 0.33, 0.01}}, {0, 0, 0});
  EXPECT_EQ(boxes, (std::array{6, 2, 1}));
  EXPECT_EQ(boxes_of(s, {{0, 0, 0}, {1, 1, 1}}, {3, 0, 2}), (std::array{3, 6, 2}));
  EXPECT_EQ(boxes_of(Snapshot{}, {{0, 0, 0}, {1, 1, 1}}, {0, 0, 0}), (std::array{1, 1, 1}));
}

TEST(AnalysisGrid, ARegionInsideOutIsRefused) {
  Settings settings;
  settings.region = Domain{{0, 0, 0}, {1, -1, 1}};
  EXPECT_THROW(region_of(Snapshot{}, settings), InputError);
}

}  // namespace
}  // namespace dem::analysis
