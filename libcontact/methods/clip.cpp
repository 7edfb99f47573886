#include "libcontact/methods/clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/methods/polygon_measure.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Part = shapes::Polygon::Part;

// A side of the overlap: on the outline of a, of b, or on a cut.
enum Side : std::uint32_t { of_a, of_b, of_cut };

class Overlap {
 public:
  explicit Overlap(const PlacedPolygons& pair) : pair_(pair) {
    for (const Part& p : pair.a.parts)
      for (const Part& q : pair.b.parts)
        if (meet(p, q)) clip(p, q);
  }

  // The sums of both outlines are opposite; their difference halves the rounding.
  ClippedArea result() const {
    ClippedArea c{area_, 0.5 * (surface_[of_a] - surface_[of_b]), {}, 0};
    if (!(area_ > 0)) return c;
    const Vec3d from_origin = first_ * (1 / area_);
    c.centroid = origin_ + from_origin;
    c.moment = 0.5 * (moment_[of_a] - moment_[of_b]) - cross(from_origin, c.surface).z;
    return c;
  }

 private:
  bool meet(const Part& p, const Part& q) const {
    const Vec3d between = pair_.place_b.point(q.centre) - pair_.place_a.point(p.centre);
    const double reach = pair_.place_a.scale * p.radius + pair_.place_b.scale * q.radius;
    return dot(between, between) <= reach * reach * (1 + 0x1p-30);
  }

  void clip(const Part& p, const Part& q) {
    Corners buffer[2], *region = buffer, *other = buffer + 1;
    for (std::size_t k = 0; k < p.vertices.size(); ++k)
      region->push_back({pair_.place_a.point(p.vertices[k]), p.edge[k] == shapes::Polygon::none ? of_cut : of_a});
    for (std::size_t k = 0; k < q.normals.size(); ++k) {
      const Vec3d n = pair_.place_b.direction(q.normals[k]);
      const double height = pair_.place_b.scale * q.offsets[k] + dot(n, pair_.place_b.at);
      cut(*region, n, height, q.edge[k] == shapes::Polygon::none ? of_cut : of_b, *other);
      std::swap(region, other);
      if (region->size() < 3) return;
    }
    add(*region);
  }

  void add(const Corners& region) {
    if (area_ == 0) origin_ = region[0].x;
    const Vec3d d = region[0].x - origin_;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const Vec3d& x = region[i].x;
      const Vec3d along = region[i + 1 == region.size() ? 0 : i + 1].x - x;
      const Vec3d p = x - region[0].x, q = p + along, out{along.y, -along.x, 0};
      surface_[region[i].side] += out;  // (1)
      moment_[region[i].side] += cross(d + 0.5 * (p + q), out).z;
      const double w = 0.5 * (p.x * q.y - p.y * q.x);
      area_ += w;
      first_ += w * (d + (1.0 / 3) * (p + q));
    }
  }

  const PlacedPolygons& pair_;
  double area_ = 0, moment_[3]{};
  Vec3d surface_[3]{}, first_{}, origin_{};
};

PolygonMeasure measure(const PlacedPolygons& pair) {
  PolygonMeasure m;
  const ClippedArea c = Overlap(pair).result();
  const double length = length_and_direction(c.surface, m.normal);
  if (!(c.area > 0 && length > 64 * epsilon * pair.size)) return m;
  m.overlap = c.area / length;
  m.point = m.inside = c.centroid;
  m.found = true;
  return m;
}

}  // namespace

ClippedArea clipped_area(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset) {
  double up = 1;
  ClippedArea c;
  if (const PlacedPolygons pair = placed_polygons(a, b, offset, up); pair.size > 0) c = Overlap(pair).result();
  return {c.area * up * up, c.surface * up, c.centroid * up, c.moment * up * up};
}

Contact Clip::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                    const Options&, Cache*) {
  return by_polygon_method(a, b, offset, measure);
}

}  // namespace contact
