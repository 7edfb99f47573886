// From a pair of kinds to the code that answers it: looked up once per chunk of pairs, never per pair.
//
// Three doors to the same code: `query` (one pair, defaults or a named method) and `find` (a function over a chunk of
// pairs of one bin). The table is derived from methods/list.h; extend.h makes it of other lists.
#pragma once

#include <cstddef>
#include <string_view>

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

// A placed body of any kind, as chunks carry it: trivially copyable, no ownership.
struct Body {
  shapes::Kind kind = shapes::Kind::sphere;
  std::uint32_t part = 0;              // mesh: facet
  const void* geometry = nullptr;      // the shape of kinds that are not given by `size` alone
  Vec3d size{};                        // sphere, disc: (radius, -, -); ellipsoid: semi-axes; ellipse: (a, b, -);
                                       // rounded polyhedron: (scale, rounding radius, -); others: (scale, -, -)
  Mat3d rotation = Mat3d::identity();  // body -> world; plane: normal = third column; line: normal = second column.
                                       // Orthonormal to 4 eps: not checked but for NaN and infinity, and no bound of an
                                       // answer holds without it
};

// Radius of a ball about the body's origin that holds it, m; 0 of planes and lines, which none holds.
CONTACT_API double circumradius(const Body& b);

template <class S>
Placed<S> placed(const Body& b) {
  if constexpr (requires { Placed<S>::of(b); }) return Placed<S>::of(b);  // a shape of a host: extend.h
  if constexpr (std::is_same_v<S, shapes::Sphere>) return {b.size.x};
  if constexpr (std::is_same_v<S, shapes::Ellipsoid>) return {b.size, b.rotation};
  if constexpr (std::is_same_v<S, shapes::Polyhedron>)
    return {static_cast<const shapes::Polyhedron*>(b.geometry), b.size.x, b.rotation};
  if constexpr (std::is_same_v<S, shapes::Plane>) return {b.rotation.column(2)};
  if constexpr (std::is_same_v<S, shapes::Mesh>)
    return {static_cast<const shapes::Mesh*>(b.geometry), b.part, b.size.x, b.rotation};
  if constexpr (std::is_same_v<S, shapes::RoundedPolyhedron>)
    return {{static_cast<const shapes::Polyhedron*>(b.geometry), b.size.x, b.rotation}, b.size.y};
  if constexpr (std::is_same_v<S, shapes::PotentialParticle>)
    return {static_cast<const shapes::PotentialParticle*>(b.geometry), b.size.x, b.rotation};
  const double cosine = b.rotation.row[0].x, sine = b.rotation.row[1].x;
  if constexpr (std::is_same_v<S, shapes::Disc>) return {b.size.x};
  if constexpr (std::is_same_v<S, shapes::Ellipse>) return {b.size.x, b.size.y, cosine, sine};
  if constexpr (std::is_same_v<S, shapes::Polygon>)
    return {static_cast<const shapes::Polygon*>(b.geometry), b.size.x, cosine, sine};
  if constexpr (std::is_same_v<S, shapes::Line>) return {b.rotation.column(1)};
}

// Answers n pairs of one bin: out[i] for (a[i], b[i], offset[i]); cache may be null, else n entries.
using ChunkQuery = void (*)(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options,
                            Cache* cache, Contact* out);

struct MethodInfo {
  std::string_view name;  // "analytic", "support_newton", …
  int cost_rank;          // static: lower is cheaper
  shapes::Kind a, b;      // a <= b
  bool certified;         // answers are certified over its whole range
  bool exact;             // the gap is right to rounding; else it is the separation along the method's own normal
  double reach;  // narrowest proven interval that it may be asked for, over the smaller circumradius: 0 of exact
                 // methods, infinite of those that prove none
  std::string_view remark;  // one clause for the catalogue
};

// The table, by (a, b) and cost rank; and its end.
CONTACT_API const MethodInfo* methods_begin();
CONTACT_API const MethodInfo* methods_end();

// Null when no such method answers this pair. Needs a <= b in kind order. "auto": the cheapest certified one of the
// exact methods, else the cheapest exact one. With a tolerance, which goes into Options as well, "auto" is the cheapest
// method whose reach it is, and after it, pair by pair and marked `handed_over`, the dearer ones as long as no interval
// is proven and narrow enough. Of answers to a tolerance, `gap_upper < 0` is what no proof of separation contradicts,
// from a cache or from elsewhere.
CONTACT_API const MethodInfo* choose(shapes::Kind a, shapes::Kind b, std::string_view method = "auto",
                                     double tolerance = 0);
CONTACT_API ChunkQuery find(shapes::Kind a, shapes::Kind b, std::string_view method = "auto", double tolerance = 0);

// For a law that acts on what the method measures: gap, normal and patch centre of the answer are
// −method_overlap, method_normal and method_point where the method is approximate.
CONTACT_API ChunkQuery find_own_measure(shapes::Kind a, shapes::Kind b, std::string_view method = "auto");

// One pair in any order; normal points from a to b; vectors relative to a's origin. Status refused for an unknown pair.
CONTACT_API Contact query(const Body& a, const Body& b, const Vec3d& offset, const Options& options = {},
                          std::string_view method = "auto");

}  // namespace contact
