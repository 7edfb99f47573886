#include "libdem/analysis/walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/table.h"
#include "libdem/analysis/wall_profile.h"
#include "libdem/mesh_triangles.h"

namespace dem::analysis {

namespace {

using shapes::Kind;

std::vector<WallPatch> sides_of(const Snapshot& s, const SnapshotWall& wall) {
  const shapes::Polygon& p = *wall.polygon;
  std::vector<WallPatch> list(p.vertices.size());
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    const Vec3d &a = p.vertices[i], &b = p.vertices[p.next(i)];
    list[i].centre = wall.position + rotate(wall.orientation, (a + b) * 0.5);
    list[i].area = norm(b - a) * s.thickness;
  }
  return list;
}

std::size_t side_at(const shapes::Polygon& p, const Vec3d& x) {
  std::size_t best = 0;
  double nearest = -1;
  for (std::uint32_t i = 0; i < p.vertices.size(); ++i) {
    const Vec3d &a = p.vertices[i], d = p.vertices[p.next(i)] - a;
    const double t = std::clamp(dot(x - a, d) / dot(d, d), 0.0, 1.0);
    const double away = norm(x - a - d * t);
    if (nearest >= 0 && away >= nearest) continue;
    nearest = away;
    best = i;
  }
  return best;
}

std::vector<WallPatch> triangles_of(const SnapshotWall& wall) {
  std::vector<WallPatch> list(wall.mesh->triangles.size() / 3);
  for (std::size_t t = 0; t < list.size(); ++t) {
    const auto corner = corners_of(*wall.mesh, t);
    list[t].centre = wall.position + rotate(wall.orientation, (corner[0] + corner[1] + corner[2]) * (1.0 / 3));
    list[t].area = area_of(corner);
  }
  return list;
}

std::vector<WallPatch> squares_on(const Snapshot& s, const SnapshotWall& wall, const std::array<Extent, 2>& range,
                                  const std::array<int, 2>& squares) {
  std::vector<WallPatch> list;
  const double du = range[0].width() / squares[0], dv = range[1].width() / squares[1];
  for (int j = 0; j < squares[1]; ++j)
    for (int i = 0; i < squares[0]; ++i) {
      const double v = wall.kind == Kind::line ? 0 : range[1].low + (j + 0.5) * dv;
      WallPatch p;
      p.centre = wall.position + rotate(wall.orientation, Vec3d{range[0].low + (i + 0.5) * du, v, 0});
      p.area = du * (wall.kind == Kind::line ? s.thickness : dv);
      list.push_back(p);
    }
  return list;
}

std::size_t square_at(const std::array<Extent, 2>& range, const std::array<int, 2>& squares, bool line,
                      const Vec3d& x) {
  const auto along = [&](std::size_t axis, double value) {
    const double place = std::floor((value - range[axis].low) / range[axis].width() * squares[axis]);
    return static_cast<std::size_t>(std::clamp(place, 0.0, squares[axis] - 1.0));
  };
  const std::size_t i = range[0].width() > 0 ? along(0, x.x) : 0;
  const std::size_t j = !line && range[1].width() > 0 ? along(1, x.y) : 0;
  return i + static_cast<std::size_t>(squares[0]) * j;
}

}  // namespace

std::array<Extent, 2> seen_from(const SnapshotWall& wall, const Domain& region) {
  std::array<Extent, 2> range;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Vec3d e = rotation_matrix(wall.orientation).column(static_cast<int>(axis));
    double middle = dot(e, (region.lower + region.upper) * 0.5 - wall.position), half = 0;
    for (int k = 0; k < 3; ++k) half += 0.5 * std::abs(e[k]) * (region.upper[k] - region.lower[k]);
    range[axis] = {middle - half, middle + half};
  }
  return range;
}

std::vector<WallForce> wall_forces(const Snapshot& s) {
  std::vector<WallForce> list(s.walls.size());
  for (const SnapshotContact& c : s.contacts) {
    if (!c.wall) continue;
    WallForce& w = list[c.b];
    w.force -= c.force;
    w.torque -= cross(c.point - s.walls[c.b].position, c.force);
    w.pressing += c.pressing();
  }
  for (const Pair& p : pairs_of(s).walls) ++list[p.b].contacts;
  return list;
}

std::array<int, 2> squares_of(const Snapshot& s, std::size_t wall, const Domain& region, double side) {
  const std::array<Extent, 2> range = seen_from(s.walls[wall], region);
  const auto count = [side](const Extent& r) {
    return side > 0 ? static_cast<int>(std::clamp(std::round(r.width() / side), 1.0, 256.0)) : 1;
  };
  return {count(range[0]), s.walls[wall].kind == Kind::line ? 1 : count(range[1])};
}

std::vector<WallPatch> wall_map(const Snapshot& s, std::size_t place, const Domain& region,
                                const std::array<int, 2>& squares) {
  const SnapshotWall& wall = s.walls[place];
  const std::array<Extent, 2> range = seen_from(wall, region);
  const bool outline = wall.polygon != nullptr, mesh = !outline && wall.mesh != nullptr;
  std::vector<WallPatch> map = outline ? sides_of(s, wall)
                               : mesh  ? triangles_of(wall)
                                       : squares_on(s, wall, range, squares);
  const Mat3d frame = rotation_matrix(wall.orientation);
  for (const SnapshotContact& c : s.contacts) {
    if (!c.wall || c.b != place) continue;
    const Vec3d x = transposed_times(frame, c.point - wall.position);
    std::size_t at = 0;
    if (outline) {
      at = side_at(*wall.polygon, x);
    } else if (mesh) {
      if (c.part >= wall.mesh->facets.size()) continue;
      at = triangle_at(*wall.mesh, c.part, x);
    } else {
      at = square_at(range, squares, wall.kind == Kind::line, x);
    }
    map[at].pressing += c.pressing();
    map[at].force -= c.force;
    map[at].tangential -= c.force + c.normal * c.pressing();
  }
  return map;
}

Result report_walls(const Snapshot& s, const Settings& settings) {
  Result r;
  if (lacks_forces(s, r)) return r;
  r.notes.emplace_back(s.walls.empty() ? "no walls" : "torques of the forces alone, without couples of contacts");
  const Domain region = region_of(s, settings);
  double diameter = 0;
  for (const double radius : s.radius) diameter += 2 * radius / static_cast<double>(s.count());
  const std::vector<WallForce> forces = wall_forces(s);
  for (std::size_t k = 0; k < s.walls.size(); ++k) {
    const SnapshotWall& wall = s.walls[k];
    if (!wall.present) {
      r.notes.push_back(fmt::format("wall {}: not present", wall.name));
      continue;
    }
    const WallForce& w = forces[k];
    const std::string word = file_word(wall.name);
    r.add(word + "_contacts", "1", static_cast<double>(w.contacts));
    for (int i = 0; i < s.dimension; ++i) r.add(word + "_force_" + "xyz"[i], "N", w.force[i]);
    for (int i = s.dimension == 2 ? 2 : 0; i < 3; ++i) r.add(word + "_torque_" + "xyz"[i], "N m", w.torque[i]);
    r.add(word + "_normal_force", "N", w.pressing);
    std::array<int, 2> squares = squares_of(s, k, region, 4 * diameter);
    for (std::size_t i = 0; i < 2; ++i)
      if (settings.boxes[i] > 0 && (i == 0 || wall.kind != Kind::line)) squares[i] = settings.boxes[i];
    Table t = table_of("map_" + word, "Pressure of bodies on " + wall.name + " now",
                       {{"x", "m"},
                        {"y", "m"},
                        {"z", "m"},
                        {"area", "m^2"},
                        {"pressure", "Pa"},
                        {"traction_x", "Pa"},
                        {"traction_y", "Pa"},
                        {"traction_z", "Pa"},
                        {"shear", "Pa"}});
    double area = 0, mapped = 0, largest = 0;
    for (const WallPatch& p : wall_map(s, k, region, squares)) {
      area += p.area;
      mapped += p.pressing;
      if (!(p.area > 0)) continue;
      const Vec3d f = p.force * (1 / p.area);
      largest = std::max(largest, p.pressing / p.area);
      add_row(t, p.centre.x, p.centre.y, p.centre.z, p.area, p.pressing / p.area, f.x, f.y, f.z,
              norm(p.tangential) / p.area);
    }
    if (area > 0) {
      r.add(word + "_pressure", "Pa", w.pressing / area);
      r.add(word + "_largest_pressure", "Pa", largest);
    }
    if (std::abs(mapped - w.pressing) > 1e-9 * std::abs(w.pressing))
      r.notes.push_back(
          fmt::format("wall {}: some contacts are of no facet of its mesh and not in the map", wall.name));
    r.tables.push_back(std::move(t));
    if (Table profile = profile_table(s, k, region, 2 * diameter); !profile.columns[0].values.empty())
      r.tables.push_back(std::move(profile));
  }
  if (s.periodic[0] || s.periodic[1] || s.periodic[2])
    r.notes.emplace_back("torques: of the bodies where they stand in the cell, not of their images");
  return r;
}

}  // namespace dem::analysis
