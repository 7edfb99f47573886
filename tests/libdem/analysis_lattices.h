// Lattices of equal spheres and discs of diameter 1 that touch, as snapshots; reference values of physics.md section 5.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libdem/analysis/snapshot.h"
#include "libdem/build.h"
#include "libdem/random.h"

namespace dem::analysis {

struct Lattice {
  std::string name;
  Vec3d cell{};              // edges of the unit cell
  std::vector<Vec3d> basis;  // in edges of the cell
  double solid_fraction = 0, voronoi_volume = 0;
  std::vector<std::pair<double, int>> shells;  // distance, count
  int dimension = 3;
};

inline std::vector<Lattice> lattices() {
  const double pi = std::numbers::pi, r2 = std::sqrt(2.0), r3 = std::sqrt(3.0), r6 = std::sqrt(6.0);
  return {
      {"simple cubic",
       {1, 1, 1},
       {{0, 0, 0}},
       pi / 6,
       1,
       {{1, 6}, {r2, 12}, {r3, 8}, {2, 6}, {std::sqrt(5.0), 24}, {r6, 24}}},
      {"body-centred",
       {2 / r3, 2 / r3, 2 / r3},
       {{0, 0, 0}, {0.5, 0.5, 0.5}},
       pi * r3 / 8,
       4 / (3 * r3),
       {{1, 8}, {2 / r3, 6}, {std::sqrt(8.0 / 3), 12}, {std::sqrt(11.0 / 3), 24}, {2, 8}, {4 / r3, 6}}},
      {"face-centred",
       {r2, r2, r2},
       {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}},
       pi / (3 * r2),
       1 / r2,
       {{1, 12}, {r2, 6}, {r3, 24}, {2, 12}, {std::sqrt(5.0), 24}, {r6, 8}}},
      {"hexagonal close",
       {1, r3, std::sqrt(8.0 / 3)},
       {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 1.0 / 6, 0.5}, {0, 2.0 / 3, 0.5}},
       pi / (3 * r2),
       1 / r2,
       {{1, 12}, {r2, 6}, {std::sqrt(8.0 / 3), 2}, {r3, 18}, {std::sqrt(11.0 / 3), 12}, {2, 6}, {std::sqrt(5.0), 12}}},
      {"square", {1, 1, 0}, {{0, 0, 0}}, pi / 4, 1, {{1, 4}, {r2, 4}, {2, 4}, {std::sqrt(5.0), 8}}, 2},
      {"hexagonal",
       {1, r3, 0},
       {{0, 0, 0}, {0.5, 0.5, 0}},
       pi / (2 * r3),
       r3 / 2,
       {{1, 6}, {r3, 6}, {2, 6}, {std::sqrt(7.0), 12}},
       2}};
}

// A sphere (in the plane a disc of a prism of the snapshot's thickness).
inline void add_round(Snapshot& s, const Vec3d& x, double radius) {
  if (s.shapes.empty()) {
    s.shapes.emplace_back();
    make_sphere(1, s.shapes[0]);
    if (s.dimension == 2) s.shapes[0].kind = shapes::Kind::disc;
    s.shapes[0].name = "ball";
    s.materials = {"stuff"};
  }
  s.id.push_back(s.count());
  s.shape.push_back(0);
  s.material.push_back(0);
  s.species.push_back(0);
  s.size.push_back({radius, radius, radius});
  s.position.push_back(x);
  for (auto* zero : {&s.velocity, &s.spin, &s.rotation}) zero->emplace_back();
  s.orientation.emplace_back();
  s.radius.push_back(radius);
  s.bounding_radius.push_back(radius);
  const double area = std::numbers::pi * radius * radius;
  s.volume.push_back(s.dimension == 2 ? area * s.thickness : 4.0 / 3 * area * radius);
  s.mass.push_back(s.volume.back());
}

// n unit cells along each axis, periodic; `offset`: of the first body, in edges of the cell.
inline Snapshot lattice_of(const Lattice& l, const std::array<int, 3>& n, const Vec3d& offset = {}) {
  Snapshot s;
  s.dimension = l.dimension;
  s.thickness = 0.25;
  for (int k = 0; k < l.dimension; ++k) {
    s.periodic[static_cast<std::size_t>(k)] = true;
    s.length[k] = n[static_cast<std::size_t>(k)] * l.cell[k];
  }
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < (l.dimension == 2 ? 1 : n[2]); ++k)
        for (const Vec3d& b : l.basis) add_round(s, scaled(Vec3d{1.0 * i, 1.0 * j, 1.0 * k} + b + offset, l.cell), 0.5);
  return s;
}

// `count` spheres (discs) at random places of a periodic or a closed box of side 1, radii between the two; they
// overlap.
inline Snapshot random_rounds(std::size_t count, double least, double greatest, bool periodic, int dimension = 3,
                              std::uint64_t seed = 1) {
  Snapshot s;
  s.dimension = dimension;
  for (int k = 0; k < dimension; ++k)
    if (periodic) s.periodic[static_cast<std::size_t>(k)] = true, s.length[k] = 1;
  Random random(seed, 2, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = random.uniform(least, greatest), m = periodic ? 0 : radius;
    const double x = random.uniform(m, 1 - m), y = random.uniform(m, 1 - m), z = random.uniform(m, 1 - m);
    add_round(s, {x, y, dimension == 2 ? 0 : z}, radius);
  }
  return s;
}

}  // namespace dem::analysis
