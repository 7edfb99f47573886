// What tests of normal laws share: prescribed paths, impacts as the time loop makes them, lanes and units.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "libcontact/laws/state.h"
#include "shapes/math/pack.h"
#include "shapes/math/random.h"

namespace contact::paths {

constexpr double radius_eff = 1e-3, mass_eff = 3.3e-5;

inline Kinematics<double> pressed(double overlap, double before = 0, double closing_speed = 0) {
  Kinematics<double> k{};
  k.overlap = overlap;
  k.normal = {0, 0, 1};
  k.closing_speed = closing_speed;
  k.radius_eff = radius_eff;
  k.mass_eff = mass_eff;
  k.overlap_before = before;
  return k;
}

// A contact whose overlap is prescribed, at rest.
template <class Law>
struct Walk {
  PairParameters p;
  typename Law::template State<double> state{};
  double before = 0;
  NormalForce<double> to(double overlap) {
    const auto f = Law::template update<double>(p, pressed(overlap, before), LawOptions{}, state);
    before = overlap;
    return f;
  }
};

struct Impact {
  double restitution = 0, deepest = 0, longest_gap = 0;
  bool stuck = false;
};

// A head-on impact by kick, drift, kick; `phase` of the first step lies before the touch.
template <class Law>
Impact impact(const PairParameters& p, double speed, double dt, double phase, bool clip = true, double mass = mass_eff,
              double radius = radius_eff) {
  LawOptions options;
  options.clip = clip;
  typename Law::template State<double> state{};
  double x = -speed * dt * phase, v = speed, force = 0, before = 0;
  bool touching = false;
  Impact result;
  for (long step = 0; step < 20'000'000; ++step) {
    v -= 0.5 * dt * force / mass;
    x += v * dt;
    Kinematics<double> k = pressed(x, before, v);
    k.dt = dt;
    k.radius_eff = radius;
    k.mass_eff = mass;
    const bool fresh = !touching;
    k.onset = fresh && v * dt > 0 ? std::min(1.0, x / (v * dt)) : 0;
    if (!clip && -v * dt > x && x > 0) k.onset = x / (-v * dt);
    k.dt_contact = fresh ? k.onset * dt : dt;
    force = 0;
    bool holds = x > 0;
    if (x > 0 || (law_adheres<Law> && touching)) {
      const auto f = Law::template update<double>(p, k, options, state);
      force = f.force;
      holds = holds || f.bond > 0;
    }
    if (touching && !holds) {
      result.restitution = -(v - 0.5 * dt * force / mass) / speed;
      return result;
    }
    touching = holds;
    before = touching ? x : 0;
    result.deepest = std::max(result.deepest, x);
    result.longest_gap = std::max(result.longest_gap, -x);
    v -= 0.5 * dt * force / mass;
  }
  result.stuck = true;
  return result;
}

// A path that wanders: turning points drawn between `low` and `high`, most of them partial; ends where it began.
inline std::vector<double> wandering(double low, double high, int turns, int steps, std::uint64_t seed) {
  shapes::Random draw(seed, 0, 0);
  std::vector<double> path;
  double from = high * 1e-9;
  for (int i = 0; i <= turns; ++i) {
    const double to = i == turns ? high * 1e-9 : low + (high - low) * draw.uniform();
    for (int j = 1; j <= steps; ++j) path.push_back(from + (to - from) * j / steps);
    from = to;
  }
  return path;
}

// Pack lanes give the scalar's bits along wandering paths, one path per lane.
template <class Law>
void expect_lanes_equal_scalars(const PairParameters& p, double low, double high) {
  using shapes::Pack;
  constexpr int lanes = static_cast<int>(Pack::size());
  std::vector<std::vector<double>> path;
  for (int l = 0; l < lanes; ++l) path.push_back(wandering(low, high, 12, 9, 77 + static_cast<std::uint64_t>(l)));
  PairOf<Pack> wide;
  each_parameter(wide, static_cast<const PairOf<double>&>(p), [](Pack& a, double b) { a = b; });
  typename Law::template State<Pack> state{};
  std::vector<Walk<Law>> walks(lanes, Walk<Law>{p});
  typename Law::template State<double> alone[lanes]{};
  for (std::size_t i = 0; i < path[0].size(); ++i) {
    Kinematics<Pack> k{};
    NormalForce<double> expected[lanes];
    for (int l = 0; l < lanes; ++l) {
      const auto at = static_cast<std::size_t>(l);
      Kinematics<double> one = pressed(path[at][i], i > 0 ? path[at][i - 1] : 0, 0.1 * (l - 1));
      one.dt = 1e-7;
      one.onset = i == 0 ? 0.3 : 0;
      expected[l] = Law::template update<double>(p, one, LawOptions{}, alone[l]);
      k.overlap[l] = one.overlap;
      k.closing_speed[l] = one.closing_speed;
      k.radius_eff[l] = one.radius_eff;
      k.mass_eff[l] = one.mass_eff;
      k.dt[l] = one.dt;
      k.onset[l] = one.onset;
      k.overlap_before[l] = one.overlap_before;
    }
    const NormalForce<Pack> f = Law::template update<Pack>(wide, k, LawOptions{}, state);
    for (int l = 0; l < lanes; ++l)
      each_of_normal_force(f, expected[l], [&](const Pack& a, double b) {
        const double lane = a[l];
        EXPECT_EQ(std::memcmp(&lane, &b, sizeof b), 0) << Law::name << " lane " << l << " step " << i << ": " << b;
      });
  }
}

// Lengths, masses and times in other units, apart by powers of two: the same bits, scaled.
template <class Law>
void expect_units_do_not_matter(const PairParameters& p, double low, double high) {
  for (const auto& [length, mass, time] : {std::array{7, -3, 2}, std::array{-10, 5, -9}, std::array{1, 0, 0}}) {
    const auto unit = [&](int l, int m, int t) { return std::ldexp(1.0, l * length + m * mass + t * time); };
    PairParameters q = p;
    for (double* x : {&q.young_eff, &q.shear_eff, &q.yield_pressure, &q.shear_twist}) *x *= unit(-1, 1, -2);
    for (double* x : {&q.stiffness_n, &q.stiffness_t, &q.plastic_stiffness, &q.adhesive_stiffness, &q.work_of_adhesion})
      *x *= unit(0, 1, -2);
    q.viscous_time *= unit(0, 0, 1);
    typename Law::template State<double> one{}, other{};
    double before = 0;
    for (const double x : wandering(low, high, 20, 5, 5)) {
      Kinematics<double> k = pressed(x, before, 0.07), s = k;
      k.dt = 1e-7;
      s.dt = k.dt * unit(0, 0, 1);
      s.overlap *= unit(1, 0, 0);
      s.overlap_before *= unit(1, 0, 0);
      s.radius_eff *= unit(1, 0, 0);
      s.mass_eff *= unit(0, 1, 0);
      s.closing_speed *= unit(1, 0, -1);
      const auto a = Law::template update<double>(p, k, LawOptions{}, one);
      const auto b = Law::template update<double>(q, s, LawOptions{}, other);
      const double force = unit(1, 1, -2), stiffness = unit(0, 1, -2), damping = unit(0, 1, -1);
      EXPECT_EQ(a.force * force, b.force);
      EXPECT_EQ(a.elastic * force, b.elastic);
      EXPECT_EQ(a.stiffness * stiffness, b.stiffness);
      EXPECT_EQ(a.damping * damping, b.damping);
      EXPECT_EQ(a.contact_radius * unit(1, 0, 0), b.contact_radius);
      EXPECT_EQ(a.stiffness_t * stiffness, b.stiffness_t);
      EXPECT_EQ(a.damping_t * damping, b.damping_t);
      EXPECT_EQ(a.holding * force, b.holding);
      EXPECT_EQ(a.shrink, b.shrink);
      EXPECT_EQ(a.energy * unit(2, 1, -2), b.energy);
      EXPECT_EQ(a.bond, b.bond);
      before = x;
    }
  }
}

// Along wandering paths the work done on the contact is never less than what its energy gained: never a gain, at any
// time. `scale`: J, what errors of Simpson's rule are compared with. Returns the work lost on the last path.
template <class Law>
double expect_paths_lose(const PairParameters& p, double low, double high, double scale, double tolerance = 1e-6) {
  double lost = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Walk<Law> walk{p};
    double work = 0, x = 0, least = 0;
    NormalForce<double> last = walk.to(high * 1e-9);
    const double start = last.energy;
    x = high * 1e-9;
    bool apart = false;
    for (const double next : wandering(low, high, 12, 1000, seed)) {
      const double middle = walk.to(0.5 * (x + next)).elastic;
      const auto f = walk.to(next);
      if (law_adheres<Law> && f.bond == 0) {
        apart = true;  // what was left is gone with it
        break;
      }
      work += (f.elastic + 4 * middle + last.elastic) / 6 * (next - x);
      const double loss = work - (f.energy - start);
      EXPECT_GT(loss, least - tolerance * scale) << "seed " << seed << " at " << next;  // and it never comes back
      if (loss < least - tolerance * scale) return 0;
      least = std::max(least, loss);
      EXPECT_GE(f.holding, 0);
      last = f;
      x = next;
    }
    lost = least;
    if (!apart) {
      EXPECT_GE(work, -tolerance * scale);
    }
  }
  return lost;
}

// F = dU/dδ by a central difference where no memory changes, the same memory on both sides.
template <class Law>
double slope_of_energy(const Walk<Law>& at, double overlap, double step) {
  Walk<Law> up = at, down = at;
  return (up.to(overlap + step).energy - down.to(overlap - step).energy) / (2 * step);
}

}  // namespace contact::paths
