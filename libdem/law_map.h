// From the shapes of two bodies that touch to what the laws take of them (law.map).
//
//   auto, equivalent_radius   1/R* = 1/R_a + 1/R_b, R of the sphere of equal volume (prism: the disc of equal area) (1)
//   edge_radius   (1) with R = law.edge_radius of polyhedra and polygons, R = their rounding of rounded polyhedra (2)
//   curvature     R* = φ² R_e, R_e = 1/(2 sqrt(AB)) of the gap A x² + B y², φ(B/A) of laws/elliptical.h, so that
//                 Hertz' force of spheres 4/3 E* sqrt(R*) δ^(3/2) is that of the ellipse (3) at the normal where the
//                 record begins to touch, and the same until it ends
//
// A wall counts as flat. R* of (3) stays: one that followed the point of contact would give or take work where a body
// rolls along its shape, a seventh of the stored energy per lap at an aspect ratio of 2. The record's word of memory
// holds it, zero: not read yet. Of (3) the contact radius that a law sees is kn/(2 E*), its pull-off force that of R*.
//
// Source: (3) Johnson, Contact Mechanics (1985), ch. 4. Which pairs of shapes a map is for: map_verdict. Tests:
// tests/libdem/law_maps.cpp
#pragma once

#include "libdem/world.h"

namespace dem {

inline constexpr std::size_t map_count = 4;
const char* name_of(LawMap map);

enum class Verdict { theory, model, refused };
struct MapVerdict {
  Verdict verdict = Verdict::refused;
  const char* why = "";  // what the model is, or why there is none
};
// Kinds in any order; the parts of a compound count by themselves.
MapVerdict map_verdict(LawMap map, shapes::Kind a, shapes::Kind b);

// Throws InputError, naming shapes and map, where two kinds of the scene may meet that the map is not for.
void check_map(const World& world);

// Words of a record's memory that are the map's; they stand between those of the laws and the energy.
std::size_t map_words(const World& world);

// The map's word of a record; 0: it keeps none, or not yet.
inline double kept_by_map(const World& world, std::size_t record) {
  const Contacts& c = world.contacts;
  return c.words > world.law.words + 1 ? c.memory[record * c.words + world.law.words] : 0;
}

// R of (1) and (2), of a body without parts or of a part: its size as contact::Body has it, `equivalent` of equal
// volume.
inline double law_radius(const World& world, shapes::Kind kind, const Vec3d& size, double equivalent) {
  if (world.scene.law.map != LawMap::edge_radius) return equivalent;
  if (kind == shapes::Kind::rounded_polyhedron) return size.y;
  return kind == shapes::Kind::polyhedron || kind == shapes::Kind::polygon ? world.scene.law.edge_radius : equivalent;
}
inline double law_radius(const World& world, std::size_t i) {
  const Particles& p = world.particles;
  return law_radius(world, p.kind[i], p.size[i], p.motion[i].equivalent_radius);
}

// (3) of two bodies, or a body and a wall, whose normal is from a to b; `equivalent` is (1), and stays where both are
// round or one of them round and the other a wall.
double radius_of_curvature(const contact::Body& a, const contact::Body& b, const Vec3d& normal, double equivalent);

// The largest R* that a body may be met with: how it goes into the step and into the reach of adhesion.
struct RadiusBound {
  double radius = 0;  // m, of a body against a wall, without φ²
  double ratio = 1;   // largest of its principal curvatures over the other one
};
RadiusBound radius_bound(const World& world, std::size_t i);
RadiusBound radius_bound(const World& world, std::uint32_t shape, double scale);
double radius_bound(const RadiusBound& a, const RadiusBound& b);  // of two bodies, m
double radius_bound(const RadiusBound& a);                        // of a body and a wall, m

}  // namespace dem
