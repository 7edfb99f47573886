// Which method answers a pair of kinds of a scene.
//
// The method that the scene names where it answers the pair, acting on its own measure; the cheapest exact method for
// all other pairs, as walls need one too.
#pragma once

#include <string_view>

#include "libcontact/dispatch.h"

namespace dem::detection {

inline const contact::MethodInfo* choose(shapes::Kind a, shapes::Kind b, std::string_view method) {
  const contact::MethodInfo* named = contact::choose(a, b, method);
  return named != nullptr ? named : contact::choose(a, b);
}

inline contact::ChunkQuery find(shapes::Kind a, shapes::Kind b, std::string_view method) {
  const contact::ChunkQuery named = contact::find_own_measure(a, b, method);
  return named != nullptr ? named : contact::find(a, b);
}

}  // namespace dem::detection
