// A contact of Hertz led along a path of overlap and slip through a tangential law, over any scalar.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "libcontact/laws/normal/hertz.h"
#include "shapes/math/pack.h"

#if TEST_HAS_BOOST
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact::tests {

using shapes::Vec3d;
#if TEST_HAS_BOOST
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
#endif

// Of the equation sheet's paths: ν = 0.3, E* 38.46153846 GPa, R* 12.5 mm.
template <class T>
PairOf<T> sheet_pair(const T& friction = T(3) / T(10)) {
  PairOf<T> p{};
  p.young_eff = T(38461538460.0);
  p.shear_eff = p.young_eff * T(7) / T(34);  // κ = E*/(4 G*) = 1.7/1.4
  p.friction = friction;
  return p;
}

template <class Law, class T = double, class Normal = Hertz>
struct Path {
  PairOf<T> pair = sheet_pair<T>();
  LawOptions options{};
  typename Law::template State<T> state{};
  typename Normal::template State<T> normal_state{};
  NormalForce<T> normal{};
  T radius_eff = T(1) / T(80), overlap{};
  T damping_t{};
  double dt = 1;

  // To this overlap, by this slip, straight.
  TangentialForce<T> step(const T& to, const Vec3<T>& slip) {
    Kinematics<T> k{};
    k.overlap = to;
    k.normal = {T(0), T(0), T(1)};
    k.slip = slip * (T(1) / T(dt));
    k.closing_speed = (to - overlap) / T(dt);
    k.radius_eff = radius_eff;
    k.mass_eff = T(1) / T(50);
    k.dt = k.dt_contact = T(dt);
    k.overlap_before = overlap;
    normal = Normal::update(pair, k, options, normal_state);
    normal.damping_t = damping_t;
    overlap = to;
    return Law::update(pair, k, normal, options, state);
  }
  T along(const T& to, const T& slip) { return step(to, {slip, T(0), T(0)}).force.x; }
};

// 400 closed loops of (overlap, slip, slip) through random corners: the least work put in, over the most stored.
struct Loops {
  int steps;  // between two corners
  bool constant_overlap = false, plane = true;
  LawOptions options{};
};
template <class Law>
double least_work_of_loops(const Loops& loops) {
  std::mt19937_64 engine(11);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  double least = std::numeric_limits<double>::infinity();
  for (int loop = 0; loop < 400; ++loop) {
    Path<Law> path;
    path.options = loops.options;
    const double kappa = path.pair.young_eff / (4 * path.pair.shear_eff);
    const double unit = kappa * path.pair.friction * 1e-5, reach = std::pow(10, in(-2, 0.3));
    const int corners = 3 + loop % 4, n = loops.steps;
    Vec3d corner[8] = {};  // overlap, slip, slip
    for (int i = 0; i < corners; ++i)
      corner[i] = {loops.constant_overlap ? 1e-5 : 1e-5 * in(0.2, 1), unit * reach * in(-1, 1),
                   loops.plane ? unit * reach * in(-1, 1) : 0};
    path.step(corner[0].x, {});
    double work = 0, most = 0;
    Vec3d before{};
    for (int i = 0; i < corners; ++i) {
      const Vec3d a = corner[i], b = corner[(i + 1) % corners];
      for (int j = 1; j <= n; ++j) {
        const Vec3d d = {(b.y - a.y) / n, (b.z - a.z) / n, 0};
        const auto out = path.step(a.x + (b.x - a.x) * j / n, d);
        work += 0.5 * dot(before + out.force, d);
        before = out.force;
        most = std::max(most, out.energy);
      }
    }
    least = std::min(least, work / most);
  }
  return least;
}

// Random steps of overlap and slip, some at rest, some sliding far, some apart: every lane of a pack is its scalar. The
// state of the last lane.
template <class Law, class Normal = Hertz>
typename Law::template State<double> expect_lanes_are_scalars(unsigned seed, const PairOf<double>& base) {
  using shapes::Pack;
  constexpr std::size_t lanes = Pack::size(), words = state_words<Law>;
  std::mt19937_64 engine(seed);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  Path<Law, Pack, Normal> wide;
  Path<Law, double, Normal> single[lanes];
  each_parameter(wide.pair, base, [](Pack& a, const double& b) { a = b; });
  for (std::size_t l = 0; l < lanes; ++l) {
    single[l].pair = base;
    single[l].pair.friction = wide.pair.friction[l] = l == 0 ? 0 : in(0.1, 0.6);
  }
  for (int i = 0; i < 300; ++i) {
    Pack overlap(0);
    Vec3<Pack> slip{};
    TangentialForce<double> answer[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      const bool grows = i % 60 < 40 && single[l].overlap > 0;  // little by little
      const double at = in(0, 1) < 0.05 ? 0 : in(0.2, 1) * 1e-5, to = grows ? single[l].overlap * (1 + 1e3 * at) : at;
      const double size = in(0, 1) < 0.2 ? 0 : in(0, 1) * (grows ? 300 * to * at : 3e-6);
      const Vec3d d = Vec3d{in(-1, 1), in(-1, 1), 0} * size;
      overlap[l] = to;
      slip.x[l] = d.x;
      slip.y[l] = d.y;
      answer[l] = single[l].step(to, d);
    }
    const auto packed = wide.step(overlap, slip);
    std::uint64_t bits[words * lanes], expected[words];
    std::memcpy(bits, &wide.state, sizeof bits);
    for (std::size_t l = 0; l < lanes; ++l) {
      std::memcpy(expected, &single[l].state, sizeof expected);
      for (std::size_t w = 0; w < words; ++w)
        EXPECT_EQ(bits[w * lanes + l], expected[w]) << "step " << i << " lane " << l << " word " << w;
      EXPECT_EQ(packed.force.x[l], answer[l].force.x);
      EXPECT_EQ(packed.force.y[l], answer[l].force.y);
      EXPECT_EQ(packed.energy[l], answer[l].energy);
    }
    if (testing::Test::HasFailure()) break;
  }
  return single[lanes - 1].state;
}

}  // namespace contact::tests
