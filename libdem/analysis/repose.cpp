#include "libdem/analysis/repose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/table.h"
#include "libdem/scene/where.h"

namespace dem::analysis {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double toe = 0.2, apex = 0.8;  // shares of the height between which slopes are taken
constexpr std::size_t fewest = 4;
constexpr std::size_t sectors = 8;

// Height of the base along `up`.
double base_of(const Snapshot& s, const Vec3d& up, const std::string& name) {
  bool found = false;
  double base = 0, lowest = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    const double bottom = dot(up, s.position[i]) - s.bounding_radius[i];
    lowest = i == 0 ? bottom : std::min(lowest, bottom);
  }
  for (const SnapshotWall& w : s.walls) {
    const bool looks_up = is_half_space(w.kind) && w.present && dot(w.normal(), up) > 1 - 1e-9;
    if (!name.empty() && w.name == name) {
      if (!looks_up) throw InputError(fmt::format("base wall '{}' of the angle of repose is no level plane", name));
      return dot(up, w.position);
    }
    if (!looks_up) continue;
    const double height = dot(up, w.position);
    base = found ? std::min(base, height) : height;
    found = true;
  }
  if (!name.empty()) throw InputError(fmt::format("there is no wall '{}' to be the base of the angle of repose", name));
  return found ? base : lowest;
}

std::vector<std::uint8_t> at_rest_on_others(const Snapshot& s) {
  std::vector<std::uint8_t> touched(s.count(), s.has_contacts && !s.contacts.empty() ? 0 : 1);
  for (const SnapshotContact& c : s.contacts) {
    touched[c.a] = 1;
    if (!c.wall) touched[c.b] = 1;
  }
  return touched;
}

Slope fit(const std::vector<std::pair<double, double>>& points) {
  double mean_r = 0, mean_h = 0;
  const auto n = static_cast<double>(points.size());
  for (const auto& [r, h] : points) {
    mean_r += r / n;
    mean_h += h / n;
  }
  double rr = 0, rh = 0, hh = 0;
  for (const auto& [r, h] : points) {
    rr += (r - mean_r) * (r - mean_r);
    rh += (r - mean_r) * (h - mean_h);
    hh += (h - mean_h) * (h - mean_h);
  }
  Slope slope;
  slope.points = points.size();
  if (!(rr > 0)) return slope;
  const double b = -rh / rr, left = std::max(hh - rh * rh / rr, 0.0);
  slope.angle = std::atan(b);
  slope.error = std::sqrt(left / ((n - 2) * rr)) / (1 + b * b);  // (3)
  return slope;
}

}  // namespace

FreeSurface free_surface_of(const Snapshot& s, const Settings& settings) {
  FreeSurface f;
  f.up = upward(s);
  if (s.dimension == 2) {
    f.along = {f.up.y, -f.up.x, 0};
  } else {
    int largest = 0;  // axes of the world where gravity is along one
    for (int k = 1; k < 3; ++k)
      if (std::abs(f.up[k]) > std::abs(f.up[largest])) largest = k;
    Vec3d e{};
    e[(largest + 1) % 3] = 1;
    f.along = normalized(e - f.up * dot(e, f.up));
    f.across = cross(f.up, f.along);
  }
  if (s.count() == 0) return f;
  f.base = base_of(s, f.up, settings.base_wall);
  const std::vector<std::uint8_t> counted = at_rest_on_others(s);
  double mass = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    f.width += 4 * s.radius[i] / static_cast<double>(s.count());
    if (counted[i] == 0) continue;
    f.middle += s.position[i] * s.mass[i];
    mass += s.mass[i];
  }
  f.middle *= mass > 0 ? 1 / mass : 0;
  // A ridge runs along the horizontal axis that is periodic.
  const auto quarter_turn = [&f] { f.along = std::exchange(f.across, -f.along); };
  const auto periodic = [&](const Vec3d& e) {
    for (int k = 0; k < 3; ++k)
      if (s.periodic[static_cast<std::size_t>(k)] && std::abs(e[k]) > 1 - 1e-9) return true;
    return false;
  };
  if (s.dimension == 3) {
    if (periodic(f.along)) {
      quarter_turn();
    }
    f.ridge = periodic(f.across);
  }
  // Squares fill the extent of the centres, so that none is a sliver along a wall.
  const auto place_of = [&](std::size_t i) {
    const Vec3d x = s.position[i] - f.middle;
    return std::array<double, 2>{dot(x, f.along), dot(x, f.across)};
  };
  std::array<double, 2> low{}, high{};
  bool first = true;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (counted[i] == 0) continue;
    const std::array<double, 2> place = place_of(i);
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = first ? place[k] : std::min(low[k], place[k]);
      high[k] = first ? place[k] : std::max(high[k], place[k]);
    }
    first = false;
  }
  // One square from front to back: a slice of a ridge, and its squares are half as long, to be enough.
  std::array<double, 2> width{f.width, f.width};
  const auto squares = [&](std::size_t k) { return std::max(1.0, std::floor((high[k] - low[k]) / width[k])); };
  const std::size_t narrow = squares(0) < squares(1) ? 0 : 1, wide = 1 - narrow;
  const bool slice = s.dimension == 3 && !f.ridge && squares(narrow) == 1 && squares(wide) > 1;
  if (slice) width[wide] *= 0.5;
  std::map<std::array<long, 2>, std::size_t> top;  // by square
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (counted[i] == 0) continue;
    const std::array<double, 2> place = place_of(i);
    std::array<long, 2> square{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double count = squares(k);
      const double at = high[k] > low[k] ? (place[k] - low[k]) / (high[k] - low[k]) : 0;
      square[k] = std::lround(std::min(std::floor(at * count), count - 1));
    }
    const double height = dot(s.position[i], f.up) + s.bounding_radius[i];
    const auto [at, fresh] = top.try_emplace(square, i);
    if (!fresh && height > dot(s.position[at->second], f.up) + s.bounding_radius[at->second]) at->second = i;
  }
  for (const auto& [square, i] : top) {
    const double height = dot(s.position[i], f.up) + s.bounding_radius[i] - f.base;
    const Vec3d place = s.position[i] + f.up * s.bounding_radius[i];
    f.points.push_back({place, height});
  }
  f.ridge = f.ridge || slice;
  if (slice && narrow == 0) quarter_turn();
  return f;
}

Repose repose_of(const FreeSurface& f) {
  Repose result;
  for (const SurfacePoint& p : f.points) result.height = std::max(result.height, p.height);
  const bool two_sides = f.ridge || norm(f.across) == 0;
  result.sides = two_sides ? 2 : sectors;
  std::vector<std::vector<std::pair<double, double>>> side(result.sides);
  for (const SurfacePoint& p : f.points) {
    if (p.height <= toe * result.height || p.height >= apex * result.height) continue;
    const double u = dot(p.place - f.middle, f.along), v = two_sides ? 0 : dot(p.place - f.middle, f.across);
    std::size_t k = u < 0 ? 1 : 0;
    if (!two_sides)
      k = static_cast<std::size_t>(std::floor((std::atan2(v, u) + 2 * pi) / (2 * pi / sectors) + 0.5)) % sectors;
    side[k].emplace_back(std::hypot(u, v), p.height);
  }
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (side[k].size() < fewest) continue;
    Slope slope = fit(side[k]);
    slope.direction = 2 * pi * static_cast<double>(k) / static_cast<double>(result.sides);
    if (slope.angle > 0) result.slopes.push_back(slope);
  }
  if (result.slopes.empty()) return result;
  const auto n = static_cast<double>(result.slopes.size());
  double mean = 0, square = 0, error = 0;
  for (const Slope& x : result.slopes) {
    mean += x.angle / n;
    error += x.error * x.error / (n * n);
  }
  for (const Slope& x : result.slopes) square += (x.angle - mean) * (x.angle - mean);
  if (n > 1) error += square / ((n - 1) * n);
  result.angle = mean;
  result.error = std::sqrt(error);  // (4)
  return result;
}

std::optional<Tilt> tilt_of(const FreeSurface& f) {
  struct Place {
    double u, v, h;
  };
  std::vector<Place> all;
  double low[2]{}, high[2]{};
  for (const SurfacePoint& p : f.points) {
    all.push_back({dot(p.place - f.middle, f.along), dot(p.place - f.middle, f.across), p.height});
    for (int k = 0; k < 2; ++k) {
      const double x = k == 0 ? all.back().u : all.back().v;
      low[k] = all.size() == 1 ? x : std::min(low[k], x);
      high[k] = all.size() == 1 ? x : std::max(high[k], x);
    }
  }
  const int widest = high[1] - low[1] > high[0] - low[0] ? 1 : 0;
  const double middle = 0.5 * (low[widest] + high[widest]), half = 0.25 * (high[widest] - low[widest]);
  std::erase_if(all, [&](const Place& p) { return std::abs((widest == 0 ? p.u : p.v) - middle) > half; });
  if (all.size() <= fewest) return {};
  const auto n = static_cast<double>(all.size());
  Place mean{};
  for (const Place& p : all) mean = {mean.u + p.u / n, mean.v + p.v / n, mean.h + p.h / n};
  double uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;
  for (Place& p : all) {
    p = {p.u - mean.u, p.v - mean.v, p.h - mean.h};
    uu += p.u * p.u;
    uv += p.u * p.v;
    vv += p.v * p.v;
    uh += p.u * p.h;
    vh += p.v * p.h;
  }
  // One square across, or the plane: a line along the other axis.
  const bool line = !(uu * vv - uv * uv > 1e-6 * uu * vv) || !(std::min(uu, vv) > 1e-6 * std::max(uu, vv));
  if (line) {
    (widest == 0 ? vv : uu) = 1;
    (widest == 0 ? vh : uh) = 0;
    uv = 0;
  }
  const double determinant = uu * vv - uv * uv;
  const double a = (uh * vv - vh * uv) / determinant, b = (vh * uu - uh * uv) / determinant, steep = std::hypot(a, b);
  double left = 0;
  for (const Place& p : all) left += (p.h - a * p.u - b * p.v) * (p.h - a * p.u - b * p.v);
  const double eu = steep > 0 ? a / steep : 1, ev = steep > 0 ? b / steep : 0;
  const double spread = (eu * eu * vv - 2 * eu * ev * uv + ev * ev * uu) / determinant;
  return Tilt{std::atan(steep), std::sqrt(left / (n - (line ? 2 : 3)) * spread) / (1 + steep * steep), all.size()};
}

Result report_repose(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  if (!(norm(s.gravity) > 0)) r.notes.emplace_back("no gravity: up is the last axis");
  const FreeSurface f = free_surface_of(s, settings);
  const Repose found = repose_of(f);
  r.add("height", "m", found.height);
  r.add("sides", "1", static_cast<double>(found.slopes.size()));
  if (found.angle) r.scalars.push_back({"angle_of_repose", "degree", *found.angle * 180 / pi, found.error * 180 / pi});
  if (const std::optional<Tilt> tilt = tilt_of(f)) {
    r.scalars.push_back({"surface_tilt", "degree", tilt->angle * 180 / pi, tilt->error * 180 / pi});
    r.notes.emplace_back("surface_tilt: of one plane through the middle half of the surface, as of a bed in a drum");
  }
  r.notes.push_back(fmt::format(
      "angle of repose: least squares over surface squares {:.4g} m wide between 20 and 80 % of the height, mean of {} "
      "of {} sides; error from the fits and the scatter of the sides",
      f.width, found.slopes.size(), found.sides));
  if (!found.angle) r.notes.emplace_back("no side has four squares that fall outwards: no angle");
  Table sides = table_of("sides", "Slope of each side of the heap",
                         {{"direction", "rad"}, {"angle", "degree"}, {"error", "degree"}, {"points", "1"}});
  for (const Slope& x : found.slopes) add_row(sides, x.direction, x.angle * 180 / pi, x.error * 180 / pi, x.points);
  Table surface = table_of("surface", "Free surface: the top of the highest body over each square",
                           {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"height", "m"}});
  for (const SurfacePoint& p : f.points) add_row(surface, p.place.x, p.place.y, p.place.z, p.height);
  r.tables.push_back(std::move(sides));
  r.tables.push_back(std::move(surface));
  return r;
}

}  // namespace dem::analysis
