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
constexpr int walk_limit = 48;

// Search over the polyhedron's outward directions m, in its frame and in units.
class Search {
 public:
  Search(const EllipsoidAt& ellipsoid, const shapes::Polyhedron& p, double scale, double size)
      : ellipsoid_(ellipsoid), p_(p), scale_(scale), size_(size), rolling_(ellipsoid.least_curvature_radius()) {}

  double value = -infinity, upper = infinity;
  Vec3d m{};
  int iterations = 0;

  void try_faces() {
    const double least = ellipsoid_.least_axis();
    for (const auto& face : p_.faces) {
      const double level = dot(face.normal, ellipsoid_.centre) - scale_ * face.offset;
      if (level - least > value) keep(level - ellipsoid_.support(face.normal).height, face.normal);
    }
  }

  // Proves the answer, or follows the feature that contradicts it. The ellipsoid is a convex body K plus a ball of
  // radius ρ, its smallest radius of curvature: while gap + ρ > 0 the gap is the distance from K less ρ, so
  //   gap <= |point of K – polyhedron| − ρ  for every point of K,                                             (1)
  // with equality at the solution. The feature nearest to that point is where the solution lies, or closer to it.
  // Deeper, the bound of a point (ρ = 0) and of a vertex, gap <= its signed distance to the other body, still prove
  // most faces and vertices.
  bool walk() {
    for (int k = 0; k < walk_limit; ++k, ++iterations) {
      const bool shallow = value + rolling_ > 0;
      const double ball = shallow ? rolling_ : 0;
      const SurfacePoint nearest = surface_point(p_, scale_, ellipsoid_.deepest(m) + ball * m, size_);
      if (shallow && nearest.distance < 0) return false;
      upper = std::min(upper, nearest.distance - ball);
      if (upper - value <= rounding(size_)) return true;
      if (!shallow) upper = std::min(upper, try_vertex(highest_vertex(p_, m).index));
      if (upper - value <= rounding(size_)) return true;
      const double before = value;
      switch (nearest.feature) {
        case SurfacePoint::Feature::face: {
          const auto& face = p_.faces[nearest.index];
          keep(dot(face.normal, ellipsoid_.centre) - scale_ * face.offset - ellipsoid_.support(face.normal).height,
               face.normal);
          break;
        }
        case SurfacePoint::Feature::edge:
          try_edge(p_.edges[nearest.index], nearest.outward);
          break;
        case SurfacePoint::Feature::vertex:
          try_vertex(nearest.index);
          break;
      }
      // Where that feature is not the one: turning m towards the nearest point always climbs, by convexity, at first.
      for (double step = 1; !(value > before) && shallow && step > 0x1p-20; step *= 0.5) {
        const Vec3d turned = normalized(m + step * (nearest.outward - m));
        keep(separation(turned), turned);
      }
      if (!(value > before)) return false;
    }
    return false;
  }

  // Every feature, from several starts; then what proofs hold at any depth.
  void try_everything() {
    const bool shallow = value + rolling_ > 0;  // then a local maximum is the only one
    const int starts = shallow ? 1 : 8;
    for (const auto& edge : p_.edges) {
      const Vec3d &n0 = p_.faces[edge.face[0]].normal, &n1 = p_.faces[edge.face[1]].normal;
      for (int k = 0; k <= starts; ++k) {
        const double t = static_cast<double>(k) / starts;
        const Vec3d start = (1 - t) * n0 + t * n1;
        if (!(dot(start, start) > 0.01)) continue;
        try_edge(edge, normalized(start));
        for (const std::uint32_t v : edge.vertex) {
          if (shallow) break;
          const Vec3d direction = ascend(ellipsoid_, scale_ * p_.vertices[v], normalized(start));
          keep(separation(direction), direction);
        }
      }
    }
    double shallowest = infinity;  // (2) gap <= signed distance of any vertex to the ellipsoid
    for (std::uint32_t i = 0; i < p_.vertices.size(); ++i) shallowest = std::min(shallowest, try_vertex(i));
    // (3) gap <= signed distance of any point of the ellipsoid to the polyhedron
    const double point = surface_point(p_, scale_, ellipsoid_.deepest(m), size_).distance;
    upper = std::min({upper, shallowest, point});
    if (value + rolling_ > 0) {
      const SurfacePoint nearest = surface_point(p_, scale_, ellipsoid_.deepest(m) + rolling_ * m, size_);
      if (nearest.distance >= 0) upper = std::min(upper, nearest.distance - rolling_);
    }
  }

 private:
  void keep(double v, const Vec3d& direction) {
    if (v > value) value = v, m = direction;
  }
  double separation(const Vec3d& direction) const {
    return dot(direction, ellipsoid_.centre) - ellipsoid_.support(direction).height -
           scale_ * highest_vertex(p_, direction).value;
  }
  void try_edge(const shapes::Polyhedron::Edge& edge, const Vec3d& start) {
    const Vec3d &n0 = p_.faces[edge.face[0]].normal, &n1 = p_.faces[edge.face[1]].normal;
    const Vec3d p = scale_ * p_.vertices[edge.vertex[0]], e = scale_ * p_.vertices[edge.vertex[1]] - p;
    const ArcMaximum best = maximise_on_arc(ellipsoid_, p, e, n0, n1, start);
    if (best.value > value) keep(separation(best.m), best.m);
  }
  double try_vertex(std::uint32_t i) {
    Vec3d direction;
    const double bound = ellipsoid_.point_separation(scale_ * p_.vertices[i], direction);
    if (bound > value) keep(separation(direction), direction);
    return bound;
  }

  const EllipsoidAt& ellipsoid_;
  const shapes::Polyhedron& p_;
  double scale_, size_, rolling_;
};

}  // namespace

Contact Features::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                        const Options& options, Cache*) {
  const double extent = max_abs(offset) + max_abs(a.semi_axes) + b.scale * b.shape->circumradius;
  if (!(b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent) &&
        all_at_least(a.semi_axes, smallest_ratio * extent)))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const EllipsoidAt ellipsoid{unit.down * a.semi_axes, -transposed_times(b.rotation, unit.down * offset),
                              transposed(b.rotation) * a.rotation};
  Search search(ellipsoid, *b.shape, unit.down * b.scale, size);
  search.try_faces();
  if (!(std::abs(search.value) <= 16)) return refused();  // a rotation that is not finite
  if (options.overlap_only && search.value > proof_margin(size))
    return separation_proof(search.value, size, -(b.rotation * search.m), unit.up);
  if (!search.walk()) search.try_everything();
  const double allowance = polyhedron_rounding * size;
  const double gap = search.value;
  const Vec3d n = -(b.rotation * search.m);
  const Vec3d touch = b.rotation * -ellipsoid.support(search.m).arm;  // relative to the ellipsoid's centre
  const bool proven = search.upper - gap <= allowance;
  const double upper = (proven ? std::max(search.upper, gap) : gap) + allowance;
  Contact c = smooth_contact(gap, gap - allowance, upper, n, touch, touch + gap * n, unit.up, search.iterations);
  c.certified = proven;
  return c;
}

}  // namespace contact
