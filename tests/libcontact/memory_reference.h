// The memory diagram with as many layers as the path asks for, and the depth of slip by bisection: an evaluation of
// Mindlin & Deresiewicz's law apart from the one that is tested. Forces over μ K, slips over κ μ; two dimensions.
#pragma once

#include <cmath>
#include <vector>

namespace contact::tests {

template <class T>
class DiagramReference {
 public:
  // To depth z by the slip (dx, dy).
  void step(const T& z, T dx, T dy) {
    const T before = depth();
    if (z > before) {
      const T h = z - before;
      if (dx * dx + dy * dy <= h * h) {
        layers_.push_back({z, dx / h, dy / h});
        return;
      }
      layers_.push_back({z, T(0), T(0)});
    } else {
      const auto [x, y] = held(z);
      dx += x;
      dy += y;
      while (!layers_.empty() && bottom(layers_.size() - 1) >= z) layers_.pop_back();
      if (!layers_.empty()) layers_.back().top = z;
    }
    if (z == T(0) || (dx == T(0) && dy == T(0))) return;
    const auto too_much = [&](const T& q) {
      const auto [x, y] = held(q);
      return (dx + x) * (dx + x) + (dy + y) * (dy + y) > (z - q) * (z - q);
    };
    T low(0), high = z;
    if (too_much(T(0))) {
      high = 0;
    } else {
      for (int i = 0; i < 400; ++i) {
        const T middle = (low + high) / 2;
        if (middle == low || middle == high) break;
        (too_much(middle) ? high : low) = middle;
      }
    }
    using std::sqrt;
    const auto [x, y] = held(high);
    const T ux = dx + x, uy = dy + y, length = sqrt(ux * ux + uy * uy);
    while (!layers_.empty() && bottom(layers_.size() - 1) >= high) layers_.pop_back();
    if (!layers_.empty()) layers_.back().top = high;
    layers_.push_back({z, ux / length, uy / length});
  }
  T depth() const { return layers_.empty() ? T(0) : layers_.back().top; }
  std::size_t size() const { return layers_.size(); }
  void force(T& x, T& y) const {
    using std::sqrt;
    x = y = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const T high = layers_[i].top, low = bottom(i), w = high * sqrt(high) - low * sqrt(low);
      x += layers_[i].x * w;
      y += layers_[i].y * w;
    }
  }
  // ∫ U²/2 d sqrt(ζ), U the slip held above ζ: what springs side by side store, over 3/2 K κ μ². In every layer U² is
  // of degree 4 in sqrt(ζ): Boole's rule is exact.
  T energy() const {
    using std::sqrt;
    T sum(0);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const T a = sqrt(bottom(i)), b = sqrt(layers_[i].top), h = (b - a) / 4;
      const T weight[] = {T(7), T(32), T(12), T(32), T(7)};
      for (int j = 0; j < 5; ++j) {
        const T y = a + h * j;
        const auto [ux, uy] = held(j == 4 ? layers_[i].top : y * y);
        sum += weight[j] * (ux * ux + uy * uy) / 2 * h * 2 / 45;
      }
    }
    return sum;
  }

 private:
  struct Layer {
    T top, x, y;
  };
  struct Pair {
    T x, y;
  };
  T bottom(std::size_t i) const { return i == 0 ? T(0) : layers_[i - 1].top; }
  // ∫ D dz from q to the top.
  Pair held(const T& q) const {
    Pair sum{T(0), T(0)};
    for (std::size_t i = layers_.size(); i-- > 0 && layers_[i].top > q;) {
      const T low = bottom(i) > q ? bottom(i) : q;
      sum.x += layers_[i].x * (layers_[i].top - low);
      sum.y += layers_[i].y * (layers_[i].top - low);
    }
    return sum;
  }
  std::vector<Layer> layers_;
};

}  // namespace contact::tests
