// Counter-based random numbers: a value is a function of (seed, stream, index) alone, so nothing depends on the order
// in which numbers are drawn, on threads or on a restart. Mixing: two rounds of the 64-bit finaliser of SplitMix64
// (Steele, Lea, Flood, OOPSLA 2014) per word.
#pragma once

#include <cmath>
#include <cstdint>

#include "shapes/math/quat.h"

namespace shapes {

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : state_(mix(mix(seed + 0x9e3779b97f4a7c15u) ^ mix(stream + 0xd1b54a32d192ed03u)) ^
               mix(index + 0x8cb92ba72f3d8dd7u)) {}

  std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15u); }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // Uniform random rotation about z: a direction of the upper half disc, taken as (cos, sin) of half the angle.
  Quatd turn() {
    double a, b, s;
    do {
      a = uniform(-1, 1);
      b = uniform(0, 1);
      s = a * a + b * b;
    } while (s >= 1 || s == 0);
    return normalized(Quatd{a, 0, 0, b});
  }
  // Uniform random rotation (Marsaglia, Ann. Math. Stat. 43 (1972) 645: two discs, no trigonometry).
  Quatd rotation() {
    double a, b, c, d, s1, s2;
    do {
      a = uniform(-1, 1);
      b = uniform(-1, 1);
      s1 = a * a + b * b;
    } while (s1 >= 1);
    do {
      c = uniform(-1, 1);
      d = uniform(-1, 1);
      s2 = c * c + d * d;
    } while (s2 >= 1 || s2 == 0);
    const double r = std::sqrt((1 - s1) / s2);
    return normalized(Quatd{a, b, c * r, d * r});
  }

  // Uniform random direction (the same paper: one disc).
  Vec3d direction() {
    double a, b, s;
    do {
      a = uniform(-1, 1);
      b = uniform(-1, 1);
      s = a * a + b * b;
    } while (s >= 1);
    const double r = 2 * std::sqrt(1 - s);
    return {a * r, b * r, 1 - 2 * s};
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace shapes
