// No tangential force: smooth bodies.
//   Ft = 0                                                                                                        (1)
// Cost: none. Tests: tests/libcontact/laws_frictionless.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct Frictionless {
  static constexpr const char* name = "none";
  static constexpr const char* parameters = "";
  static constexpr const char* remark = "no tangential force";
  static constexpr const char* source = "the smooth sphere";
  template <class T>
  struct State {
    Vec3<T> force{};  // zero
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>&, const Kinematics<T>&, const NormalForce<T>&, const LawOptions&,
                                   State<T>& s) {
    s.force = {T(0), T(0), T(0)};
    return {};
  }
};

}  // namespace contact
