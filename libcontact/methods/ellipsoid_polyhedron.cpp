#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/ellipsoid_support.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Search over the polyhedron's outward directions m, in its frame and in units, for the greatest separation
//   f(m) = min over vertices v of φ_v(m),  φ_v(m) = m·(c − v) − |D Qᵀ m|                                         (1)
class Search {
 public:
  Search(const EllipsoidAt& ellipsoid, const shapes::Polyhedron& p, double scale, double size, double enough)
      : ellipsoid_(ellipsoid), p_(p), scale_(scale), size_(size), enough_(enough) {}

  double value = -infinity, upper = infinity;
  Vec3d m{};
  int iterations = 0;

  bool proves_separation() const { return value > enough_; }

  // Where the ellipsoid's centre is highest over a face: most contacts with large faces are answered here, proven by
  // the point of the ellipsoid that is deepest below that face lying over it. A point x of the ellipsoid bounds the
  // gap by its signed distance to the polyhedron, and one of K (see `climb_down`) by its own less ρ.
  bool try_top_face() {
    const std::size_t top = highest_face(p_, scale_, ellipsoid_.centre).index;
    const auto& face = p_.faces[top];
    const auto support = ellipsoid_.support(face.normal);
    const double height = dot(face.normal, ellipsoid_.centre) - scale_ * face.offset;
    value = height - support.height;
    m = face.normal;
    if (!(std::abs(value) <= 16) || proves_separation()) return true;
    const double rho = ellipsoid_.least_curvature_radius();
    const double ball = value + rho > 0 ? rho : 0;
    const Vec3d x = ellipsoid_.centre - support.arm + ball * m;
    const FaceHeight above = highest_face(p_, scale_, x);
    if (above.index != top || (above.height > 0 && !over_face(p_, face, scale_, x))) return false;
    upper = value;
    return true;
  }

  // The least of (1) over a basis of at most three vertices bounds f from above, and is its maximum when no other
  // vertex is lower there. So: add the lowest vertex, find the basis of the four, until there is none. The bound falls
  // at every step. While gap + ρ > 0 the ellipsoid is a convex body K plus a ball of its smallest radius of curvature
  // ρ, K lies apart from the polyhedron, and every maximum is the only one. False when deeper, or when rounding ends
  // it.
  bool climb_down() {
    std::uint32_t basis[4];
    int count = 0;
    Vec3d at = m;
    const double shallow = -ellipsoid_.least_curvature_radius();
    for (iterations = 0; iterations < step_limit; ++iterations) {
      const Extreme highest = highest_vertex(p_, at);
      const double reached = dot(at, ellipsoid_.centre) - ellipsoid_.support(at).height - scale_ * highest.value;
      keep(reached, at);
      if (proves_separation() || upper - value <= 8 * epsilon * size_) return true;
      for (int i = 0; i < count; ++i)
        if (basis[i] == highest.index) return false;
      basis[count++] = highest.index;
      double bound;
      if (!reduce(basis, count, at, bound) || !(bound > shallow) || bound > upper) return false;
      upper = bound;
    }
    return false;
  }

  // Every local maximum there can be: face normals; on an edge's arc, one or two; in a vertex's cone, one or two. What
  // lies outside its arc or cone is only tried. Dropped: edges whose faces both lie high over a point x of the
  // ellipsoid inside the polyhedron, as f <= m·(x − p), at most the larger of the two heights of x.
  void try_everything() {
    ++iterations;
    for (const auto& face : p_.faces) {
      const double height = dot(face.normal, ellipsoid_.centre) - scale_ * face.offset;
      if (height - ellipsoid_.least_axis() > value) keep(height - ellipsoid_.support(face.normal).height, face.normal);
    }
    Vec3d candidate[2];
    for (const Vec3d& corner : p_.vertices) {
      const int count = maxima_of_point(ellipsoid_, scale_ * corner, candidate);
      for (int k = 0; k < count; ++k) try_direction(scale_ * corner, candidate[k]);
    }
    Vec3d witness = ellipsoid_.deepest(m);
    for (const auto& edge : p_.edges) {
      const auto height = [&](std::uint32_t f) {
        return dot(p_.faces[f].normal, witness) - scale_ * p_.faces[f].offset;
      };
      if (const double bound = std::max(height(edge.face[0]), height(edge.face[1])); bound < 0 && bound < value)
        continue;
      const Vec3d p = scale_ * p_.vertices[edge.vertex[0]], e = scale_ * p_.vertices[edge.vertex[1]] - p;
      const int count = maxima_of_edge(ellipsoid_, p, e, candidate);
      for (int k = 0; k < count; ++k)
        if (try_direction(p, candidate[k])) witness = ellipsoid_.deepest(m);
    }
    upper = value;
  }

  double separation(const Vec3d& direction) const {
    return dot(direction, ellipsoid_.centre) - ellipsoid_.support(direction).height -
           scale_ * highest_vertex(p_, direction).value;
  }

 private:
  static constexpr int step_limit = 64;

  bool keep(double v, const Vec3d& direction) {
    if (!(v > value)) return false;
    value = v;
    m = direction;
    return true;
  }
  double from_point(const Vec3d& p, const Vec3d& direction) const {
    return dot(direction, ellipsoid_.centre - p) - ellipsoid_.support(direction).height;
  }
  bool try_direction(const Vec3d& p, const Vec3d& direction) {
    return from_point(p, direction) > value && keep(separation(direction), direction);
  }
  Vec3d corner(std::uint32_t i) const { return scale_ * p_.vertices[i]; }

  // Of vertices basis[0 .. count), the subset with the last one whose own maximum is that of all: the deepest point
  // of the ellipsoid there projects into their segment or triangle, and no other vertex is lower.
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
        if (dot(n, ellipsoid_.centre - v) < 0) n = -n;
        const Vec3d x = ellipsoid_.deepest(n) - v, normal = cross(e, f);
        const double s = dot(cross(x, f), normal), t = dot(cross(e, x), normal);
        if (s >= 0 && t >= 0 && s + t <= square && accept(n, {basis[i], basis[j], last})) return true;
      }
    for (int i = 0; i < old; ++i) {
      const Vec3d e = corner(basis[i]) - v;
      const Vec3d n = maximum_of_edge(ellipsoid_, v, e);
      const double along = dot(ellipsoid_.deepest(n) - v, e);
      if (along >= 0 && along <= dot(e, e) && accept(n, {basis[i], last})) return true;
    }
    Vec3d n;
    ellipsoid_.point_separation(v, n);
    return accept(n, {last});
  }

  const EllipsoidAt& ellipsoid_;
  const shapes::Polyhedron& p_;
  double scale_, size_, enough_;
};

}  // namespace

Contact Features::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                        const Options& options, Cache* cache) {
  const double radius_a = max_abs(a.semi_axes), radius_b = b.scale * b.shape->circumradius;
  const double extent = max_abs(offset) + radius_a + radius_b;
  if (!(b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent) &&
        all_at_least(a.semi_axes, smallest_ratio * extent)))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const EllipsoidAt ellipsoid{unit.down * a.semi_axes, -transposed_times(b.rotation, unit.down * offset),
                              transposed(b.rotation) * a.rotation};
  const double enough = options.overlap_only ? proof_margin(size) : infinity;
  Search search(ellipsoid, *b.shape, unit.down * b.scale, size, enough);
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache) cache->axis = transposed_times(a.rotation, n);
    return separation_proof(value, size, n, unit.up, search.iterations);
  };
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis)) {
    const Vec3d m = -transposed_times(b.rotation, a.rotation * axis);
    if (const double value = search.separation(m); value > enough) return proof(value, m);
  }
  if (!search.try_top_face() && !search.climb_down()) search.try_everything();
  if (!(std::abs(search.value) <= 16)) return refused();  // a rotation that is not finite
  if (search.proves_separation()) return proof(search.value, search.m);
  const double allowance = polyhedron_rounding * size;
  const double gap = search.value;
  const Vec3d n = -(b.rotation * search.m);
  const Vec3d touch = b.rotation * -ellipsoid.support(search.m).arm;  // relative to the ellipsoid's centre
  const Contact c = smooth_contact(gap, gap - allowance, std::max(search.upper, gap) + allowance, n, touch,
                                   touch + gap * n, unit.up, search.iterations);
  if (cache) cache->axis = c.status == Status::separated ? transposed_times(a.rotation, n) : Vec3d{};
  return c;
}

}  // namespace contact
