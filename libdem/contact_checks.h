// What is checked of the contacts of a step, once they are all answered; each throws a RunError that names the bodies.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "libdem/world.h"

namespace dem {

// Bodies pressed beyond each other's middle are pushed out on the other side: their normal turns round in a step.
// `through`: the records that did, in any order.
void check_passages(const World& world, const std::vector<std::uint32_t>& through);

// An impact may be over before the monitor of the time step looks: each contact is judged as it comes, and by the
// overlap that it had in its last step as it goes.
class ImpactCheck {
 public:
  explicit ImpactCheck(const World& world);
  ~ImpactCheck();
  void judge(std::span<const Change> changed);
  void stop() const;  // throws when one has failed

 private:
  struct Tightest;
  std::unique_ptr<Tightest> tightest_;
};

}  // namespace dem
