// Pairs that may touch in several regions: which of the pair's records a region belongs to.
#pragma once

#include "libcontact/methods/polygon_regions.h"

namespace dem {

// The regions of a pair, one to a record: answer, touching, centre and cache have contact::max_regions entries. A
// region continues the touching record whose centre of the step before is nearest to its own, nearest ones first; a new
// one takes the first record that is free. Records without a region are answered as separated. Where a region lies
// about one corner its record's cache keeps that (side_of below), else nothing. Returns the clearance of
// contact::RegionSearch. Of a pair that touches, Contacts::apart_until of its second record is that of the parts that
// share no region.
double answer_regions(const contact::Body& a, const contact::Body& b, const contact::Vec3d& offset,
                      const std::uint8_t* touching, const contact::Vec3d* centre, contact::Cache* cache,
                      contact::Contact* answer);

// Whether any of the pair's records was answered with a region.
bool any_region(const contact::Contact* answer);

// What a record's cache says of its region; kind none: nothing.
contact::PartSide side_of(const contact::Cache& cache);

}  // namespace dem
