#include "shapes/cells.h"

#include <algorithm>

#include "shapes/convex.h"

namespace shapes::convex {
namespace {

// Heights over the plane, those within rounding of it set to 0.
std::vector<double> heights(const Outline& polygon, const Vec3d& normal, double offset) {
  std::vector<double> h;
  for (const Vec3d& x : polygon) {
    const double v = dot(normal, x) - offset;
    h.push_back(std::fabs(v) <= cell_tolerance ? 0 : v);
  }
  return h;
}

Outline kept_part(const Outline& polygon, const std::vector<double>& h) {
  Outline kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (h[i] <= 0) kept.push_back(polygon[i]);
    if ((h[i] < 0 && h[j] > 0) || (h[i] > 0 && h[j] < 0))
      kept.push_back(polygon[i] + (h[i] / (h[i] - h[j])) * (polygon[j] - polygon[i]));
  }
  return kept;
}

// Grows with the angle of (x, y), from 0 to 4.
double angle_of(double x, double y) {
  const double sum = std::fabs(x) + std::fabs(y);
  if (!(sum > 0)) return 0;
  const double share = y / sum;
  return x < 0 ? 2 - share : (y < 0 ? 4 + share : share);
}

// Points of a plane in order about their middle, counter-clockwise seen against the normal.
Outline ordered(const std::vector<Vec3d>& points, const Vec3d& normal) {
  Vec3d middle{}, u, v;
  for (const Vec3d& x : points) middle += x;
  middle *= 1.0 / static_cast<double>(points.size());
  tangent_frame(normal, u, v);
  std::vector<std::pair<double, Vec3d>> around;
  for (const Vec3d& x : points) around.emplace_back(angle_of(dot(u, x - middle), dot(v, x - middle)), x);
  std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Outline loop;
  for (const auto& [angle, x] : around)
    if (loop.empty() || max_abs(x - loop.back()) > cell_tolerance) loop.push_back(x);
  while (loop.size() > 1 && max_abs(loop.front() - loop.back()) <= cell_tolerance) loop.pop_back();
  return loop;
}

}  // namespace

Cell cell_of(const Polyhedron& p) {
  Cell cell;
  for (const auto& f : p.faces) {
    Outline loop;
    for (std::uint32_t k = 0; k < f.count; ++k) loop.push_back(p.vertices[p.face_vertices[f.first + k]]);
    cell.faces.push_back(std::move(loop));
  }
  return cell;
}

Outline part_below(const Outline& polygon, const Vec3d& normal, double offset) {
  Outline kept = kept_part(polygon, heights(polygon, normal, offset));
  return kept.size() >= 3 ? kept : Outline{};
}

Cell part_below(const Cell& cell, const Vec3d& normal, double offset) {
  double highest = -1, lowest = 1;
  for (const Outline& face : cell.faces)
    for (const double h : heights(face, normal, offset)) {
      highest = std::fmax(highest, h);
      lowest = std::fmin(lowest, h);
    }
  if (highest <= 0) return cell;
  if (lowest >= 0) return {};
  Cell kept;
  std::vector<Vec3d> rim;
  for (const Outline& face : cell.faces) {
    const std::vector<double> h = heights(face, normal, offset);
    Outline part = kept_part(face, h);
    for (const Vec3d& x : part)
      if (std::fabs(dot(normal, x) - offset) <= 2 * cell_tolerance) rim.push_back(x);
    const bool flat = std::all_of(h.begin(), h.end(), [](double v) { return v >= 0; });  // touches the plane only
    if (part.size() >= 3 && !flat) kept.faces.push_back(std::move(part));
  }
  Outline cap = ordered(rim, normal);
  if (cap.size() >= 3) kept.faces.push_back(std::move(cap));
  return kept;
}

Cell intersection(Cell cell, const Polyhedron& p) {
  for (const auto& f : p.faces) {
    if (cell.faces.empty()) break;
    cell = part_below(cell, f.normal, f.offset);
  }
  return cell;
}

std::vector<Cell> difference(const Cell& cell, const Polyhedron& p) {
  if (!(volume_of(intersection(cell, p)) > 0)) return {cell};
  std::vector<Cell> pieces;
  Cell rest = cell;
  for (const auto& f : p.faces) {
    Cell outside = part_below(rest, -f.normal, -f.offset);
    if (volume_of(outside) > 0) pieces.push_back(std::move(outside));
    rest = part_below(rest, f.normal, f.offset);
  }
  return pieces;
}

std::vector<Cell> disjoint_cells(const std::vector<const Polyhedron*>& parts) {
  std::vector<Cell> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<Cell> own{cell_of(*parts[i])};
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<Cell> left;
      for (const Cell& cell : own)
        for (Cell& piece : difference(cell, *parts[j])) left.push_back(std::move(piece));
      own = std::move(left);
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

MassProperties mass_of(const Cell& cell) {
  std::vector<Vec3d> vertices;
  std::vector<Loop> loops;
  for (const Outline& face : cell.faces) {
    Loop loop;
    for (const Vec3d& x : face) {
      loop.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(x);
    }
    loops.push_back(std::move(loop));
  }
  if (vertices.empty()) return {};
  return mass_of(vertices, loops);
}

double volume_of(const Cell& cell) {
  const double volume = cell.faces.size() < 4 ? 0 : mass_of(cell).volume;
  return volume > 1e-14 ? volume : 0;  // slivers of rounding
}

double area_of(const Outline& polygon) {
  Vec3d sum{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * norm(sum);
}

}  // namespace shapes::convex
