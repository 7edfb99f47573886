// The lists of force laws, one per family, and the classical combinations that have names. Scene keywords, the stages
// of the kernels, the catalogue and the property tests are made from them.
#pragma once

#include <string_view>
#include <tuple>

#include "libcontact/laws/cohesion/constant_cohesion.h"
#include "libcontact/laws/cohesion/dmt.h"
#include "libcontact/laws/cohesion/liquid_bridge.h"
#include "libcontact/laws/cohesion/liquid_bridge_rabinovich.h"
#include "libcontact/laws/cohesion/no_cohesion.h"
#include "libcontact/laws/normal/adhesive_plastic_spring.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/jkr.h"
#include "libcontact/laws/normal/latching_spring.h"
#include "libcontact/laws/normal/linear.h"
#include "libcontact/laws/normal/thornton_ning.h"
#include "libcontact/laws/normal/thornton_ning_adhesive.h"
#include "libcontact/laws/normal/viscoelastic_hertz.h"
#include "libcontact/laws/rolling/no_rolling.h"
#include "libcontact/laws/rolling/rolling_constant.h"
#include "libcontact/laws/rolling/rolling_spring.h"
#include "libcontact/laws/rolling/rolling_viscous.h"
#include "libcontact/laws/tangential/coulomb_spring.h"
#include "libcontact/laws/tangential/frictionless.h"
#include "libcontact/laws/tangential/latching_tangential.h"
#include "libcontact/laws/tangential/memory_diagram.h"
#include "libcontact/laws/tangential/mindlin_deresiewicz.h"
#include "libcontact/laws/tangential/thornton_peeling.h"

namespace contact {

using NormalLaws = std::tuple<Linear, Hertz, ViscoelasticHertz, LatchingSpring, AdhesivePlasticSpring, ThorntonNing,
                              Jkr, ThorntonNingAdhesive>;
using TangentialLaws =
    std::tuple<CoulombSpring, MindlinDeresiewicz, MemoryDiagram, LatchingTangential, ThorntonPeeling, Frictionless>;
using RollingLaws = std::tuple<NoRolling, RollingConstant, RollingViscous, RollingSpring>;
using CohesionLaws = std::tuple<NoCohesion, ConstantCohesion, Dmt, LiquidBridge, LiquidBridgeRabinovich>;

// f(Law{}, i) for every law of a list.
template <class List, class F>
constexpr void each_law(F&& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(std::tuple_element_t<i, List>{}, i), ...); }
  (std::make_index_sequence<std::tuple_size_v<List>>{});
}

// Whether a normal law's stiffness follows from moduli; else it is given.
constexpr bool hertzian(std::string_view normal) {
  bool found = false;
  each_law<NormalLaws>([&](auto law, std::size_t) {
    if (normal == law.name) found = std::string_view(law.parameters).starts_with("young");
  });
  return found;
}

struct NamedLaw {
  std::string_view name, normal, tangential, rolling, cohesion;
  bool damped;  // reads `restitution`
  std::string_view remark;
};

inline constexpr NamedLaw named_laws[] = {
    {"linear_spring", "linear", "coulomb_spring", "none", "none", false, "(9.20)-(9.23), no dashpots"},
    {"spring_dashpot", "linear", "coulomb_spring", "none", "none", true, "(9.24)-(9.28)"},
    {"hertz_mindlin", "hertz", "coulomb_spring", "none", "none", true, "(9.6), (9.7), (9.16), no micro-slip"},
    {"hertz_mindlin_deresiewicz", "hertz", "mindlin_deresiewicz", "none", "none", true,
     "Box 9.1, micro-slip step by step"},
    {"mindlin_deresiewicz_exact", "hertz", "memory_diagram", "none", "none", true,
     "micro-slip, exact for any path of loading"},
    {"jkr_thornton", "jkr", "thornton_peeling", "none", "none", true,
     "Box 9.2, sticky elastic spheres, peeling before sliding"},
    {"partially_latching_spring", "latching_spring", "latching_tangential", "none", "none", true,
     "(9.29)-(9.34), restitution by plastic flattening"},
    {"thornton_ning", "thornton_ning", "coulomb_spring", "none", "none", false, "elastic-plastic spheres"},
    {"thornton_ning_adhesive", "thornton_ning_adhesive", "coulomb_spring", "none", "none", false,
     "elastic-plastic, sticky spheres"},
    {"viscoelastic_hertz", "viscoelastic_hertz", "coulomb_spring", "none", "none", false, "spheres of a viscous solid"},
    {"adhesive_plastic_spring", "adhesive_plastic_spring", "coulomb_spring", "none", "none", true,
     "Luding's, plastic and sticky"},
    {"dmt", "hertz", "coulomb_spring", "none", "dmt", true, "small, stiff, sticky spheres"},
};

// Laws that need more of their partner than every one gives: the normal laws that they work with.
struct Partners {
  std::string_view law, normal;
};
inline constexpr Partners partners[] = {
    {"memory_diagram", "hertz, viscoelastic_hertz"},
    {"mindlin_deresiewicz", "hertz, viscoelastic_hertz"},
    {"thornton_peeling", "jkr"},
};

}  // namespace contact
