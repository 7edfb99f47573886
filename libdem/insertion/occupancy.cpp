#include "libdem/insertion/occupancy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {
namespace {

Vec3d nearest_on_segment(const Vec3d& a, const Vec3d& b, const Vec3d& x) {
  const Vec3d d = b - a;
  const double length2 = dot(d, d);
  const double t = length2 > 0 ? std::clamp(dot(x - a, d) / length2, 0.0, 1.0) : 0;
  return a + d * t;
}

// The foot of x on the triangle's plane when it lies inside, else the nearest point of its three sides.
double distance2_to_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x) {
  const Vec3d n = cross(b - a, c - a);
  const double n2 = dot(n, n);
  const auto side = [&](const Vec3d& p, const Vec3d& q) { return dot(cross(q - p, x - p), n); };
  if (n2 > 0 && side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0) {
    const double h = dot(n, x - a);
    return h * h / n2;
  }
  double best = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : {nearest_on_segment(a, b, x), nearest_on_segment(b, c, x), nearest_on_segment(c, a, x)})
    best = std::min(best, dot(x - p, x - p));
  return best;
}

double distance_to_half_space(const Wall& wall, const Vec3d& x) {
  const Vec3d local = transposed_times(shapes::rotation_matrix(wall.orientation), x - wall.position);
  return wall.kind == shapes::Kind::plane ? local.z : local.y;
}

std::int64_t cell_at(double v, double side) {
  constexpr double most = 1e18;  // within the integers
  return static_cast<std::int64_t>(std::clamp(std::floor(v / side), -most, most));
}

}  // namespace

std::size_t Occupancy::Hash::operator()(const Cell& c) const {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const std::int64_t v : {c.x, c.y, c.z})
    h = (h ^ static_cast<std::uint64_t>(v)) * 0xbf58476d1ce4e5b9u, h ^= h >> 29;
  return static_cast<std::size_t>(h);
}

Occupancy::Occupancy(const World& world, const Vec3d& lower, const Vec3d& upper) : lower_(lower), upper_(upper) {
  for (const Wall& w : world.walls)
    if (w.present && is_half_space(w.kind))
      half_spaces_.push_back(&w);
    else if (w.present)
      add_mesh(w);
  for (int k = 0; k < 3; ++k) period_[k] = world.cell.lattice.length[k];
  for (const Motion& m : world.particles.motion) add(m.position, m.bounding_radius);
}

void Occupancy::add(const Vec3d& x, double radius) {
  const auto images = [&](int k) { return period_[k] > 0 ? 1 : 0; };
  for (int i = -images(0); i <= images(0); ++i)
    for (int j = -images(1); j <= images(1); ++j)
      for (int k = -images(2); k <= images(2); ++k)
        add_image({x.x + i * period_.x, x.y + j * period_.y, x.z + k * period_.z}, radius);
}

void Occupancy::add_image(const Vec3d& x, double radius) {
  for (int k = 0; k < 3; ++k)
    if (!(x[k] + radius >= lower_[k] && x[k] - radius <= upper_[k])) return;
  file({x, radius, none});
}

void Occupancy::add_mesh(const Wall& wall) {
  const shapes::Mat3d frame = shapes::rotation_matrix(wall.orientation);
  for (std::size_t t = 0; t < wall.mesh->triangles.size(); t += 3) {
    std::array<Vec3d, 3> corner;
    for (std::size_t v = 0; v < 3; ++v)
      corner[v] = wall.position + frame * wall.mesh->vertices[wall.mesh->triangles[t + v]];
    const Vec3d centre = (corner[0] + corner[1] + corner[2]) * (1.0 / 3);
    double radius = 0;
    bool reaches = true;
    for (const Vec3d& v : corner) radius = std::max(radius, norm(v - centre));
    for (int k = 0; k < 3; ++k)
      reaches = reaches && std::max({corner[0][k], corner[1][k], corner[2][k]}) >= lower_[k] &&
                std::min({corner[0][k], corner[1][k], corner[2][k]}) <= upper_[k];
    if (!reaches || radius == 0) continue;
    file({centre, radius * (1 + 1e-9), static_cast<std::uint32_t>(triangles_.size())});
    triangles_.push_back(corner);
  }
}

void Occupancy::file(const Sphere& sphere) {
  const int l = std::ilogb(sphere.radius);
  Level& level = levels_[l];
  level.side = std::ldexp(1.0, l + 2);
  const auto at = [&](double v) { return cell_at(v, level.side); };
  level.cells[{at(sphere.x.x), at(sphere.x.y), at(sphere.x.z)}].push_back(
      static_cast<std::uint32_t>(level.spheres.size()));
  level.spheres.push_back(sphere);
}

bool Occupancy::overlaps(const Sphere& s, const Vec3d& x, double radius) const {
  const Vec3d d = s.x - x;
  const double reach = s.radius + radius;
  if (!(dot(d, d) < reach * reach)) return false;
  if (s.triangle == none) return true;
  const auto& [a, b, c] = triangles_[s.triangle];
  return distance2_to_triangle(a, b, c, x) < radius * radius;
}

bool Occupancy::meets(const Level& level, const Vec3d& x, double radius) const {
  const auto hit = [&](const Sphere& s) { return overlaps(s, x, radius); };
  const double reach = radius + 0.5 * level.side;
  std::int64_t low[3] = {}, high[3] = {};
  double number = 1;
  for (int k = 0; k < 3; ++k) {
    low[k] = cell_at(x[k] - reach, level.side);
    high[k] = cell_at(x[k] + reach, level.side);
    number *= static_cast<double>(high[k] - low[k] + 1);
  }
  if (number > static_cast<double>(level.spheres.size()))
    return std::any_of(level.spheres.begin(), level.spheres.end(), hit);
  for (std::int64_t i = low[0]; i <= high[0]; ++i)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      for (std::int64_t k = low[2]; k <= high[2]; ++k) {
        const auto cell = level.cells.find({i, j, k});
        if (cell == level.cells.end()) continue;
        for (const std::uint32_t s : cell->second)
          if (hit(level.spheres[s])) return true;
      }
  return false;
}

bool Occupancy::blocked(const Vec3d& x, double radius) const {
  for (const auto& [number, level] : levels_)
    if (meets(level, x, radius)) return true;
  return std::any_of(half_spaces_.begin(), half_spaces_.end(),
                     [&](const Wall* w) { return distance_to_half_space(*w, x) < radius; });
}

}  // namespace dem
