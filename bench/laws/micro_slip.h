// Mindlin & Deresiewicz in one dimension, apart from the library: every segment of the memory is kept, in any scalar.
// Depths z, slip X; the force over K = 4/3 E* sqrt(R*). A step is straight in overlap and slip.
//   Ft = μ K Σ D_k (z_k^{3/2} − z_{k−1}^{3/2}),  slip held = κ μ Σ D_k (z_k − z_{k−1}),  |D| <= 1
#pragma once

#include <cmath>
#include <vector>

namespace laws {

template <class Real>
class MicroSlip {
 public:
  MicroSlip(const Real& kappa, const Real& friction) : unit_(kappa * friction), friction_(friction) {}

  Real move(const Real& depth, const Real& slip) {
    const Real before = segments_.empty() ? Real(0) : segments_.back().to;
    // What is above the new depth is cut off: its slip is still held, and must be placed again.
    Real need = slip / unit_;
    while (!segments_.empty() && segments_.back().to > depth) {
      Segment& s = segments_.back();
      const Real from = segments_.size() > 1 ? segments_[segments_.size() - 2].to : Real(0);
      need += s.share * (s.to - (from < depth ? depth : from));
      if (from >= depth) {
        segments_.pop_back();
      } else {
        s.to = depth;
      }
    }
    const Real grown = depth - (before < depth ? before : depth);
    if (grown > 0 && magnitude(need) <= grown) {
      segments_.push_back({depth, need / grown});
      return force();
    }
    // Slips with one sign from the edge inwards, as deep as it takes.
    const Real sign = need < 0 ? -1 : 1;
    Real q = (before < depth ? before : depth);
    need -= sign * grown;
    while (sign * need > 0 && !segments_.empty()) {
      const Segment s = segments_.back();
      const Real from = segments_.size() > 1 ? segments_[segments_.size() - 2].to : Real(0);
      const Real most = (sign - s.share) * (q - from);  // what turning the whole of it gives
      if (magnitude(most) <= magnitude(need)) {
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
    return force();
  }

 private:
  static Real magnitude(const Real& x) { return x < 0 ? Real(-x) : x; }
  struct Segment {
    Real to, share;
  };
  Real force() const {
    using std::sqrt;
    Real sum = 0, from = 0;
    for (const Segment& s : segments_) {
      sum += s.share * (s.to * sqrt(s.to) - from * sqrt(from));
      from = s.to;
    }
    return friction_ * sum;
  }
  Real unit_, friction_;
  std::vector<Segment> segments_;
};

}  // namespace laws
