// Which method answers a pair of kinds of a scene.
//
// The method that the scene names where it answers the pair, acting on its own measure; for all other pairs, as walls
// need one too, the cheapest exact method, or where the scene gives a tolerance the cheapest that reaches it.
#pragma once

#include "libcontact/dispatch.h"
#include "libdem/particles.h"
#include "libdem/scene/scene.h"

namespace dem::detection {

inline const contact::MethodInfo* choose(shapes::Kind a, shapes::Kind b, const Scene& scene) {
  const contact::MethodInfo* named = contact::choose(a, b, scene.method, scene.tolerance);
  return named != nullptr ? named : contact::choose(a, b);
}

inline contact::ChunkQuery find(shapes::Kind a, shapes::Kind b, const Scene& scene) {
  const contact::ChunkQuery named = scene.method == "auto" ? contact::find(a, b, "auto", scene.tolerance)
                                                           : contact::find_own_measure(a, b, scene.method);
  return named != nullptr ? named : contact::find(a, b);
}

// Spheres, discs and half-spaces go through kernels of their own, in the bits of the exact method, unless another
// method is named for them.
inline bool closed_form(shapes::Kind a, shapes::Kind b, const Scene& scene) {
  return is_round(a) && (is_round(b) || is_half_space(b)) && choose(a, b, scene)->exact;
}

// Two ellipsoids or two ellipses by the exact method: while they touch they go through kernels of their own, which
// begin at the normal of the step before, in an answer within the interval of that method.
inline bool is_smooth(shapes::Kind a, shapes::Kind b, const Scene& scene) {
  return a == b && (a == shapes::Kind::ellipsoid || a == shapes::Kind::ellipse) &&
         choose(a, b, scene) == contact::choose(a, b);
}

// Do the answers agree with every proof of separation? Not what an approximate method measures.
inline bool agrees_with_proofs(shapes::Kind a, shapes::Kind b, const Scene& scene) {
  return scene.method == "auto" || choose(a, b, scene)->exact;
}

}  // namespace dem::detection
