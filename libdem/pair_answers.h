// The answers to the pairs of a step, kind by kind: detection, law, back to their records.
#pragma once

#include <memory>

#include "libdem/force_pass.h"

namespace dem {

class PairAnswers {
 public:
  PairAnswers(World& world, double dt);
  ~PairAnswers();
  PairAnswers(const PairAnswers&) = delete;
  PairAnswers& operator=(const PairAnswers&) = delete;
  // Chunks first … last of the pairs that have met, records of spheres with planes, or awake pairs of other bins.
  Tally answer(Bin& bin, bool met, std::size_t first, std::size_t last, Scratch& s) const;
  // Whether kernels run across pairs of this bin.
  bool in_lanes(const Bin& bin) const;

 private:
  struct Pass;
  std::unique_ptr<const Pass> pass_;
};

}  // namespace dem
