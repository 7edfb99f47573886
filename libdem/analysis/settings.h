// What may be asked of the quantities; one set for a command, a scene's [analysis], or a call.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

struct Settings {
  std::optional<Domain> region;       // where to look; else domain_of(snapshot)
  std::array<int, 3> boxes{0, 0, 0};  // boxes along each axis; 0: about four mean diameters each
  int bins = 36;                      // of a rose over the full circle, of histograms
  double rdf_range = 0;               // m; 0: five mean diameters
  int rdf_bins = 200;
  int voronoi_points = 0;               // surface points per body of set-Voronoi; 0: chosen, with its error
  std::string split = "species";        // what mixing compares: the words of groups.h
  double strong_force = 1;              // of the mean normal force: from here on a contact is in the strong network
  std::string base_wall;                // of the angle of repose; empty: the lowest
  const Snapshot* reference = nullptr;  // frame that displacements, bands and mixing refer to; null: none
  const Snapshot* before = nullptr;     // the frame before this one; null: this is the first
};

}  // namespace dem::analysis
