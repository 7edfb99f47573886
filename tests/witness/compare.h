// What a witness proves about a pair, and how far the library's answer is from what it said.
#pragma once

#include <string>
#include <vector>

#include "tests/witness/peer.h"

namespace witness {

// What the witness's answer proves, by the plain code of bodies.h: below <= gap <= above.
//   below  support separation along its direction
//   above  separated: distance of its two points, where each is on its body within 1e-6 L, pulled into it when outside;
//          overlapping: minus the radii of the balls about its points, and midway, that fit into A and into B
struct Proof {
  Real below, above;
};
Proof proof(const Pair& pair, const Answer& answer);

// Why the interval [lower, upper] cannot hold the gap; empty when the witness proves nothing against it.
std::string contradiction(const Pair& pair, const Proof& proof, double lower, double upper);

// Whether the answer's own witnesses prove that the bodies overlap, or that they do not, as the answer says.
bool proves_itself(const Pair& pair, const contact::Contact& contact);

// What came of one query on many pairs.
struct Tally {
  int pairs = 0, threw = 0, aborted = 0, hung = 0, not_asked = 0;
  int yes_no = 0, refuted = 0;     // answers of overlap or not, |gap| > 1e-6 L; those that the plain code refutes
  int points = 0, points_off = 0;  // pairs of points when separated; those off the bodies by more than 1e-6 L
  int gaps = 0, within_3 = 0, within_6 = 0;  // gaps asked and given; within 1e-3 L, 1e-6 L of ours
  std::vector<std::string> failures;         // contradictions

  void add(const Pair& pair, const contact::Contact& contact, const Answer& answer);
  int answered() const { return pairs - threw - aborted - hung - not_asked; }
  std::string line(const std::string& name) const;
};

}  // namespace witness
