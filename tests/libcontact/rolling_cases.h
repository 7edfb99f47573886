// A sphere on a plane under gravity, and what laws of rolling have to do with it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include "libcontact/laws/state.h"
#include "shapes/math/pack.h"

namespace contact {

using shapes::Vec3d;

// The plane is b: n points into it. Hertz-like numbers, pressed by the weight.
struct OnPlane {
  double radius = 0.01, mass = 0.02, gravity = 9.81, dt = 1e-5;
  PairOf<double> pair;
  NormalForce<double> normal;
  LawOptions options;

  OnPlane() {
    pair.rolling_friction = 0.1;
    pair.twisting_friction = 0.2;
    pair.rolling_viscosity = 0.5;
    pair.shear_twist = 4e8;
    normal.holding = normal.force = normal.elastic = mass * gravity;
    normal.stiffness = 2e4;
    normal.stiffness_t = 1.6e4;
    normal.contact_radius = 2e-4;
    normal.shrink = 1;
  }
  double weight() const { return mass * gravity; }
  double solid() const { return 0.4 * mass * radius * radius; }  // about its centre
  double about_contact() const { return 1.4 * mass * radius * radius; }
  Kinematics<double> turning(const Vec3d& spin) const {
    Kinematics<double> k;
    k.overlap = k.overlap_before = 1e-6;
    k.normal = {0, 0, -1};
    k.radius_eff = radius;
    k.mass_eff = mass;
    k.dt = k.dt_contact = dt;
    k.relative_spin = spin;
    return k;
  }
  template <class Law>
  Moment<double> moment(const Vec3d& spin, typename Law::template State<double>& s) const {
    return Law::update(pair, turning(spin), normal, options, s);
  }
};

// Kinematics of every sort, lane i of a pack, against the scalar law.
template <class Law>
void lanes_are_the_scalar_law() {
  using shapes::Pack;
  using Words = typename Law::template State<double>;
  std::mt19937_64 engine(11);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  for (int round = 0; round < 300; ++round) {
    PairOf<Pack> p;
    Kinematics<Pack> k;
    NormalForce<Pack> f;
    typename Law::template State<Pack> s{};
    PairOf<double> p1[Pack::size()];
    Kinematics<double> k1[Pack::size()];
    NormalForce<double> f1[Pack::size()];
    Words s1[Pack::size()];
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      p1[i].rolling_friction = in(-0.2, 0.6) > 0 ? in(0, 0.5) : 0;
      p1[i].twisting_friction = in(-0.2, 0.6) > 0 ? in(0, 0.5) : 0;
      p1[i].rolling_viscosity = in(0, 100);
      p1[i].rolling_damping = in(-0.5, 1) > 0 ? 0.3 : 0;
      p1[i].shear_twist = 4e8;
      k1[i] = OnPlane().turning(in(0, 1) < 0.1 ? Vec3d{} : Vec3d{in(-9, 9), in(-9, 9), in(-9, 9)});
      k1[i].normal = shapes::normalized(Vec3d{in(-1, 1), in(-1, 1), 2});
      f1[i] = OnPlane().normal;
      f1[i].holding *= in(0, 1) < 0.1 ? 0 : in(0, 1);
      f1[i].stiffness *= in(0, 1);
      f1[i].contact_radius *= in(0, 1) < 0.3 ? 0 : in(0, 1);
    }
    for (int step = 0; step < 3; ++step) {
      const auto gather = [](Pack& lane, auto&& one) { lane = Pack([&](auto i) { return double(one(i)); }); };
      gather(p.rolling_friction, [&](auto i) { return p1[i].rolling_friction; });
      gather(p.twisting_friction, [&](auto i) { return p1[i].twisting_friction; });
      gather(p.rolling_viscosity, [&](auto i) { return p1[i].rolling_viscosity; });
      gather(p.rolling_damping, [&](auto i) { return p1[i].rolling_damping; });
      gather(p.shear_twist, [&](auto i) { return p1[i].shear_twist; });
      for (int c = 0; c < 3; ++c) {
        gather(k.relative_spin[c], [&](auto i) { return k1[i].relative_spin[c]; });
        gather(k.normal[c], [&](auto i) { return k1[i].normal[c]; });
      }
      gather(k.radius_eff, [&](auto i) { return k1[i].radius_eff; });
      gather(k.mass_eff, [&](auto i) { return k1[i].mass_eff; });
      gather(k.dt, [&](auto i) { return k1[i].dt; });
      gather(k.dt_contact, [&](auto i) { return k1[i].dt_contact; });
      gather(f.holding, [&](auto i) { return f1[i].holding; });
      gather(f.stiffness, [&](auto i) { return f1[i].stiffness; });
      gather(f.stiffness_t, [&](auto i) { return f1[i].stiffness_t; });
      gather(f.contact_radius, [&](auto i) { return f1[i].contact_radius; });
      const Moment<Pack> out = Law::update(p, k, f, {}, s);
      for (std::size_t i = 0; i < Pack::size(); ++i) {
        const Moment<double> one = Law::update(p1[i], k1[i], f1[i], {}, s1[i]);
        EXPECT_EQ(one.moment.x, double(out.moment.x[i]));
        EXPECT_EQ(one.moment.y, double(out.moment.y[i]));
        EXPECT_EQ(one.moment.z, double(out.moment.z[i]));
        EXPECT_EQ(one.energy, double(out.energy[i]));
        f1[i].stiffness *= 0.9;
      }
    }
  }
}

// Without the two frictions (and the viscosity) there is nothing.
template <class Law>
void nothing_without_friction(double huge = std::numeric_limits<double>::infinity()) {
  OnPlane c;
  c.pair.rolling_friction = c.pair.twisting_friction = c.pair.rolling_viscosity = 0;
  c.pair.rolling_damping = 0.5;
  typename Law::template State<double> s{};
  for (int i = 0; i < 5; ++i) {
    const Moment<double> m = c.moment<Law>({3, -4, 5}, s);
    EXPECT_EQ(shapes::norm(m.moment), 0);
    EXPECT_EQ(m.energy, 0);
  }
  // Nor where nothing presses, however large the friction.
  OnPlane apart;
  apart.normal.holding = 0;
  apart.pair.twisting_friction = apart.pair.rolling_friction = apart.pair.rolling_viscosity = huge;
  typename Law::template State<double> t{};
  EXPECT_EQ(shapes::norm(apart.moment<Law>({3, -4, 5}, t).moment), 0);
}

// A change of units by powers of two keeps the bits: lengths, masses and times.
template <class Law>
void scales_with_units() {
  for (const auto& [length, mass, time] : {Vec3d{8, 1, 1}, Vec3d{1, 0.5, 1}, Vec3d{1, 1, 0.125}, Vec3d{32, 2, 16}}) {
    OnPlane small, big;
    const double force = mass * length / (time * time), moment = force * length;
    small.pair.rolling_damping = big.pair.rolling_damping = 0.3;
    big.radius *= length;
    big.mass *= mass;
    big.dt *= time;
    big.pair.rolling_viscosity *= time / length;
    big.pair.shear_twist *= force / (length * length);
    big.normal.holding *= force;
    big.normal.stiffness *= force / length;
    big.normal.stiffness_t *= force / length;
    big.normal.contact_radius *= length;
    typename Law::template State<double> s{}, t{};
    for (int i = 0; i < 40; ++i) {
      const Vec3d spin = Vec3d{1, 2, 3} * std::sin(1.0 * i);
      const Moment<double> one = small.moment<Law>(spin, s), other = big.moment<Law>(spin * (1 / time), t);
      EXPECT_EQ(one.moment.x * moment, other.moment.x);
      EXPECT_EQ(one.moment.z * moment, other.moment.z);
      EXPECT_EQ(one.energy * moment, other.energy);
    }
  }
}

}  // namespace contact
