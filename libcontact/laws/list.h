// The list of named force laws: which normal and tangential laws a combination is made of, which material parameters it
// reads, and its history. Scene keywords and the catalogue are checked against it.
#pragma once

#include <tuple>

#include "libcontact/laws/law.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"
#include "libcontact/laws/tangential/coulomb_spring.h"

namespace contact {

struct SpringDashpot {
  static constexpr const char* name = "spring_dashpot";
  using Normal = Linear;
  using Tangential = CoulombSpring;
  static constexpr const char* parameters = "stiffness (N/m), poisson, restitution, friction";
  static constexpr const char* remark = "F = kn d + cn v, clipped at zero or not; kt = kn 2(1-nu)/(2-nu)";
  static constexpr const char* source = "Cundall & Strack 1979; end of contact at F = 0, or at d = 0";
};

struct HertzMindlin {
  static constexpr const char* name = "hertz_mindlin";
  using Normal = Hertz;
  using Tangential = CoulombSpring;
  static constexpr const char* parameters = "young (Pa), poisson, restitution, friction";
  static constexpr const char* remark =
      "F = 4/3 E* sqrt(R*) d^1.5 + Tsuji's dashpot, clipped or not; kt = 8 G* a, no micro-slip";
  static constexpr const char* source =
      "Mindlin 1949; Tsuji, Tanaka & Ishida 1992; rescaling on unloading: Agnolin & Roux 2007";
};

using Laws = std::tuple<SpringDashpot, HertzMindlin>;

}  // namespace contact
