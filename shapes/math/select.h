// The branch-free operations that scalars and SIMD packs share by name.
#pragma once

#include <type_traits>

namespace shapes {

// a where the mask is set, b elsewhere, lane by lane.
template <class M, class T>
T select(const M& mask, const T& a, const T& b) {
  if constexpr (std::is_same_v<M, bool>) {
    return mask ? a : b;
  } else {
    T r = b;
    where(mask, r) = a;  // found by the pack's namespace
    return r;
  }
}
inline bool all_of(bool lane) { return lane; }  // of packs: their own
template <class T>
T larger(const T& a, const T& b) {
  return select(a > b, a, b);
}
template <class T>
T lesser(const T& a, const T& b) {
  return select(a < b, a, b);
}

}  // namespace shapes
