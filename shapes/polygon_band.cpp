#include "shapes/polygon_band.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "shapes/convex.h"
#include "shapes/polygon_build.h"
#include "shapes/polygon_parts.h"
#include "shapes/polyhedron_build.h"

namespace shapes {

namespace {

constexpr std::uint32_t none = Polygon::none;

struct Joint {
  Vec3d x;
  std::size_t given;  // its place in the chain as given, for messages
};

std::string text(double metres) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", metres);
  return buffer;
}

double turn(const Vec3d& a, const Vec3d& b) { return convex::accurate_cross(a, b).z; }

class Band {
 public:
  Band(std::span<const Vec3d> chain, double depth, bool closed) : closed_(closed) {
    take(chain, depth);
    drop_idle_joints();
    direct();
    offset();
    check_sides();
    check_bands();
  }

  Polygon polygon() const {
    const std::size_t m = chain_.size();
    Polygon p;
    for (std::size_t k = m; k-- > 0;) p.vertices.push_back(chain_[k].x);
    p.vertices.insert(p.vertices.end(), back_.begin(), back_.end());
    p.second_border = static_cast<std::uint32_t>(closed_ ? m : 2 * m);
    if (sides() == 1) {
      p = polygon_from_outline(p.vertices);
      to_units(p, exponent_);
      return p;
    }
    add_edges(p);
    for (std::size_t k = 0; k < sides(); ++k) add_part(p, k);
    for (std::size_t k = closed_ ? 0 : 1; k < sides(); ++k) {
      const bool towards_bodies = turn(direction_[before(k)], direction_[k]) > 0;
      p.seams.push_back({{static_cast<std::uint32_t>(before(k)), static_cast<std::uint32_t>(k)},
                         {chain_[k].x, back_[k]},
                         {towards_bodies ? front(k) : rear(k), none}});
    }
    add_moments(p);
    to_units(p, exponent_);
    return p;
  }

 private:
  std::size_t sides() const { return chain_.size() - (closed_ ? 0 : 1); }
  std::size_t next(std::size_t k) const { return k + 1 == chain_.size() ? 0 : k + 1; }
  std::size_t before(std::size_t k) const { return k == 0 ? chain_.size() - 1 : k - 1; }
  // Vertices of the polygon, and the edges that begin there.
  std::uint32_t front(std::size_t k) const { return static_cast<std::uint32_t>(chain_.size() - 1 - k); }
  std::uint32_t rear(std::size_t k) const { return static_cast<std::uint32_t>(chain_.size() + k); }
  std::string side_name(std::size_t k) const {
    return "the side from vertex " + std::to_string(chain_[k].given) + " to " + std::to_string(chain_[next(k)].given);
  }

  void take(std::span<const Vec3d> given, double depth) {
    const std::size_t least = closed_ ? 3 : 2;
    if (given.size() < least)
      throw Error("chain: " + std::to_string(given.size()) + " vertices: allowed at least " + std::to_string(least));
    for (const Vec3d& v : given)
      if (!std::isfinite(v.x) || !std::isfinite(v.y)) throw Error("chain: a vertex is not finite");
    if (!(depth > 0) || !std::isfinite(depth)) throw Error("chain: depth: allowed > 0");
    exponent_ = convex::exponent_above(std::max(convex::largest_coordinate(given), depth));
    depth_ = std::ldexp(depth, -exponent_);
    for (std::size_t k = 0; k < given.size(); ++k)
      chain_.push_back({convex::times_two_to({given[k].x, given[k].y, 0}, -exponent_), k});
    // What lies behind a side must stand out from rounding.
    if (!(depth_ > 1e-9)) throw Error("chain: depth is below 1e-9 of its largest coordinate");
    for (std::size_t k = 0; k + 1 < given.size(); ++k)
      if (one_point(k, k + 1))
        throw Error("chain: vertices " + std::to_string(k) + " and " + std::to_string(k + 1) + " are one point");
    if (one_point(0, given.size() - 1))
      throw Error("chain: it ends at vertex " + std::to_string(given.size() - 1) +
                  " where it begins; allowed: closed = true, without that vertex");
  }
  bool one_point(std::size_t i, std::size_t j) const { return max_abs(chain_[j].x - chain_[i].x) <= convex::rounding; }

  // Whether b lies on the way from a to c.
  static bool is_idle(const Joint& a, const Joint& b, const Joint& c) {
    const Vec3d chord = c.x - a.x, step = b.x - a.x;
    return dot(step, chord) > 0 && dot(c.x - b.x, chord) > 0 &&
           std::abs(turn(chord, step)) <= convex::rounding * norm(chord);
  }
  void drop_idle_joints() {
    std::vector<Joint> kept;
    for (const Joint& j : chain_) {
      while (kept.size() >= 2 && is_idle(kept[kept.size() - 2], kept.back(), j)) kept.pop_back();
      kept.push_back(j);
    }
    if (closed_) {
      while (kept.size() >= 3 && is_idle(kept[kept.size() - 2], kept.back(), kept.front())) kept.pop_back();
      while (kept.size() >= 3 && is_idle(kept.back(), kept.front(), kept[1])) kept.erase(kept.begin());
      if (kept.size() < 3) throw Error("chain: its vertices enclose no area");
    }
    chain_ = std::move(kept);
  }

  void direct() {
    for (std::size_t k = 0; k < sides(); ++k) {
      const Vec3d &a = chain_[k].x, &b = chain_[next(k)].x, t = convex::unit(b - a), n{-t.y, t.x, 0};
      direction_.push_back(t);
      normal_.push_back(n);
      height_.push_back(0.5 * (dot(n, a) + dot(n, b)));
    }
  }

  void offset() {
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      const bool first = k == 0 && !closed_, last = k + 1 == chain_.size() && !closed_;
      const Vec3d &a = normal_[first ? 0 : before(k)], &b = normal_[last ? before(k) : k];
      const double both = 1 + dot(a, b);
      if (!(both > 1e-6))  // an angle of 0.08 degrees and less
        throw Error("chain: it turns back on itself at vertex " + std::to_string(chain_[k].given));
      mitre_.push_back((a + b) * (1 / both));
      back_.push_back(chain_[k].x - depth_ * mitre_[k]);
    }
  }

  void check_sides() const {
    for (std::size_t k = 0; k < sides(); ++k) {
      const Vec3d& t = direction_[k];
      const double length = norm(chain_[next(k)].x - chain_[k].x), lost = dot(mitre_[next(k)] - mitre_[k], t);
      if (length - depth_ * lost > convex::rounding) continue;
      throw Error("chain: depth is too large between the bends of " + side_name(k) + "; allowed: below " +
                  text(std::ldexp(length / lost, exponent_)) + " m");
    }
  }

  using Quad = std::array<Vec3d, 4>;  // counter-clockwise, as (3)
  Quad quad(std::size_t k) const { return {chain_[next(k)].x, chain_[k].x, back_[k], back_[next(k)]}; }
  // A side of one quad has the other in front of it, farther than rounding.
  static bool parts(const Quad& a, const Quad& b) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3d along = convex::unit(a[(i + 1) % 4] - a[i]), n{along.y, -along.x, 0};
      double least = std::numeric_limits<double>::infinity();
      for (const Vec3d& v : b) least = std::min(least, dot(n, v - a[i]));
      if (least > convex::rounding) return true;
    }
    return false;
  }
  void check_bands() const {
    for (std::size_t i = 0; i < sides(); ++i)
      for (std::size_t j = i + 2; j < sides(); ++j) {
        if (closed_ && i == 0 && j + 1 == sides()) continue;  // neighbours
        const Quad a = quad(i), b = quad(j);
        if (parts(a, b) || parts(b, a)) continue;
        throw Error("chain: " + side_name(i) + " and " + side_name(j) +
                    " meet: with its depth the chain must not cross or touch itself");
      }
  }

  void add_edges(Polygon& p) const {
    const std::size_t m = chain_.size();
    p.normals.resize(2 * m);
    p.offsets.resize(2 * m);
    const auto add = [&](std::uint32_t edge, const Vec3d& n, double height) {
      p.normals[edge] = n;
      p.offsets[edge] = height;
    };
    for (std::size_t k = 0; k < sides(); ++k) {
      add(front(next(k)), normal_[k], height_[k]);
      add(rear(k), -normal_[k], -0.5 * (dot(normal_[k], back_[k]) + dot(normal_[k], back_[next(k)])));
    }
    if (closed_) return;
    const auto cap = [&](std::uint32_t edge, const Vec3d& n, std::size_t k) {
      add(edge, n, 0.5 * (dot(n, chain_[k].x) + dot(n, back_[k])));
    };
    cap(front(0), -direction_.front(), 0);
    cap(rear(m - 1), direction_.back(), m - 1);
  }

  void add_part(Polygon& p, std::size_t k) const {
    Polygon::Part part;
    const auto side = [&](const Vec3d& from, std::uint32_t edge, const Vec3d& n, double height) {
      part.vertices.push_back(from);
      part.edge.push_back(edge);
      part.normals.push_back(n);
      part.offsets.push_back(height);
    };
    const auto outer = [&](const Vec3d& from, std::uint32_t edge) {
      side(from, edge, p.normals[edge], p.offsets[edge]);
    };
    // The end at a joint, with one line for both parts that meet there; else a cap.
    const auto end = [&](const Vec3d& from, std::size_t joint, double sign, std::uint32_t cap) {
      const bool inner = closed_ || (joint > 0 && joint + 1 < chain_.size());
      if (!inner) return outer(from, cap);
      const Vec3d along = convex::unit(mitre_[joint]), n{along.y, -along.x, 0};
      side(from, none, sign * n, sign * (0.5 * (dot(n, chain_[joint].x) + dot(n, back_[joint]))));
    };
    const std::size_t to = next(k);
    outer(chain_[to].x, front(to));
    end(chain_[k].x, k, -1, front(0));
    outer(back_[k], rear(k));
    end(back_[to], to, 1, rear(chain_.size() - 1));
    add_circle(part);
    p.parts.push_back(std::move(part));
  }

  void add_moments(Polygon& p) const {
    const auto each_triangle = [&](auto&& use) {
      for (const Polygon::Part& part : p.parts)
        for (const std::size_t k : {2u, 3u}) use(part.vertices[0], part.vertices[k - 1], part.vertices[k]);
    };
    const Vec3d& origin = chain_[0].x;
    Vec3d first{};
    each_triangle([&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
      const double area = 0.5 * turn(b - a, c - a);
      p.area += area;
      first += (area / 3) * ((a - origin) + (b - origin) + (c - origin));
    });
    p.centroid = origin + (1 / p.area) * first;
    each_triangle([&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
      const Vec3d x = a - p.centroid, y = b - p.centroid, z = c - p.centroid, sum = x + y + z;
      p.second_moment += 0.5 * turn(b - a, c - a) * (dot(x, x) + dot(y, y) + dot(z, z) + dot(sum, sum)) / 12;
    });
    for (const Vec3d& v : p.vertices) p.circumradius = std::max(p.circumradius, norm(v));
  }

  bool closed_;
  int exponent_ = 0;
  double depth_ = 0;
  std::vector<Joint> chain_;
  std::vector<Vec3d> direction_, normal_;  // of the sides
  std::vector<double> height_;
  std::vector<Vec3d> mitre_, back_;  // at the vertices
};

}  // namespace

Polygon band_along(std::span<const Vec3d> chain, double depth, bool closed) {
  return Band(chain, depth, closed).polygon();
}

}  // namespace shapes
