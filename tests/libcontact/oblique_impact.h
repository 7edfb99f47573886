// A sphere without spin that strikes a fixed half-space obliquely: a normal and a tangential law driven by kick, drift,
// kick until the bodies part.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/laws/state.h"

namespace contact::tests {

struct ObliqueImpact {
  PairParameters pair{};
  LawOptions options{};
  double radius = 0.025, density = 2650, speed = 5;  // m, kg/m³, m/s: approach along the normal
  int steps = 1000;                                  // in Hertz's contact time

  struct Rebound {
    double slip = 0;         // s'/(μ vn): of the contact point
    double restitution = 0;  // et = vt'/vt
    double spin = 0;         // R ω'/(μ vn)
    double normal = 0;       // e = vn'/vn
    double energy = 0;       // after over before
    double merges = 0;       // of a memory diagram
  };

  // Θ = vt/(μ vn) for e = 1. `angle` turns the path in the plane.
  template <class Normal, class Tangential>
  Rebound run(double theta, double angle = 0) const {
    const double mass = 4.0 / 3 * std::numbers::pi * radius * radius * radius * density;
    const double time = 2.8682655789 * std::pow(mass * mass / (radius * pair.young_eff * pair.young_eff * speed), 0.2);
    const double dt = time / steps, unit = pair.friction * speed;
    typename Normal::template State<double> normal_state{};
    typename Tangential::template State<double> state{};
    const Vec3<double> along = {std::cos(angle), std::sin(angle), 0};
    Vec3<double> v = along * (theta * unit), spin{}, force_t{};  // spin: R ω as a speed of the contact point
    double vn = speed, overlap = 0, force_n = 0;
    for (int i = 0; i < 4 * steps; ++i) {
      const auto kick = [&] {
        vn -= 0.5 * dt * force_n / mass;
        v -= force_t * (0.5 * dt / mass);
        spin -= force_t * (0.5 * dt * 2.5 / mass);  // R²/I = 5/(2m)
      };
      kick();
      const double before = overlap;
      overlap += vn * dt;
      force_n = 0;
      force_t = {};
      if (overlap > 0) {
        Kinematics<double> k{};
        k.overlap = overlap;
        k.normal = {0, 0, 1};
        k.closing_speed = vn;
        k.slip = v + spin;
        k.radius_eff = radius;
        k.mass_eff = mass;
        k.dt = k.dt_contact = dt;
        k.onset = before == 0 ? 1 : 0;
        k.overlap_before = before;
        const auto n = Normal::update(pair, k, options, normal_state);
        force_n = n.force;
        force_t = Tangential::update(pair, k, n, options, state).force;
      }
      kick();
      if (!(overlap > 0)) break;
    }
    Rebound out;
    const auto energy = [](double a, double b, double c) { return a * a + b * b + 0.4 * c * c; };
    out.slip = dot(v + spin, along) / unit;
    out.restitution = theta > 0 ? dot(v, along) / (theta * unit) : 0;
    out.spin = dot(spin, along) / unit;
    out.normal = -vn / speed;
    out.energy = energy(vn, dot(v, along), dot(spin, along)) / energy(speed, theta * unit, 0);
    if constexpr (requires { state.merges; }) out.merges = state.merges;
    return out;
  }
};

}  // namespace contact::tests
