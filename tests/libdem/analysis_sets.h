// Sets of bodies for the tests of contact networks: lattices, and spheres thrown at random.
#pragma once

#include <cmath>

#include "tests/libdem/analysis_lattices.h"

namespace dem::analysis::sets {

inline std::size_t add_body(Snapshot& s, const Vec3d& x, double radius) {
  add_round(s, x, radius);
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

// n³ (n²) cells of a lattice, periodic, with its contacts.
inline Snapshot lattice(const char* name, int n) {
  Snapshot s;
  for (const Lattice& l : lattices())
    if (l.name == name) s = lattice_of(l, {n, n, n});
  touch_all(s);
  return s;
}

inline Snapshot simple_cubic(int n = 4) { return lattice("simple cubic", n); }
inline Snapshot body_centred(int n = 4) { return lattice("body-centred", n); }
inline Snapshot face_centred(int n = 3) { return lattice("face-centred", n); }
inline Snapshot close_packed(int n = 3) { return lattice("hexagonal close", n); }  // layers along z, rows along x
inline Snapshot square(int n = 5) { return lattice("square", n); }
inline Snapshot hexagonal(int n = 5) { return lattice("hexagonal", n); }

// Overlapping spheres (discs) thrown into a box of side 1, periodic or not, with forces at random.
inline Snapshot thrown(std::size_t count, bool periodic, std::uint64_t seed, int dimension = 3) {
  const double r = 0.5 * std::pow(static_cast<double>(count), -1.0 / dimension);
  Snapshot s = random_rounds(count, 0.8 * r, 1.2 * r, periodic, dimension, seed);
  touch_all(s);
  Random random(seed, 3, 0);
  for (SnapshotContact& c : s.contacts) c.force *= random.uniform(0, 2);
  return s;
}

}  // namespace dem::analysis::sets
