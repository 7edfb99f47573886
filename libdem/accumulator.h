// A sum that carries its rounding error (Neumaier): totals over 10⁸ terms keep 15 digits.
#pragma once

namespace dem {

struct Accumulator {
  double sum = 0, carry = 0;
  void add(double v) {
    const double t = sum + v;
    const bool big = (sum < 0 ? -sum : sum) >= (v < 0 ? -v : v);
    carry += big ? (sum - t) + v : (v - t) + sum;
    sum = t;
  }
  double value() const { return sum + carry; }
};

}  // namespace dem
