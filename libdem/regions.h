// Pairs that may touch in several regions: which of the pair's records a region belongs to.
#pragma once

#include "libcontact/methods/polygon_regions.h"

namespace dem {

// The regions of a pair, one to a record: answer, touching and centre have contact::max_regions entries. A region
// continues the touching record whose centre of the step before is nearest to its own, nearest ones first; a new one
// takes the first record that is free. Records without a region are answered as separated.
void answer_regions(const contact::Body& a, const contact::Body& b, const contact::Vec3d& offset,
                    const std::uint8_t* touching, const contact::Vec3d* centre, contact::Contact* answer);

}  // namespace dem
