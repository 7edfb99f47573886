#include "libdem/analysis/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libdem/scene/where.h"

namespace dem::analysis {

namespace {

constexpr std::size_t most_values = 8;
constexpr double alike = 1e-6;

Groups named(std::vector<std::string> names, const std::vector<std::uint32_t>& of_body) {
  Groups g;  // those that nobody is in are left out
  std::vector<std::uint32_t> place(names.size(), Groups::none);
  for (const std::uint32_t k : of_body) place[k] = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (place[k] == Groups::none) continue;
    place[k] = static_cast<std::uint32_t>(g.names.size());
    g.names.push_back(std::move(names[k]));
  }
  for (const std::uint32_t k : of_body) g.of_body.push_back(place[k]);
  return g;
}

Groups by_value(const std::vector<double>& value, const char* unit) {
  std::vector<double> sorted = value, levels;
  std::sort(sorted.begin(), sorted.end());
  for (const double v : sorted)
    if (levels.empty() || v - levels.back() > alike * v) levels.push_back(v);
  Groups g;
  if (levels.size() <= most_values) {
    for (const double v : levels) g.names.push_back(fmt::format("{:.6g} {}", v, unit));
    for (const double v : value) {
      const auto above = std::upper_bound(levels.begin(), levels.end(), v);
      g.of_body.push_back(static_cast<std::uint32_t>(above - levels.begin()) - 1);
    }
    return g;
  }
  const double mean = std::accumulate(value.begin(), value.end(), 0.0) / static_cast<double>(value.size());
  g.names = {fmt::format("below {:.6g} {}", mean, unit), fmt::format("above {:.6g} {}", mean, unit)};
  for (const double v : value) g.of_body.push_back(v < mean ? 0 : 1);
  return g;
}

Groups slabs_along(const Snapshot& s, const Snapshot& reference, const Vec3d& axis, int count, const char* name) {
  Groups g;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < reference.count(); ++i) {
    const double x = dot(reference.position[i], axis);
    low = i == 0 ? x : std::min(low, x);
    high = i == 0 ? x : std::max(high, x);
  }
  for (int k = 0; k < count; ++k)
    g.names.push_back(fmt::format("{} {:.4g} to {:.4g} m", name, low + (high - low) * k / count,
                                  low + (high - low) * (k + 1) / count));
  for (const std::uint32_t at : places_in(s, reference)) {
    if (at == Groups::none) {
      g.of_body.push_back(Groups::none);
      continue;
    }
    const double share = high > low ? (dot(reference.position[at], axis) - low) / (high - low) : 0;
    g.of_body.push_back(static_cast<std::uint32_t>(std::clamp(std::floor(share * count), 0.0, count - 1.0)));
  }
  return g;
}

}  // namespace

std::vector<std::uint32_t> places_in(const Snapshot& s, const Snapshot& other) {
  std::vector<std::uint32_t> place(s.count(), Groups::none);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const auto at = std::lower_bound(other.id.begin(), other.id.end(), s.id[i]);
    if (at != other.id.end() && *at == s.id[i]) place[i] = static_cast<std::uint32_t>(at - other.id.begin());
  }
  return place;
}

Vec3d upward(const Snapshot& s) {
  const double g = norm(s.gravity);
  if (g > 0) return s.gravity * (-1 / g);
  return s.dimension == 2 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
}

Groups groups_of(const Snapshot& s, const std::string& by, const Snapshot* reference, int slabs) {
  const Snapshot& from = reference != nullptr ? *reference : s;
  if (by == "species") {
    std::vector<std::string> names{"none"};
    names.insert(names.end(), s.species_names.begin(), s.species_names.end());
    for (const std::uint32_t k : s.species)
      while (k >= names.size()) names.push_back(fmt::format("species {}", names.size()));
    return named(std::move(names), s.species);
  }
  if (by == "material") return named(s.materials, s.material);
  if (by == "shape") {
    std::vector<std::string> names;
    for (const ShapeEntry& e : s.shapes) names.push_back(e.name);
    return named(std::move(names), s.shape);
  }
  if (by == "size") return by_value(s.radius, "m");
  if (by == "density") {
    std::vector<double> density;
    for (std::size_t i = 0; i < s.count(); ++i) density.push_back(s.volume[i] > 0 ? s.mass[i] / s.volume[i] : 0);
    return by_value(density, "kg/m^3");
  }
  for (int k = 0; k < 3; ++k) {
    Vec3d axis{};
    axis[k] = 1;
    const char name[] = {"xyz"[k], '\0'};
    if (by == name) return slabs_along(s, from, axis, slabs, name);
  }
  if (by == "layers") return slabs_along(s, from, upward(s), slabs, "height");
  if (by == "position") return slabs_along(s, from, upward(s), 2, "height");
  std::string words;
  for (const std::string& word : group_words()) words += (words.empty() ? "" : ", ") + word;
  throw InputError(fmt::format("groups of bodies: '{}' is unknown; one of {}", by, words));
}

}  // namespace dem::analysis
