#include "libcontact/methods/convex_overlap.h"

namespace contact {

OverlapSums convex_overlap(const PolyhedronPair& pair) {
  const OverlapBody& body = overlap_body(pair);
  OverlapSums s;
  if (body.faces().empty()) return s;
  s.apex = body.corner(body.faces()[0], 0);
  for (const OverlapBody::Face& f : body.faces()) {
    const Vec3d first = body.corner(f, 0) - s.apex;
    const double height = dot(f.normal, first);
    const std::size_t of = f.of_other ? 1 : 0;
    Vec3d p = body.corner(f, 1) - s.apex - first;
    for (std::uint32_t i = 2; i < f.count; ++i) {
      const Vec3d q = body.corner(f, i) - s.apex - first, middle = first + (1.0 / 3) * (p + q);
      const double area = 0.5 * dot(f.normal, cross(p, q)), cone = area * height / 3;
      s.surface[of] += area * f.normal;
      s.moment[of] += area * cross(middle, f.normal);
      s.volume += cone;
      s.first += cone * (0.75 * middle);  // a cone's centroid, from its apex
      p = q;
    }
  }
  return s;
}

}  // namespace contact
