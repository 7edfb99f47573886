// Mixing in a V-blender: once a turn, when the V stands as at the start, the bed is parted into samples of equal
// number, and the relative standard deviation (RSD) of the share of one colour over the samples is compared with that
// of a random mixture. Blenders of this kind mix exponentially with the number of turns; in the free-flowing, slow
// regime the speed does not matter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

struct Spread {  // squares of the RSD
  double measured = 0, random = 0;
};

// The bed is halved `halvings` times, each part at the median across its longest side: 2^halvings samples of the same
// number n of spheres (to one), compact, wherever the bed lies. A random mixture of N spheres, of which the share p is
// counted, has RSD^2 = (1 - p) / (p n) (N - n) / (N - 1): binomial, without putting back.
class Samples {
 public:
  explicit Samples(const World& w) : world_(w), order_(w.particles.count()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
  }

  Spread spread(int halvings) {
    const double all = static_cast<double>(order_.size()), samples = std::ldexp(1, halvings), n = all / samples;
    const double share = counted(0, order_.size()) / all;
    sum_ = 0;
    halve(0, order_.size(), halvings, share);
    return {sum_ / (samples * share * share), (1 - share) / (share * n) * (all - n) / (all - 1)};
  }

 private:
  const Vec3d& position(std::size_t i) const { return world_.particles.motion[i].position; }

  double counted(std::size_t begin, std::size_t end) const {
    return static_cast<double>(std::count_if(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                                             order_.begin() + static_cast<std::ptrdiff_t>(end),
                                             [&](std::size_t i) { return world_.particles.species[i] == 1; }));
  }

  void halve(std::size_t begin, std::size_t end, int halvings, double share) {
    if (halvings == 0) {
      sum_ += std::pow(counted(begin, end) / static_cast<double>(end - begin) - share, 2);
      return;
    }
    Vec3d low = position(order_[begin]), high = low;
    for (std::size_t k = begin; k < end; ++k)
      for (int d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], position(order_[k])[d]);
        high[d] = std::max(high[d], position(order_[k])[d]);
      }
    const Vec3d side = high - low;
    int across = 0;
    for (int d = 1; d < 3; ++d)
      if (side[d] > side[across]) across = d;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t i, std::size_t j) {
      const double x = position(i)[across], y = position(j)[across];
      return x < y || (x == y && i < j);
    });
    halve(begin, middle, halvings - 1, share);
    halve(middle, end, halvings - 1, share);
  }

  const World& world_;
  std::vector<std::size_t> order_;
  double sum_ = 0;
};

struct Mixing {
  double rate = 0;       // per turn, of the part of the RSD that is not random
  double r_squared = 0;  // of the straight line through its logarithm
  double limit = 0;      // RSD over that of a random mixture, mean of the last turns
  double turns = 0;      // on the line
};

// The variance is the sum of that of a random mixture and of what is not yet mixed; the root of the latter is what
// decays. The line goes through it from the first turn on, until the random part is the greater.
Mixing mix(Runs& runs, double turns_a_minute) {
  constexpr int halvings = 7, turns = 12, last = 3;  // 128 samples of 15 or 16
  const double begin = wall_named(runs.build(), "mixer").motion.start, period = 60 / turns_a_minute;
  std::vector<Spread> seen;
  runs.run({fmt::format("wall.mixer.rate={}", 2 * std::numbers::pi / period),
            fmt::format("run.time={}", begin + (turns + 0.01) * period)},
           fmt::format("{}_rpm", turns_a_minute), [&](const World& w) {
             if (w.time() >= begin + static_cast<double>(seen.size()) * period)
               seen.push_back(Samples(w).spread(halvings));
           });
  Mixing m;
  double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t k = 1; k < seen.size() && seen[k].measured > 2 * seen[k].random; ++k) {
    const double x = static_cast<double>(k), y = 0.5 * std::log(seen[k].measured - seen[k].random);
    m.turns += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  const double xx = sxx - sx * sx / m.turns, xy = sxy - sx * sy / m.turns, yy = syy - sy * sy / m.turns;
  m.rate = -xy / xx;
  m.r_squared = xy * xy / (xx * yy);
  for (std::size_t k = seen.size() - last; k < seen.size(); ++k)
    m.limit += std::sqrt(seen[k].measured / seen[k].random) / last;
  return m;
}

}  // namespace

extern const Validation v_mixer;
const Validation v_mixer{"v_mixer", "v_mixer.toml", "the colours mix exponentially with the turns, at either speed",
                         [](Runs& runs) -> std::vector<Row> {
                           const Mixing slow = mix(runs, 15), fast = mix(runs, 30);
                           return {
                               at_least("R^2 of the exponential decay, 15 rpm", slow.r_squared, 0.95),
                               at_least("R^2 of the exponential decay, 30 rpm", fast.r_squared, 0.95),
                               within("RSD at the end over the random one, 15 rpm", slow.limit, 1, 0.15),
                               within("RSD at the end over the random one, 30 rpm", fast.limit, 1, 0.15),
                               within("rate per turn at 15 rpm over that at 30 rpm", slow.rate / fast.rate, 1, 0.25),
                               for_information("rate at 30 rpm", fast.rate, "per turn"),
                               for_information("turns on the line, 15 rpm", slow.turns),
                               for_information("turns on the line, 30 rpm", fast.turns)};
                         }};

}  // namespace dem::validate
