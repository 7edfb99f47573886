// Shapes of a view: each the parts that are drawn, a part a round body or a mesh; and walls as triangles.
#pragma once

#include <nlohmann/json.hpp>

#include "libdem/analysis/snapshot.h"
#include "libdem/io/surfaces.h"

namespace dem::report {

using Json = nlohmann::ordered_json;

// {family, parts: [{mesh: -1 or place in meshes, centre, turn, size, own}]}; size and centre of a body of scale 1,
// `own`: the body itself has the size (spheres and ellipsoids). Meshes are added to `meshes`: {points, triangles}.
Json shape_json(const ShapeEntry& shape, Json& meshes);

// Box around bodies and, unless they are much larger, meshes of walls.
void add_to_box(const analysis::Snapshot& s, io::Box& box);

// Walls in their own frame, at the first frame in which they are present; planes end at the box and at other planes.
class ViewWalls {
 public:
  explicit ViewWalls(const io::Box& box) : box_(box) {}
  void add(const analysis::Snapshot& s);
  const Json& walls() const { return walls_; }     // [{name, points, triangles}] or null where never present
  static Json poses(const analysis::Snapshot& s);  // of each wall: [x, y, z, w, x, y, z], or null: absent

 private:
  io::Box box_;
  Json walls_ = Json::array();
};

Json list_of(const Vec3d& v);
Json list_of(const Quatd& q);

}  // namespace dem::report
