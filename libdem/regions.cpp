#include "libdem/regions.h"

#include <algorithm>

namespace dem {

using contact::max_regions;
using contact::PartSide;
using contact::SideContact;

namespace {

constexpr std::uint32_t most = 0x7fff;  // of the places in lists that a cache has room for

contact::Cache cache_of(const PartSide& side) {
  contact::Cache cache;
  if (side.at.kind == SideContact::none || std::max({side.part_a, side.part_b, side.at.side, side.at.corner}) > most)
    return cache;
  cache.feature[0] = static_cast<std::uint32_t>(side.at.kind) << 30 | side.part_a << 15 | side.part_b;
  cache.feature[1] = side.at.side << 15 | side.at.corner;
  return cache;
}

}  // namespace

PartSide side_of(const contact::Cache& cache) {
  const std::uint32_t parts = cache.feature[0], at = cache.feature[1];
  return {{static_cast<SideContact::Kind>(parts >> 30), at >> 15, at & most}, parts >> 15 & most, parts & most};
}

bool any_region(const contact::Contact* answer) {
  return std::any_of(answer, answer + max_regions, [](const contact::Contact& q) { return q.gap < 0; });
}

double answer_regions(const contact::Body& a, const contact::Body& b, const contact::Vec3d& offset,
                      const std::uint8_t* touching, const contact::Vec3d* centre, contact::Cache* cache,
                      contact::Contact* answer) {
  union Regions {
    Regions() {}  // NOLINT(modernize-use-equals-default): that would be deleted
    contact::Contact list[max_regions];
  } regions;  // without initial values, as answers below
  const contact::Contact* found = regions.list;
  contact::RegionSearch search;
  const std::size_t count =
      contact::polygon_regions(a, b, offset, {.overlap_only = true, .measure = true}, regions.list, &search);
  bool taken[max_regions] = {}, placed[max_regions] = {};
  for (std::size_t slot = 0; slot < max_regions; ++slot) {
    // Of a record without a region no more is read; clearing the whole answer would cost as much as a query.
    answer[slot].status = contact::Status::separated;
    answer[slot].gap = answer[slot].gap_upper = 1;
    cache[slot] = {};
  }
  const auto place = [&](std::size_t region, std::size_t slot) {
    answer[slot] = found[region];
    cache[slot] = cache_of(search.side[region]);
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
  return search.clearance;
}

}  // namespace dem
