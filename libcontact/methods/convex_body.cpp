#include "libcontact/methods/convex_body.h"

#include <cmath>

#include "libcontact/methods/vertex_support.h"
#include "shapes/vertex_lookup.h"

namespace contact {

namespace {

using shapes::Kind;

const shapes::Polyhedron& solid(const ConvexBody& b) { return *static_cast<const shapes::Polyhedron*>(b.geometry); }
const shapes::PotentialParticle& potential(const ConvexBody& b) {
  return *static_cast<const shapes::PotentialParticle*>(b.geometry);
}
const shapes::Polygon& polygon(const ConvexBody& b) { return *static_cast<const shapes::Polygon*>(b.geometry); }
shapes::PotentialSupport<double> potential_support(const ConvexBody& b, const Vec3d& n, const Vec3d* near = nullptr) {
  const Vec3d m = transposed_times(b.rotation, n);
  Vec3d start{};
  if (near != nullptr) start = transposed_times(b.rotation, *near) * (1 / b.scale) - potential(b).centre;
  return shapes::support_from_centre<double>(potential(b), m * (1 / norm(m)), near != nullptr ? &start : nullptr);
}

}  // namespace

ConvexBody::Far ConvexBody::support(const Vec3d& n, const Vec3d* near) const {
  switch (kind) {
    case Kind::polyhedron:
    case Kind::rounded_polyhedron: {
      const shapes::Polyhedron& p = solid(*this);
      const Vec3d m = transposed_times(rotation, n);
      const std::uint32_t v = p.vx.size() <= scan_limit
                                  ? highest_vertex(p, m).index
                                  : climb(p, m, p.lookup[shapes::lookup_patch(m, p.lookup_cells)]).index;
      return {rotation * (scale * p.vertices[v]), v};
    }
    case Kind::polygon: {
      const shapes::Polygon& p = polygon(*this);
      const Vec3d m = transposed_times(rotation, n);
      std::uint32_t v = 0;
      double most = -std::numeric_limits<double>::infinity();
      for (std::uint32_t i = 0; i < p.vertices.size(); ++i)
        if (const double along = dot(m, p.vertices[i]); along > most) most = along, v = i;
      return {rotation * (scale * p.vertices[v]), v};
    }
    case Kind::ellipsoid:
    case Kind::ellipse: {
      const Vec3d u = scaled(axes, transposed_times(rotation, n));
      return {rotation * scaled(axes, u * (1 / norm(u)))};
    }
    case Kind::potential_particle:
      return {rotation * (scale * (potential_support(*this, n, near).from_centre + potential(*this).centre))};
    default:
      return {Vec3d{}};
  }
}

double ConvexBody::height(const Vec3d& n) const {
  if (is_solid()) return scale * highest_vertex(solid(*this), transposed_times(rotation, n)).value;
  if (kind != Kind::potential_particle) return dot(n, support(n).at);
  const auto s = potential_support(*this, n);
  return scale * (s.height + s.excess + dot(transposed_times(rotation, n), potential(*this).centre));
}

Vec3d ConvexBody::inner_centre() const {
  switch (kind) {
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
      return rotation * (scale * core_ball(solid(*this)).centre);
    case Kind::polygon:
      return rotation * (scale * polygon(*this).centroid);
    case Kind::potential_particle:
      return rotation * (scale * potential(*this).centre);
    default:
      return {};
  }
}

double ConvexBody::inner_radius() const {
  switch (kind) {
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
      return scale * core_ball(solid(*this)).radius + margin;
    case Kind::potential_particle:
      return scale * potential(*this).inner_radius;
    case Kind::ellipsoid:
      return std::min({axes.x, axes.y, axes.z});
    case Kind::ellipse:
      return std::min(axes.x, axes.y);
    case Kind::polygon: {
      const shapes::Polygon& p = polygon(*this);
      double least = p.circumradius;
      for (std::size_t i = 0; i < p.normals.size(); ++i)
        least = std::min(least, p.offsets[i] - dot(p.normals[i], p.centroid));
      return scale * least;
    }
    default:
      return margin;
  }
}

}  // namespace contact
