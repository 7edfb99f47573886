// Piles in the plane, of discs alone and of regular pentagons alone: corners and sides hold where discs roll, as
// simulations of both with the same friction have shown.
//
// The slope is that of the triangle with the heap's centre of area: of an isosceles triangle of height H on a base 2 L
// the mean height is H/3 and the mean distance from its axis L/3, so
//   tan(angle) = mean height / mean distance from the middle,
// over the heap's profile above a quarter of its height, where what rolls away over the plate does not count.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

// Highest point of a body over the floor, m.
double top_of(const World& w, std::uint32_t i) {
  const Particles& p = w.particles;
  const shapes::Polygon* polygon = w.shapes[p.shape[i]].polygon.get();
  if (polygon == nullptr) return p.motion[i].position.y + p.motion[i].equivalent_radius;
  const shapes::Mat3d r = shapes::rotation_matrix(p.orientation[i]);
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3d& v : polygon->vertices) top = std::max(top, (r * (v * p.size[i].x)).y);
  return p.motion[i].position.y + top;
}

double slope_of_heap(const World& w) {  // degrees
  const Particles& p = w.particles;
  double width = 0, peak = 0;
  for (const contact::Motion& m : p.motion)
    width += 2 * m.equivalent_radius / static_cast<double>(p.count());  // of a column: one body
  std::map<long, double> profile;
  for (std::uint32_t i = 0; i < p.count(); ++i) {
    double& height = profile[std::lround(std::floor(p.motion[i].position.x / width))];
    height = std::max(height, top_of(w, i));
    peak = std::max(peak, height);
  }
  double area = 0, middle = 0, height = 0, distance = 0;
  for (auto& [column, h] : profile) {
    h = std::max(0.0, h - 0.25 * peak);
    area += h;
    middle += h * static_cast<double>(column);
    height += 0.5 * h * h;
  }
  middle /= area;
  for (const auto& [column, h] : profile) distance += h * width * std::abs(static_cast<double>(column) - middle);
  return std::atan(height / distance) * 180 / std::numbers::pi;
}

}  // namespace

extern const Validation pile_2d;
const Validation pile_2d{
    "pile_2d", "pile_2d.toml", "a heap of regular pentagons is steeper than one of discs by 5 degrees or more",
    [](Runs& runs) -> std::vector<Row> {
      const std::size_t items = runs.build().scene.fills[0].items.size();
      const auto heap_of = [&](const std::string& shape) {
        std::vector<std::string> alone;
        for (std::size_t i = 0; i < items; ++i) {
          alone.push_back(fmt::format("fill[0].items[{}].shape={}", i, shape));
          alone.push_back(fmt::format("fill[0].items[{}].scale=[0.9, 1.1]", i));
        }
        return slope_of_heap(runs.run(alone, shape));
      };
      const double mixed = slope_of_heap(runs.run({}, "mixed")), discs = heap_of("disc"),
                   pentagons = heap_of("pentagon");
      return {at_least(fmt::format("pentagons, {:.1f} deg, over discs, {:.1f} deg", pentagons, discs),
                       pentagons - discs, 5, "deg"),
              for_information("heap of all shapes mixed", mixed, "deg")};
    }};

}  // namespace dem::validate
