// Packing density in boxes, and on the same boxes what the bodies in them do.
//
//   D      = Σ (volume of bodies in the box)/V                  exact shares (box_share.h)                        (1)
//   flux   = Σ v (volume of the body in the box)/V              of solids, m³ per m² and s                        (2)
//   mean of the bodies whose centres lie in the box, each counted once:
//     rotation (1/np) Σ ω_i                                     (9.39): accumulated rotation ∫ω dt, rad, not spin
//     spin, velocity, coordination                              contacts with other bodies
//     granular temperature (1/np) Σ |v − mean v|²/d             d dimensions, m²/s²
//
// Envelope: boxes of several sizes fill the region; per size the mean of D over the boxes, its standard deviation
// (n − 1) and standard error deviation/√n: how large a box must be for its density to mean something. Bodies that
// overlap count both; what of a body lies outside the region does not count. Source: physics.md 1.5 (9.39).
// Accuracy: 1e-12 where the shares are. Cost: 1e5 spheres 0.1 s a grid, eight sizes of boxes 1 s on one core.
// Tests: tests/libdem/analysis_density.cpp.
#pragma once

#include "libdem/analysis/box_share.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct BoxFields {                              // one entry per box
  std::vector<double> solid_volume;             // m³
  std::vector<double> solid_fraction;           // 1
  std::vector<double> bodies;                   // centres in the box
  std::vector<Vec3d> rotation, spin, velocity;  // rad, rad/s, m/s; zero without centres
  std::vector<double> granular_temperature;     // m²/s²
  std::vector<double> coordination;             // 1
  std::vector<Vec3d> flux;                      // m/s
};
BoxFields box_fields(const Snapshot& snapshot, const BoxShares& shares, const Grid& grid);

// D of every box of a grid.
std::vector<double> solid_fractions(const BoxShares& shares, const Grid& grid);

struct EnvelopePoint {
  double edge = 0;  // of a cube (square) as large as a box, m
  std::size_t boxes = 0;
  double mean = 0, deviation = 0, error = 0, least = 0, greatest = 0;  // deviation and error 0 of a single box
};
EnvelopePoint envelope_point(const std::vector<double>& fractions, const Grid& grid);
// Boxes about 1.5, 2, 3, 4, 6, … mean diameters wide, up to the whole region; sizes that fall together once.
std::vector<EnvelopePoint> density_envelope(const Snapshot& snapshot, const BoxShares& shares, const Domain& region);

Result report_density(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
