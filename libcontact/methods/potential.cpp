#include "libcontact/methods/potential.h"

#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/round_search.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

BallAt in_units(const Placed<shapes::Sphere>& s, double down) { return {s.radius * down}; }
EllipsoidBody in_units(const Placed<shapes::Ellipsoid>& e, double down) { return {e.semi_axes * down, e.rotation}; }
PotentialAt in_units(const Placed<shapes::PotentialParticle>& p, double down) {
  return {p.shape, p.scale * down, p.rotation};
}
double circumradius(const Placed<shapes::Sphere>& s) { return s.radius; }
double circumradius(const Placed<shapes::Ellipsoid>& e) { return max_abs(e.semi_axes); }
double circumradius(const Placed<shapes::PotentialParticle>& p) { return p.scale * p.shape->circumradius; }
bool at_least(const Placed<shapes::Sphere>& s, double limit) { return s.radius >= limit; }
bool at_least(const Placed<shapes::Ellipsoid>& e, double limit) { return all_at_least(e.semi_axes, limit); }
bool at_least(const Placed<shapes::PotentialParticle>& p, double limit) {
  return p.scale > 0 && p.scale * p.shape->inner_radius >= limit;
}
Vec3d to_body(const Placed<shapes::Sphere>&, const Vec3d& n) { return n; }
Vec3d to_body(const auto& body, const Vec3d& n) { return transposed_times(body.rotation, n); }
Vec3d to_world(const Placed<shapes::Sphere>&, const Vec3d& n) { return n; }
Vec3d to_world(const auto& body, const Vec3d& n) { return body.rotation * n; }

template <class A, class B>
Contact round_pair(const A& a, const B& b, const Vec3d& offset, const Options& options, Cache* cache) {
  const double size = max_abs(offset) + (circumradius(a) + circumradius(b));
  if (!(extent_in_range(size) && all_at_least(offset, -size) && at_least(a, smallest_ratio * size) &&
        at_least(b, smallest_ratio * size)))
    return refused();
  const Scale scale = scale_of(size);
  RoundPair<decltype(in_units(a, 1)), decltype(in_units(b, 1))> pair{in_units(a, scale.down), in_units(b, scale.down),
                                                                     offset * scale.down, 0};
  const double distance = norm(pair.d);
  pair.extent = distance + (pair.a.circumradius() + pair.b.circumradius());
  const double enough = proof_margin(pair.extent);
  const auto proves = [&](const auto& p) {
    const double value = p.f - (p.a.excess + p.b.excess);
    return value > enough && value <= 16;
  };
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis)) {
    const auto p = pair.evaluate(to_world(a, axis));
    if (proves(p)) return separation_proof(p.f - (p.a.excess + p.b.excess), 2 * pair.extent, p.n, scale.up);
  }
  const auto start = pair.cold_start();
  // The extent is below 4: a rotation that is not finite, or zero.
  if (!(std::abs(start.f) <= 16 && start.a.height > 0)) return refused();
  const double m = pair.least_curvature_radius();
  auto root = pair.climb(start, options.overlap_only);
  if (!root.converged || root.point.f + m <= 0) root = pair.search_deep(root);
  const auto& p = root.point;
  const double lower = p.f - (p.a.excess + p.b.excess);
  if (root.proof) {
    if (cache != nullptr) cache->axis = to_body(a, p.n);
    return separation_proof(lower, 2 * pair.extent, p.n, scale.up, root.iterations);
  }
  const auto& s = root.step;
  const double allowance = polyhedron_rounding * pair.extent;
  const bool refine = root.converged && s.at_maximum && s.gain <= 0x1p-20 * pair.extent;
  const double gap = refine ? p.f + 0.5 * s.gain : p.f;
  const double excess = pair.excess_bound(p, s);
  const double ball_gap = norm(pair.d + pair.b.inner_centre() - pair.a.inner_centre()) -
                          (pair.a.inner_radius() + pair.b.inner_radius());  // (5)
  double upper = std::min(p.f + excess, ball_gap);
  const bool proven = !root.converged || excess <= largest_extent || ball_gap <= gap + allowance;
  if (!proven) upper = gap;
  upper = std::max(upper, gap);
  Vec3d normal = p.n, point_a = p.a.x, point_b = pair.d + p.b.x;
  if (refine) {
    normal = normalized(p.n + s.turn);
    point_a += s.shift_a;
    point_b += s.shift_b;
  }
  Contact c = smooth_contact(gap, std::min(lower, gap) - allowance, upper + allowance, normal, point_a, point_b,
                             scale.up, root.iterations);
  c.certified = proven;
  if (!root.converged) c.status = Status::not_converged;
  if (cache != nullptr) cache->axis = c.status == Status::separated ? to_body(a, normal) : Vec3d{};
  return c;
}

}  // namespace

Contact Potential::query(const Placed<shapes::Sphere>& a, const Placed<shapes::PotentialParticle>& b,
                         const Vec3d& offset, const Options& options, Cache* cache) {
  return round_pair(a, b, offset, options, cache);
}

Contact Potential::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::PotentialParticle>& b,
                         const Vec3d& offset, const Options& options, Cache* cache) {
  return round_pair(a, b, offset, options, cache);
}

Contact Potential::query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::PotentialParticle>& b,
                         const Vec3d& offset, const Options& options, Cache* cache) {
  if (!seen_from_b(offset)) return round_pair(a, b, offset, options, cache);
  // The cached axis is kept in A's frame, whichever body the pair is solved from.
  Vec3d axis;
  Cache own;
  if (cached_direction(cache, axis)) own.axis = transposed_times(b.rotation, -(a.rotation * axis));
  const Contact c = exchanged(round_pair(b, a, -offset, options, cache != nullptr ? &own : nullptr), offset);
  if (cache != nullptr) cache->axis = c.status == Status::separated ? transposed_times(a.rotation, c.normal) : Vec3d{};
  return c;
}

Contact Potential::query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Plane>& b,
                         const Vec3d& offset, const Options&, Cache*) {
  const double size = max_abs(offset) + circumradius(a);
  if (!(extent_in_range(size) && all_at_least(offset, -size) && at_least(a, smallest_ratio * size))) return refused();
  const Scale scale = scale_of(size);
  const PotentialAt body = in_units(a, scale.down);
  const Vec3d d = offset * scale.down, n = -b.normal;
  const auto s = body.at(n);
  const double gap = dot(n, d) - s.height, allowance = polyhedron_rounding * (norm(d) + body.circumradius());
  if (!(std::abs(gap) <= 16)) return refused();
  return smooth_contact(gap, gap - s.excess - allowance, gap + allowance, n, s.x, s.x + gap * n, scale.up);
}

}  // namespace contact
