// Where a fuzzed pair gets its numbers from: a stream of random words, or the bytes that a fuzzing engine feeds, then
// zeros.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "shapes/math/vec.h"

namespace pair_fuzz {

class Source {
 public:
  explicit Source(std::uint64_t seed) : engine_(seed) {}
  Source(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), left_(size), fed_(true) {}

  std::uint64_t bits() {
    if (!fed_) return engine_();
    std::uint64_t word = 0;
    for (int i = 0; i < 8 && left_ > 0; ++i, ++bytes_, --left_) word = word << 8 | *bytes_;
    return word;
  }
  std::size_t pick(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  // Uniform in the logarithm.
  double spread(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  int integer(int low, int high) { return low + static_cast<int>(pick(static_cast<std::size_t>(high - low) + 1)); }
  shapes::Vec3d vector() {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
  const std::uint8_t* bytes_ = nullptr;
  std::size_t left_ = 0;
  bool fed_ = false;
};

}  // namespace pair_fuzz
