// What the view of a page shows: bodies, walls and colours of frames, packed small.
#pragma once

#include <string>
#include <vector>

#include "libdem/analysis/frames.h"
#include "libdem/report/listing.h"

namespace dem::report {

struct ViewData {
  std::string json;                    // as view.js reads it, with "</" broken up
  std::size_t bodies = 0, frames = 0;  // bodies of the last frame, drawn or not
  std::vector<std::string> notes;      // what is left out
};

// Frames of the listing, about `most_bodies` bodies of each at most (one in k, spread over ids), and at most 500,000
// bodies of all frames together (every k-th frame and the last). Places are kept to 1/65535 of the box that holds all
// of it, angles to 1/32767, colours to 1/65535 of their largest value. Bands and strain refer to frame `reference` of
// the source. Two passes over the frames.
ViewData view_data(const analysis::Frames& frames, const Listing& listing, std::size_t most_bodies,
                   std::size_t reference);

}  // namespace dem::report
