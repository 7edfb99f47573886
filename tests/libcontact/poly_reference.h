// Reference answers for polyhedra in extended precision: every axis, every feature pair, no pruning.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <filesystem>
#include <random>
#include <vector>

#include "libcontact/contact.h"
#include "shapes/polyhedron_build.h"

namespace reference {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using contact::Placed;
using shapes::Mat3d;
using shapes::Polyhedron;
using shapes::Quatd;
using shapes::Vec3d;

template <class T>
using Vec = shapes::Vec3<T>;
template <class T>
Vec<T> widen(const Vec3d& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
T least(const T& a, const T& b) {
  return b < a ? b : a;
}
template <class T>
T greatest(const T& a, const T& b) {
  return a < b ? b : a;
}

// A polyhedron as placed, in T, from the unit quaternion nearest to the one given.
template <class T>
struct Solid {
  std::vector<Vec<T>> vertices;
  std::vector<Vec<T>> normals;                    // of every face, twice: as stored and from its corners
  std::vector<std::vector<std::uint32_t>> loops;  // per face
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;

  Solid(const Polyhedron& p, double scale, const Quatd& orientation, const Vec3d& position) {
    const shapes::Quat<T> q =
        normalized(shapes::Quat<T>{T(orientation.w), T(orientation.x), T(orientation.y), T(orientation.z)});
    const shapes::Mat3<T> r = rotation_matrix(q);
    for (const auto& v : p.vertices) vertices.push_back(r * (T(scale) * widen<T>(v)) + widen<T>(position));
    for (const auto& f : p.faces) {
      loops.emplace_back(p.face_vertices.begin() + f.first, p.face_vertices.begin() + f.first + f.count);
      normals.push_back(r * normalized(widen<T>(f.normal)));
      const auto& l = loops.back();
      normals.push_back(normalized(cross(vertices[l[1]] - vertices[l[0]], vertices[l[2]] - vertices[l[0]])));
    }
    for (const auto& e : p.edges) edges.emplace_back(e.vertex[0], e.vertex[1]);
  }
  T highest(const Vec<T>& n) const {
    T best = dot(n, vertices[0]);
    for (const auto& v : vertices) best = greatest(best, dot(n, v));
    return best;
  }
};

template <class T>
T separation(const Solid<T>& a, const Solid<T>& b, const Vec<T>& n) {
  return -b.highest(-n) - a.highest(n);
}

// max over face normals and edge cross products of the support separation.
template <class T>
T sat_gap(const Solid<T>& a, const Solid<T>& b) {
  T best = T(-1e300);
  for (const auto& n : a.normals) best = greatest(best, separation(a, b, n));
  for (const auto& n : b.normals) best = greatest(best, separation(a, b, -n));
  for (const auto& ea : a.edges)
    for (const auto& eb : b.edges) {
      const Vec<T> n =
          cross(a.vertices[ea.second] - a.vertices[ea.first], b.vertices[eb.second] - b.vertices[eb.first]);
      if (!(dot(n, n) > T(0))) continue;
      const Vec<T> u = normalized(n);
      best = greatest(best, greatest(separation(a, b, u), separation(a, b, -u)));
    }
  return best;
}

template <class T>
T square_to_segment(const Vec<T>& x, const Vec<T>& p, const Vec<T>& q) {
  const Vec<T> e = q - p;
  T t = dot(x - p, e) / dot(e, e);
  t = least(greatest(t, T(0)), T(1));
  const Vec<T> w = x - p - t * e;
  return dot(w, w);
}

// Distance of a point to a convex solid; minus the least depth inside.
template <class T>
T point_gap(const Vec<T>& x, const Solid<T>& s) {
  using std::sqrt;
  T inside = T(-1e300), square = T(1e300);
  for (std::size_t f = 0; f < s.loops.size(); ++f) {
    const Vec<T>& n = s.normals[2 * f + 1];
    const auto& l = s.loops[f];
    const T level = dot(n, x - s.vertices[l[0]]);
    inside = greatest(inside, level);
    bool over = true;
    for (std::size_t k = 0; k < l.size(); ++k) {
      const Vec<T>&p = s.vertices[l[k]], &q = s.vertices[l[(k + 1) % l.size()]];
      over = over && dot(cross(n, q - p), x - p) >= T(0);
    }
    if (over) square = least(square, level * level);
  }
  if (inside <= T(0)) return inside;
  for (const auto& e : s.edges) square = least(square, square_to_segment(x, s.vertices[e.first], s.vertices[e.second]));
  return sqrt(square);
}

// Distance of separated solids over all feature pairs.
template <class T>
T distance(const Solid<T>& a, const Solid<T>& b) {
  using std::sqrt;
  T best = T(1e300);
  for (const auto& v : b.vertices) best = least(best, point_gap(v, a));
  for (const auto& v : a.vertices) best = least(best, point_gap(v, b));
  for (const auto& ea : a.edges)
    for (const auto& eb : b.edges) {
      const Vec<T>&p = a.vertices[ea.first], &q = b.vertices[eb.first];
      const Vec<T> e = a.vertices[ea.second] - p, f = b.vertices[eb.second] - q, n = cross(e, f), w = q - p;
      const T square = dot(n, n);
      if (!(square > T(0))) continue;
      const T s = dot(cross(w, f), n) / square, t = dot(cross(w, e), n) / square;
      if (s < T(0) || s > T(1) || t < T(0) || t > T(1)) continue;
      const T d = dot(n, w);
      best = least(best, sqrt(d * d / square));
    }
  return best;
}

inline Placed<Polyhedron> place(const Polyhedron& p, double scale, const Quatd& q) {
  return {&p, scale, rotation_matrix(q)};
}

// Draws that do not depend on the library's distributions.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (dot(v, v) > 0.01 && dot(v, v) < 1) return normalized(v);
    }
  }
  Quatd orientation() {
    for (;;) {
      const Quatd q{between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)};
      const double s = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
      if (s > 0.01 && s < 1) return normalized(q);
    }
  }
  std::size_t index(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

 private:
  std::mt19937_64 engine_;
};

inline Polyhedron grain(const char* name) {
  return shapes::polyhedron_from_file(std::string(PROJECT_ROOT "/shapes/data/ct_hull_coarse/") + name,
                                      shapes::Frame::principal);
}

}  // namespace reference
