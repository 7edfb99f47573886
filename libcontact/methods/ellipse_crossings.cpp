#include "libcontact/methods/ellipse_crossings.h"

#include <cmath>

namespace contact {

namespace {

struct Direction {  // (cos θ, sin θ)
  double c, s;
};

Direction in_quadrant(double t, double c_sign, double s_sign) {
  const double c = 1 / std::sqrt(1 + t * t);
  return {c_sign * c, s_sign * (t * c)};
}

constexpr double smallest = 0x1p-200, largest = 0x1p200;

// The zero of k in [low, high], where it has the sign of `before` below; an end of the range where it does not change.
// Sought around `guess`, to a millionth: at a stationary point g errs by the square of that.
template <class K>
double zero(const K& k, double low, double high, double before, double guess) {
  const auto below = [&](double t) { return before * k(t) > 0; };
  double t = guess > low && guess < high ? guess : std::sqrt(low) * std::sqrt(high);
  if (below(t)) {
    for (double factor = 2; low = t, t < high; factor *= factor)
      if (t = std::fmin(t * factor, high); !below(t)) break;
    if (low >= high) return high;
    high = t;
  } else {
    for (double factor = 2; high = t, t > low; factor *= factor)
      if (t = std::fmax(t / factor, low); below(t)) break;
    if (high <= low) return low;
    low = t;
  }
  while (high > 2 * low) {
    t = std::sqrt(low) * std::sqrt(high);
    (below(t) ? low : high) = t;
  }
  double k_low = k(low), k_high = k(high);
  for (int i = 0; i < 60 && high - low > 1e-6 * low; ++i) {
    t = i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * (k_low / (k_low - k_high));
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    const double value = k(t);
    if (value == 0) return t;
    if (before * value > 0) {
      low = t, k_low = value, k_high *= 0.5;
    } else {
      high = t, k_high = value, k_low *= 0.5;
    }
  }
  return 0.5 * (low + high);
}

class Outline {
 public:
  explicit Outline(const UnitBallSpace& space) : space_(space) {
    first_ = space.sigma.x >= space.sigma.y ? 0 : 1;
    for (int k = 0; k < 2; ++k) {
      const int i = k == 0 ? first_ : 1 - first_;
      sigma_[k] = space.sigma[i];
      e_[k] = std::abs(space.e[i]);
      sign_[k] = space.e[i] > 0 ? -1 : 1;  // mirrored so that A's centre lies in the first quadrant of B
    }
  }

  EllipseCrossings crossings() {
    nodes();
    EllipseCrossings found;
    int zeros = 0;
    for (int i = 0; i < count_; ++i) zeros += node_[i].sign == 0;
    found.everywhere = zeros == count_;
    if (found.everywhere) return found;
    // A zero between stationary points is a crossing that the neighbours show as well.
    int kept = 0;
    for (int i = 0; i < count_; ++i)
      if (node_[i].stationary || node_[i].sign != 0) node_[kept++] = node_[i];
    count_ = kept;
    for (int i = 0; i < count_; ++i) {
      const Node &from = node_[i], &to = node_[(i + 1) % count_];
      if (from.sign * to.sign < 0) add(found, root(from, to));
      if (from.sign != 0) continue;
      const Node& before = node_[(i + count_ - 1) % count_];
      add(found, from.u);
      found.tangencies += before.sign * to.sign >= 0;
    }
    return found;
  }

 private:
  struct Node {
    Direction u;
    double g;
    int sign;
    bool stationary;
  };

  void position(const Direction& u, double& x, double& y) const {
    x = sigma_[0] * u.c - e_[0];
    y = sigma_[1] * u.s - e_[1];
  }
  double value(const Direction& u) const {  // (1)
    double x, y;
    position(u, x, y);
    return (x * x + y * y) - 1;
  }
  void add_node(const Direction& u, bool stationary) {
    double x, y;
    position(u, x, y);
    const double g = value(u), terms = std::abs(x) * (sigma_[0] * std::abs(u.c) + e_[0]) +
                                       std::abs(y) * (sigma_[1] * std::abs(u.s) + e_[1]) + 1;
    node_[count_++] = {u, g, std::abs(g) <= 8 * epsilon * terms ? 0 : (g < 0 ? -1 : 1), stationary};
  }

  // In order of θ: the stationary points, and the ends of the axes, so that neighbours are less than half a turn apart.
  void nodes() {
    const double alpha = sigma_[0] * e_[0], beta = sigma_[1] * e_[1];
    const double delta = (sigma_[0] - sigma_[1]) * (sigma_[0] + sigma_[1]);
    const auto length = [](double t) { return std::sqrt(1 + t * t); };
    const auto nearest = [&](double t) { return length(t) * (alpha - beta / t) - delta; };   // (2)
    const auto farthest = [&](double t) { return length(t) * (alpha - beta / t) + delta; };  // (2)
    const auto across = [&](double t) { return delta - length(t) * (alpha + beta / t); };    // (3)
    const double ratio = beta / alpha;
    add_node({1, 0}, false);
    add_node(in_quadrant(zero(nearest, smallest, largest, -1, ratio), 1, 1), true);
    add_node({0, 1}, false);
    add_node({-1, 0}, false);
    add_node(in_quadrant(zero(farthest, smallest, largest, -1, ratio), -1, -1), true);
    add_node({0, -1}, false);
    if (!(delta > alpha + beta)) return;  // (3) is at most Δ − α − β
    const double top = zero([&](double t) { return alpha * (t * t * t) - beta; }, smallest, largest, -1, 1);
    if (!(across(top) > 0)) return;
    add_node(in_quadrant(zero(across, top, largest, 1, 2 * top), 1, -1), true);
    add_node(in_quadrant(zero(across, smallest, top, -1, 0.5 * top), 1, -1), true);
  }

  // The zero of g from one node to the next, along the chord between them.
  Direction root(const Node& from, const Node& to) const {
    const auto at = [&](double tau) {
      const double c = from.u.c + tau * (to.u.c - from.u.c), s = from.u.s + tau * (to.u.s - from.u.s);
      const double inverse = 1 / std::sqrt(c * c + s * s);
      return Direction{c * inverse, s * inverse};
    };
    double low = 0, high = 1, g_low = from.g, g_high = to.g;
    Direction u = from.u;
    double last = 0;
    int side = 0;
    for (int i = 0; i < 100; ++i) {
      // False position, halving the weight of an end that stays (Illinois); a bisection in between keeps it safe.
      double tau = i % 4 == 3 ? 0.5 * (low + high) : low + (high - low) * (g_low / (g_low - g_high));
      if (!(tau > low && tau < high)) tau = 0.5 * (low + high);
      u = at(tau);
      const double g = value(u);
      if (g == 0 || std::abs(tau - last) <= 0x1p-53 || !(tau > low && tau < high)) break;
      last = tau;
      if (g * from.g > 0) {
        low = tau, g_low = g;
        if (side == 1) g_high *= 0.5;
        side = 1;
      } else {
        high = tau, g_high = g;
        if (side == -1) g_low *= 0.5;
        side = -1;
      }
    }
    return u;
  }

  void add(EllipseCrossings& found, const Direction& u) const {
    double x, y;
    position(u, x, y);
    Vec3d p{};
    p[first_] = sign_[0] * x;
    p[1 - first_] = sign_[1] * y;
    if (found.count < 4) found.point[found.count] = space_.to_world * p;
    ++found.count;
  }

  const UnitBallSpace& space_;
  int first_;
  double sigma_[2], e_[2], sign_[2];
  Node node_[8];
  int count_ = 0;
};

}  // namespace

EllipseCrossings ellipse_crossings(const UnitBallSpace& space) { return Outline(space).crossings(); }

}  // namespace contact
