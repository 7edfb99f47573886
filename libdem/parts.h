// The parts of a body as contacts see them. A body without parts is its own part 0.
#pragma once

#include "libdem/world.h"

namespace dem {

inline const shapes::Compound* compound_of(const World& world, std::size_t i) {
  return world.shapes[world.particles.shape[i]].compound.get();
}
inline std::uint32_t part_count(const World& world, std::size_t i) {
  const shapes::Compound* c = compound_of(world, i);
  return c == nullptr ? 1 : static_cast<std::uint32_t>(c->parts.size());
}
shapes::Kind kind_of(shapes::Compound::PartKind kind);
shapes::Kind part_kind(const World& world, std::size_t i, std::uint32_t part);

struct PartBody {
  contact::Body body;
  Vec3d centre;   // relative to the body's centre, world axes, m
  double radius;  // of curvature, as laws of spheres take it: that of the part where it is round, else the equivalent
                  // radius of the whole body, which does not depend on how it was cut, or what law.map gives, m
};
// `rotation`: of body i, body axes -> world axes.
PartBody part_body(const World& world, std::size_t i, std::uint32_t part, const Mat3d& rotation);
double part_radius(const World& world, std::size_t i, std::uint32_t part);  // PartBody::radius

// A sphere about a part, for the search.
struct PartBall {
  Vec3d centre;   // relative to the body's centre, world axes, m
  double radius;  // m
};
PartBall part_ball(const World& world, std::size_t i, std::uint32_t part, const Mat3d& rotation);

// max of n·x over a part, relative to its own centre; n unit, world axes.
double part_extent(const contact::Body& part, const Vec3d& n);

// Distance of a point of the body frame from a part at scale 1, negative inside; of an ellipsoid to first order.
double part_distance(const shapes::Compound::Part& part, const Vec3d& x);

}  // namespace dem
