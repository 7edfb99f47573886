// Forces of contacts of two ellipsoids, or two ellipses, that touched a step ago: in lanes from the bodies to the
// slots.
#pragma once

#include "libcontact/kernels/smooth.h"
#include "libdem/force_pass.h"

namespace dem {

class SmoothPass : public ForcePass {
 public:
  SmoothPass(World& world, double dt);

 protected:
  // Whether pairs of this bin go through lanes while they touch: where a fused kernel has the law.
  bool in_lanes(const Bin& bin) const { return bin.smooth && !staged_; }

  // Of `count` pairs, given by their places in the bin, those that touched and still do. The others, into `rest`: their
  // number is returned; nothing is known of them yet.
  std::size_t answer_smooth(const Bin& bin, const std::uint32_t* places, std::size_t count, std::uint32_t* rest,
                            Scratch& s, Tally& t) const;

 private:
  std::uint32_t answer_lanes(const Bin& bin, std::size_t n, Scratch& s) const;

  contact::kernels::SmoothBodies bodies_;
};

}  // namespace dem
