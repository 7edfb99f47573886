// The kernel of bodies against one body at a time, bit by bit, in every instruction set.
#include "libdem/integrators/bodies.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libdem/cell.h"
#include "libdem/coherence.h"
#include "libdem/integrators/rotation.h"
#include "libdem/particles.h"
#include "libdem/sweep.h"

namespace dem {
namespace {

using contact::Motion;
using contact::Slot;
using shapes::Kind;

// Bodies with slots in lists of 0 to 5 entries.
struct Bodies {
  std::vector<Kind> kind;
  std::vector<Motion> motion;
  std::vector<Quatd> orientation;
  std::vector<Vec3d> rotation, momentum, inertia, force, torque;
  std::vector<double> travel;
  std::vector<Slot> slot;
  std::vector<std::uint32_t> active, start, count;

  Bodies(std::size_t n, const std::vector<Kind>& kinds, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1), positive(0.1, 1);
    const auto vector = [&] { return Vec3d{number(random), number(random), number(random)}; };
    for (int k = 0; k < 40; ++k) slot.push_back({vector(), positive(random), vector(), positive(random)});
    for (std::size_t i = 0; i < n; ++i) {
      kind.push_back(kinds[random() % kinds.size()]);
      motion.push_back({vector(), positive(random), vector(), positive(random), vector(), positive(random)});
      orientation.push_back(
          shapes::normalized(Quatd{number(random), number(random), number(random), number(random) + 2}));
      for (auto* v : {&rotation, &momentum, &force, &torque}) v->push_back(vector());
      inertia.push_back({positive(random), positive(random), positive(random)});
      travel.push_back(positive(random));
      start.push_back(static_cast<std::uint32_t>(active.size()));
      count.push_back(static_cast<std::uint32_t>(random() % 6));
      for (std::uint32_t e = 0; e < count.back(); ++e) active.push_back(static_cast<std::uint32_t>(random() % 80));
    }
    active.push_back(0);
  }

  BodyArrays arrays(bool travels) {
    return {reinterpret_cast<const std::uint8_t*>(kind.data()),
            motion.data(),
            orientation.data(),
            rotation.data(),
            momentum.data(),
            inertia.data(),
            force.data(),
            torque.data(),
            travels ? travel.data() : nullptr};
  }
  SumLists lists() const { return {slot.data(), active.data(), start.data(), count.data(), true}; }
};

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// What bodies.h says, for body i.
void advance_one(Bodies& b, const BodyStep& s, const Cell& cell, bool travels, std::size_t i, BodyTally& tally) {
  Motion& m = b.motion[i];
  Vec3d f = b.force[i], t = b.torque[i];
  if (s.sum) {
    f = t = {};
    for (std::uint32_t e = 0; e < b.count[i]; ++e) {
      const std::uint32_t entry = b.active[b.start[i] + e];
      const Slot& slot = b.slot[entry / 2];
      f += entry % 2 != 0 ? -slot.force : slot.force;
      t += slot.couple * (entry % 2 != 0 ? slot.lever_b : slot.lever_a);
    }
    if (s.keep) {
      b.force[i] = f;
      b.torque[i] = t;
    }
  }
  const bool uniform = turns_uniformly(b.kind[i]);
  const auto kick = [&] {
    m.velocity += (f * m.inverse_mass + s.gravity) * (0.5 * s.dt);
    b.momentum[i] += t * (0.5 * s.dt);
  };
  const auto set_spin = [&] {
    m.spin = uniform ? b.momentum[i] * (1 / b.inertia[i].x) : spin_of(b.orientation[i], b.momentum[i], b.inertia[i]);
  };
  if (s.end) {
    if (s.deforms) m.velocity = scaled(m.velocity, s.flow.slowed);
    kick();
    set_spin();
  }
  if (s.begin) {
    kick();
    const Vec3d before = m.position;
    if (s.deforms) {
      m.velocity = scaled(m.velocity, s.flow.slowed);
      const Vec3d way = m.velocity * (0.5 * s.dt);
      m.position = s.centre + scaled(m.position + way - s.centre, s.flow.scale) + way;
    } else {
      m.position += m.velocity * s.dt;
    }
    const Vec3d moved = m.position - before;
    if (s.periodic) cell.wrap(m.position);
    const Quatd turned = b.orientation[i];
    const bool still = (s.still >> static_cast<unsigned>(b.kind[i]) & 1) != 0;
    if (uniform) {
      set_spin();
      if (!still) b.orientation[i] = rotated_uniformly(turned, m.spin, s.dt);
    } else {
      b.orientation[i] = rotated_freely(turned, b.momentum[i], b.inertia[i], s.dt);
      set_spin();
    }
    if (!still) b.rotation[i] += m.spin * s.dt;
    double way = dot(moved, moved);
    if (travels) {
      way = travel_of(moved, turned, b.orientation[i], m.bounding_radius);
      b.travel[i] += way;
    }
    tally.farthest = std::max(tally.farthest, way);
  }
  const double probe = (m.position.x + m.position.y + m.position.z) + (m.velocity.x + m.velocity.y + m.velocity.z) +
                       (m.spin.x + m.spin.y + m.spin.z);
  if (s.end && !std::isfinite(probe)) tally.bad = std::min(tally.bad, i);
}

Cell box(bool periodic) {
  Cell c;
  c.periodic = periodic;
  c.centre = {0.1, 0.2, 0.3};
  if (periodic) {
    c.lattice.length = {1.5, 1.25, 0};
    c.set_lengths(c.lattice.length);
  }
  return c;
}

const std::vector<std::vector<Kind>> mixtures = {
    {Kind::sphere}, {Kind::ellipsoid}, {Kind::sphere, Kind::polyhedron}, {Kind::disc, Kind::ellipse, Kind::polygon}};

TEST(Bodies, InLanesAreOneBodyAtATime) {
  int cases = 0;
  for (const contact::kernels::KernelSet* set : contact::kernels::kernel_sets())
    for (std::size_t n = 1; n <= 13; ++n)
      for (const auto& kinds : mixtures)
        for (unsigned flags = 0; flags < 256; ++flags) {
          const Cell cell = box((flags & 8) != 0);
          BodyStep s{.sum = (flags & 1) != 0,
                     .end = (flags & 2) != 0,
                     .begin = (flags & 4) != 0,
                     .keep = (flags & 16) != 0,
                     .deforms = (flags & 32) != 0,
                     .dt = 0.5,
                     .gravity = {0.5, -9, 0.25},
                     .uniform = kinds_that(turns_uniformly),
                     .still = (flags & 128) != 0 ? kinds_that(is_round) : 0,
                     .periodic = cell.periodic,
                     .lower = cell.lower,
                     .centre = cell.centre,
                     .lattice = cell.lattice,
                     .flow = {{0.9, 0.8, 0.7}, {1.1, 1.2, 0.9}}};
          const bool travels = (flags & 64) != 0;
          if (!s.sum && !s.end && !s.begin) continue;
          Bodies lanes(n, kinds, 1000 * n + flags);
          if (n > 5 && flags % 3 == 0) lanes.motion[n - 2].velocity.y = 1e308 * 10;
          Bodies one = lanes;
          const std::size_t first = n > 8 ? 3 : 0;
          BodyTally got, expected;
          body_kernel(set->name)(lanes.arrays(travels), lanes.lists(), s, first, n, got);
          for (std::size_t i = first; i < n; ++i) advance_one(one, s, cell, travels, i, expected);
          ++cases;
          SCOPED_TRACE(std::string(set->name) + ", " + std::to_string(n) + " bodies, flags " + std::to_string(flags));
          EXPECT_TRUE(same(lanes.motion, one.motion));
          EXPECT_TRUE(same(lanes.orientation, one.orientation));
          EXPECT_TRUE(same(lanes.rotation, one.rotation));
          EXPECT_TRUE(same(lanes.momentum, one.momentum));
          EXPECT_TRUE(same(lanes.force, one.force));
          EXPECT_TRUE(same(lanes.torque, one.torque));
          EXPECT_TRUE(same(lanes.travel, one.travel));
          EXPECT_EQ(got.bad, expected.bad);
          EXPECT_EQ(got.farthest, expected.farthest);
          if (HasFailure()) return;
        }
  EXPECT_GT(cases, 5000);
}

}  // namespace
}  // namespace dem
