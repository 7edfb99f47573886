// A rigid body made of convex parts that may touch and overlap: clumps of spheres, non-convex solids.
//
// The body is the union of its parts. No face of a polyhedron lies inside the body, unless nothing convex can be made
// of it: pieces of a body that touch face to face are grown into each other, so that parts overlap there. Frame: the
// origin is the centre of mass, the axes are principal axes (those given where they are principal already). Built by
// shapes/compound_build.h.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "shapes/export.h"
#include "shapes/mass.h"
#include "shapes/math/quat.h"
#include "shapes/polyhedron.h"

namespace shapes {

struct SHAPES_API Compound {
  static constexpr const char* name = "compound";

  enum class PartKind : std::uint8_t { sphere, ellipsoid, polyhedron };
  struct Part {
    PartKind kind = PartKind::sphere;
    Vec3d centre{};                           // of its own frame, in the body frame, m
    Quatd orientation{};                      // its axes -> body axes; other than the identity for ellipsoids only
    Mat3d rotation = Mat3d::identity();       // the same
    Vec3d size{};                             // sphere (r, r, r), ellipsoid semi-axes, m; polyhedron (1, 1, 1)
    std::shared_ptr<const Polyhedron> solid;  // polyhedron, about `centre`
    double bounding_radius = 0;               // of a sphere about `centre` that holds the part, m
    double inscribed_radius = 0;              // of a sphere about `centre` inside the part, m
    double equivalent_radius = 0;             // of the sphere of the part's volume, m
    std::vector<std::uint32_t> neighbours;    // parts that it meets
  };
  // Where two parts meet: their intersection, which may be a flat polygon.
  struct Joint {
    std::uint32_t a = 0, b = 0;  // parts, a < b
    std::vector<Vec3d> points;   // whose hull it is, body frame, m; two spheres: none
    Vec3d middle{};              // of the points; two spheres: of the circle in which they meet, m
    Vec3d axis{};                // two spheres: unit, across the circle
    double radius = 0;           // two spheres: of the circle, m
  };

  std::vector<Part> parts;
  std::vector<Joint> joints;  // by (a, b)
  MassProperties mass;        // in this frame
  double mass_error = 0;      // bound of the relative error of volume and moments; 0: exact to rounding
  double circumradius = 0;    // m, of a sphere about the origin that holds the body
  Pose frame;                 // x_input = R(frame.orientation) x_body + frame.position

  const Joint* joint(std::uint32_t p, std::uint32_t q) const;  // null: they do not meet
};

// Distance of a point of the body frame from a part, negative inside. Exact for spheres and inside polyhedra; outside a
// polyhedron a lower bound; of ellipsoids to first order at the surface.
SHAPES_API double distance(const Compound::Part& part, const Vec3d& x);
// max of n·x over the intersection of two parts; n unit, body frame. Exact, but for joints of unlike parts, whose
// curved sides are sampled (0.3 % of their size).
SHAPES_API double extent(const Compound& body, const Compound::Joint& joint, const Vec3d& n);

}  // namespace shapes
