// What an answer of libcontact must satisfy whatever the pair is, judged in extended precision by support functions and
// memberships of the checker's own:
//
//   gap_lower <= s(normal),  s(n) = min over B of n·b − max over A of n·a                                         (1)
//   s(n) <= gap_upper for every unit n: face normals of both, the line of centres, random ones, and many about `normal`
//   at distances of 1e-1 to 1e-9, when the answer is certified                                                    (2)
//   nothing is NaN; the bounds hold the gap; the normal is a unit vector; status follows from the bounds          (3)
//   the same answer, bit for bit, from the door of any order, from a chunk, and without a patch; the same verdict with
//   a stop at the first proof and with a right or a wrong cached axis                                               (4)
//
// All within 8 eps L, for the rotation matrices that the bodies are given by are themselves rounded. Facets of a mesh
// answer for a part of a surface: of them (3) and (4) alone.
//
// How far the witness points lie off their bodies, or their distance off the gap, is a matter of degree: a point slides
// by the error of the normal times the radius of curvature. It is measured, not judged.
#pragma once

#include "tests/fuzz/pair_cases.h"

namespace pair_fuzz {

struct Judgement {
  const char* broken = nullptr;  // the rule that does not hold
  double by = 0;                 // in units of eps L, where it is a matter of degree
  bool refused = false, uncertified = false, not_converged = false;
  double width = 0;   // of the bounds, in units of eps L
  double points = 0;  // how far the witness points are off, in units of eps L
};

// (1) to (3) of an answer, which need not be the library's.
Judgement judge(const PairCase& pair, const Contact& answer, Source& source);
// (1) to (4) of the library's answer by one method.
Judgement judge(const PairCase& pair, const MethodInfo& method, Source& source);

}  // namespace pair_fuzz
