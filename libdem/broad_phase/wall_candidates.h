// Candidates of bodies with walls: half-spaces, polygons, and the facets of meshes near a body.
#pragma once

#include <vector>

#include "libcontact/methods/polygon_regions.h"
#include "libdem/broad_phase/candidate.h"
#include "libdem/world.h"

namespace dem {

// Copies of a record for each region that its pair may touch in, or the record alone.
inline void add_records(Candidate record, bool regions, std::vector<Candidate>& row) {
  if (!regions) {
    row.push_back(record);
    return;
  }
  for (std::uint32_t slot = 0; slot < contact::max_regions; ++slot) {
    record.key.part = slot;
    row.push_back(record);
  }
}

// Walls as a block of bodies sees them: stored side by side, bodies of a block are near in space, and most facets of a
// mesh are far from all of them.
class NearWalls {
 public:
  explicit NearWalls(const World& world);
  // Of bodies first … last, the block that `add` is asked for from now on.
  void look(std::size_t first, std::size_t last);
  // The walls and facets near body i go to the end of its row, in order of wall and facet; regions: the body has any.
  void add(std::size_t i, bool regions, std::vector<Candidate>& row) const;

 private:
  const World& world_;
  std::vector<Mat3d> frames_;
  std::vector<std::vector<std::uint32_t>> facets_;  // per wall, in order
};

}  // namespace dem
