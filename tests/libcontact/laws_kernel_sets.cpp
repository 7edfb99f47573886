// Every kernel set of this processor answers the same chunks with the same bits, and those of the scalar laws.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/mix.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"
#include "tests/libcontact/law_lanes.h"

namespace contact::kernels {
namespace {

// Lanes of every sort: deep, grazing, apart, just come, unloading, sliding, without friction, without damping.
LawChunk law_chunk(unsigned seed) {
  Draw draw(seed);
  LawChunk c;
  for (std::size_t i = 0; i < chunk_size; ++i) {
    const auto n = draw.unit(), old = shapes::normalized(n + draw.vector(1e-3));
    const bool fresh = i % 5 == 0;
    c.overlap[i] = i % 11 == 10 ? -1e-5 : draw.in(1e-9, 1e-4);
    put(c.normal, i, n);
    put(c.velocity, i, draw.vector(i % 7 == 0 ? 0 : 1));
    c.turn[i] = draw.in(-50, 50);
    c.radius_eff[i] = draw.in(1e-3, 1e-2);
    c.mass_eff[i] = draw.in(1e-4, 1e-2);
    c.pair.young_eff[i] = draw.in(1e6, 1e9);
    c.pair.shear_eff[i] = 0.3 * c.pair.young_eff[i];
    c.pair.stiffness_n[i] = draw.in(1e3, 1e6);
    c.pair.stiffness_t[i] = 0.8 * c.pair.stiffness_n[i];
    c.pair.friction[i] = i % 6 == 0 ? 0 : draw.in(0.1, 1);
    c.pair.damping[i] = i % 4 == 0 ? 0 : draw.in(0, 1.5);
    if (fresh) continue;
    const auto f = draw.vector(1);
    put(c.history_force, i, f - old * dot(f, old));
    put(c.history_normal, i, old);
    c.history_overlap[i] = draw.in(1e-9, 1e-4);
    c.history_twist[i] = draw.in(-1e-4, 1e-4);
    c.spread_xx[i] = draw.in(0, 1e-5);
    c.spread_yy[i] = draw.in(0, 1e-5);
    c.spread_zz[i] = draw.in(0, 1e-5);
    c.spread_xy[i] = 0.1 * c.spread_xx[i];
    put(c.relative_spin, i, draw.vector(20));
  }
  return c;
}

SphereChunk sphere_chunk(unsigned seed) {
  Draw draw(seed);
  SphereChunk s;
  for (std::size_t i = 0; i < chunk_size; ++i) {
    s.radius_a[i] = draw.in(1e-3, 1e-2);
    s.radius_b[i] = draw.in(1e-3, 1e-2);
    s.inverse_mass[i] = draw.in(1e2, 1e6);
    put(s.offset, i, draw.unit() * ((s.radius_a[i] + s.radius_b[i]) * draw.in(0.98, 1.001)));
    put(s.spin_a, i, draw.vector(100));
    put(s.spin_b, i, draw.vector(100));
  }
  return s;
}

bool same_bits(const LawChunk& a, const LawChunk& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(KernelSets, TheNarrowestComesFirstAndTheChosenOneIsAmongThem) {
  const auto sets = kernel_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_STREQ(sets.front()->name, "sse2");
  bool found = false;
  for (const KernelSet* s : sets) found = found || s == &kernels();
  EXPECT_TRUE(found);
}

TEST(KernelSets, LawsGiveTheSameBits) {
  const auto sets = kernel_sets();
  if (sets.size() < 2) GTEST_SKIP() << "this processor runs one kernel set only";
  for (const auto law : {&KernelSet::hertz_mindlin, &KernelSet::spring_dashpot, &KernelSet::hertz_mindlin_patch,
                         &KernelSet::spring_dashpot_patch})
    for (const LawOptions options : {LawOptions{}, LawOptions{.rescale = false}, LawOptions{.clip = false}})
      for (const double dt : {0.0, 1e-6, 1e-4})
        for (unsigned seed = 0; seed < 20; ++seed) {
          LawChunk first = law_chunk(seed);
          (sets[0]->*law)(first, chunk_size, dt, options);
          for (std::size_t k = 1; k < sets.size(); ++k) {
            LawChunk other = law_chunk(seed);
            (sets[k]->*law)(other, chunk_size, dt, options);
            EXPECT_TRUE(same_bits(first, other)) << sets[k]->name << ", seed " << seed << ", dt " << dt;
          }
        }
}

TEST(KernelSets, SphereKernelsGiveTheSameBits) {
  const auto sets = kernel_sets();
  if (sets.size() < 2) GTEST_SKIP() << "this processor runs one kernel set only";
  for (unsigned seed = 0; seed < 50; ++seed) {
    const SphereChunk s = sphere_chunk(seed);
    LawChunk first = law_chunk(seed);
    sets[0]->spheres(s, first, chunk_size);
    sets[0]->hertz_mindlin(first, chunk_size, 1e-6, {});
    sets[0]->sphere_torques(s, first, chunk_size);
    for (std::size_t k = 1; k < sets.size(); ++k) {
      LawChunk other = law_chunk(seed);
      sets[k]->spheres(s, other, chunk_size);
      sets[k]->hertz_mindlin(other, chunk_size, 1e-6, {});
      sets[k]->sphere_torques(s, other, chunk_size);
      EXPECT_TRUE(same_bits(first, other)) << sets[k]->name << ", seed " << seed;
    }
  }
}

// The first of the lowest points, ties and numbers that do not compare included.
TEST(KernelSets, TheLowestPointIsTheFirstOfTheLowest) {
  for (const KernelSet* set : kernel_sets()) {
    Draw draw(5);
    for (const std::size_t count : {8u, 16u, 24u, 56u, 200u})
      for (int round = 0; round < 40; ++round) {
        std::vector<double> x, y, z;
        for (std::size_t i = 0; i < count; ++i) {
          const auto whole = [&] { return std::round(draw.in(-2, 2)); };
          x.push_back(whole());
          y.push_back(whole());
          z.push_back(whole());
        }
        const Points points{x.data(), y.data(), z.data(), count};
        const shapes::Vec3d n{std::round(draw.in(-2, 2)), 1, draw.in(-1, 1)};
        std::size_t least = 0;
        const auto value = [&](std::size_t i) { return n.x * x[i] + n.y * y[i] + n.z * z[i]; };
        for (std::size_t i = 1; i < count; ++i) least = value(i) < value(least) ? i : least;
        contact::Extreme two[2];
        set->search.lowest_two(points, n, points, -n, two);
        for (const contact::Extreme& found : {set->search.lowest(points, n), two[0]}) {
          EXPECT_EQ(found.index, least) << set->name;
          EXPECT_EQ(found.value, value(least)) << set->name;
        }
        EXPECT_EQ(two[1].index, set->search.lowest(points, -n).index);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        EXPECT_EQ(set->search.lowest(points, {nan, 0, 0}).index, 0u);
      }
  }
}

// A lane's answer depends on its own inputs alone: neither on its place nor on how many lanes are asked for.
TEST(KernelSets, LanesAreIndependent) {
  for (const KernelSet* set : kernel_sets()) {
    LawChunk full = law_chunk(3);
    set->hertz_mindlin(full, chunk_size, 1e-6, {});
    for (const std::size_t count : {std::size_t(1), std::size_t(5), std::size_t(17)}) {
      LawChunk part = law_chunk(3);
      set->hertz_mindlin(part, count, 1e-6, {});
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(part.force.x[i], full.force.x[i]);
        EXPECT_EQ(part.history_force.z[i], full.history_force.z[i]);
      }
    }
  }
}

// The pack's lanes are the scalar template's numbers.
TEST(KernelSets, LanesAreTheScalarLaw) {
  LawChunk c = law_chunk(9);
  const LawChunk in = c;
  kernels().hertz_mindlin(c, chunk_size, 0.0, {});
  LawChunk l = law_chunk(9);
  kernels().spring_dashpot(l, chunk_size, 0.0, {});
  for (std::size_t i = 0; i < chunk_size; ++i) {
    const shapes::Vec3d n{in.normal.x[i], in.normal.y[i], in.normal.z[i]};
    const shapes::Vec3d v{in.velocity.x[i], in.velocity.y[i], in.velocity.z[i]};
    Kinematics<double> k{};
    k.overlap = larger(in.overlap[i], 0.0);
    k.normal = n;
    k.closing_speed = dot(v, n);
    k.slip = v - n * k.closing_speed;
    k.radius_eff = in.radius_eff[i];
    k.mass_eff = in.mass_eff[i];
    PairOf<double> p;
    each_parameter(p, in.pair, [i](double& x, const Lane& lane) { x = lane[i]; });
    NoState<double> none;
    const auto hertz = Hertz::update(p, k, {}, none);
    const auto linear = Linear::update(p, k, {}, none);
    if (in.pair.friction[i] != 0) continue;  // with friction the tangential part adds to it
    EXPECT_EQ(c.force.x[i], -(n.x * hertz.force + 0.0)) << i;
    EXPECT_EQ(l.force.z[i], -(n.z * linear.force + 0.0)) << i;
  }
}

}  // namespace
}  // namespace contact::kernels
