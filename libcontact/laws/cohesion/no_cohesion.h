// No attraction beside the normal law's own.
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct NoCohesion {
  static constexpr const char *name = "none", *parameters = "", *remark = "no attraction beside the normal law's",
                              *source = "";
  template <class T>
  using State = NoState<T>;
  static double range(const PairParameters&, const LawOptions&, double) { return 0; }
  template <class T>
  static Pull<T> update(const PairOf<T>&, const Kinematics<T>&, const NormalForce<T>&, const LawOptions&, State<T>&) {
    return {};
  }
};

}  // namespace contact
