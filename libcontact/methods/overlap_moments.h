// (1)–(4) of overlap_depth.h for an overlap that has been made as a body.
#pragma once

#include "libcontact/kernels/overlap_sums.h"
#include "libcontact/methods/overlap_body.h"

namespace contact {

// As libcontact gives it.
OverlapDepth line_of_action(const DepthSlope& slope);

// `size`: of the smaller body. False where the overlap is shallower than that, or its vector area has no direction.
bool depth_slope(const OverlapBody& body, double size, DepthSlope& out);

}  // namespace contact
