// Angle of repose of a heap, and its free surface.
//
//   surface  h: top of the highest body in each square, above the base and at that body's place; squares without
//            bodies have none. They are w = two mean diameters wide or a little more, so that they fill the extent of
//            the centres and none is a sliver along a wall; in the plane stretches                                 (1)
//   slope    on each side of the heap h = a − b r over the squares with 0.2 H < h < 0.8 H by least squares, r the
//            horizontal distance from the middle of mass, H the highest; that leaves out apex and toe              (2)
//   angle_k = atan b;  error_k = s_b/(1 + b²), s_b the standard error of b                                         (3)
//   angle   = mean over the n sides, error² = Σ error_k²/n² + (variance of the angles)/n                           (4)
// Sides: two in the plane, where one horizontal axis is periodic (a ridge) and where the bodies are one square deep (a
// slice of a ridge, between two walls; squares are then half as long), else eight sectors about the middle.
// A side with fewer than four squares, or that rises outwards, is left out and said: a heap against a wall has the
// others alone. Bodies without any contact are left out where contacts are known (they fly).
// A body reaches up by its bounding radius: too much where it is not round, but alike on the whole slope.
// A bed in a drum or a tray has no top: its surface is one plane, h = c + g·r by least squares over the squares in the
// middle half of its widest extent, tilt = atan |g|, error = s_g/(1 + |g|²) along the slope                      (5)
// Base: the plane or line of that name, the lowest below the bodies that looks up, or the lowest point of the bodies.
// Cost: O(bodies log bodies). Accuracy: that of (4), (5). Validity: heaps that have one top and straight sides; tilts
// of flat surfaces. Tests: tests/libdem/analysis_repose.cpp.
#pragma once

#include <optional>
#include <vector>

#include "libdem/analysis/result.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct SurfacePoint {
  Vec3d place{};      // on the surface, world, m
  double height = 0;  // above the base, m
};
struct FreeSurface {
  Vec3d up{}, along{}, across{};  // unit; `across` zero in the plane
  double base = 0, width = 0;     // height of the base along `up`; w; m
  Vec3d middle{};                 // of mass of the bodies, m
  bool ridge = false;             // along `across`
  std::vector<SurfacePoint> points;
};
FreeSurface free_surface_of(const Snapshot& snapshot, const Settings& settings);

struct Slope {
  double direction = 0;         // of its middle about `up` from `along`, rad
  double angle = 0, error = 0;  // rad
  std::size_t points = 0;
};
struct Repose {
  std::vector<Slope> slopes;    // of the sides that have one
  std::size_t sides = 0;        // looked at
  double height = 0;            // H, m
  std::optional<double> angle;  // rad
  double error = 0;             // rad
};
Repose repose_of(const FreeSurface& surface);

struct Tilt {
  double angle = 0, error = 0;  // rad
  std::size_t points = 0;
};
std::optional<Tilt> tilt_of(const FreeSurface& surface);  // (5); nothing of fewer than five squares

Result report_repose(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
