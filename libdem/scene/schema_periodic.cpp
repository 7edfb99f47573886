// The keys of [periodic] and [drag].
#include "libdem/fields/drag.h"
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::tables;
using bind::value;

namespace {

const std::vector<std::string> some{"x", "y", "z", "xy", "xz", "yz", "xyz"};
std::vector<std::string> some_or_none() {
  std::vector<std::string> all{"none"};
  all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<Key> deform_keys() {
  return {
      value<&DeformSpec::start>("start", "s", "From this time on, until the start of the next entry.").from(0),
      value<&DeformSpec::strain_rates>("strain_rates", "1/s",
                                       "Rates of the box lengths, over the lengths; negative compresses."),
      value<&DeformSpec::stress_axes>("stress_axes", "",
                                      "The axes whose rate is steered towards target_stress instead.")
          .one_of(some_or_none()),
      value<&DeformSpec::target_stress>("target_stress", "Pa",
                                        "Normal stress to reach along x, y, z; compression positive.")
          .when("stress_axes", some)
          .must(),
      value<&DeformSpec::rate_limit>("rate_limit", "1/s", "Largest rate of the stress_axes, either way.")
          .above(0)
          .when("stress_axes", some)
          .must(),
      value<&DeformSpec::gain>(
          "gain", "",
          "1 = a lack of stress is worked off in the time that sound needs to cross the box; less = slower.")
          .above(0)
          .to(10)
          .when("stress_axes", some),
      value<&DeformSpec::isotropic>("isotropic", "", "One rate for all stress_axes, after the mean of their stresses.")
          .when("stress_axes", some),
  };
}

}  // namespace

std::vector<Key> periodic_keys() {
  return {
      value<&PeriodicSpec::axes>("axes", "", "The axes along which what leaves the box enters it at the other side.")
          .one_of(some_or_none()),
      value<&PeriodicSpec::lower>("lower", "m", "Lower corner of the box; its components along the axes count.")
          .when("axes", some)
          .must(),
      value<&PeriodicSpec::upper>("upper", "m", "Upper corner.").when("axes", some).must(),
      tables<&PeriodicSpec::deform>("deform", "How the box deforms, about its centre; it takes the bodies along.",
                                    deform_keys())
          .when("axes", some),
  };
}

std::vector<Key> drag_keys() {
  std::vector<std::string> laws{"none"};
  for (const DragLawInfo& l : drag_laws) laws.emplace_back(l.name);
  return {
      value<&DragSpec::law>("law", "", "Stokes, Schiller and Naumann, a constant coefficient, or none.").one_of(laws),
      value<&DragSpec::density>("density", "kg/m^3", "Of the fluid.")
          .above(0)
          .when("law", {"schiller_naumann", "quadratic"})
          .must(),
      value<&DragSpec::viscosity>("viscosity", "Pa s", "Of the fluid.")
          .above(0)
          .when("law", {"stokes", "schiller_naumann"})
          .must(),
      value<&DragSpec::drag_coefficient>("drag_coefficient", "", "C of pi/8 C rho d^2 u^2.")
          .above(0)
          .when("law", {"quadratic"})
          .must(),
      value<&DragSpec::velocity>("velocity", "m/s", "Of the fluid at the origin."),
      value<&DragSpec::gradient>("gradient", "1/s", "Three rows of dv_i/dx_j; without it the flow is uniform."),
  };
}

}  // namespace dem
