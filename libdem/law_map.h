// From the shapes of two bodies that touch to what the laws take of them (law.map).
//
//   auto, equivalent_radius   1/R* = 1/R_a + 1/R_b, R of the sphere of equal volume (prism: the disc of equal area) (1)
//                 Flat faces meet by d of libcontact/overlap_depth.h, with its J, in all maps but `volume`
//   edge_radius   (1) with R = law.edge_radius of polyhedra and polygons, R = their rounding of rounded polyhedra (2)
//   curvature     R* = φ² R_e, R_e = 1/(2 sqrt(AB)) of the gap A x² + B y², φ(B/A) of laws/elliptical.h, so that
//                 Hertz' force of spheres 4/3 E* sqrt(R*) δ^(3/2) is that of the ellipse (3) at the normal where the
//                 record begins to touch, and the same until it ends
//
//   volume        the law acts on δ_eq and its force F on b along the line of action of the vector area S of the
//                 overlap V (libcontact/overlap_volume.h), with R* of (1):
//                   space   δ_eq = sqrt(V/(π R*)),                J = dδ_eq/dδ = |S|/(2π R* δ_eq)     (4)
//                   plane   δ_eq = (3A/(4 sqrt(2R*)))^(2/3),      J = 2/3 δ_eq |S|/A                  (5)
//                 force on b: J F along S, the slope of a potential of V in place and angle
//                 where F is one of δ_eq                                                              (6)
//
// Of shallow spheres (discs) δ_eq is δ and J is 1. Hertz' law on (4) is the potential 8/15 E* sqrt(R*) (V/(π
// R*))^(5/4): faces A that meet by δ press with A^(5/4) δ^(1/4), and their stiffness at first touch has no bound. The
// monitors of the step count it from the stated overlap run.dt_overlap on: below, what a step is too long for stays
// that shallow. A wall counts as flat. R* of (3) stays: one that followed the point of contact would give or take work
// where a body rolls along its shape, a seventh of the stored energy per lap at an aspect ratio of 2. The record's word
// of memory holds it, zero: not read yet. Of (3) the contact radius that a law sees is kn/(2 E*), its pull-off force
// that of R*.
//
// Source: (3) Johnson, Contact Mechanics (1985), ch. 4; (6) Y. T. Feng, Comput. Methods Appl. Mech. Eng. 373 (2021)
// 113493. Which pairs of shapes a map is for: map_verdict. Tests:
// tests/libdem/law_maps.cpp
#pragma once

#include "libdem/world.h"

namespace dem {

inline constexpr std::size_t map_count = 5;
const char* name_of(LawMap map);

enum class Verdict { theory, model, refused };
struct MapVerdict {
  Verdict verdict = Verdict::refused;
  const char* why = "";  // what the model is, or why there is none
};
// Kinds in any order; the parts of a compound count by themselves.
MapVerdict map_verdict(LawMap map, shapes::Kind a, shapes::Kind b);
MapVerdict map_verdict(LawMap map, const contact::LawModel& law);

// Throws InputError, naming shapes and map, where two kinds of the scene may meet that the map is not for.
void check_map(const World& world);

// Words of a record's memory that are the map's; they stand between those of the laws and the energy.
std::size_t map_words(const World& world);

// Whether bodies with flat faces meet by the depth of their overlap, libcontact/overlap_depth.h.
bool measures_depth(const World& world);

// All words of a record: of the laws, of the map, the stored energy. 0 where the fused kernels do without.
std::size_t record_words(const World& world);

// (4), (5) of an overlap that is there; `planar`: V is an area.
struct EquivalentOverlap {
  double overlap = 0;  // δ_eq, m
  double gain = 1;     // J
};
EquivalentOverlap equivalent_overlap(double volume, double section, double radius_eff, bool planar);
// Whether (5) is meant: prisms; else (4).
inline bool measures_area(const World& world) {
  return world.scene.dimension == 2 && world.scene.disc_model == DiscModel::prism;
}

// What a record's word is: R* of `curvature`, J of `volume`. The map's word of a record; 0: it keeps none, or not yet.
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
  const double equivalent = p.motion[i].equivalent_radius;
  return world.scene.law.map == LawMap::edge_radius ? law_radius(world, p.kind[i], p.size[i], equivalent) : equivalent;
}

// (3) of two bodies, or a body and a wall, whose normal is from a to b; `equivalent` is (1), and stays where both are
// round or one of them round and the other a wall.
double radius_of_curvature(const contact::Body& a, const contact::Body& b, const Vec3d& normal, double equivalent);

// The stiffest way in which a body may be met: how it goes into the step and into the reach of adhesion.
struct RadiusBound {
  double radius = 0;   // m, of R* of a body against a wall, without φ²
  double ratio = 1;    // largest of its principal curvatures over the other one
  double gain = 1;     // of (4), (5) where it is round
  double section = 0;  // its largest face, m², or side, m, of a body that has them
};
RadiusBound radius_bound(const World& world, std::size_t i);
RadiusBound radius_bound(const World& world, std::uint32_t shape, double scale);
double radius_bound(const RadiusBound& a, const RadiusBound& b);  // of two bodies, m
double radius_bound(const RadiusBound& a);                        // of a body and a wall, m

// Map `volume`: what an overlap of this depth, m, is to the law at the most; no second body: null.
EquivalentOverlap steepest_overlap(const World& world, const RadiusBound& a, const RadiusBound* b, double overlap);
// What record k with the overlap δ_eq is to the monitors of the step, J kept with it.
EquivalentOverlap monitored_overlap(const World& world, std::size_t k, double overlap);

}  // namespace dem
