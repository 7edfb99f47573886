#include "libdem/insertion/region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/world.h"

namespace dem {

Region::Region(const RegionSpec& spec, int dimension) : dimension_(dimension) {
  constexpr double pi = std::numbers::pi;
  if (spec.kind == "box") {
    lower_ = spec.lower;
    upper_ = spec.upper;
    if (dimension_ == 2) lower_.z = upper_.z = 0;
    const Vec3d d = upper_ - lower_;
    size_ = d.x * d.y * (dimension_ == 2 ? 1 : d.z);
    return;
  }
  centre_ = spec.centre;
  radius_ = spec.radius;
  Vec3d half{radius_, radius_, radius_};
  if (spec.kind == "cylinder") {
    kind_ = Kind::cylinder;
    half_height_ = 0.5 * spec.height;
    axis_ = shapes::normalized(spec.axis * (1 / shapes::max_abs(spec.axis)));
    // Two sides perpendicular to the axis, from the coordinate axis that is farthest from it.
    int least = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(axis_[k]) < std::abs(axis_[least])) least = k;
    Vec3d e{};
    e[least] = 1;
    side_[0] = shapes::normalized(cross(axis_, e));
    side_[1] = cross(axis_, side_[0]);
    for (int k = 0; k < 3; ++k)
      half[k] = half_height_ * std::abs(axis_[k]) + radius_ * std::sqrt(std::max(0.0, 1 - axis_[k] * axis_[k]));
    size_ = pi * radius_ * radius_ * spec.height;
  } else {
    kind_ = Kind::ball;
    if (dimension_ == 2) half.z = centre_.z = 0;
    size_ = dimension_ == 2 ? pi * radius_ * radius_ : 4 * pi / 3 * radius_ * radius_ * radius_;
  }
  lower_ = centre_ - half;
  upper_ = centre_ + half;
}

bool Region::holds_sphere(const Vec3d& x, double radius) const {
  const double r = radius * (1 - 1e-9);
  if (kind_ == Kind::box) {
    for (int k = 0; k < dimension_; ++k)
      if (!(x[k] - lower_[k] >= r && upper_[k] - x[k] >= r)) return false;
    return true;
  }
  const Vec3d d = x - centre_;
  const double along = dot(d, axis_), free = radius_ - r;
  if (kind_ == Kind::ball) return free >= 0 && dot(d, d) <= free * free;
  if (!(half_height_ - std::abs(along) >= r) || free < 0) return false;
  const Vec3d across = d - axis_ * along;
  return dot(across, across) <= free * free;
}

bool Region::has_room_for(double radius) const { return holds_sphere(0.5 * (lower_ + upper_), radius); }

Vec3d Region::sample(Random& random, double radius) const {
  Vec3d x{};
  if (kind_ == Kind::box) {
    for (int k = 0; k < dimension_; ++k) {
      const double half = std::max(0.0, 0.5 * (upper_[k] - lower_[k]) - radius);
      x[k] = 0.5 * (lower_[k] + upper_[k]) + half * random.uniform(-1, 1);
    }
    return x;
  }
  // Points of the unit ball or disc by rejection: no trigonometry.
  const bool flat = kind_ == Kind::cylinder || dimension_ == 2;
  Vec3d u;
  do {
    u = {random.uniform(-1, 1), random.uniform(-1, 1), flat ? 0.0 : random.uniform(-1, 1)};
  } while (dot(u, u) > 1);
  const double free = std::max(0.0, radius_ - radius);
  if (kind_ == Kind::ball) return centre_ + u * free;
  const double along = std::max(0.0, half_height_ - radius) * random.uniform(-1, 1);
  return centre_ + side_[0] * (free * u.x) + side_[1] * (free * u.y) + axis_ * along;
}

int dimension_of(const World& world) { return world.scene.dimension; }

Region region_of(const World& world, const std::string& name) {
  const auto& list = world.scene.regions;
  return {*std::find_if(list.begin(), list.end(), [&](const RegionSpec& r) { return r.name == name; }),
          dimension_of(world)};
}

}  // namespace dem
