// Sets of bodies for the tests of contact networks: lattices, and spheres thrown at random.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "libdem/analysis/snapshot.h"
#include "libdem/random.h"

namespace dem::analysis::sets {

inline std::size_t add_body(Snapshot& s, const Vec3d& x, double radius) {
  if (s.shapes.empty()) {
    ShapeEntry e;
    e.kind = s.dimension == 2 ? shapes::Kind::disc : shapes::Kind::sphere;
    s.shapes.push_back(e);
    s.materials.emplace_back("glass");
  }
  const double pi = std::numbers::pi;
  const double volume = s.dimension == 2 ? pi * radius * radius * s.thickness : 4 * pi / 3 * radius * radius * radius;
  s.id.push_back(s.id.size());
  s.shape.push_back(0);
  s.material.push_back(0);
  s.species.push_back(0);
  s.size.push_back({radius, radius, radius});
  s.position.push_back(x);
  s.velocity.emplace_back();
  s.spin.emplace_back();
  s.rotation.emplace_back();
  s.orientation.emplace_back();
  s.mass.push_back(volume * 1000);
  s.volume.push_back(volume);
  s.radius.push_back(radius);
  s.bounding_radius.push_back(radius);
  return s.count() - 1;
}

// A contact of two round bodies with a normal force, and a tangential one along z × n (or x × n).
inline void touch(Snapshot& s, std::size_t a, std::size_t b, double normal_force = 1, double tangential = 0) {
  SnapshotContact c;
  c.a = static_cast<std::uint32_t>(a);
  c.b = static_cast<std::uint32_t>(b);
  c.branch = s.between(s.position[a], s.position[b]);
  c.normal = c.branch * (1 / norm(c.branch));
  c.overlap = s.radius[a] + s.radius[b] - norm(c.branch);
  c.point = s.position[a] + c.normal * (s.radius[a] - 0.5 * c.overlap);
  Vec3d across = cross(Vec3d{0, 0, 1}, c.normal);
  if (norm(across) < 1e-9) across = cross(Vec3d{1, 0, 0}, c.normal);
  c.force = c.normal * -normal_force + across * (tangential / norm(across));
  s.contacts.push_back(c);
}

inline void touch_wall(Snapshot& s, std::size_t a, std::size_t wall, const Vec3d& into, double normal_force = 1) {
  SnapshotContact c;
  c.a = static_cast<std::uint32_t>(a);
  c.b = static_cast<std::uint32_t>(wall);
  c.wall = true;
  c.normal = into;
  c.point = s.position[a] + into * s.radius[a];
  c.branch = c.point - s.position[a];
  c.force = into * -normal_force;
  s.contacts.push_back(c);
}

// Every pair whose surfaces are nearer than `reach` times the sum of radii, minus one: all against all.
inline void touch_all(Snapshot& s, double reach = 1e-9) {
  for (std::size_t a = 0; a < s.count(); ++a)
    for (std::size_t b = a + 1; b < s.count(); ++b)
      if (norm(s.between(s.position[a], s.position[b])) <= (s.radius[a] + s.radius[b]) * (1 + reach)) touch(s, a, b);
}

// n³ (n²) cells of a lattice of spheres (discs) of diameter 1, periodic; `basis` in units of the cell.
inline Snapshot lattice(const Vec3d& cell, const std::vector<Vec3d>& basis, int n, int dimension = 3) {
  Snapshot s;
  s.dimension = dimension;
  for (int k = 0; k < dimension; ++k) {
    s.periodic[static_cast<std::size_t>(k)] = true;
    s.length[k] = cell[k] * n;
  }
  for (int k = 0; k < (dimension == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (const Vec3d& b : basis)
          add_body(s, {(i + b.x) * cell.x, (j + b.y) * cell.y, dimension == 3 ? (k + b.z) * cell.z : 0}, 0.5);
  touch_all(s);
  return s;
}

inline Snapshot simple_cubic(int n = 4) { return lattice({1, 1, 1}, {{}}, n); }
inline Snapshot body_centred(int n = 4) {
  const double a = 2 / std::sqrt(3.0);
  return lattice({a, a, a}, {{}, {0.5, 0.5, 0.5}}, n);
}
inline Snapshot face_centred(int n = 3) {
  const double a = std::sqrt(2.0);
  return lattice({a, a, a}, {{}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, n);
}
inline Snapshot close_packed(int n = 3) {  // hexagonal: layers along z, rows along x
  const double third = 1.0 / 3;
  return lattice({1, std::sqrt(3.0), 2 * std::sqrt(2.0 / 3)},
                 {{}, {0.5, 0.5, 0}, {0.5, 0.5 * third, 0.5}, {0, 0.5 + 0.5 * third, 0.5}}, n);
}
inline Snapshot square(int n = 5) { return lattice({1, 1, 1}, {{}}, n, 2); }
inline Snapshot hexagonal(int n = 5) { return lattice({1, std::sqrt(3.0), 1}, {{}, {0.5, 0.5, 0}}, n, 2); }

// Overlapping spheres thrown into a box, periodic or not, with forces at random.
inline Snapshot thrown(std::size_t count, bool periodic, std::uint64_t seed, int dimension = 3) {
  Snapshot s;
  s.dimension = dimension;
  Random random(seed, 0, 0);
  for (int k = 0; k < dimension; ++k) {
    s.periodic[static_cast<std::size_t>(k)] = periodic;
    if (periodic) s.length[k] = 1;
  }
  const double r = dimension == 3 ? 0.5 * std::cbrt(1.0 / static_cast<double>(count))
                                  : 0.5 * std::sqrt(1.0 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d x{random.uniform(0, 1), random.uniform(0, 1), dimension == 3 ? random.uniform(0, 1) : 0};
    add_body(s, x, r * random.uniform(0.8, 1.2));
  }
  touch_all(s);
  for (SnapshotContact& c : s.contacts) c.force *= random.uniform(0, 2);
  return s;
}

}  // namespace dem::analysis::sets
