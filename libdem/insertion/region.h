// A region of space that bodies are put into or counted in. In two dimensions it lies in the plane z = 0.
#pragma once

#include "libdem/random.h"
#include "libdem/scene/scene.h"

namespace dem {

class Region {
 public:
  // dimension 2: box and disc; 3: box, cylinder and sphere. The values of `spec` are taken as checked.
  Region(const RegionSpec& spec, int dimension);

  const Vec3d& lower() const { return lower_; }  // of its bounding box, m
  const Vec3d& upper() const { return upper_; }
  double size() const { return size_; }  // m³; m² in two dimensions

  bool holds(const Vec3d& x) const { return holds_sphere(x, 0); }
  // Whether a sphere lies inside whole; one that touches the border does, within 1e-9 of its radius.
  bool holds_sphere(const Vec3d& x, double radius) const;
  bool has_room_for(double radius) const;
  // Uniform over the centres of spheres that lie inside; only where there is room.
  Vec3d sample(Random& random, double radius) const;

 private:
  enum class Kind { box, cylinder, ball };  // a disc is a ball of the plane
  Kind kind_ = Kind::box;
  int dimension_;
  Vec3d lower_{}, upper_{}, centre_{}, axis_{0, 0, 1}, side_[2]{};
  double radius_ = 0, half_height_ = 0, size_ = 0;
};

struct World;
// 2 in the plane, 3 in space.
int dimension_of(const World& world);
Region region_of(const World& world, const std::string& name);

}  // namespace dem
