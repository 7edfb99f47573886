// Radial distribution function of the bodies' centres, of all and of one group about another: species, or what else
// settings.split says (groups.h).
//
//   g_ab(r) = n_ab(r)/(n̄_b S(r))     n_ab: mean count of bodies b per reference body a with r <= distance < r + Δr
//                                    n̄_b = N_b/V, S: volume of the shell, m³ (in the plane its area, m²)          (1)
//   S = 4π/3 ((r + Δr)³ − r³), in the plane π ((r + Δr)² − r²)                                                     (2)
//
// (9.40) and (9.41) have 2πr Δr and 4πr² Δr for S, which at r = 1, Δr = 0.1 are 5 and 9 % off; (2) is exact. Where the
// region ends S is the mean, over the reference bodies, of that part of the shell which lies in the region, exact
// (round_in_box.h): no bias, and bodies near a boundary count with what they can see. Along periodic axes that the
// region spans the nearest image counts, up to half the cell. Meant for a homogeneous system.
// Source: physics.md 1.5. Accuracy: counts exact, S to 1e-13. Cost: 1e5 spheres at five diameters 0.4 s on one core,
// 0.6 s where all sides are boundaries; memory by bins × groups². Tests: tests/libdem/analysis_rdf.cpp.
#pragma once

#include "libdem/analysis/grid.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct PairDistribution {
  std::uint32_t a = Groups::none, b = Groups::none;  // places in Rdf::names; none: all bodies
  std::vector<double> count;                         // per bin: mean per reference body
  std::vector<double> g;                             // (1)
};

struct Rdf {
  double width = 0;                     // Δr, m
  std::size_t bodies = 0;               // in the region
  std::vector<std::string> names;       // of the groups
  std::vector<PairDistribution> pairs;  // all of all first; then (a, b), where two groups or more have bodies there
  bool bounded = false;                 // an axis ends at the region's faces
};

// `range` from 0, m, cut down to half the cell along periodic axes that the region spans; bins > 0.
// Bodies of no group count among all.
Rdf rdf_of(const Snapshot& snapshot, const Groups& groups, const Domain& region, double range, int bins);
// The largest range that the nearest image allows; infinite without periodic axes.
double longest_range(const Snapshot& snapshot, const Domain& region);

Result report_rdf(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
