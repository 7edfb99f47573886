// One contact query: conventions, the bodies, the answer. Everything in libcontact hangs on this header.
//
// Conventions (stated once, here):
//   gap      signed support separation  max over unit n of [ min over B of n·b − max over A of n·a ]   (1)
//            > 0: Euclidean distance; < 0: minus the least separating translation; overlap = −gap
//   normal   the maximising unit n, from A to B
//   offset   d = (origin of B) − (origin of A), formed once by the caller; every vector of the answer is relative to
//            the origin of A and along world axes, so nothing is lost far from the world's origin
//   bounds   gap_lower <= gap <= gap_upper; gap_lower is always proven, gap_upper is when `certified`
//   pairs    are stated in kind order (position in shapes::List); swapping is the caller's, with an exact sign flip
#pragma once

#include <cstdint>

#include "shapes/list.h"

namespace contact {

using shapes::Mat3d;
using shapes::Vec3d;

enum class Status : std::uint8_t { separated, touching, overlapping, not_converged, refused };

// Where the contact force acts and how the patch spreads about it. The patch is the overlap, seen along
// the normal, weighted by its local depth h: centre = ∫x h / ∫h, spread = ∫(x−c)(x−c)ᵀ h / ∫h. Smooth bodies touch in a
// point: centre midway between the witness points, spread zero.
struct Patch {
  Vec3d centre{};         // relative to A's origin, world axes, m
  double spread[6] = {};  // xx, yy, zz, xy, xz, yz of the second moment, world axes, m²
  double weight = 0;      // ∫h over the patch, m³; 0 of a point
};

// How deep flat-faced bodies lie in each other, and its slope, which a potential acts along: overlap_depth.h. On
// request it comes with the answer of facets of meshes, of the regions of polygons that are not convex, and of pairs of
// polyhedra where these can; of other pairs overlap_depth gives it.
struct OverlapDepth {
  double depth = 0;  // d, m; 0: not measured
  double gain = 1;   // J
  Vec3d normal{};    // n_f, unit, from a to b
  Vec3d point{};     // p, relative to a's origin, m: of the line of action the one next to the overlap's centroid
  double screw = 0;  // h, m
};

struct Contact {
  Status status = Status::refused;
  bool certified = false;
  bool handed_over = false;                      // the method named cannot answer this pair: the production method did
  double gap = 0, gap_lower = 0, gap_upper = 0;  // m
  Vec3d normal{};                                // unit
  Vec3d point_a{}, point_b{};                    // witness points, relative to A's origin, m
  Patch patch{};
  // What the method itself measures (a chord, the distance of two potential points, a clipped area over a length, …),
  // on which a law acts in a scene that names an approximate method. Of an exact method: −gap, normal, patch centre.
  double method_overlap = 0;  // m
  Vec3d method_normal{}, method_point{};
  OverlapDepth measure{};
  int iterations = 0;
};

// What the caller wants. `overlap_only`: a separated pair may stop at the first proof (gap is then gap_lower, the
// witness points are not set and gap_upper is +infinity); an overlapping pair is always answered in full.
// `warm_start` (ellipsoid pairs; others ignore it): the normal of every answer is left in the cache, and the search
// starts from the one that is found there. Answers then differ from cold ones within their intervals: a caller that
// needs the same bits after another history leaves it off.
// `tolerance`, relative to the smaller circumradius of the two (walls have none): a method may stop once its proven
// interval is narrower than that; 0: as narrow as it can. Methods that have nothing to gain ignore it.
struct Options {
  bool overlap_only = false;
  bool patch = true;
  bool measure = false;  // of facets, regions and polyhedron pairs; on a face of these the patch is the overlap itself
  bool warm_start = false;
  double tolerance = 0;
};

// What an earlier query of the same pair left: used as a proof that is checked anew, and as a start only on request.
// Without `warm_start` any content gives the same answer.
struct Cache {
  Vec3d axis{};                // separating direction in A's body frame; zero: none
  std::uint32_t feature[2]{};  // the method's own: what answered an overlap; zeros: none
};

// A body as a query sees it: geometry, size and rotation; its position enters only through `offset`.
template <class S>
struct Placed;
template <>
struct Placed<shapes::Sphere> {
  double radius;
};
template <>
struct Placed<shapes::Ellipsoid> {
  Vec3d semi_axes;
  Mat3d rotation;  // body -> world
};
template <>
struct Placed<shapes::Polyhedron> {
  const shapes::Polyhedron* shape;
  double scale;  // vertices are scale · shape->vertices
  Mat3d rotation;
};
template <>
struct Placed<shapes::RoundedPolyhedron> {
  Placed<shapes::Polyhedron> core;
  double radius;
};
template <>
struct Placed<shapes::PotentialParticle> {
  const shapes::PotentialParticle* shape;
  double scale;
  Mat3d rotation;
};
// Bodies of the plane: z of every vector is exactly 0, `cosine` and `sine` turn body axes to world axes.
template <>
struct Placed<shapes::Disc> {
  double radius;
};
template <>
struct Placed<shapes::Ellipse> {
  double a, b;
  double cosine, sine;
};
template <>
struct Placed<shapes::Polygon> {
  const shapes::Polygon* shape;
  double scale;
  double cosine, sine;
};
template <>
struct Placed<shapes::Plane> {
  Vec3d normal;  // unit, out of the solid; the plane passes through the body's origin
};
template <>
struct Placed<shapes::Line> {
  Vec3d normal;  // unit, z = 0, out of the solid; the line passes through the body's origin
};
template <>
struct Placed<shapes::Mesh> {  // one facet of a mesh wall: the part that a contact record belongs to
  const shapes::Mesh* mesh;
  std::uint32_t facet;
  double scale;
  Mat3d rotation;
};

inline constexpr double epsilon = 0x1p-52;

}  // namespace contact
