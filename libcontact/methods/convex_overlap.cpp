#include "libcontact/methods/convex_overlap.h"

namespace contact {

OverlapSums convex_overlap(const PolyhedronPair& pair) {
  const OverlapBody& body = overlap_body(pair);
  OverlapSums s;
  if (body.empty()) return s;
  const auto corners = body.corners();
  s.apex = corners[0];
  // A fan of triangles in each face, from any of its corners.
  static thread_local ScratchList<std::uint32_t> fans;
  fans.make_room(body.faces().size());
  for (const OverlapBody::Side& side : body.sides()) fans[side.left] = fans[side.right] = side.from;
  const auto add = [&](std::uint32_t face, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t f = fans[face];
    if (f == from || f == to) return;
    const Vec3d first = corners[f] - s.apex, p = corners[from] - corners[f], q = corners[to] - corners[f];
    const Vec3d area = 0.5 * cross(p, q), middle = first + (1.0 / 3) * (p + q);
    const std::size_t of = body.faces()[face].of_other ? 1 : 0;
    const double cone = dot(area, first) / 3;
    s.surface[of] += area;
    s.moment[of] += cross(middle, area);
    s.volume += cone;
    s.first += cone * (0.75 * middle);  // a cone's centroid, from its apex
  };
  for (const OverlapBody::Side& side : body.sides()) {
    add(side.left, side.from, side.to);
    add(side.right, side.to, side.from);
  }
  return s;
}

}  // namespace contact
