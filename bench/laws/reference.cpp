#include "bench/laws/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace laws {
namespace {

// Scaled: m* = 1, E* R*^½ 4/3 = K = 1, vn = 1. κ = E*/(4G*): kt = 8 G* a = (3/2) K sqrt(δ)/κ.
class Exact {  // the sheet, 2.4
 public:
  Exact(double kappa, double friction) : unit_(kappa * friction), friction_(friction) {}

  double move(double depth, double slip) {
    const double before = segments_.empty() ? 0 : segments_.back().to;
    // What is above the new depth is cut off: its slip is still held, and must be placed again.
    double need = slip / unit_;
    while (!segments_.empty() && segments_.back().to > depth) {
      Segment& s = segments_.back();
      const double from = segments_.size() > 1 ? segments_[segments_.size() - 2].to : 0;
      need += s.share * (s.to - std::max(from, depth));
      if (from >= depth) {
        segments_.pop_back();
      } else {
        s.to = depth;
      }
    }
    const double grown = depth - std::min(before, depth);
    if (grown > 0 && std::abs(need) <= grown) {
      segments_.push_back({depth, need / grown});
      return force(depth);
    }
    // Slips with one sign from the edge inwards, as deep as it takes.
    const double sign = need < 0 ? -1 : 1;
    double q = std::min(before, depth);
    need -= sign * grown;
    while (sign * need > 0 && !segments_.empty()) {
      const Segment s = segments_.back();
      const double from = segments_.size() > 1 ? segments_[segments_.size() - 2].to : 0;
      const double most = (sign - s.share) * (q - from);  // what turning the whole of it gives
      if (std::abs(most) <= std::abs(need)) {
        need -= most;
        q = from;
        segments_.pop_back();
      } else {
        q -= need / (sign - s.share);
        segments_.back().to = q;
        need = 0;
      }
    }
    if (q < depth) segments_.push_back({depth, sign});
    return force(depth);
  }

 private:
  struct Segment {
    double to, share;
  };
  double force(double) const {
    double sum = 0, from = 0;
    for (const Segment& s : segments_) {
      sum += s.share * (s.to * std::sqrt(s.to) - from * std::sqrt(from));
      from = s.to;
    }
    return friction_ * sum;
  }
  double unit_, friction_;
  std::vector<Segment> segments_;
};

}  // namespace

Oblique oblique_impact(Across law, double theta, double poisson, double friction) {
  const double kappa = (2 - poisson) / (2 * (1 - poisson)), slip_before = theta * friction;
  const double depth_max = std::pow(1.25, 0.4);  // of ½ = (2/5) δ^{5/2}
  const double duration = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * depth_max;
  const double linear = std::pow(std::numbers::pi / duration, 2);  // kn with m* = 1, (9.22)
  const int steps = 10000;
  const double dt = duration / steps;
  Exact exact(kappa, friction);
  double depth = 0, speed = 1, s = slip_before, ft = 0, before = 0, fn = 0, impulse = 0;
  for (int i = 0; i < 2 * steps; ++i) {
    speed -= 0.5 * dt * fn;
    s -= 0.5 * dt * 3.5 * ft;
    depth += dt * speed;
    impulse += 0.5 * dt * ft;
    if (!(depth > 0)) break;
    const double slip = s * dt;
    if (law == Across::linear) {
      fn = linear * depth;
      ft = std::clamp(ft + linear / kappa * slip, -friction * fn, friction * fn);
    } else {
      const double root = std::sqrt(depth);
      fn = depth * root;
      if (law == Across::exact) {
        ft = exact.move(depth, slip);
      } else {
        if (law == Across::hertz_rescaled && depth < before) ft *= root / std::sqrt(before);
        ft = std::clamp(ft + 1.5 * root / kappa * slip, -friction * fn, friction * fn);
      }
    }
    before = depth;
    impulse += 0.5 * dt * ft;
    speed -= 0.5 * dt * fn;
    s -= 0.5 * dt * 3.5 * ft;
  }
  return {s / friction, -2.5 * impulse / friction, 1 - impulse / slip_before};
}

}  // namespace laws
