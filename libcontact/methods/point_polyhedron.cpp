#include "libcontact/methods/point_polyhedron.h"

#include <cmath>
#include <experimental/simd>
#include <limits>

#include "libcontact/contact.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {

using Feature = SurfacePoint::Feature;

double height(const shapes::Polyhedron& p, std::size_t i, double scale, const Vec3d& x) {
  return p.nx[i] * x.x + p.ny[i] * x.y + p.nz[i] * x.z - scale * p.nd[i];
}

}  // namespace

FaceHeight highest_face(const shapes::Polyhedron& p, double scale, const Vec3d& x) {
  using Lanes = std::experimental::native_simd<double>;
  using std::experimental::element_aligned;
  const Lanes vx = x.x, vy = x.y, vz = x.z, s = scale;
  const Lanes count([](auto lane) { return static_cast<double>(lane); });
  const auto value_at = [&](std::size_t i) {
    return Lanes(&p.nx[i], element_aligned) * vx + Lanes(&p.ny[i], element_aligned) * vy +
           Lanes(&p.nz[i], element_aligned) * vz - s * Lanes(&p.nd[i], element_aligned);
  };
  Lanes best = value_at(0), at = count, here = count;
  for (std::size_t i = Lanes::size(); i < p.nx.size(); i += Lanes::size()) {
    here += static_cast<double>(Lanes::size());
    const Lanes value = value_at(i);
    where(value > best, at) = here;
    best = max(value, best);
  }
  const double height = hmax(best);
  where(best != height, at) = static_cast<double>(p.nx.size());
  // Padding repeats face 0, with a higher index; NaN compares with nothing and is left to the caller.
  const double index = hmin(at);
  return {height, index < static_cast<double>(p.faces.size()) ? static_cast<std::uint32_t>(index) : 0};
}

bool over_face(const shapes::Polyhedron& p, const shapes::Polyhedron::Face& face, double scale, const Vec3d& x) {
  const std::uint32_t* loop = p.face_vertices.data() + face.first;
  Vec3d from = scale * p.vertices[loop[face.count - 1]];
  for (std::uint32_t k = 0; k < face.count; ++k) {
    const Vec3d to = scale * p.vertices[loop[k]];
    if (dot(cross(face.normal, to - from), x - from) < 0) return false;
    from = to;
  }
  return true;
}

SurfacePoint surface_point(const shapes::Polyhedron& p, double scale, const Vec3d& x, double size) {
  const auto [level, top] = highest_face(p, scale, x);
  const SurfacePoint on_top{level, p.faces[top].normal, Feature::face, top, level};
  if (!(level > 0) || over_face(p, p.faces[top], scale, x)) return on_top;
  constexpr std::size_t cap = 256;
  double known[cap];
  const std::size_t heights = p.faces.size() <= cap ? p.faces.size() : 0;
  for (std::size_t i = 0; i < heights; ++i) known[i] = height(p, i, scale, x);
  // The analyser loses track of the loop above, which has set every known[i] that is read.
  // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.UndefReturn)
  const auto height_over = [&](std::size_t i) { return heights > 0 ? known[i] : height(p, i, scale, x); };
  // A face that x is over is the highest, up to rounding between nearly parallel ones.
  for (std::size_t i = 0; i < p.faces.size(); ++i)
    if (const double h = height_over(i); h >= level - 16 * epsilon * size && over_face(p, p.faces[i], scale, x))
      return {h, p.faces[i].normal, Feature::face, static_cast<std::uint32_t>(i), level};
  // Else the closest point lies on an edge of a face that x is above.
  SurfacePoint best = on_top;
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.edges.size(); ++i) {
    const auto& edge = p.edges[i];
    if (height_over(edge.face[0]) <= 0 && height_over(edge.face[1]) <= 0) continue;
    const Vec3d from = scale * p.vertices[edge.vertex[0]], to = scale * p.vertices[edge.vertex[1]];
    const ClosestPoints c = point_segment(x, from, to - from);
    if (dot(c.normal, c.normal) >= square) continue;
    square = dot(c.normal, c.normal);
    best.outward = -c.normal;
    const bool at_from = c.b == from, at_to = c.b == to;
    best.feature = at_from || at_to ? Feature::vertex : Feature::edge;
    best.index = at_from ? edge.vertex[0] : (at_to ? edge.vertex[1] : static_cast<std::uint32_t>(i));
  }
  best.distance = std::sqrt(square);
  if (!(best.distance > 4 * epsilon * size)) return {best.distance, on_top.outward, Feature::face, on_top.index, level};
  best.outward *= 1 / best.distance;
  return best;
}

}  // namespace contact
