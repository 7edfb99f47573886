#include "libdem/regions.h"

namespace dem {

using contact::max_regions;

void answer_regions(const contact::Body& a, const contact::Body& b, const contact::Vec3d& offset,
                    const std::uint8_t* touching, const contact::Vec3d* centre, contact::Contact* answer) {
  union Regions {
    Regions() {}  // NOLINT(modernize-use-equals-default): that would be deleted
    contact::Contact list[max_regions];
  } regions;  // without initial values, as answers below
  const contact::Contact* found = regions.list;
  const std::size_t count =
      contact::polygon_regions(a, b, offset, {.overlap_only = true, .measure = true}, regions.list);
  bool taken[max_regions] = {}, placed[max_regions] = {};
  for (std::size_t slot = 0; slot < max_regions; ++slot) {
    // Of a record without a region no more is read; clearing the whole answer would cost as much as a query.
    answer[slot].status = contact::Status::separated;
    answer[slot].gap = answer[slot].gap_upper = 1;
  }
  const auto place = [&](std::size_t region, std::size_t slot) {
    answer[slot] = found[region];
    taken[slot] = placed[region] = true;
  };
  for (;;) {
    std::size_t region = max_regions, slot = max_regions;
    double nearest = 0;
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t s = 0; s < max_regions; ++s) {
        if (placed[r] || taken[s] || touching[s] == 0) continue;
        const contact::Vec3d d = found[r].patch.centre - centre[s];
        if (slot < max_regions && !(dot(d, d) < nearest)) continue;
        nearest = dot(d, d);
        region = r;
        slot = s;
      }
    if (slot == max_regions) break;
    place(region, slot);
  }
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t s = 0; s < max_regions && !placed[r]; ++s)
      if (!taken[s]) place(r, s);
}

}  // namespace dem
