// Which method answers a pair of kinds of a scene.
//
// The method that the scene names where it answers the pair, acting on its own measure; for all other pairs, as walls
// need one too, the cheapest exact method, or where the scene gives a tolerance the cheapest that reaches it.
#pragma once

#include <string_view>

#include "libcontact/dispatch.h"

namespace dem::detection {

// How a scene wants its contacts found.
struct Choice {
  std::string_view method = "auto";
  double tolerance = 0;  // of the gap, over the smaller circumradius; 0: exact
};

inline const contact::MethodInfo* choose(shapes::Kind a, shapes::Kind b, const Choice& choice) {
  if (const contact::MethodInfo* named = contact::choose(a, b, choice.method);
      named != nullptr && (choice.method != "auto" || !(choice.tolerance > 0)))
    return named;
  for (const contact::MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m)
    if (m->a == a && m->b == b && m->reach <= choice.tolerance && choice.tolerance > 0) return m;
  return contact::choose(a, b);
}

inline contact::ChunkQuery find(shapes::Kind a, shapes::Kind b, const Choice& choice) {
  if (choice.method != "auto")
    if (const contact::ChunkQuery named = contact::find_own_measure(a, b, choice.method); named != nullptr)
      return named;
  return choice.tolerance > 0 ? contact::find_within(a, b) : contact::find(a, b);
}

// Spheres, discs and half-spaces go through kernels of their own, in the bits of the exact method, unless another
// method is named for them.
inline bool closed_form(shapes::Kind a, shapes::Kind b, const Choice& choice) {
  const auto round = [](shapes::Kind k) { return k == shapes::Kind::sphere || k == shapes::Kind::disc; };
  const bool half_space = b == shapes::Kind::plane || b == shapes::Kind::line;
  return round(a) && (round(b) || half_space) && choose(a, b, choice)->exact;
}

// Do the answers agree with every proof of separation? Not what an approximate method measures.
inline bool agrees_with_proofs(shapes::Kind a, shapes::Kind b, const Choice& choice) {
  return choice.method == "auto" || choose(a, b, choice)->exact;
}

}  // namespace dem::detection
