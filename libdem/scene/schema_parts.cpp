// The keys of [[shape]] of kinds that are made of parts.
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::tables;
using bind::value;

std::vector<Key> part_keys() {
  return {
      value<&ShapeSpec::spheres>("spheres", "m",
                                 "Spheres [x, y, z, radius] that are one body; they may overlap. The body is centred "
                                 "on its centre of mass, its "
                                 "axes are principal axes. Give this or spheres_file.")
          .when("kind", {"clump"}),
      value<&ShapeSpec::spheres_file>("spheres_file", "",
                                      "CSV file of spheres with columns x, y, z, radius (m, or shape.diameter says the "
                                      "size).")
          .as_file()
          .when("kind", {"clump"}),
      tables<&ShapeSpec::parts>(
          "parts",
          "Other shapes that are one body, not convex in general; centred and turned as a clump. Pieces that touch "
          "face "
          "to face have no inner faces.",
          {value<&PartSpec::shape>("shape", "",
                                   "Shape of the part: sphere, ellipsoid or any solid with flat faces, whose vertices "
                                   "or file count as they stand.")
               .refers("shape")
               .must(),
           value<&PartSpec::position>("position", "m", "Of the origin of that shape."),
           value<&PartSpec::orientation>("orientation", "",
                                         "Unit quaternion w, x, y, z: its axes to those of the body.")})
          .when("kind", {"union"})
          .must(),
  };
}

}  // namespace dem
