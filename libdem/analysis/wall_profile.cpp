#include "libdem/analysis/wall_profile.h"

#include <algorithm>
#include <cmath>

#include "libdem/analysis/groups.h"
#include "libdem/analysis/table.h"
#include "libdem/analysis/walls.h"
#include "libdem/mesh_triangles.h"

namespace dem::analysis {

namespace {

// A convex flat piece of a wall, or a length of a line of the plane.
struct Piece {
  std::vector<Vec3d> corners;
  double area = 0;
};

double area_of_outline(const std::vector<Vec3d>& corners) {
  Vec3d sum{};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * norm(sum);
}

std::vector<Piece> pieces_of(const Snapshot& s, const SnapshotWall& wall, const Domain& region) {
  std::vector<Piece> list;
  const auto world = [&](const Vec3d& x) { return wall.position + rotate(wall.orientation, x); };
  const auto add_length = [&](const Vec3d& a, const Vec3d& b) {
    list.push_back({{world(a), world(b)}, norm(b - a) * s.thickness});
  };
  if (wall.polygon != nullptr) {
    const auto& v = wall.polygon->vertices;
    for (std::uint32_t i = 0; i < v.size(); ++i) add_length(v[i], v[wall.polygon->next(i)]);
  } else if (wall.mesh != nullptr) {
    for (std::size_t t = 0; t < wall.mesh->triangles.size() / 3; ++t) {
      const auto corner = corners_of(*wall.mesh, t);
      list.push_back({{world(corner[0]), world(corner[1]), world(corner[2])}, area_of(corner)});
    }
  } else {
    const auto [along, across] = seen_from(wall, region);
    if (wall.kind == shapes::Kind::line) {
      add_length({along.low, 0, 0}, {along.high, 0, 0});
    } else {
      list.push_back({{world({along.low, across.low, 0}), world({along.high, across.low, 0}),
                       world({along.high, across.high, 0}), world({along.low, across.high, 0})},
                      along.width() * across.width()});
    }
  }
  return list;
}

// Area of the piece below a height: by the part of its outline there.
double area_below(const Piece& piece, const std::vector<double>& height, double level) {
  const std::size_t n = height.size();
  if (n == 2) {
    const double low = std::min(height[0], height[1]), high = std::max(height[0], height[1]);
    if (level >= high) return piece.area;
    return level <= low ? 0 : piece.area * (level - low) / (high - low);
  }
  if (std::all_of(height.begin(), height.end(), [&](double h) { return h < level; })) return piece.area;
  std::vector<Vec3d> part;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    if (height[i] < level) part.push_back(piece.corners[i]);
    if ((height[i] < level) != (height[j] < level))
      part.push_back(piece.corners[i] +
                     (piece.corners[j] - piece.corners[i]) * ((level - height[i]) / (height[j] - height[i])));
  }
  return area_of_outline(part);
}

}  // namespace

std::vector<WallBand> wall_profile(const Snapshot& s, std::size_t place, const Domain& region, double height) {
  const SnapshotWall& wall = s.walls[place];
  const Vec3d up = upward(s);
  double low = 0, high = 0;
  for (int k = 0; k < 3; ++k) {
    low += std::min(up[k] * region.lower[k], up[k] * region.upper[k]);
    high += std::max(up[k] * region.lower[k], up[k] * region.upper[k]);
  }
  const auto count = static_cast<std::size_t>(std::clamp(std::round((high - low) / height), 0.0, 10000.0));
  if (!(height > 0) || count < 2) return {};
  std::vector<WallBand> bands(count);
  const double step = (high - low) / static_cast<double>(count);
  const auto level = [&](std::size_t k) { return k == count ? high : low + static_cast<double>(k) * step; };
  for (std::size_t k = 0; k < count; ++k) bands[k] = {level(k), level(k + 1), 0, 0, 0};
  for (const Piece& piece : pieces_of(s, wall, region)) {
    std::vector<double> at;
    for (const Vec3d& x : piece.corners) at.push_back(dot(up, x));
    const auto [least, most] = std::minmax_element(at.begin(), at.end());
    double below = area_below(piece, at, low);
    for (std::size_t k = 0; k < count; ++k) {
      if (bands[k].to < *least || bands[k].from > *most) continue;
      const double to_here = area_below(piece, at, bands[k].to);
      bands[k].area += std::max(to_here - below, 0.0);
      below = to_here;
    }
  }
  std::size_t first = count, last = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!(bands[k].area > 0)) continue;
    first = std::min(first, k);
    last = k;
  }
  if (last < first + 1) return {};
  for (const SnapshotContact& c : s.contacts) {
    if (!c.wall || c.b != place) continue;
    const double k = std::floor((dot(up, c.point) - low) / step);
    WallBand& band =
        bands[static_cast<std::size_t>(std::clamp(k, static_cast<double>(first), static_cast<double>(last)))];
    band.pressing += c.pressing();
    band.across += norm(c.force + c.normal * c.pressing());
  }
  std::erase_if(bands, [](const WallBand& b) { return !(b.area > 0); });
  return bands;
}

Table profile_table(const Snapshot& s, std::size_t wall, const Domain& region, double height) {
  Table t = table_of(
      "height_" + file_word(s.walls[wall].name), "Pressure of bodies on " + s.walls[wall].name + " over height",
      {{"height", "m"}, {"from", "m"}, {"to", "m"}, {"area", "m^2"}, {"pressure", "Pa"}, {"shear", "Pa"}});
  for (const WallBand& b : wall_profile(s, wall, region, height))
    add_row(t, 0.5 * (b.from + b.to), b.from, b.to, b.area, b.pressing / b.area, b.across / b.area);
  return t;
}

}  // namespace dem::analysis
