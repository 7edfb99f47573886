// Contacts per body.
//
//   Z  = 2 NC / np                            (9.42)   NC contacts between bodies, np bodies
//   Zm = (2 NC − n1) / (np − n1 − n0)         (9.43)   as printed: n0, n1 bodies with no, one contact
//   Zm = (2 NC − 2 n1) / (np − n1 − n0)                the contacts of the n1 removed at both ends (labelled so)
//   backbone: bodies with fewer than `least` contacts are removed, walls counted, until none is left to remove
//   Z  = π / (1 − D)                          (9.44)   of the relative density D; both are called lines of ordered
//   Z  = 14 − 10.4 (1 − D)^0.38               (9.45)   packings, but (9.45) fits random ones: FCC 7.77 for 12
//
// What holds a body: with friction two contacts can (least = 2), so (9.43) and `least` = 2 remove the same bodies in
// the first pass. Without friction a sphere without weight needs d + 1 contacts in d dimensions (least = d + 1); weight
// takes the place of one, and a flat face that of three: then `least` = d + 1 removes bodies that do rest.
// Source: physics.md 1.5; (9.43) also Thornton and Antony, Phil. Trans. R. Soc. A 356 (1998) 2763.
// With a region: of the bodies whose centres are in it, all their contacts. Cost: O(bodies + contacts).
// Tests: tests/libdem/analysis_coordination.cpp.
#pragma once

#include <optional>

#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct Coordination {
  std::size_t bodies = 0, none = 0, one = 0;  // looked at; with no and with one contact to other bodies: np, n0, n1
  double contacts = 0;                        // 2 NC: sum over these bodies
  double wall_contacts = 0;
  double mean = 0, mean_with_walls = 0;               // (9.42); 0 without bodies
  std::optional<double> mechanical;                   // (9.43); nothing where its denominator is 0
  std::optional<double> mechanical_both_ends;         // the same with 2 n1
  std::vector<std::uint32_t> of_body, walls_of_body;  // of every body of the snapshot
  std::vector<std::uint8_t> counted;                  // whether it is among those looked at
};
Coordination coordination_of(const Snapshot& snapshot, const Pairs& pairs, const std::optional<Domain>& region = {});

struct Backbone {
  std::uint32_t least = 2;
  std::size_t rattlers = 0;                     // among the bodies looked at
  std::optional<double> mean, mean_with_walls;  // contacts per body of the backbone; nothing: it is empty
  std::vector<std::uint8_t> rattles;            // per body of the snapshot
};
Backbone backbone_of(const Snapshot& snapshot, const Pairs& pairs, const Coordination& of, std::uint32_t least);

double line_of_ordered(double solid_fraction);  // (9.44)
double line_of_random(double solid_fraction);   // (9.45)

Result report_coordination(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
