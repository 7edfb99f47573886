#include "libdem/analysis/round_in_box.h"

#include <array>
#include <cmath>
#include <numbers>

namespace dem::analysis {

namespace {

constexpr double pi = std::numbers::pi;

// R = 1, distances >= 0.
double beyond_one(double a) { return a < 1 ? pi / 3 * (1 - a) * (1 - a) * (2 + a) : 0; }

double beyond_two(double a, double b) {
  const double square = 1 - a * a - b * b;
  if (!(square > 0)) return 0;
  const double c = std::sqrt(square);
  const double arc_a = 2 * std::atan2(c, b), arc_b = 2 * std::atan2(c, a), corner = std::atan2(c, a * b);
  const double area_a = 0.5 * (1 - a * a) * arc_a - b * c, area_b = 0.5 * (1 - b * b) * arc_b - a * c;
  return (2 * corner - a * arc_a - b * arc_b - a * area_a - b * area_b) / 3;  // (1)
}

double beyond_three(double a, double b, double c) {
  if (!(1 - a * a - b * b - c * c > 0)) return 0;
  const double ab = std::sqrt(1 - a * a - b * b), bc = std::sqrt(1 - b * b - c * c), ca = std::sqrt(1 - c * c - a * a);
  const double angle = std::atan2(ab, a * b) + std::atan2(bc, b * c) + std::atan2(ca, c * a) - pi;
  // In the plane at a: from (√(1 − a² − c²), c) to (b, √(1 − a² − b²)).
  const auto part = [](double p, double q, double r, double to_q, double to_r) {
    const double arc = std::atan2(to_q, q) - std::atan2(r, to_r);
    const double area = 0.5 * ((1 - p * p) * arc - q * (to_q - r) - r * (to_r - q));
    return p * (arc + area);
  };
  return (angle - part(a, b, c, ab, ca) - part(b, c, a, bc, ab) - part(c, a, b, ca, bc)) / 3;  // (2)
}

double beyond_two_lines(double a, double b) {
  if (!(1 - a * a - b * b > 0)) return 0;
  const double to_a = std::sqrt(1 - a * a), to_b = std::sqrt(1 - b * b);
  const double arc = std::atan2(to_a, a) - std::atan2(b, to_b);
  return 0.5 * (arc - a * (to_a - b) - b * (to_b - a));
}
double beyond_line(double a) { return a < 1 ? std::atan2(std::sqrt(1 - a * a), a) - a * std::sqrt(1 - a * a) : 0; }

// The stretch between two planes as a signed sum: of everything (distance −1), and of what is beyond planes.
struct Stretch {
  struct Term {
    double distance, sign;
  };
  std::array<Term, 3> terms{};
  int count = 0;
  void add(double distance, double sign) {
    if (distance < 1) terms[static_cast<std::size_t>(count++)] = {distance, sign};
  }
};
Stretch stretch(double lower, double upper) {
  Stretch s;
  if (lower > 0) {
    s.add(lower, 1);
    s.add(upper, -1);
  } else if (upper < 0) {
    s.add(-upper, 1);
    s.add(-lower, -1);
  } else {
    s.add(-1, 1);
    s.add(-lower, -1);
    s.add(upper, -1);
  }
  return s;
}

double ball_term(double x, double y, double z) {
  if (x < 0) return y < 0 ? (z < 0 ? 4 * pi / 3 : beyond_one(z)) : (z < 0 ? beyond_one(y) : beyond_two(y, z));
  if (y < 0) return z < 0 ? beyond_one(x) : beyond_two(x, z);
  return z < 0 ? beyond_two(x, y) : beyond_three(x, y, z);
}
double disc_term(double x, double y) {
  if (x < 0) return y < 0 ? pi : beyond_line(y);
  return y < 0 ? beyond_line(x) : beyond_two_lines(x, y);
}

}  // namespace

double ball_in_box(const Vec3d& centre, double radius, const Vec3d& lower, const Vec3d& upper) {
  std::array<Stretch, 3> s{};
  for (int k = 0; k < 3; ++k)
    s[static_cast<std::size_t>(k)] = stretch((lower[k] - centre[k]) / radius, (upper[k] - centre[k]) / radius);
  double sum = 0;
  for (int i = 0; i < s[0].count; ++i)
    for (int j = 0; j < s[1].count; ++j)
      for (int k = 0; k < s[2].count; ++k) {
        const auto &x = s[0].terms[static_cast<std::size_t>(i)], &y = s[1].terms[static_cast<std::size_t>(j)],
                   &z = s[2].terms[static_cast<std::size_t>(k)];
        sum += x.sign * y.sign * z.sign * ball_term(x.distance, y.distance, z.distance);
      }
  return std::fmax(0, sum) * radius * radius * radius;
}

double disc_in_box(const Vec3d& centre, double radius, const Vec3d& lower, const Vec3d& upper) {
  const Stretch sx = stretch((lower.x - centre.x) / radius, (upper.x - centre.x) / radius);
  const Stretch sy = stretch((lower.y - centre.y) / radius, (upper.y - centre.y) / radius);
  double sum = 0;
  for (int i = 0; i < sx.count; ++i)
    for (int j = 0; j < sy.count; ++j) {
      const auto &x = sx.terms[static_cast<std::size_t>(i)], &y = sy.terms[static_cast<std::size_t>(j)];
      sum += x.sign * y.sign * disc_term(x.distance, y.distance);
    }
  return std::fmax(0, sum) * radius * radius;
}

double unit_ball_below(double height) { return height < 0 ? beyond_one(-height) : 4 * pi / 3 - beyond_one(height); }

double unit_disc_below(double height) { return height < 0 ? beyond_line(-height) : pi - beyond_line(height); }

}  // namespace dem::analysis
