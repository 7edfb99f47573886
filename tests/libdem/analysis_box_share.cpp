// Shares of bodies of every shape in boxes: they add up to the body, halves are halves, and they agree with counting
// points that the definition of the shape puts inside.
#include <gtest/gtest.h>

#include <numbers>

#include "libdem/analysis/box_share.h"
#include "tests/libdem/analysis_bodies.h"

namespace dem::analysis {
namespace {

constexpr double edge = 0.05;

Snapshot space(std::size_t each, std::uint64_t seed = 1) {
  std::size_t symmetric = 0;
  return scenes::scattered(scenes::shapes_of_space(symmetric), 3, each, edge, seed);
}
Snapshot plane(std::size_t each) { return scenes::scattered(scenes::shapes_of_the_plane(), 2, each, edge); }

void expect_sums(const Snapshot& s, const std::array<int, 3>& boxes, double tolerance) {
  const BoxShares shares(s);
  EXPECT_TRUE(shares.notes().empty());
  const Grid grid(s, {{0, 0, 0}, {edge, edge, edge}}, boxes);
  std::vector<double> sum(s.count());
  std::vector<int> count(s.count());
  for (const BoxShare& share : shares.on(grid)) sum[share.body] += share.volume, ++count[share.body];
  for (std::size_t i = 0; i < s.count(); ++i) {
    EXPECT_NEAR(sum[i] / s.volume[i], 1, tolerance) << s.shape_of(i).name << " in " << count[i];
    EXPECT_GT(count[i], 0);
  }
}

Snapshot periodic(Snapshot s) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(s.dimension); ++k) {
    s.periodic[k] = true;
    s.length[static_cast<int>(k)] = edge;
  }
  return s;
}

TEST(AnalysisBoxShare, SharesAddUpToTheBodyForEveryShape) {
  for (const int n : {1, 3, 7}) {  // boxes larger and smaller than the bodies
    expect_sums(periodic(space(6)), {n, n + 1, n}, 1e-10);
    expect_sums(periodic(plane(20)), {n, n + 1, 1}, 1e-10);
  }
}

TEST(AnalysisBoxShare, PiecesHaveTheVolumeOfTheShape) {
  for (const ShapeEntry& shape : space(1).shapes) {
    if (shape.kind == shapes::Kind::sphere || shape.kind == shapes::Kind::ellipsoid) continue;
    // Of the volume of the shape, where that was found by quadrature.
    const bool mixed = shape.name == "mushroom" || shape.name == "stick";
    const double tolerance = shape.potential || mixed ? 1e-8 : 1e-10;
    EXPECT_NEAR(pieces_of(shape).volume / shape.volume, 1, tolerance) << shape.name;
  }
  const Snapshot s = plane(1);
  for (const ShapeEntry& shape : s.shapes)
    if (shape.polygon) {
      EXPECT_NEAR(pieces_of(shape).volume * s.thickness / shape.volume, 1, 1e-12) << shape.name;
    }
}

TEST(AnalysisBoxShare, APlaneThroughTheCentreHalvesSymmetricBodies) {
  std::size_t symmetric = 0;
  const auto list = scenes::shapes_of_space(symmetric);
  const Snapshot s = space(30, 2);
  const BoxShares shares(s);
  for (std::size_t i = 0; i < symmetric * 30; ++i) {
    const Vec3d x = s.position[i];
    for (int axis = 0; axis < 3; ++axis) {
      Grid::Box half{x - Vec3d{1, 1, 1}, x + Vec3d{1, 1, 1}};
      half.upper[axis] = x[axis];
      EXPECT_NEAR(shares.in_box(i, {}, half) / s.volume[i], 0.5, 1e-12) << s.shape_of(i).name;
    }
  }
}

// Random boxes against points of a fine lattice, moved at random, in the body's bounding cube.
void expect_counts(const Snapshot& s, std::size_t i, int n, double tolerance) {
  const BoxShares shares(s);
  Random random(11, i, 0);
  const bool flat = s.dimension == 2;
  const double reach = s.bounding_radius[i] * (flat ? 1.42 : 1.74);
  const Vec3d c = s.position[i];
  Vec3d low{}, high{};
  for (int k = 0; k < 3; ++k) {
    low[k] = c[k] + random.uniform(-0.4, 0) * reach;
    high[k] = c[k] + random.uniform(0.05, 0.5) * reach;
  }
  const Mat3d turn = rotation_matrix(s.orientation[i]);
  // The lattice along neither the box nor the body.
  const Mat3d oblique = rotation_matrix(flat ? scenes::turn({0, 0, 1}, 0.3) : random.rotation());
  const double step = 2 * reach / n, dx = random.uniform(), dy = random.uniform(), dz = random.uniform();
  std::size_t inside = 0, both = 0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      for (int d = 0; d < (flat ? 1 : n); ++d) {
        const Vec3d x =
            oblique * Vec3d{(a + dx) * step - reach, (b + dy) * step - reach, flat ? 0 : (d + dz) * step - reach};
        Vec3d body = transposed_times(turn, x);
        if (s.shape_of(i).kind != shapes::Kind::ellipsoid && s.shape_of(i).kind != shapes::Kind::ellipse &&
            !is_round(s.shape_of(i).kind))
          body = body * (1 / s.size[i].x);
        if (!scenes::holds(s, i, body)) continue;
        ++inside;
        bool in = true;
        for (int k = 0; k < s.dimension; ++k) in = in && c[k] + x[k] >= low[k] && c[k] + x[k] <= high[k];
        both += in;
      }
  const double point = std::pow(step, s.dimension) * (flat ? s.thickness : 1);
  EXPECT_NEAR(static_cast<double>(inside) * point / s.volume[i], 1, tolerance) << s.shape_of(i).name;
  EXPECT_NEAR(shares.in_box(i, {}, {low, high}) / s.volume[i], static_cast<double>(both) * point / s.volume[i],
              tolerance)
      << s.shape_of(i).name;
}

TEST(AnalysisBoxShare, SharesAgreeWithCountedPoints) {
  const Snapshot s = space(1, 5);
  for (std::size_t i = 0; i < s.count(); ++i) expect_counts(s, i, 120, 3e-3);
  const Snapshot flat = plane(2);
  for (std::size_t i = 0; i < flat.count(); ++i) expect_counts(flat, i, 1000, 1e-3);
}

TEST(AnalysisBoxShare, EllipsoidsThatOverlapAreToldOf) {
  const Snapshot s = scenes::scattered(
      {scenes::ellipsoid("cap", {0.006, 0.005, 0.003}),
       scenes::union_of("cross", {{"cap", {0, 0, 0}, {}}, {"cap", {0.004, 0, 0}, scenes::turn({0, 1, 0}, 1)}})},
      3, 1, edge);
  const BoxShares shares(s);
  ASSERT_EQ(shares.notes().size(), 1u);
  EXPECT_NE(shares.notes()[0].find("\"cross\""), std::string::npos);
  const Grid grid(periodic(s), {{0, 0, 0}, {edge, edge, edge}}, {9, 9, 9});
  double sum = 0;
  for (const BoxShare& share : shares.on(grid)) sum += share.body == 1 ? share.volume : 0;
  EXPECT_NEAR(sum / s.volume[1], 1, 1e-12);  // the parts are shares of one body all the same
}

}  // namespace
}  // namespace dem::analysis
