// Potential particle against a polyhedron, rounded or not: (6) and (7) of potential.h.
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/polyhedron_search.h"
#include "libcontact/methods/potential.h"
#include "libcontact/methods/potential_lowered.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The particle as the search wants it, in the polyhedron's frame.
struct Particle {
  Lowered lowered;
  double size;
  Vec3d centre;

  struct Support {
    double height;
    Vec3d arm;
  };
  Support support(const Vec3d& m) const {
    const auto s = lowered.body.at(-m);
    return {s.height, -s.x};
  }
  Vec3d deepest(const Vec3d& m) const { return lowered.at(m).lowest; }
  Vec3d inner_centre() const { return centre + lowered.body.inner_centre(); }
  double least_curvature_radius() const { return lowered.body.least_curvature_radius(); }
  double point_separation(const Vec3d& p, Vec3d& m) const {
    const Maximum best = best_at_point(lowered, p, 0.25 * size);
    m = best.m;
    return best.gap;
  }
  Vec3d edge_maximum(const Vec3d& p, const Vec3d& e) const {
    const Vec3d along = normalized(e);
    Vec3d start = inner_centre() - p, other;
    start -= dot(start, along) * along;
    const double length = norm(start);
    if (length > epsilon * size)
      start *= 1 / length;
    else
      tangent_frame(along, start, other);
    return best_across_edge(lowered, p, e, start, size).m;
  }
};

class Search : public PolyhedronSearch<Particle> {
 public:
  using PolyhedronSearch::PolyhedronSearch;

  // Deeper than ρ: the normals of both bodies, then Newton's method and `ascend` from the best of several directions on
  // each edge's arc and in each vertex's cone. Dropped: edges and vertices all of whose faces are high over a point x
  // of the particle inside the polyhedron, as m in the cone is a sum of their normals with weights of one at least
  // together, so that f <= m·(x − v) <= the highest of the heights of x, which are negative.
  void try_everything() {
    ++iterations;
    try_faces(-infinity);
    body_.lowered.body.for_each_normal([&](const Vec3d& n) { keep(separation(-n), -n); });
    ascend(m);
    body_.lowered.body.for_each_normal([&](const Vec3d& n) { ascend(-n); });
    for (std::uint32_t v = 0; v < p_.vertices.size(); ++v) try_vertex(v);
    for (const auto& edge : p_.edges) try_edge(edge);
  }

 private:
  double height(std::uint32_t face, const Vec3d& x) const {
    return dot(p_.faces[face].normal, x) - scale_ * p_.faces[face].offset;
  }
  bool cannot_win(double highest) const { return highest < 0 && highest <= value + 4 * epsilon * size_; }

  // Along Newton's steps of the highest vertex' φ while f rises, then along the arc where another vertex becomes the
  // highest.
  void ascend(Vec3d at) {
    double reached = separation(at);
    const auto rises = [&](const Vec3d& next) {
      const double there = separation(next);
      if (!(there > reached + epsilon * size_)) return false;
      reached = there;
      at = next;
      return true;
    };
    for (int step = 0; step < step_limit; ++step) {
      const std::uint32_t top = highest_vertex(p_, at).index;
      const Vec3d p = corner(top);
      const RoundPair<BallAt, PotentialAt> pair{{0}, body_.lowered.body, body_.centre - p, size_};
      const Vec3d turn = pair.newton_step(pair.evaluate(at)).turn;
      const double angle = norm(turn);
      std::uint32_t other = top;
      bool moved = false;
      double fraction = angle > 0.5 ? 0.5 / angle : 1;
      for (int cut = 0; cut < 12 && !moved; ++cut, fraction *= 0.25) {
        const Vec3d next = normalized(at + fraction * turn);
        moved = rises(next);
        if (const std::uint32_t v = highest_vertex(p_, next).index; !moved && v != top) other = v;
      }
      if (moved) continue;
      if (other == top) break;
      const Vec3d e = corner(other) - p, along = normalized(e);
      if (!rises(best_across_edge(body_.lowered, p, e, normalized(at - dot(at, along) * along), size_).m)) break;
    }
    ++iterations;
    keep(reached, at);
  }

  void try_vertex(std::uint32_t v) {
    const Vec3d witness = body_.deepest(m);
    double highest = -infinity;
    Vec3d sum{};
    for (const auto& edge : p_.edges) {
      if (edge.vertex[0] != v && edge.vertex[1] != v) continue;
      for (const std::uint32_t f : edge.face) {
        highest = std::max(highest, height(f, witness));
        sum += p_.faces[f].normal;
      }
    }
    if (cannot_win(highest)) return;
    const Vec3d p = scale_ * p_.vertices[v];
    const RoundPair<BallAt, PotentialAt> pair{{0}, body_.lowered.body, body_.centre - p, size_};
    using Point = typename RoundPair<BallAt, PotentialAt>::Point;
    constexpr int most = 3;
    Point starts[most];
    int count = 0;
    const auto offer = [&](const Vec3d& direction) {
      if (!(dot(direction, direction) > 0x1p-20)) return;
      const Point at = pair.evaluate(normalized(direction));
      int k = count < most ? count++ : most;
      if (k == most && !(at.f > starts[most - 1].f)) return;
      for (k = std::min(k, most - 1); k > 0 && at.f > starts[k - 1].f; --k) starts[k] = starts[k - 1];
      starts[k] = at;
    };
    const Vec3d middle = normalized(sum);
    offer(middle);
    offer(m);
    for (const auto& edge : p_.edges) {
      if (edge.vertex[0] != v && edge.vertex[1] != v) continue;
      const Vec3d &first = p_.faces[edge.face[0]].normal, &second = p_.faces[edge.face[1]].normal;
      offer(first + second);
      offer(first + second + middle);
    }
    body_.lowered.body.for_each_normal([&](const Vec3d& n) { offer(-n); });
    for (int k = 0; k < count; ++k) {
      const auto root = pair.climb(starts[k], false);
      iterations += root.iterations;
      try_direction(p, root.point.n);
      ascend(starts[k].n);
    }
  }

  template <class Edge>
  void try_edge(const Edge& edge) {
    const Vec3d witness = body_.deepest(m);
    if (cannot_win(std::max(height(edge.face[0], witness), height(edge.face[1], witness)))) return;
    const Vec3d p = scale_ * p_.vertices[edge.vertex[0]], e = scale_ * p_.vertices[edge.vertex[1]] - p;
    const Vec3d &first = p_.faces[edge.face[0]].normal, &second = p_.faces[edge.face[1]].normal;
    const Vec3d along = normalized(e);
    constexpr int last = 8;
    Vec3d at[last + 1];
    double phi[last + 1];
    for (int k = 0; k <= last; ++k) {
      const Vec3d between = first + (static_cast<double>(k) / last) * (second - first);
      at[k] = normalized(between - dot(between, along) * along);
      phi[k] = from_point(p, at[k]);
    }
    for (int k = 0; k <= last; ++k)
      if ((k == 0 || phi[k] >= phi[k - 1]) && (k == last || phi[k] >= phi[k + 1]))
        ascend(try_direction(p, best_across_edge(body_.lowered, p, e, at[k], size_).m) ? m : at[k]);
  }
};

// (7), with the ball that touches the surface in the deepest point, and with the inner ball.
double from_balls(const Particle& body, const shapes::Polyhedron& p, double scale, const Vec3d& m) {
  const auto from = [&](const Vec3d& centre, double radius) {
    return surface_point(p, scale, centre, body.size).distance - radius;
  };
  const Vec3d x = body.deepest(m);
  const double rho = body.least_curvature_radius();
  const Vec3d outward = normalized(body.lowered.body.rotation * body.lowered.level(x).half_gradient);
  return std::min(from(x - rho * outward, rho), from(body.inner_centre(), body.lowered.body.inner_radius()));
}

Contact solve(const Placed<shapes::Polyhedron>& a, double radius, const Placed<shapes::PotentialParticle>& b,
              const Vec3d& offset, const Options& options, Cache* cache) {
  const double extent = max_abs(offset) + a.scale * a.shape->circumradius + radius + b.scale * b.shape->circumradius;
  if (!(a.scale > 0 && b.scale > 0 && radius >= 0 && extent_in_range(extent) && all_at_least(offset, -extent) &&
        b.scale * b.shape->inner_radius >= smallest_ratio * extent))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent, rounding_radius = unit.down * radius, scale = unit.down * a.scale;
  const Vec3d centre = transposed_times(a.rotation, unit.down * offset);
  const Particle body{{{b.shape, unit.down * b.scale, transposed(a.rotation) * b.rotation}, centre}, size, centre};
  const double enough = options.overlap_only ? rounding_radius + proof_margin(size) : infinity;
  Search search(body, *a.shape, scale, size, enough);
  const auto proof = [&](double value, const Vec3d& m) {
    if (cache != nullptr) cache->axis = m;
    return separation_proof(value - rounding_radius, 2 * size, a.rotation * m, unit.up, search.iterations);
  };
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis))
    if (const double value = search.separation(axis); value > enough && value <= 16) return proof(value, axis);
  const bool shallow = search.try_top_face() || search.climb_down();
  if (!shallow) search.try_everything();
  if (!(std::abs(search.value) <= 16)) return refused();  // a rotation that is not finite
  if (search.proves_separation()) return proof(search.value, search.m);
  const double allowance = polyhedron_rounding * size, gap = search.value - rounding_radius;
  double upper = from_balls(body, *a.shape, scale, search.m) - rounding_radius;
  const bool proven = upper - gap <= 2 * allowance;
  upper = proven ? std::max(upper, gap) : gap;
  const auto s = body.lowered.at(search.m);
  const Vec3d n = a.rotation * search.m, touch = a.rotation * s.lowest;
  Contact c = smooth_contact(gap, gap - s.excess - allowance, upper + allowance, n, touch - gap * n, touch, unit.up,
                             search.iterations);
  c.certified = proven;
  if (cache != nullptr) cache->axis = c.status == Status::separated ? search.m : Vec3d{};
  return c;
}

}  // namespace

Contact Potential::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::PotentialParticle>& b,
                         const Vec3d& offset, const Options& options, Cache* cache) {
  return solve(a, 0, b, offset, options, cache);
}

Contact Potential::query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::PotentialParticle>& b,
                         const Vec3d& offset, const Options& options, Cache* cache) {
  if (!(a.radius > 0)) return refused();
  return solve(a.core, a.radius, b, offset, options, cache);
}

}  // namespace contact
