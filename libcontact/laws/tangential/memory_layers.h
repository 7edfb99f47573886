// Layers of a memory diagram (memory_diagram.h): what they store, and two of them made one when there is no room.
//   ∫_0^1 sqrt(x) U·D dx,  U(x) = ∫_x^1 D dx:  in a layer from x = a² to b², above which U(b²) is,
//     2/3 (b³ − a³) U(b²)·D + D² (b − a)² (4b³ + 8ab² + 12a²b + 6a³)/15                                         (1)
//   fusing layers 1 and 2, D = (D₁ h₁ + D₂ h₂)/(h₁ + h₂), changes the force by about
//     |D₁ − D₂| h₁ h₂/(h₁ + h₂) · Δsqrt(x)                                                                      (2)
// and leaves the slip that they hold as it was. Then all D shrink by the factor f that brings what is stored, less the
// work done in the step with the force at its end, down to what it was:
//     f² S' − f w' = S − w where S' − w' > S − w, else f = 1;  S of (1), w = Σ D Δ(x^1.5) · slip/(3/2 κ μ z)      (3)
// y = sqrt(x) throughout.
// Tests: tests/libcontact/laws_memory_diagram.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact::diagram {

template <class M>
bool any(const M& mask) {
  if constexpr (std::is_same_v<M, bool>)
    return mask;
  else
    return any_of(mask);
}
// b³ − a³
template <class T>
T rise(const T& a, const T& b) {
  return (b - a) * (b * b + a * b + a * a);
}
// (1)
template <class T>
T stored(const Vec3<T>* share, const T* y, int count) {
  T sum(0);
  Vec3<T> above{};
  for (int i = count - 1; i >= 0; --i) {
    const T b = y[i], a = i > 0 ? y[i - 1] : T(0), w = b - a;
    const T own = w * w * (b * b * (T(4) * b + T(8) * a) + a * a * (T(12) * b + T(6) * a));
    sum = sum + T(2.0 / 3.0) * rise(a, b) * dot(above, share[i]) + dot(share[i], share[i]) * own / T(15);
    above += share[i] * (w * (b + a));
  }
  return sum;
}

// Σ D Δ(x^1.5)
template <class T>
Vec3<T> pull(const Vec3<T>* share, const T* y, int count) {
  Vec3<T> sum{};
  for (int i = 0; i < count; ++i) sum += share[i] * rise(i > 0 ? y[i - 1] : T(0), y[i]);
  return sum;
}

// Where `full`: of `count` + 1 layers `count`, by the fusion that (2) says changes the force least. `slip` is the
// step's, over 3/2 κ μ overlap. All shares are to be multiplied by `factor` <= 1: as of (3).
template <int count, class M, class T>
void fuse(const M& full, const Vec3<T>& slip, Vec3<T>* share, T* depth, T* y, T& factor) {
  using std::sqrt;
  const T room = stored(share, y, count + 1) - dot(pull(share, y, count + 1), slip);
  T least(0), place(count);
  Vec3<T> mean{};
  for (int i = 0; i < count; ++i) {
    const T h1 = i > 0 ? depth[i] - depth[i - 1] : depth[i], h2 = depth[i + 1] - depth[i], h = h1 + h2;
    const auto thick = h > T(0);
    const T inverse = select(thick, T(1) / select(thick, h, T(1)), T(0));
    const Vec3<T> jump = share[i] - share[i + 1];
    const T kink = h1 * h2 * inverse * (y[i + 1] - (i > 0 ? y[i - 1] : T(0)));
    const T loss = dot(jump, jump) * kink * kink;  // (2), squared
    const auto best = full && (loss < least || T(i) == T(0));
    least = select(best, loss, least);
    place = select(best, T(i), place);
    mean = select(best, share[i] * (h1 * inverse) + share[i + 1] * (h2 * inverse), mean);
  }
  for (int i = 0; i < count; ++i) {
    const auto fused = place == T(i), moves = place < T(i), next = fused || moves;
    share[i] = select(fused, mean, select(moves, share[i + 1], share[i]));
    depth[i] = select(next, depth[i + 1], depth[i]);
    y[i] = select(next, y[i + 1], y[i]);
  }
  const T after = stored(share, y, count), work = dot(pull(share, y, count), slip);
  const auto more = full && after - work > room, loads = work > T(0);
  const T root = sqrt(larger(work * work + T(4) * after * room, T(0)));
  const T above = select(loads, work + root, T(2) * larger(room, T(0)));
  const T below = select(loads, T(2) * after, root - work);
  factor = select(more && below > T(0), above / select(below > T(0), below, T(1)), T(1));
}

}  // namespace contact::diagram
