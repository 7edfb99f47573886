// Bodies that other codes wrote, on their way to a snapshot: spheres and ellipsoids.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

struct ForeignOptions {
  double density = 0;      // kg/m³, of bodies without a mass; 0: none
  double time_step = 0;    // s, of sources that count steps; 0: their time is not known
  double contact_gap = 0;  // as SphereContacts::gap
};

struct ForeignBody {
  std::uint64_t id = 0;
  Vec3d semi_axes{};  // m; all equal: a sphere
  Vec3d position{}, velocity{}, spin{};
  Quatd orientation{};
  double mass = 0;      // kg; 0: not known
  std::string species;  // as the source names it; its material too
};

class ForeignBodies {
 public:
  void add(ForeignBody body);
  // Puts the bodies into `snapshot` (which says its step, time, cell, and what the source lacks), in order of their
  // ids, wrapped into the cell, and finds the contacts of spheres. Throws InputError, naming `source`, when an id
  // stands twice.
  void finish(const std::string& source, const ForeignOptions& options, Snapshot& snapshot);

 private:
  std::uint32_t shape_of(const Vec3d& semi_axes, Snapshot& snapshot);

  std::vector<ForeignBody> bodies_;
  std::map<std::tuple<double, double, double>, std::uint32_t> shapes_;  // by proportions
  std::map<std::string, std::uint32_t> species_;
};

// Contacts of spheres (discs) from their places and sizes alone, where a source has none: pairs with
//   gap <= `gap` (R_a + R_b)                                                                                       (1)
// to nearest images, in order; without forces. Of other shapes, and of walls, none. Cost: about linear (cells as large
// as the largest body).
void find_sphere_contacts(Snapshot& snapshot, double gap);

}  // namespace dem::analysis
