// Rounded polyhedra, from the queries of their cores: h(core ⊕ ball) = h(core) + r, so along any n
//
//   separation(n) = separation of the cores(n) − (r_A + r_B)                                                    (1)
//
// and the gap is the cores' less the radii, with the same n and bounds. Witness points move by the radii along n.
// Patch: the cores are pushed together by the radii; where they then meet with the same normal (a face is met), their
// patch is taken, else the point midway between the witness points.
//
// A facet of a mesh is met as by the ball about the point of the core that is nearest to it: the facet's plane, or one
// of its own edges or ends (facet.h); where the core passes through the facet, by the core, less the radius.
//
// A sphere is a point with a radius: its pair is that of a larger sphere with the core. Validity: any depth. Accuracy:
// that of the core's query. Cost: the core's query in full, and once more for a patch; a separated pair with a cached
// axis 0.1 us. Tests: tests/libcontact/contract.cpp, rounded_mesh.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Rounded {
  static constexpr const char* name = "rounded";
  static constexpr int cost_rank = 30;
  static constexpr const char* remark = "the core's query, less the rounding radii";

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::RoundedPolyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::RoundedPolyhedron>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
