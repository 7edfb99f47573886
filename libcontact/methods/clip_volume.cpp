#include "libcontact/methods/clip_volume.h"

#include <utility>

#include "libcontact/methods/planar_outline.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

class Overlap {
 public:
  // Frame and units of `pair`; clips faces of self by other, then faces of other by self.
  explicit Overlap(const PolyhedronPair& pair) {
    add_faces(pair, Mat3d::identity(), {}, surface_[0]);
    add_faces(pair.swapped(), pair.other_to_self, pair.offset, surface_[1]);
  }

  PolyhedronMeasure measure(double size) const {
    PolyhedronMeasure m;
    const Vec3d surface = 0.5 * (surface_[0] - surface_[1]);  // (1): halves the rounding
    const double area = length_and_direction(surface, m.normal);
    if (!(volume_ > 0 && area > 0x1p-40 * size * size)) return m;
    m.overlap = volume_ / area;  // (2)
    m.point = apex_ + first_ * (1 / volume_);
    m.found = true;
    return m;
  }

 private:
  // What lies of self's faces in other, in the frame that x -> rotation·x + position takes self's to.
  void add_faces(const PolyhedronPair& pair, const Mat3d& rotation, const Vec3d& position, Vec3d& surface) {
    const shapes::Polyhedron &own = *pair.self, &other = *pair.other;
    for (const auto& face : own.faces) {
      Corners buffer[2], *region = buffer, *next = buffer + 1;
      for (std::uint32_t k = 0; k < face.count; ++k)
        region->push_back({pair.self_vertex(own.face_vertices[face.first + k]), 0});
      for (const auto& plane : other.faces) {
        const Vec3d n = pair.other_to_self * plane.normal;
        cut(*region, n, pair.other_scale * plane.offset + dot(n, pair.offset), 0, *next);
        std::swap(region, next);
        if (region->size() < 3) break;
      }
      if (region->size() < 3) continue;
      add(*region, rotation, position, rotation * face.normal, surface);
    }
  }

  void add(const Corners& region, const Mat3d& rotation, const Vec3d& position, const Vec3d& normal, Vec3d& surface) {
    const auto at = [&](std::size_t i) { return rotation * region[i].x + position; };
    const Vec3d first = at(0);
    if (!begun_) apex_ = first, begun_ = true;
    const double height = dot(normal, first - apex_);
    Vec3d p = at(1) - first;
    for (std::size_t i = 2; i < region.size(); ++i) {
      const Vec3d q = at(i) - first;
      const double area = 0.5 * dot(normal, cross(p, q)), cone = area * height / 3;
      surface += area * normal;
      volume_ += cone;
      first_ += cone * (0.75 * ((first - apex_) + (1.0 / 3) * (p + q)));  // a cone's centroid, from its apex
      p = q;
    }
  }

  bool begun_ = false;
  double volume_ = 0;
  Vec3d apex_{}, first_{}, surface_[2]{};
};

PolyhedronMeasure measure(const PlacedPolyhedra& placed) { return Overlap(placed.pair).measure(placed.size); }

}  // namespace

Contact ClipVolume::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                          const Options&, Cache*) {
  return by_polyhedron_method(a, b, offset, measure);
}

}  // namespace contact
