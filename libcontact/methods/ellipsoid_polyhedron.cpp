#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/ellipsoid_support.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/polyhedron_search.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Deep: an ellipsoid has few local maxima, all of which are known.
class Search : public PolyhedronSearch<EllipsoidAt> {
 public:
  using PolyhedronSearch::PolyhedronSearch;

  // Every local maximum there can be: face normals; on an edge's arc, one or two; in a vertex's cone, one or two. What
  // lies outside its arc or cone is only tried. Dropped: edges whose faces both lie high over a point x of the
  // ellipsoid inside the polyhedron, as f <= m·(x − p), at most the larger of the two heights of x.
  void try_everything() {
    ++iterations;
    try_faces(body_.least_axis());
    Vec3d candidate[2];
    for (const Vec3d& corner : p_.vertices) {
      const int count = maxima_of_point(body_, scale_ * corner, candidate);
      for (int k = 0; k < count; ++k) try_direction(scale_ * corner, candidate[k]);
    }
    Vec3d witness = body_.deepest(m);
    for (const auto& edge : p_.edges) {
      const auto height = [&](std::uint32_t f) {
        return dot(p_.faces[f].normal, witness) - scale_ * p_.faces[f].offset;
      };
      if (const double bound = std::max(height(edge.face[0]), height(edge.face[1])); bound < 0 && bound < value)
        continue;
      const Vec3d p = scale_ * p_.vertices[edge.vertex[0]], e = scale_ * p_.vertices[edge.vertex[1]] - p;
      const int count = maxima_of_edge(body_, p, e, candidate);
      for (int k = 0; k < count; ++k)
        if (try_direction(p, candidate[k])) witness = body_.deepest(m);
    }
    upper = value;
  }
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
  const Vec3d n = normalized(-(b.rotation * search.m));  // of the rounding of both factors
  Vec3d on_a, on_b;                                      // relative to the ellipsoid's centre
  if (Vec3d across; search.across(across)) {
    on_b = b.rotation * (across - ellipsoid.centre);
    on_a = on_b - gap * n;
  } else {
    on_a = b.rotation * -ellipsoid.support(search.m).arm;
    on_b = on_a + gap * n;
  }
  const Contact c = smooth_contact(gap, gap - allowance, std::max(search.upper, gap) + allowance, n, on_a, on_b,
                                   unit.up, search.iterations);
  if (cache) cache->axis = c.status == Status::separated ? transposed_times(a.rotation, n) : Vec3d{};
  return c;
}

}  // namespace contact
