// Where snapshots come from: the folder of a run, a record, a dump of another code, a CSV file of bodies. Frames are
// read one at a time.
#pragma once

#include <functional>
#include <string>

#include "libdem/analysis/foreign.h"

namespace dem::analysis {

struct Frames {
  std::string source;                         // the file that is read
  std::size_t count = 0;                      // 0: a record without frames
  std::function<Snapshot(std::size_t)> read;  // frame 0 … count − 1; throws InputError where it is damaged
};

// A folder of a run: frames of its record.h5, or without one its last state (of its checkpoint), alone. A file: record
// .h5 (beside its scene.toml); a dump (read_lammps.h); a CSV file of bodies (read_bodies_csv). Throws InputError.
Frames open_frames(const std::string& path, const ForeignOptions& options);

// One frame of bodies: columns x, y, z and radius (or diameter, or semi-axes a, b, c with qw, qx, qy, qz); further id;
// vx, vy, vz; wx, wy, wz; mass; species or type or material. A final.csv, which has no sizes, stands in the folder of
// its run: shapes and sizes are those of the bodies that its scene begins with.
Snapshot read_bodies_csv(const std::string& path, const ForeignOptions& options);

// Which frames: "A:B:S" as slices of Python and numpy have it: from A up to, not including, B, each S-th; each part may
// be left out, A and B may be negative (from the end); "A" is one frame. Throws InputError when one is outside, the
// step is not positive, or none is left.
std::vector<std::size_t> select_frames(const std::string& range, const Frames& frames);

}  // namespace dem::analysis
