#include "libdem/sleep.h"

#include <limits>

#include "libcontact/methods/polygon_regions.h"

namespace dem {
namespace {

constexpr double steps_ahead = 16;

}  // namespace

void wake(World& world) {
  Contacts& c = world.contacts;
  c.way += c.step_way;
  if (!(c.way > c.way_allowed)) return;
  const bool known = c.way_allowed >= 0 && !c.travel.empty();
  const double w = steps_ahead * c.step_way;
  for (Bin& bin : c.bins) {
    if (bin.query == nullptr) continue;
    const std::uint32_t step = bin.regions ? contact::max_regions : 1;
    bin.awake.clear();
    for (std::uint32_t r = 0; r < bin.records.size(); r += step) {
      const std::uint32_t k = bin.records[r];
      if (known && travels(world, bin, r) + 2 * w < c.apart_until[k]) continue;
      bin.awake.push_back(r);
    }
  }
  c.way = 0;
  c.way_allowed = known ? w : c.travel.empty() ? std::numeric_limits<double>::infinity() : 0;
}

}  // namespace dem
