// Places for the bodies of a fill: sites of a lattice, or one after the other at random.
#pragma once

#include "libdem/insertion/drafts.h"
#include "libdem/insertion/region.h"

namespace dem {

struct Place {
  Vec3d position;
  Quatd orientation;
};

// A place for every draft, in its order, such that no bounding sphere overlaps another, a body that is there already
// or a wall. Throws InputError, with what was reached, when they do not fit. A function of (seed, stream) and of what
// is there.
std::vector<Place> places(const World& world, const FillSpec& fill, const Region& region, const Recipe& recipe,
                          const std::vector<Draft>& drafts, std::uint64_t stream);
// The sites of a regular lattice in a region for bounding spheres of one radius: what `count = 0` asks for.
std::uint64_t site_count(const World& world, const FillSpec& fill, const Region& region, double radius);

// Random numbers of insertion: what is drawn from which stream.
inline constexpr std::uint64_t placing_streams = std::uint64_t(1) << 32, random_streams = std::uint64_t(2) << 32,
                               rain_streams = std::uint64_t(3) << 32, recycle_streams = std::uint64_t(4) << 32;

}  // namespace dem
