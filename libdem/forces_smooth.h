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
  // A chunk of the pairs of a smooth bin that have met: those that touched and still do. The places of the others, into
  // `rest`, of which nothing is known yet: how many they are.
  std::size_t answer_smooth(const Bin& bin, std::size_t chunk, std::uint32_t* rest, Scratch& s, Tally& t) const;

 private:
  void fetch_ahead(const Met& met, std::size_t first, std::size_t quarter) const;

  std::uint32_t prepare_stages(const std::uint32_t* record, std::size_t n, std::uint32_t good, Scratch& s) const;

  contact::kernels::SmoothBodies bodies_;
};

}  // namespace dem
