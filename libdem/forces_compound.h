// Contact forces of bodies of parts: groups of records (Contacts::groups) instead of bins.
#pragma once

#include "libdem/force_pass.h"

namespace dem {

class CompoundPass : public ForcePass {
 public:
  using ForcePass::ForcePass;

  // Groups first … last: every pair of parts is queried, bin by bin; the contacts of each group are weighed against
  // each other (contact_share.h); then the law acts on those that have a share.
  Tally answer(std::size_t first, std::size_t last, Scratch& s) const;

 private:
  struct Meet;     // one record with its parts and its answer
  struct Working;  // a thread's records of a task
  void place(const Group& group, Working& w) const;
  void query(Working& w, Scratch& s, Tally& t) const;
  void weigh(std::size_t first, std::size_t last, Working& w) const;
  double joined_depth(const Meet& i, const Meet& j) const;
  double sideways_depth(const Meet& i, const Meet& j, const shapes::Compound::Joint* joint_a,
                        const shapes::Compound::Joint* joint_b) const;
  double cover(const Meet& m) const;
  void pool_memory(std::size_t i, const Working& w) const;
  void act(Working& w, Scratch& s, Tally& t) const;
};

}  // namespace dem
