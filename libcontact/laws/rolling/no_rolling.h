// No resistance to rolling or twisting.
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct NoRolling {
  static constexpr const char *name = "none", *parameters = "", *remark = "no resistance to rolling or twisting",
                              *source = "";
  template <class T>
  using State = NoState<T>;
  template <class T>
  static Moment<T> update(const PairOf<T>&, const Kinematics<T>&, const NormalForce<T>&, const LawOptions&, State<T>&) {
    return {};
  }
};

}  // namespace contact
