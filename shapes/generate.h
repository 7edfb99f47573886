// Grains made by random numbers: convex bodies to a statistic of size ratios and sphericity, and Voronoi cells.
//
// Every grain is a function of (seed, stream, index) alone, the same bits on any machine; all have the size of unit
// volume-equivalent diameter (`scaled` makes others) and their principal frame. Set-up only. Tests:
// tests/shapes/generate.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapes/export.h"
#include "shapes/polyhedron.h"

namespace shapes {

// What one grain of a sample measures (see form.h).
struct FormTarget {
  double flatness = 1;          // T/W in (0, 1]
  double elongation = 1;        // W/L in (0, 1]
  double sphericity_cubed = 0;  // 36 π V²/A³; 0: not given
};

// Which of `size` grains of a sample come first, second, …: `count` of them, spread evenly over all three measures (a
// tree that halves the sample along each in turn, in random order; its leaves in the order of van der Corput). Any
// 2^k in a row hold each half, quarter, … of the sample with the same weight.
SHAPES_API std::vector<std::size_t> spread(std::span<const FormTarget> sample, std::size_t count, std::uint64_t seed,
                                           std::uint64_t stream);

// A convex grain that meets both ratios to 2e-3 (to 1e-2 where W is next to L), by a stretch of the hull of random
// points, and whose sphericity is as near as 32 trials come: fewer points make it more angular, 5 to 64 are tried.
// Where no trial meets the ratios (L = W = T) it is the one that comes nearest. Cost: about 2 ms.
SHAPES_API Polyhedron grain_of_form(const FormTarget& target, std::uint64_t seed, std::uint64_t stream,
                                    std::uint64_t index);

// Voronoi cells of random points, 64 at a time in a periodic box. `relaxations`: how often each point goes to the
// centre of mass of its cell first (Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129): rounder cells, more alike.
SHAPES_API std::vector<Polyhedron> voronoi_grains(std::size_t count, int relaxations, std::uint64_t seed,
                                                  std::uint64_t stream);
// The cells themselves, in their places in the unit box: volumes sum to 1. Vertices are relative to `point`.
struct VoronoiCell {
  Vec3d point;
  Polyhedron cell;
};
SHAPES_API std::vector<VoronoiCell> voronoi_cells(std::span<const Vec3d> points);

}  // namespace shapes
