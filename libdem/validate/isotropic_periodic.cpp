// Frictionless spheres that are compressed isotropically: assembled fast they jam at a solid fraction of 0.639, where
// the backbone has 6 contacts per sphere (Agnolin and Roux, Physical Review E 76, 061302, 2007).
//
// Those are the numbers of rigid spheres. Packings under less and less pressure p come to them as overlaps and new
// contacts vanish: with Hertz's law φ − φ_J grows as (p/E)^(2/3), and Z − Z_J as its square root, (p/E)^(1/3).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/validate/held_states.h"

namespace dem::validate {

extern const Validation isotropic_periodic;
const Validation isotropic_periodic{
    "isotropic_periodic", "isotropic_periodic.toml",
    "solid fraction and contacts per sphere of jammed frictionless spheres, extrapolated to no pressure",
    [](Runs& runs) -> std::vector<Row> {
      std::vector<double> fractions, contacts;
      double hardest = 0, rattlers = 0;
      for (const int seed : {1, 2, 3}) {
        const std::vector<std::string> overrides{fmt::format("run.seed={}", seed)};
        const double young = runs.build(overrides).scene.materials[0].young;
        std::vector<double> strain, root, fraction, coordination;
        std::vector<HeldState> states = held_states(runs, overrides, fmt::format("seed_{}", seed));
        states.erase(states.begin());  // not jammed yet
        for (const HeldState& s : states) {
          strain.push_back(std::cbrt(std::pow(s.pressure / young, 2)));
          root.push_back(std::cbrt(s.pressure / young));
          fraction.push_back(s.solid_fraction);
          coordination.push_back(s.coordination);
        }
        fractions.push_back(line_through(strain, fraction).at_zero);
        contacts.push_back(line_through(root, coordination).at_zero);
        hardest = std::max(hardest, states.back().pressure / young);
        rattlers += states.back().rattlers / 3;
      }
      const auto mean = [](const std::vector<double>& v) { return (v[0] + v[1] + v[2]) / 3; };
      const auto spread = [](const std::vector<double>& v) {
        return *std::max_element(v.begin(), v.end()) - *std::min_element(v.begin(), v.end());
      };
      return {near("least pressure over Young's modulus", hardest, 1e-5, 2e-7),
              near("solid fraction, mean of 3 seeds", mean(fractions), 0.639, 0.006),
              at_most("spread of the solid fraction", spread(fractions), 0.006),
              near("contacts per sphere without rattlers, mean of 3 seeds", mean(contacts), 6, 0.15),
              at_most("spread of the contacts", spread(contacts), 0.3),
              in_band("share of rattlers at the least pressure", rattlers, 0.005, 0.05)};
    }};

}  // namespace dem::validate
