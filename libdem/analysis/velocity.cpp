#include "libdem/analysis/velocity.h"

#include <algorithm>

#include "libdem/analysis/grid.h"

namespace dem::analysis {
namespace {

std::vector<std::size_t> counted(const Snapshot& s, const Settings& settings) {
  std::vector<std::size_t> list;
  const Grid region(s, region_of(s, settings), {1, 1, 1});
  for (std::size_t i = 0; i < s.count(); ++i)
    if (!settings.region || region.index(s.position[i]) != Grid::none) list.push_back(i);
  return list;
}

// Of speeds, in bins of equal width from 0 to the largest.
Table distribution(const Snapshot& s, const std::vector<std::size_t>& bodies, double largest, int bins) {
  std::vector<double> count(static_cast<std::size_t>(bins));
  for (const std::size_t i : bodies) {
    const double at = norm(s.velocity[i]) / largest * bins;
    count[static_cast<std::size_t>(std::min(at, bins - 1.0))] += 1;
  }
  Table t{"distribution", "speeds of the bodies", {{"speed", "m/s", {}}, {"bodies", "1", {}}, {"density", "s/m", {}}}};
  const double width = largest / bins;
  for (std::size_t b = 0; b < count.size(); ++b) {
    t.columns[0].values.push_back((static_cast<double>(b) + 0.5) * width);
    t.columns[1].values.push_back(count[b]);
    t.columns[2].values.push_back(count[b] / (static_cast<double>(bodies.size()) * width));
  }
  return t;
}

}  // namespace

Velocities velocities_of(const Snapshot& s, const Settings& settings) {
  Velocities v;
  const std::vector<std::size_t> bodies = counted(s, settings);
  v.count = bodies.size();
  if (bodies.empty()) return v;
  const auto n = static_cast<double>(v.count);
  double mass = 0;
  for (const std::size_t i : bodies) {
    const double m = s.has_mass ? s.mass[i] : s.volume[i], speed = norm(s.velocity[i]);
    mass += m;
    v.mean += s.velocity[i] * m;
    v.mean_spin += s.spin[i] * (1 / n);
    v.mean_speed += speed / n;
    v.largest_speed = std::max(v.largest_speed, speed);
  }
  v.mean *= 1 / mass;
  for (const std::size_t i : bodies) {
    const Vec3d d = s.velocity[i] - v.mean, w = s.spin[i] - v.mean_spin;
    v.temperature += dot(d, d) / (s.dimension * n);
    v.spin_temperature += dot(w, w) / ((s.dimension == 3 ? 3 : 1) * n);
  }
  return v;
}

Result report_velocity(const Snapshot& s, const Settings& settings) {
  Result r;
  if (!s.has_velocity) {
    r.notes.emplace_back("no velocities in the source");
    return r;
  }
  const Velocities v = velocities_of(s, settings);
  r.add("bodies", "1", static_cast<double>(v.count));
  if (v.count == 0) {
    r.notes.emplace_back(s.count() == 0 ? "no bodies" : "no bodies in the region");
    return r;
  }
  if (!s.has_mass) r.notes.emplace_back("no masses in the source: the mean velocity is that over the bodies' volume");
  for (int k = 0; k < s.dimension; ++k) r.add(std::string("mean_") + "xyz"[k], "m/s", v.mean[k]);
  r.add("mean_speed", "m/s", v.mean_speed);
  r.add("largest_speed", "m/s", v.largest_speed);
  r.add("temperature", "m^2/s^2", v.temperature);
  for (int k = s.dimension == 3 ? 0 : 2; k < 3; ++k)
    r.add(std::string("mean_spin_") + "xyz"[k], "rad/s", v.mean_spin[k]);
  r.add("spin_temperature", "rad^2/s^2", v.spin_temperature);
  if (v.largest_speed > 0)
    r.tables.push_back(distribution(s, counted(s, settings), v.largest_speed, settings.bins));
  else
    r.notes.emplace_back("all bodies are at rest: no distribution of speeds");
  return r;
}

}  // namespace dem::analysis
