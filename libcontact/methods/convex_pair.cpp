#include "libcontact/methods/convex_pair.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

ConvexBody in_units(ConvexBody b, double down) {
  if (!shapes::is_wall(b.kind)) b.axes *= down;
  b.scale *= down;
  b.margin *= down;
  return b;
}

// Components that no sum of lengths near 1 can feel, and whose halves may be no numbers of their own.
Vec3d without_dust(Vec3d d) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(d[i]) < 0x1p-200) d[i] = 0;
  return d;
}

Contact against_plane(const ConvexBody& a, const Vec3d& out, const Vec3d& d, double size, double up) {
  const Vec3d n = -out, on_a = a.support(n).at + a.margin * n;
  const double gap = dot(n, d - on_a), allowance = polyhedron_rounding * size;
  if (!(std::abs(gap) <= 16)) return refused();
  const double lower = std::min(gap, dot(n, d) - (a.height(n) + a.margin));
  return smooth_contact(gap, lower - allowance, gap + allowance, n, on_a, on_a + gap * n, up, 1);
}

Contact answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options,
               ConvexMethod method) {
  const double extent = max_abs(offset) + (a.reach + b.reach), limit = smallest_ratio * extent;
  if (!(extent_in_range(extent) && all_at_least(offset, -extent) && a.least >= limit && b.least >= limit))
    return refused();
  const Scale unit = scale_of(extent);
  const Vec3d d = without_dust(offset * unit.down);
  const double size = norm(d) + unit.down * (a.reach + b.reach);
  if (shapes::is_wall(b.kind)) return against_plane(in_units(a, unit.down), b.axes, d, size, unit.up);
  const ConvexPair pair{in_units(a, unit.down), in_units(b, unit.down), d, size, unit.down * std::min(a.reach, b.reach),
                        options.tolerance};
  const ConvexMeasure m = method(pair);
  const Vec3d on_a = pair.a.support(m.normal).at + pair.a.margin * m.normal,
              on_b = d + pair.b.support(-m.normal).at - pair.b.margin * m.normal;
  const double apart = dot(m.normal, d) - (pair.a.height(m.normal) + pair.b.height(-m.normal) + pair.margins());
  // The support point of a potential particle is not as good as its height.
  const bool by_heights =
      pair.a.kind == shapes::Kind::potential_particle || pair.b.kind == shapes::Kind::potential_particle;
  const double f = by_heights ? apart : dot(m.normal, on_b - on_a);
  // The extent is below 2: a rotation that is not finite.
  if (!(std::abs(f) <= 16 && dot(m.point, m.point) <= 256)) return refused();
  const double ball = norm(pair.inside()) - pair.inner_radius(), allowance = polyhedron_rounding * size;
  const double lower = std::min(f, apart) - allowance;
  const double upper = std::max(f, std::min(m.upper, ball)) + allowance;
  // Points as far apart along the normal as the gap says.
  const Vec3d between = m.meets ? f * m.normal : on_b - on_a + (f - dot(m.normal, on_b - on_a)) * m.normal;
  const Vec3d middle = m.meets ? m.point : 0.5 * (on_a + on_b);
  Contact c =
      smooth_contact(f, lower, upper, m.normal, middle - 0.5 * between, middle + 0.5 * between, unit.up, m.iterations);
  c.method_overlap = m.overlap * unit.up;
  c.method_point = m.point * unit.up;
  if (!m.converged) c.status = Status::not_converged;
  return c;
}

}  // namespace

Contact by_convex_method(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options,
                         ConvexMethod method) {
  if (a.kind == b.kind && seen_from_b(offset)) return exchanged(answer(b, a, -offset, options, method), offset);
  return answer(a, b, offset, options, method);
}

}  // namespace contact
