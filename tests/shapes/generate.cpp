// Grains by random numbers against the sample that they follow, and Voronoi cells.
#include "shapes/generate.h"

#include <fstream>
#include <sstream>

#include "shapes/form.h"
#include "shapes/geometry.h"
#include "shapes/math/random.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::form_of;
using shapes::FormTarget;

std::vector<FormTarget> scanned() {
  std::ifstream file(std::string(PROJECT_ROOT) + "/shapes/data/ct_dims/all.csv");
  std::vector<FormTarget> sample;
  std::string line, cell;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::stringstream row(line);
    std::getline(row, cell, ',');
    double x[5];  // L, W, T, volume, area
    for (double& v : x) {
      std::getline(row, cell, ',');
      v = std::stod(cell);
    }
    sample.push_back({x[2] / x[1], x[1] / x[0], 36 * std::numbers::pi * x[3] * x[3] / (x[4] * x[4] * x[4])});
  }
  return sample;
}

// Two-sample Kolmogorov–Smirnov: the probability of a larger distance of the two distributions by chance (Stephens'
// form).
double same_distribution(std::vector<double> x, std::vector<double> y) {
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  const auto below = [](const std::vector<double>& v, double t) {
    return static_cast<double>(std::upper_bound(v.begin(), v.end(), t) - v.begin()) / static_cast<double>(v.size());
  };
  double distance = 0;
  for (const auto* v : {&x, &y})
    for (const double t : *v) distance = std::max(distance, std::abs(below(x, t) - below(y, t)));
  const auto n = static_cast<double>(x.size()), m = static_cast<double>(y.size());
  const double root = std::sqrt(n * m / (n + m)), a = (root + 0.12 + 0.11 / root) * distance;
  double p = 0;
  for (int j = 1; j <= 100; ++j) p += 2 * (j % 2 == 1 ? 1 : -1) * std::exp(-2 * j * j * a * a);
  return std::clamp(p, 0.0, 1.0);
}

TEST(Generate, GrainsFollowTheScannedOnes) {
  const std::vector<FormTarget> sample = scanned();
  ASSERT_EQ(sample.size(), 2500u);
  for (const std::uint64_t seed : {1, 2}) {
    std::vector<double> elongation, flatness, all_elongations, all_flatnesses;
    double sphericity = 0, mean = 0;
    for (const FormTarget& t : sample) {
      all_elongations.push_back(t.elongation);
      all_flatnesses.push_back(t.flatness);
      mean += std::cbrt(t.sphericity_cubed) / static_cast<double>(sample.size());
    }
    const std::vector<std::size_t> rows = shapes::spread(sample, 300, seed, 0);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Polyhedron p = shapes::grain_of_form(sample[rows[k]], seed, 1, k);
      const shapes::Form f = form_of(p);
      elongation.push_back(f.width / f.length);
      flatness.push_back(f.thickness / f.width);
      sphericity += f.sphericity() / 300;
      EXPECT_NEAR(elongation.back(), sample[rows[k]].elongation, 0.012);
      EXPECT_NEAR(flatness.back(), sample[rows[k]].flatness, 0.012);
      EXPECT_NEAR(shapes::equivalent_radius(p.mass.volume), 0.5, 1e-14);
      if (k < 40) expect_canonical(p);  // closed, convex, every vertex extreme
    }
    const double w = same_distribution(elongation, all_elongations), t = same_distribution(flatness, all_flatnesses);
    EXPECT_GT(w, 0.05);
    EXPECT_GT(t, 0.05);
    EXPECT_NEAR(sphericity, mean, 0.02);
    std::printf("  seed %d: KS p %.3f (W/L), %.3f (T/W); sphericity %.4f, of the sample %.4f\n", static_cast<int>(seed),
                w, t, sphericity, mean);
  }
  // The test tells what is not alike.
  std::vector<double> shifted, all;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    all.push_back(sample[i].elongation);
    if (i % 8 == 0) shifted.push_back(sample[i].elongation - 0.03);
  }
  EXPECT_LT(same_distribution(shifted, all), 0.05);
}

TEST(Generate, OneGrainDependsOnItsNumberAlone) {
  const FormTarget t{0.7, 0.8, 0.5};
  const Polyhedron a = shapes::grain_of_form(t, 5, 6, 7), b = shapes::grain_of_form(t, 5, 6, 7),
                   c = shapes::grain_of_form(t, 5, 6, 8);
  EXPECT_TRUE(a.vertices == b.vertices);
  EXPECT_FALSE(a.vertices == c.vertices);
  const auto sample = scanned();
  const auto few = shapes::spread(sample, 10, 3, 4), many = shapes::spread(sample, 100, 3, 4);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  const auto cells = shapes::voronoi_grains(3, 1, 5, 6), more = shapes::voronoi_grains(70, 1, 5, 6);
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_TRUE(cells[i].vertices == more[i].vertices);
}

// Any 64 in a row take as many from the lower half of each measure as from the upper one, nearly.
TEST(Generate, ASampleIsDrawnEvenly) {
  const auto sample = scanned();
  const auto rows = shapes::spread(sample, 256, 9, 0);
  std::vector<double> x;
  for (const FormTarget& t : sample) x.push_back(t.elongation);
  std::nth_element(x.begin(), x.begin() + 1250, x.end());
  for (std::size_t from = 0; from < 256; from += 64) {
    const auto low = std::count_if(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                   rows.begin() + static_cast<std::ptrdiff_t>(from + 64),
                                   [&](std::size_t r) { return sample[r].elongation < x[1250]; });
    EXPECT_NEAR(static_cast<double>(low), 32, 1);
  }
}

TEST(Generate, ExtremeForms) {
  for (const auto& [t, near] :
       {std::pair(FormTarget{0.05, 0.1, 0}, 0.012), std::pair(FormTarget{0.1, 0.98, 0.2}, 0.012),
        std::pair(FormTarget{0.98, 0.1, 0.1}, 0.012), std::pair(FormTarget{1, 1, 0}, 0.05),
        std::pair(FormTarget{0.9999, 0.9999, 0.99}, 0.05)}) {
    const shapes::Form f = form_of(shapes::grain_of_form(t, 1, 1, 1));
    EXPECT_NEAR(f.width / f.length, t.elongation, near * t.elongation);
    EXPECT_NEAR(f.thickness / f.width, t.flatness, near * t.flatness);
  }
  EXPECT_THROW(shapes::grain_of_form({1.5, 0.5, 0}, 1, 1, 1), shapes::Error);
  EXPECT_THROW(shapes::grain_of_form({0.5, 0, 0}, 1, 1, 1), shapes::Error);
}

TEST(Voronoi, CellsFillTheBox) {
  std::vector<Vec3d> points;
  shapes::Random random(1, 0, 0);
  for (int i = 0; i < 40; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back({x, y, z});
  }
  points.push_back({0.5, 0.5, 0.5});
  points.push_back({0.5, 0.5, 0.501});  // two near each other
  double volume = 0;
  const auto cells = shapes::voronoi_cells(points);
  for (const auto& c : cells) {
    expect_canonical(c.cell);
    volume += c.cell.mass.volume;
    // every corner is as near to its own point as to any other, at least four in all
    for (const Vec3d& v : c.cell.vertices) {
      int alike = 0;
      double nearest = 1e9;
      for (const Vec3d& other : points)
        for (int k = 0; k < 27; ++k) {
          const Vec3d d = other + Vec3d{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0} - (c.point + v);
          nearest = std::min(nearest, norm(d));
          alike += std::abs(norm(d) - norm(v)) < 1e-9 ? 1 : 0;
        }
      EXPECT_NEAR(nearest, norm(v), 1e-10);
      EXPECT_GE(alike, 4);
    }
  }
  EXPECT_NEAR(volume, 1, 1e-12);
}

// Of random points: 2 + 48 π²/35 = 15.535 faces each (Meijering, Philips Res. Rep. 8 (1953) 270).
TEST(Voronoi, FacesOfARandomCell) {
  double faces = 0, rounder = 0, plain = 0;
  const auto cells = shapes::voronoi_grains(640, 0, 3, 0), relaxed = shapes::voronoi_grains(64, 5, 3, 0);
  for (const Polyhedron& p : cells) {
    faces += static_cast<double>(p.faces.size()) / 640;
    plain += form_of(p).sphericity() / 640;
    EXPECT_NEAR(shapes::equivalent_radius(p.mass.volume), 0.5, 1e-14);
  }
  EXPECT_NEAR(faces, 15.535, 0.15);
  for (const Polyhedron& p : relaxed) rounder += form_of(p).sphericity() / 64;
  EXPECT_GT(rounder, plain + 0.05);
}

}  // namespace
}  // namespace shape_tests
