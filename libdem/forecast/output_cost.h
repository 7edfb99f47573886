// What the files of a run take: one frame, one checkpoint and a small picture are made and measured.
#pragma once

#include "libdem/world.h"

namespace dem::forecast {

struct OutputCost {
  double frame = 0, checkpoint = 0;              // s
  double analysis = 0;                           // s, of all that [analysis] names, once
  double frame_bytes = 0, checkpoint_bytes = 0;  // on the disk
  double other_bytes = 0;                        // whatever the number of frames: tables, record's head, picture
};
// Nothing (all zero) when the folder for temporary files cannot be written.
OutputCost output_cost(const World& world);

struct PictureCost {
  double seconds = 0;  // on one thread
  double bytes = 0;    // of memory
};
PictureCost picture_cost(const World& world);

}  // namespace dem::forecast
