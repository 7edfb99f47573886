#include "libcontact/methods/vertex_triangle.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/polygon_measure.h"

namespace contact {

namespace {

using shapes::Polygon;

constexpr double parallel = 1e-9;  // sine below which edges count as parallel: one face on another

double turn(const Vec3d& p, const Vec3d& q) { return p.x * q.y - p.y * q.x; }

// Strictly inside, or on a side that another triangle of the body shares.
bool in_triangles(const Polygon& p, const Placement& place, const Vec3d& x) {
  for (const Polygon::Part& part : p.parts) {
    const Vec3d from_centre = x - place.point(part.centre);
    const double reach = place.scale * part.radius;
    if (dot(from_centre, from_centre) > reach * reach * (1 + 0x1p-30)) continue;
    const Vec3d u = place.point(part.vertices[0]);
    for (std::size_t k = 1; k + 1 < part.vertices.size(); ++k) {
      const Vec3d v = place.point(part.vertices[k]), w = place.point(part.vertices[k + 1]);
      if (turn(v - u, x - u) >= 0 && turn(w - v, x - v) >= 0 && turn(u - w, x - w) >= 0) return true;
    }
  }
  return false;
}

struct Foot {
  double depth = -1;  // negative: not inside
  std::uint32_t edge = 0;
  Vec3d on_edge{};
};

// (1)
Foot foot_of(const Polygon& p, const Placement& place, const Vec3d& x) {
  Foot best;
  if (!in_triangles(p, place, x)) return best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < p.vertices.size(); ++i) {
    const Vec3d from = place.point(p.vertices[i]), along = place.point(p.vertices[p.next(i)]) - from;
    const double s = std::clamp(dot(x - from, along) / dot(along, along), 0.0, 1.0);
    const Vec3d foot = from + s * along, off = x - foot;
    if (const double square = dot(off, off); square < least) least = square, best = {0, i, foot};
  }
  best.depth = std::sqrt(least);
  return best;
}

class Search {
 public:
  explicit Search(const PlacedPolygons& pair) : pair_(pair) {}

  // Calls use(contact) in units for every contact.
  template <class Use>
  void each(Use&& use) const {
    from(true, use);
    from(false, use);
  }

 private:
  const Polygon& body(bool a) const { return a ? pair_.a : pair_.b; }
  const Placement& place(bool a) const { return a ? pair_.place_a : pair_.place_b; }
  Vec3d vertex(bool a, std::uint32_t i) const { return place(a).point(body(a).vertices[i]); }
  Foot foot(bool of_a, std::uint32_t i) const { return foot_of(body(!of_a), place(!of_a), vertex(of_a, i)); }

  template <class Use>
  void from(bool of_a, Use& use) const {
    const Polygon &own = body(of_a), &other = body(!of_a);
    for (std::uint32_t i = 0; i < own.vertices.size(); ++i) {
      const Vec3d x = vertex(of_a, i);
      const Foot f = foot(of_a, i);
      if (f.depth < 0) continue;
      const Vec3d out = place(!of_a).direction(other.normals[f.edge]);
      use(VertexContact{kind(of_a, i, f.edge), of_a, i, f.edge, f.depth, of_a ? -out : out, 0.5 * (x + f.on_edge)});
    }
  }

  VertexContact::Kind kind(bool of_a, std::uint32_t i, std::uint32_t edge) const {
    const Polygon &own = body(of_a), &other = body(!of_a);
    const Vec3d out = place(!of_a).direction(other.normals[edge]);
    for (const std::uint32_t neighbour : {own.before(i), own.next(i)}) {
      const Foot f = foot(of_a, neighbour);
      if (f.depth >= 0 && f.edge == edge) return VertexContact::face_face;
    }
    bool corner = false;
    for (const std::uint32_t end : {edge, other.next(edge)}) {
      const Foot f = foot(!of_a, end);
      if (f.depth < 0 || (f.edge != i && f.edge != own.before(i))) continue;
      const Vec3d back = place(of_a).direction(own.normals[f.edge]);
      if (std::abs(turn(out, back)) < parallel && dot(out, back) < 0) return VertexContact::face_face;  // (2)
      corner = true;
    }
    return corner ? VertexContact::corner_corner : VertexContact::face_corner;
  }

  const PlacedPolygons& pair_;
};

PolygonMeasure measure(const PlacedPolygons& pair) {
  PolygonMeasure m;
  m.overlap = -1;
  Search(pair).each([&](const VertexContact& c) {
    if (!(c.depth > m.overlap)) return;
    m.found = true;
    m.overlap = c.depth;
    m.normal = c.normal;
    m.point = c.point;
    m.inside =
        c.vertex_of_a ? pair.place_a.point(pair.a.vertices[c.vertex]) : pair.place_b.point(pair.b.vertices[c.vertex]);
  });
  return m;
}

}  // namespace

Contact VertexTriangle::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                              const Options&, Cache*) {
  return by_polygon_method(a, b, offset, measure);
}

std::size_t vertex_triangle_contacts(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b,
                                     const Vec3d& offset, VertexContact* out, std::size_t most) {
  double up = 1;
  const PlacedPolygons pair = placed_polygons(a, b, offset, up);
  if (!(pair.size > 0)) return 0;
  std::size_t count = 0;
  Search(pair).each([&](VertexContact c) {
    if (count == most) return;
    c.depth *= up;
    c.point *= up;
    out[count++] = c;
  });
  return count;
}

}  // namespace contact
