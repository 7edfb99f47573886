// Text dumps of LAMMPS and LIGGGHTS (`dump custom`), of any number of frames: spheres and ellipsoids.
//   columns    id, type; x, y, z or scaled xs, ys, zs or unwrapped xu, yu, zu or xsu, ysu, zsu; vx, vy, vz; radius or
//              diameter; mass; omegax, omegay, omegaz; of ellipsoids shapex, shapey, shapez (full lengths, as compute
//              property/atom gives them) with quatw, quati, quatj, quatk; in their place the names c_q[1] … c_q[4] and
//              c_shape[1] … c_shape[3]. Of LIGGGHTS: shapex … (semi-axes) with quat1 … quat4. Others are passed over.
//   box        BOX BOUNDS with p, f, s, m; p is periodic. A tilted box, superquadrics with a blockiness other than 2
//   and
//              frames cut short are refused, with file and line.
// Units are taken to be SI. Time is the step times `time_step`, or ITEM: TIME where the dump has it. What is missing is
// in the snapshot's notes and flags. Species and materials are the types.
// Source: LAMMPS manual, pages "dump" and "compute property/atom". Tests: tests/libdem/analysis_readers.cpp.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "libdem/analysis/foreign.h"

namespace dem::analysis {

// Whether the file begins as such a dump does.
bool is_lammps_dump(const std::string& path);

class LammpsDump {
 public:
  // Looks through the whole file once, for where its frames begin. Throws InputError.
  LammpsDump(std::string path, const ForeignOptions& options);
  std::size_t count() const { return frames_.size(); }
  Snapshot read(std::size_t frame) const;

 private:
  struct Frame {
    long long offset;  // bytes
    std::size_t line;  // of its first, from 1
  };
  std::string path_;
  ForeignOptions options_;
  std::vector<Frame> frames_;
};

}  // namespace dem::analysis
