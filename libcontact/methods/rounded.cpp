#include "libcontact/methods/rounded.h"

#include <cmath>
#include <limits>

#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/polyhedron_plane.h"
#include "libcontact/methods/rounded_parts.h"
#include "libcontact/methods/sat.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

void move(Contact& c, const Vec3d& by) {
  c.point_a += by;
  c.point_b += by;
  c.patch.centre += by;
  c.method_point += by;
}

bool radius_in_range(double radius, double extent) { return radius > 0 && radius >= smallest_ratio * extent; }

// Highest point along n, m.
double reach(const Placed<shapes::Polyhedron>& p, const Vec3d& n) {
  return p.scale * highest_vertex(*p.shape, transposed_times(p.rotation, n)).value;
}
double reach(const Placed<shapes::Ellipsoid>& e, const Vec3d& n) {
  return norm(scaled(e.semi_axes, transposed_times(e.rotation, n)));
}
double circumradius(const Placed<shapes::Polyhedron>& p) { return p.scale * p.shape->circumradius; }
double circumradius(const Placed<shapes::Ellipsoid>& e) { return max_abs(e.semi_axes); }
double least_size(const Placed<shapes::Polyhedron>& p) { return p.scale; }
double least_size(const Placed<shapes::Ellipsoid>& e) {
  return std::fmin(e.semi_axes.x, std::fmin(e.semi_axes.y, e.semi_axes.z));
}

// Two cores whose gap in full `core(offset, patch)` gives.
template <class A, class Core>
Contact rounded_pair(const A& a, double radius_a, const Placed<shapes::Polyhedron>& b, double radius_b,
                     const Vec3d& offset, const Options& options, Cache* cache, const Core& core) {
  const double radii = radius_a + radius_b, extent = max_abs(offset) + circumradius(a) + circumradius(b) + radii;
  if (!(least_size(a) > 0 && b.scale > 0 && radius_a >= 0 && extent_in_range(extent) &&
        radius_in_range(radius_b, extent) && all_at_least(offset, -extent)))
    return refused();
  if (options.overlap_only) {
    // Wider than the bounds of a query in full, so that both agree.
    const double enough = 2 * proof_margin(extent);
    const auto proves = [&](const Vec3d& n) {
      const double value = dot(n, offset) - reach(a, n) - reach(b, -n) - radii;
      return value > enough && value <= 4 * extent ? value : 0;
    };
    Vec3d n;
    const double distance = length_and_direction(offset, n);
    if (const double apart = distance - circumradius(a) - circumradius(b) - radii; apart > enough) {
      if (const double value = proves(n); value > 0) {
        if (cache) cache->axis = transposed_times(a.rotation, n);
        return separation_proof(value, 4 * extent, n, 1);
      }
    }
    if (Vec3d axis; cached_direction(cache, axis)) {
      n = a.rotation * axis;
      if (const double value = proves(n); value > 0) return separation_proof(value, 4 * extent, n, 1);
    }
  }
  Contact c = core(offset, false);
  if (c.status == Status::refused) return c;
  take_off(c, radii, 4 * epsilon * extent);
  const Vec3d n = c.normal;
  c.point_a += radius_a * n;
  c.point_b -= radius_b * n;
  c.patch = {0.5 * (c.point_a + c.point_b), {}};
  c.method_point = c.patch.centre;
  if (cache) cache->axis = c.status == Status::separated ? transposed_times(a.rotation, n) : Vec3d{};
  if (options.patch && c.gap < 0) {
    const Contact pushed = core(offset - radii * n, true);
    if (pushed.status == Status::overlapping && dot(pushed.normal, n) > same_direction) {
      c.patch = pushed.patch;
      c.patch.centre += radius_a * n;
    }
  }
  return c;
}

}  // namespace

Contact Rounded::query(const Placed<shapes::Sphere>& a, const Placed<shapes::RoundedPolyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache) {
  const double extent = max_abs(offset) + a.radius + circumradius(b.core) + b.radius;
  if (!(a.radius > 0 && extent_in_range(extent) && radius_in_range(b.radius, extent))) return refused();
  Contact c = Features::query(Placed<shapes::Sphere>{a.radius + b.radius}, b.core, offset, options, cache);
  move(c, -b.radius * c.normal);
  return c;
}

Contact Rounded::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache) {
  Options smooth = options;
  smooth.patch = false;  // met in a point
  return rounded_pair(a, 0, b.core, b.radius, offset, smooth, cache,
                      [&](const Vec3d& at, bool) { return Features::query(a, b.core, at, {}, nullptr); });
}

Contact Rounded::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache) {
  return rounded_pair(a, 0, b.core, b.radius, offset, options, cache, [&](const Vec3d& at, bool patch) {
    return Sat::query(a, b.core, at, {.overlap_only = false, .patch = patch}, nullptr);
  });
}

Contact Rounded::query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache) {
  if (!(a.radius > 0)) return refused();
  return rounded_pair(a.core, a.radius, b.core, b.radius, offset, options, cache, [&](const Vec3d& at, bool patch) {
    return Sat::query(a.core, b.core, at, {.overlap_only = false, .patch = patch}, nullptr);
  });
}

// The plane pushed towards the core by the radius: exact, with the patch at once.
Contact Rounded::query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache) {
  const double extent = max_abs(offset) + circumradius(a.core) + a.radius;
  if (!(extent_in_range(extent) && radius_in_range(a.radius, extent))) return refused();
  Contact c = PolyhedronPlane::query(a.core, b, offset + a.radius * b.normal, options, cache);
  if (c.status == Status::refused) return c;
  take_off(c, 0, 8 * epsilon * extent);
  move(c, -a.radius * b.normal);
  return c;
}

}  // namespace contact
