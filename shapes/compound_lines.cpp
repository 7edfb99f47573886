// Moments of a union of convex parts of any kinds: along x the union is a set of intervals, exact; across y and z
// adaptive quadrature, one inside the other.
#include <algorithm>
#include <cmath>

#include "shapes/compound_parts.h"
#include "shapes/quadrature.h"

namespace shapes::compound {
namespace {

using Kind = Compound::PartKind;
using Interval = std::pair<double, double>;

// The part of the line (·, y, z) in the part; false: none.
bool on_line(const Part& p, double y, double z, Interval& out) {
  if (p.kind == Kind::polyhedron) {
    double from = -4, to = 4;  // lengths are below 1
    for (const auto& f : p.solid.faces) {
      const double rest = f.offset - f.normal.y * y - f.normal.z * z;
      if (f.normal.x > 0)
        to = std::min(to, rest / f.normal.x);
      else if (f.normal.x < 0)
        from = std::max(from, rest / f.normal.x);
      else if (rest < 0)
        return false;
    }
    out = {from, to};
    return from < to;
  }
  const auto unit = [&](const Vec3d& v) {
    const Vec3d b = transposed_times(p.rotation, v);
    return Vec3d{b.x / p.size.x, b.y / p.size.y, b.z / p.size.z};
  };
  const Vec3d o = unit(Vec3d{0, y - p.centre.y, z - p.centre.z}), d = unit({1, 0, 0});
  const double dd = dot(d, d), middle = -dot(o, d) / dd;
  const Vec3d foot = o + middle * d;
  const double rest = 1 - dot(foot, foot);
  if (!(rest > 0)) return false;
  const double half = std::sqrt(rest / dd);
  out = {p.centre.x + middle - half, p.centre.x + middle + half};
  return true;
}

// Where the section of a part at height z begins and ends along y; false: it has none.
bool section(const Part& p, double z, Interval& out) {
  if (p.kind == Kind::polyhedron) {
    out = {4, -4};
    for (const auto& e : p.solid.edges) {
      const Vec3d &a = p.solid.vertices[e.vertex[0]], &b = p.solid.vertices[e.vertex[1]];
      if ((a.z < z) == (b.z < z)) continue;
      const double y = a.y + (z - a.z) / (b.z - a.z) * (b.y - a.y);
      out = {std::min(out.first, y), std::max(out.second, y)};
    }
    return out.first < out.second;
  }
  // C = R diag(size²) Rᵀ: y = c + Cyz/Czz h ± sqrt((Cyy − Cyz²/Czz)(1 − h²/Czz))
  const Vec3d ry = scaled(p.rotation.row[1], p.size), rz = scaled(p.rotation.row[2], p.size);
  const double zz = dot(rz, rz), yz = dot(ry, rz), h = z - p.centre.z, rest = 1 - h * h / zz;
  if (!(rest > 0)) return false;
  const double middle = p.centre.y + yz / zz * h, half = std::sqrt((dot(ry, ry) - yz * yz / zz) * rest);
  out = {middle - half, middle + half};
  return true;
}

}  // namespace

Moments moments_by_lines(const std::vector<const Part*>& parts) {
  double volume = 0;
  std::vector<double> heights, ends;
  for (const Part* p : parts) {
    double box = 0.5;
    for (const Vec3d& n : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) box *= highest(*p, n) - lowest(*p, n);
    volume = std::max(volume, box);
    heights.insert(heights.end(), {lowest(*p, {0, 0, 1}), highest(*p, {0, 0, 1})});
    for (const Vec3d& v : p->solid.vertices) heights.push_back(v.z);
  }
  std::sort(heights.begin(), heights.end());
  const double height = heights.back() - heights.front();

  std::vector<Interval> intervals;
  double z = 0;
  const auto on = [&](double y) {
    intervals.clear();
    Interval found{};
    for (const Part* p : parts)
      if (on_line(*p, y, z, found)) intervals.push_back(found);
    std::sort(intervals.begin(), intervals.end());
    double one = 0, x = 0, xx = 0, end = -4;
    for (const auto& [from, to] : intervals) {
      const double a = std::max(from, end);
      if (!(to > a)) continue;
      end = to;
      one += to - a;
      x += 0.5 * (to - a) * (to + a);
      xx += (to - a) / 3 * (to * to + to * a + a * a);
    }
    return std::array<double, 10>{one, x, y * one, z * one, xx, y * y * one, z * z * one, y * z * one, z * x, y * x};
  };
  std::array<double, 10> fine, tolerance, sum{};
  fine.fill(1e-8 * volume / height);
  tolerance.fill(1e-6 * volume);
  const auto across = [&](double at) {
    z = at;
    ends.clear();
    Interval found{};
    for (const Part* p : parts)
      if (section(*p, z, found)) ends.insert(ends.end(), {found.first, found.second});
    std::sort(ends.begin(), ends.end());
    std::array<double, 10> slice{};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (ends[i] < ends[i + 1]) integrate(on, ends[i], ends[i + 1], ends.back() - ends.front(), fine, 12, slice);
    return slice;
  };
  double error = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    if (heights[i] < heights[i + 1]) error += integrate(across, heights[i], heights[i + 1], height, tolerance, 12, sum);
  return {sum[0], {sum[1], sum[2], sum[3]}, {sum[4], sum[5], sum[6]}, {sum[7], sum[8], sum[9]}, error * tolerance[0]};
}

}  // namespace shapes::compound
