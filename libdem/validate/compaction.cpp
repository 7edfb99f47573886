// Frictionless spheres compressed beyond the solid fraction φ_J at which they jam, by up to 0.05: pressure grows as
// (φ − φ_J)^1.5 with Hertz's law and as its first power with linear springs, for it follows the overlaps; the contacts
// per sphere grow from the isostatic 6 as the square root (O'Hern, Silbert, Liu, Nagel, Physical Review E 68, 011306,
// 2003). States are taken as the packing is let go: on the way up spheres still find better places, and φ_J creeps.
//
// φ_J differs from packing to packing. It is where p^(2/3), or p, comes to zero on a line through the states of least
// pressure, and not fitted together with the exponent over all states: the bulk modulus grows with the contacts, by a
// quarter over the range, so a power law that should hold to its end would pull φ_J down and both exponents up.
#include <fmt/format.h>

#include <cmath>

#include "libdem/validate/held_states.h"

namespace dem::validate {

namespace {

constexpr double isostatic = 6;          // contacts per sphere that hold frictionless spheres: twice their freedoms
constexpr std::size_t near_jamming = 3;  // states that give φ_J

struct Scaling {
  double jamming = 0;                 // φ_J
  double pressure = 0, contacts = 0;  // exponents
  double least = 0, most = 0;         // φ − φ_J
};

Line logarithmic(const std::vector<HeldState>& states, double jamming, double HeldState::*value, double zero) {
  std::vector<double> x, y;
  for (const HeldState& s : states) {
    x.push_back(std::log(s.solid_fraction - jamming));
    y.push_back(std::log(s.*value - zero));
  }
  return line_through(x, y);
}

// `power`: that of the contacts' forces over their overlaps.
Scaling scaling(const std::vector<HeldState>& states, double power) {
  std::vector<double> fraction, overlap;
  for (std::size_t i = states.size() - near_jamming; i < states.size(); ++i) {
    fraction.push_back(states[i].solid_fraction);
    overlap.push_back(std::pow(states[i].pressure, 1 / power));
  }
  const Line line = line_through(fraction, overlap);
  Scaling result;
  result.jamming = -line.at_zero / line.slope;
  result.pressure = logarithmic(states, result.jamming, &HeldState::pressure, 0).slope;
  result.contacts = logarithmic(states, result.jamming, &HeldState::coordination, isostatic).slope;
  result.least = states.back().solid_fraction - result.jamming;
  result.most = states.front().solid_fraction - result.jamming;
  return result;
}

// Pressures of linear springs, Pa, at about the solid fractions of the scene's, which are those of Hertz's law.
std::vector<std::string> linear_springs() {
  std::vector<std::string> overrides{"law.name=spring_dashpot"};
  std::size_t entry = 0;
  for (const int p : {2600, 1210, 560, 260, 121, 56, 26})
    overrides.push_back(fmt::format("periodic.deform[{}].target_stress=[{}, {}, {}]", ++entry, p, p, p));
  return overrides;
}

}  // namespace

extern const Validation compaction;
const Validation compaction{
    "compaction", "compaction.toml", "exponents of pressure and of contacts over the solid fraction beyond jamming",
    [](Runs& runs) -> std::vector<Row> {
      std::vector<Row> rows;
      for (const bool hertz : {true, false}) {
        const std::string law = hertz ? "Hertz" : "linear";
        std::vector<HeldState> states =
            held_states(runs, hertz ? std::vector<std::string>{} : linear_springs(), hertz ? "hertz" : "linear");
        states.erase(states.begin());  // not jammed yet
        const Scaling s = scaling(states, hertz ? 1.5 : 1);
        rows.push_back(in_band("solid fraction at jamming, " + law, s.jamming, 0.63, 0.65));
        rows.push_back(in_band("least solid fraction beyond it, " + law, s.least, 3e-4, 7e-4));
        rows.push_back(near("largest solid fraction beyond it, " + law, s.most, 0.05, 0.005));
        rows.push_back(near("exponent of pressure, " + law, s.pressure, hertz ? 1.5 : 1, 0.1));
        rows.push_back(near("exponent of contacts, " + law, s.contacts, 0.5, 0.07));
      }
      return rows;
    }};

}  // namespace dem::validate
