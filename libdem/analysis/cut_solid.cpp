#include "libdem/analysis/cut_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dem::analysis {

namespace {

// The stretch −c <= s <= c of a line at distance d from a centre lies in the circle: the piece of [s1, s2] in it.
struct Inside {
  double from, to;  // from >= to: none
};
Inside inside_of(double square, double s1, double s2) {
  if (!(square > 0)) return {s2, s2};
  const double c = std::sqrt(square);
  return {std::clamp(-c, s1, s2), std::clamp(c, s1, s2)};
}

// (1) for R = 1: outside of the ball; d >= 0.
double cone_outside(double h, double d, double s1, double s2) {
  if (!(s2 > s1)) return 0;
  // Differences of two angles, each as one.
  const double square = h * h + d * d;
  const double x1 = d * std::sqrt(square + s1 * s1), x2 = d * std::sqrt(square + s2 * s2), y1 = h * s1, y2 = h * s2;
  const double theta = std::atan2(d * (s2 - s1), d * d + s1 * s2);
  const double psi = std::atan2(y2 * x1 - y1 * x2, x1 * x2 + y1 * y2);
  if (h >= 1) return (theta - psi) / 3;
  if (h <= -1) return (-theta - psi) / 3;
  return theta * h * (3 - h * h) / 6 - psi / 3;
}

double cone_over_edge(double h, double d, double s1, double s2) {
  const double a = std::fabs(d);
  const Inside in = inside_of((1 - h * h) - d * d, s1, s2);
  double sum = 0;
  if (in.from < in.to) sum += h * a * (in.to - in.from) / 6;
  if (in.from < in.to)
    sum += cone_outside(h, a, s1, in.from) + cone_outside(h, a, in.to, s2);
  else
    sum += cone_outside(h, a, s1, s2);
  return d < 0 ? -sum : sum;
}

struct CapEdge {
  Vec3d from, to;
};

}  // namespace

CutSolid CutSolid::box(const Vec3d& lower, const Vec3d& upper) {
  CutSolid s;
  const auto corner = [&](int x, int y, int z) {
    return Vec3d{x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z};
  };
  const auto face = [&](const Vec3d& n, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    s.add_face(n, std::array{a, b, c, d});
  };
  face({-1, 0, 0}, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  face({1, 0, 0}, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  face({0, -1, 0}, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  face({0, 1, 0}, corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  face({0, 0, -1}, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  face({0, 0, 1}, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  return s;
}

CutSolid CutSolid::of(const shapes::Polyhedron& p) {
  CutSolid s;
  std::vector<Vec3d> loop;
  for (const auto& f : p.faces) {
    loop.clear();
    for (std::uint32_t i = 0; i < f.count; ++i) loop.push_back(p.vertices[p.face_vertices[f.first + i]]);
    s.add_face(f.normal, loop);
  }
  return s;
}

CutSolid CutSolid::prism(std::span<const Vec3d> loop, const Vec3d& normal, double height) {
  CutSolid s;
  const std::size_t n = loop.size();
  std::vector<Vec3d> top, bottom;
  for (const Vec3d& v : loop) top.push_back(v + height * normal);
  bottom.assign(loop.rbegin(), loop.rend());
  s.add_face(-normal, bottom);
  s.add_face(normal, top);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec3d outward = normalized(cross(loop[j] - loop[i], normal));
    s.add_face(outward, std::array{loop[i], loop[j], top[j], top[i]});
  }
  return s;
}

void CutSolid::add_face(const Vec3d& normal, std::span<const Vec3d> loop) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  for (const Vec3d& v : loop)
    if (corners_.size() == first || !(corners_.back() == v)) corners_.push_back(v);
  while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
  const auto count = static_cast<std::uint32_t>(corners_.size()) - first;
  if (count < 3)
    corners_.resize(first);
  else
    faces_.push_back({normal, first, count});
}

void CutSolid::cut(const Vec3d& normal, double offset) {
  const auto height = [&](const Vec3d& v) { return dot(normal, v) - offset; };
  bool any_out = false, any_in = false;
  for (const Vec3d& v : corners_) (height(v) > 0 ? any_out : any_in) = true;
  if (!any_out) return;
  if (!any_in) {
    corners_.clear();
    faces_.clear();
    return;
  }
  CutSolid kept;
  kept.corners_.reserve(corners_.size() + 8);
  kept.faces_.reserve(faces_.size() + 1);
  std::vector<CapEdge> cap;
  // Corners where a loop leaves and comes back; the first to come back may stand before the first to leave.
  std::vector<Vec3d> loop, leave, enter;
  for (const Face& f : faces_) {
    loop.clear();
    leave.clear();
    enter.clear();
    const std::span<const Vec3d> c = corners(f);
    bool enter_first = false;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec3d &a = c[i], &b = c[i + 1 == c.size() ? 0 : i + 1];
      const double ha = height(a), hb = height(b);
      if (!(ha > 0)) loop.push_back(a);
      if ((ha > 0) == (hb > 0)) continue;
      // Always from the corner inside: the neighbouring face finds the same bits.
      const Vec3d x = ha > 0 ? b + (a - b) * (hb / (hb - ha)) : a + (b - a) * (ha / (ha - hb));
      loop.push_back(x);
      if (ha > 0) {
        if (leave.empty()) enter_first = true;
        enter.push_back(x);
      } else {
        leave.push_back(x);
      }
    }
    kept.add_face(f.normal, loop);
    if (enter_first) std::rotate(enter.begin(), enter.begin() + 1, enter.end());
    for (std::size_t i = 0; i < leave.size(); ++i)
      if (!(leave[i] == enter[i])) cap.push_back({enter[i], leave[i]});
  }
  while (!cap.empty()) {
    loop.assign(1, cap.back().from);
    Vec3d at = cap.back().to;
    cap.pop_back();
    while (!(at == loop[0])) {
      loop.push_back(at);
      const auto next = std::find_if(cap.begin(), cap.end(), [&](const CapEdge& e) { return e.from == at; });
      if (next == cap.end()) break;
      at = next->to;
      cap.erase(next);
    }
    kept.add_face(normal, loop);
  }
  *this = std::move(kept);
}

void CutSolid::move(const Vec3d& by) {
  for (Vec3d& v : corners_) v += by;
}

double CutSolid::volume() const {
  if (faces_.empty()) return 0;
  const Vec3d apex = corners_[0];
  double sum = 0;
  for (const Face& f : faces_) {
    const std::span<const Vec3d> c = corners(f);
    for (std::size_t i = 1; i + 1 < c.size(); ++i) sum += dot(c[0] - apex, cross(c[i] - apex, c[i + 1] - apex));
  }
  return std::max(0.0, sum / 6);
}

RoundFrame round_frame(const Vec3d& centre, const Mat3d& axes, const Vec3d& semi_axes) {
  RoundFrame f;
  f.centre = centre;
  for (int i = 0; i < 3; ++i) {
    f.map.row[i] = axes.column(i) * (1 / semi_axes[i]);
    f.inverse.row[i] = scaled(axes.row[i], semi_axes);
  }
  f.volume_scale = 1 / (semi_axes.x * semi_axes.y * semi_axes.z);
  return f;
}

double volume_in_ball(const CutSolid& solid, const RoundFrame& frame) {
  double sum = 0;
  std::vector<Vec3d> at;
  for (const CutSolid::Face& f : solid.faces()) {
    at.clear();
    for (const Vec3d& v : solid.corners(f)) at.push_back(frame.map * (v - frame.centre));
    const Vec3d n = normalized(transposed_times(frame.inverse, f.normal));
    const double h = dot(n, at[0]);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Vec3d &p = at[i], &q = at[i + 1 == at.size() ? 0 : i + 1];
      const Vec3d edge = q - p;
      const double length = norm(edge);
      if (!(length > 0)) continue;
      const Vec3d e = edge * (1 / length);
      const double s = dot(p, e);
      sum += cone_over_edge(h, dot(p, cross(e, n)), s, s + length);
    }
  }
  return std::clamp(sum, 0.0, 4 * std::numbers::pi / 3) / frame.volume_scale;
}

void add_edge_in_disc(double px, double py, double qx, double qy, double radius, DiscSums& sums) {
  const double ex = qx - px, ey = qy - py, length = std::sqrt(ex * ex + ey * ey);
  if (!(length > 0)) return;
  const double ux = ex / length, uy = ey / length;
  const double d = px * uy - py * ux, s1 = px * ux + py * uy, s2 = s1 + length;  // d > 0: the origin on the left
  const auto triangle = [&](double from, double to) {
    const double area = 0.5 * d * (to - from), mid = from + to;
    sums.area += area;
    sums.x += area / 3 * (2 * d * uy + mid * ux);
    sums.y += area / 3 * (-2 * d * ux + mid * uy);
  };
  const auto sector = [&](double from, double to) {
    const double r1 = std::sqrt(d * d + from * from), r2 = std::sqrt(d * d + to * to);
    if (!(to > from) || !(r1 > 0) || !(r2 > 0)) return;
    const double ax = (d * uy + from * ux) / r1, ay = (-d * ux + from * uy) / r1;
    const double bx = (d * uy + to * ux) / r2, by = (-d * ux + to * uy) / r2;
    sums.area += 0.5 * radius * radius * std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    const double third = radius * radius * radius / 3;
    sums.x += third * (by - ay);
    sums.y += third * (ax - bx);
  };
  const Inside in = inside_of(radius * radius - d * d, s1, s2);
  if (in.from < in.to) {
    sector(s1, in.from);
    triangle(in.from, in.to);
    sector(in.to, s2);
  } else {
    sector(s1, s2);
  }
}

double volume_in_cylinder(const CutSolid& solid, const Vec3d& point, const Vec3d& along, double radius) {
  constexpr double parallel = 1e-8;  // below, the height of a face along w is taken for one value
  Vec3d tu, tv;
  tangent_frame(along, tu, tv);
  double sum = 0;
  for (const CutSolid::Face& f : solid.faces()) {
    const std::span<const Vec3d> c = solid.corners(f);
    const double nw = dot(f.normal, along), level = dot(f.normal, c[0] - point);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Vec3d& v : c) {
      lowest = std::min(lowest, dot(v - point, along));
      highest = std::max(highest, dot(v - point, along));
    }
    // In the cylinder the face's plane lies at the heights (level ± reach)/nw: a steep face that is not there would
    // give a small difference of large numbers.
    const double reach = radius * (std::sqrt(std::max(0.0, 1 - nw * nw)) + 1e-6);
    const double one = nw * lowest, other = nw * highest;
    if (level - reach > std::max(one, other) || level + reach < std::min(one, other)) continue;
    DiscSums in;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec3d p = c[i] - point, q = c[i + 1 == c.size() ? 0 : i + 1] - point;
      add_edge_in_disc(dot(p, tu), dot(p, tv), dot(q, tu), dot(q, tv), radius, in);
    }
    if (std::fabs(nw) < parallel)
      sum += 0.5 * (lowest + highest) * in.area;
    else
      sum += (level * in.area - dot(f.normal, tu) * in.x - dot(f.normal, tv) * in.y) / nw;
  }
  return std::max(0.0, sum);
}

}  // namespace dem::analysis
