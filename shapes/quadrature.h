// Adaptive integration of several functions at once: Gauss–Kronrod 7/15 on halved intervals.
//   x = m + h (3t − t³)/2,  −1 <= t <= 1                                                                           (1)
// takes square-root behaviour at the ends of an interval away, as sections of round bodies have it.
// Nodes and weights: Piessens et al., QUADPACK (1983), 25 digits. The order of evaluation is fixed: same bits always.
// Test: tests/shapes/compound_mass.cpp.
#pragma once

#include <array>
#include <cmath>

namespace shapes {

inline constexpr double kronrod_node[8] = {0,
                                           0.2077849550078984676006894,
                                           0.4058451513773971669066064,
                                           0.5860872354676911302941448,
                                           0.7415311855993944398638648,
                                           0.8648644233597690727897128,
                                           0.9491079123427585245261897,
                                           0.9914553711208126392068547};
inline constexpr double kronrod_weight[8] = {
    0.2094821410847278280129992, 0.2044329400752988924141620, 0.1903505780647854099132564, 0.1690047266392679028265834,
    0.1406532597155259187451896, 0.1047900103222501838398763, 0.0630920926299785532907007, 0.0229353220105292249637320};
inline constexpr double gauss_weight[8] = {0.4179591836734693877551020, 0, 0.3818300505051189449503698, 0,
                                           0.2797053914892766679014678, 0, 0.1294849661688696932706114, 0};

// Adds ∫f over [a, b] to `sum`; f(x) gives an array of N values. An interval is halved until the two rules differ by
// less than tolerance[i] times its share of `whole`, or `depth` times. Returns what the rules differ by, summed and
// divided by the tolerances: an estimate from above of the error in units of the tolerance.
template <std::size_t N, class F>
double integrate(F& f, double a, double b, double whole, const std::array<double, N>& tolerance, int depth,
                 std::array<double, N>& sum) {
  const double m = 0.5 * (a + b), h = 0.5 * (b - a);
  std::array<double, N> fine{}, coarse{};
  for (int k = 0; k < 8; ++k)
    for (const double t : {kronrod_node[k], -kronrod_node[k]}) {
      if (k == 0 && std::signbit(t)) continue;
      const double slope = 1.5 * h * (1 - t * t);
      const std::array<double, N> value = f(m + 0.5 * h * t * (3 - t * t));
      for (std::size_t i = 0; i < N; ++i) {
        fine[i] += kronrod_weight[k] * slope * value[i];
        coarse[i] += gauss_weight[k] * slope * value[i];
      }
    }
  double worst = 0;
  for (std::size_t i = 0; i < N; ++i) worst = std::fmax(worst, std::fabs(fine[i] - coarse[i]) / tolerance[i]);
  if (depth > 0 && worst * whole > b - a)
    return integrate(f, a, m, whole, tolerance, depth - 1, sum) + integrate(f, m, b, whole, tolerance, depth - 1, sum);
  for (std::size_t i = 0; i < N; ++i) sum[i] += fine[i];
  return worst;
}

}  // namespace shapes
