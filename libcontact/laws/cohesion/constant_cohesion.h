// A constant attraction while the bodies overlap.
//   P = C     while δ > 0, else 0   [N]   (1)   C: `cohesion`
//   U = −P δ                        [J]   (2)   so that the force that parts the bodies is dU/dδ = −P
// Source: stated here. Valid as a stand-in for cohesion whose range is far below the overlap; the pull sets in and ends
// with a jump at δ = 0, within a step. Cost: one comparison. Test: tests/libcontact/laws_cohesion.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct ConstantCohesion {
  static constexpr const char* name = "constant";
  static constexpr const char* parameters = "cohesion (N)";
  static constexpr const char* remark = "the same attraction at every overlap";
  static constexpr const char* source = "";
  template <class T>
  using State = NoState<T>;
  static double range(const PairParameters&, const LawOptions&, double) { return 0; }

  template <class T>
  static Pull<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>&, const LawOptions&,
                        State<T>&) {
    Pull<T> out;
    out.force = select(k.overlap > T(0), p.cohesion, T(0));                  // (1)
    out.energy = select(k.overlap > T(0), -(p.cohesion * k.overlap), T(0));  // (2)
    return out;
  }
};

}  // namespace contact
