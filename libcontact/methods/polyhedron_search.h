// Greatest support separation of a polyhedron and a smooth convex body: what is common to ellipsoids and potential
// particles. Inner header.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/vertex_support.h"

namespace contact {

// Search over the polyhedron's outward directions m, in its frame and in units, for the greatest separation
//   f(m) = min over vertices v of φ_v(m),  φ_v(m) = m·(c − v) − h(−m)                                           (1)
// of a body of centre c and support height h. The body tells
//   centre, support(m): { height h(−m), arm: from the deepest point against m to the centre }, deepest(m),
//   least_curvature_radius(), point_separation(p, m): max of φ over all m, and the m that gives it,
//   edge_maximum(p, e): the m of the maximum over those perpendicular to e.
template <class Body>
class PolyhedronSearch {
 public:
  PolyhedronSearch(const Body& body, const shapes::Polyhedron& p, double scale, double size, double enough)
      : body_(body), p_(p), scale_(scale), size_(size), enough_(enough) {}

  double value = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  Vec3d m{};
  int iterations = 0;
  // One or two vertices on which the maximum is known to lie; 0: a face's normal, or not known.
  std::uint32_t on[2] = {};
  int on_count = 0;

  // The point of the polyhedron across the gap, where a vertex or an edge holds the maximum. That point is known to
  // rounding; the body's deepest one is off by the rounding of m times its radius of curvature.
  bool across(Vec3d& x) const {
    if (on_count == 0) return false;
    x = corner(on[0]);
    if (on_count == 1) return true;
    const Vec3d e = corner(on[1]) - x;
    const double along = dot(body_.deepest(m) - x, e), square = dot(e, e);
    x += e * std::clamp(along / square, 0.0, 1.0);
    return true;
  }

  bool proves_separation() const { return value > enough_; }

  // Where the body's centre is highest over a face: most contacts with large faces are answered here, proven by
  // the point of the body that is deepest below that face lying over it. A point x of the body bounds the
  // gap by its signed distance to the polyhedron, and one of K (see `climb_down`) by its own less ρ.
  bool try_top_face() {
    const std::size_t top = highest_face(p_, scale_, body_.centre).index;
    const auto& face = p_.faces[top];
    const auto support = body_.support(face.normal);
    const double height = dot(face.normal, body_.centre) - scale_ * face.offset;
    value = height - support.height;
    m = face.normal;
    if (!(std::abs(value) <= 16) || proves_separation()) return true;
    const double rho = body_.least_curvature_radius();
    const double ball = value + rho > 0 ? rho : 0;
    const Vec3d x = body_.centre - support.arm + ball * m;
    const FaceHeight above = highest_face(p_, scale_, x);
    if (above.index != top || (above.height > 0 && !over_face(p_, face, scale_, x))) return false;
    upper = value;
    return true;
  }

  // The least of (1) over a basis of at most three vertices bounds f from above, and is its maximum when no other
  // vertex is lower there. So: add the lowest vertex, find the basis of the four, until there is none. The bound falls
  // at every step. While gap + ρ > 0 the body is a convex body K plus a ball of its smallest radius of curvature
  // ρ, K lies apart from the polyhedron, and every maximum is the only one. False when deeper, or when rounding ends
  // it.
  bool climb_down() {
    std::uint32_t basis[4];
    int count = 0;
    Vec3d at = m;
    const double shallow = -body_.least_curvature_radius();
    for (iterations = 0; iterations < step_limit; ++iterations) {
      const Extreme highest = highest_vertex(p_, at);
      const double reached = dot(at, body_.centre) - body_.support(at).height - scale_ * highest.value;
      keep(reached, at);
      if (proves_separation()) return true;
      if (upper - value <= 8 * epsilon * size_) {
        if (count < 3 && value - reached <= 8 * epsilon * size_) {
          m = at;
          std::copy_n(basis, count, on);
          on_count = count;
        }
        return true;
      }
      for (int i = 0; i < count; ++i)
        if (basis[i] == highest.index) return false;
      basis[count++] = highest.index;
      double bound;
      if (!reduce(basis, count, at, bound) || !(bound > shallow) || bound > upper) return false;
      upper = bound;
    }
    return false;
  }

  // Every face's normal; `least` bounds the support height of the body from below.
  void try_faces(double least) {
    for (const auto& face : p_.faces)
      if (const double height = dot(face.normal, body_.centre) - scale_ * face.offset; height - least > value)
        keep(height - body_.support(face.normal).height, face.normal);
  }

  double separation(const Vec3d& direction) const {
    return dot(direction, body_.centre) - body_.support(direction).height -
           scale_ * highest_vertex(p_, direction).value;
  }

 protected:
  static constexpr int step_limit = 64;

  bool keep(double v, const Vec3d& direction) {
    if (!(v > value)) return false;
    value = v;
    m = direction;
    return true;
  }
  double from_point(const Vec3d& p, const Vec3d& direction) const {
    return dot(direction, body_.centre - p) - body_.support(direction).height;
  }
  bool try_direction(const Vec3d& p, const Vec3d& direction) {
    return from_point(p, direction) > value && keep(separation(direction), direction);
  }
  Vec3d corner(std::uint32_t i) const { return scale_ * p_.vertices[i]; }

  // Of vertices basis[0 .. count), the subset with the last one whose own maximum is that of all: the deepest point
  // of the body there projects into their segment or triangle, and no other vertex is lower.
  bool reduce(std::uint32_t* basis, int& count, Vec3d& at, double& bound) const {
    const std::uint32_t last = basis[count - 1];
    const Vec3d v = corner(last);
    const auto accept = [&](const Vec3d& direction, std::initializer_list<std::uint32_t> chosen) {
      const double level = dot(direction, v) + 4 * epsilon * size_;
      for (int i = 0; i < count; ++i)
        if (dot(direction, corner(basis[i])) > level &&
            std::find(chosen.begin(), chosen.end(), basis[i]) == chosen.end())
          return false;
      at = direction;
      bound = from_point(v, direction);
      std::copy(chosen.begin(), chosen.end(), basis);
      count = static_cast<int>(chosen.size());
      return true;
    };
    const int old = count - 1;
    for (int i = 0; i < old; ++i)
      for (int j = i + 1; j < old; ++j) {
        const Vec3d e = corner(basis[i]) - v, f = corner(basis[j]) - v;
        Vec3d n = cross(e, f);
        const double square = dot(n, n);
        if (!(square > 0)) continue;
        n *= 1 / std::sqrt(square);
        if (dot(n, body_.centre - v) < 0) n = -n;
        const Vec3d x = body_.deepest(n) - v, normal = cross(e, f);
        const double s = dot(cross(x, f), normal), t = dot(cross(e, x), normal);
        if (s >= 0 && t >= 0 && s + t <= square && accept(n, {basis[i], basis[j], last})) return true;
      }
    for (int i = 0; i < old; ++i) {
      const Vec3d e = corner(basis[i]) - v;
      const Vec3d n = body_.edge_maximum(v, e);
      const double along = dot(body_.deepest(n) - v, e);
      if (along >= 0 && along <= dot(e, e) && accept(n, {basis[i], last})) return true;
    }
    Vec3d n;
    body_.point_separation(v, n);
    return accept(n, {last});
  }

  const Body& body_;
  const shapes::Polyhedron& p_;
  double scale_, size_, enough_;
};

}  // namespace contact
