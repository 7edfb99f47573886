// The particles: structures of arrays, stored near in memory what is near in space. Ids are persistent and never
// reused; sums, hashes and files run in order of id (order_by_id), so nothing but speed depends on the order of
// storage.
#pragma once

#include <cstdint>
#include <vector>

#include "libcontact/kernels/records.h"
#include "shapes/list.h"
#include "shapes/math/quat.h"

namespace dem {

using shapes::Mat3d;
using shapes::Quatd;
using shapes::Vec3d;

using contact::Motion;

// Bodies whose spin stays along their angular momentum: spheres, and everything that moves in a plane.
constexpr bool turns_uniformly(shapes::Kind k) { return k == shapes::Kind::sphere || shapes::dimension_of(k) == 2; }
// Kinds that the sphere kernels answer: their contact is that of their centres and radii.
constexpr bool is_round(shapes::Kind k) { return k == shapes::Kind::sphere || k == shapes::Kind::disc; }
constexpr bool is_half_space(shapes::Kind k) { return k == shapes::Kind::plane || k == shapes::Kind::line; }

struct Particles {
  std::vector<std::uint64_t> id;
  std::vector<std::uint32_t> shape;     // index into World::shapes
  std::vector<shapes::Kind> kind;       // of the shape
  std::vector<std::uint32_t> material;  // index into World::materials
  // Sphere (r, r, r), ellipsoid semi-axes, m; rounded polyhedron (scale, radius, 0); others (scale, scale, scale).
  std::vector<Vec3d> size;
  std::vector<Motion> motion;
  std::vector<Quatd> orientation;       // body -> world
  std::vector<Vec3d> rotation;          // ∫ω dt, rad
  std::vector<Vec3d> angular_momentum;  // kg m²/s, world axes
  std::vector<Vec3d> inertia;           // principal, kg m²
  std::vector<double> mass;             // kg
  std::vector<Vec3d> force, torque;     // N, N m (gravity not included)
  std::vector<std::uint32_t> species;   // 0: none; else 1 + index into Scene::species
  std::size_t count() const { return id.size(); }
  // visit(array) for every array, always in this order: what sorting, deleting and saving run over.
  template <class Self, class Visit>
  static void each_array(Self& p, Visit visit) {
    visit(p.id);
    visit(p.shape);
    visit(p.kind);
    visit(p.material);
    visit(p.size);
    visit(p.motion);
    visit(p.orientation);
    visit(p.rotation);
    visit(p.angular_momentum);
    visit(p.inertia);
    visit(p.mass);
    visit(p.force);
    visit(p.torque);
    visit(p.species);
  }
};

}  // namespace dem
