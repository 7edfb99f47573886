// Contacts of spheres in one go against gather, geometry, law and torques one after the other, bit by bit, in every
// instruction set: spheres with spheres, in a box or not, and spheres with planes.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "libcontact/kernels/chunk.h"

namespace contact::kernels {
namespace {

using shapes::Vec3d;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3d vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Vec3d unit() {
    const Vec3d v = vector(1) + Vec3d{1.5, 0, 0};
    return normalized(v);
  }
  bool coin() { return (*this)(0, 1) < 0.5; }

 private:
  std::mt19937_64 random_;
};

constexpr std::size_t body_count = 40;
constexpr double radius = 1e-3;

struct Case {
  std::vector<Motion> motion;
  std::vector<PlaneRows> plane;
  std::vector<History> history;
  std::vector<Slot> slot;
  Index a[chunk_size], b[chunk_size], seat[chunk_size];
  std::size_t count;
  PairOf<Lane> pair{};
  LawOptions options;
  double dt;

  explicit Case(std::uint64_t seed) : history(2 * chunk_size), slot(4 * chunk_size) {
    Numbers number(seed);
    for (std::size_t i = 0; i < body_count; ++i) {
      const double own = number(0.5, 2) * radius;
      motion.push_back({number.vector(2 * radius), own, number.vector(0.3), number(1e4, 1e6), number.vector(50), own});
    }
    for (int i = 0; i < 3; ++i)
      plane.push_back({number.vector(radius), 0, number.vector(0.1), 0, number.vector(20), 0, number.unit(), 0});
    count = 1 + static_cast<std::size_t>(number(0, chunk_size));
    options.clip = number.coin();
    options.rescale = number.coin();
    dt = number.coin() ? 1e-5 : 0;
    for (std::size_t i = 0; i < chunk_size; ++i) {
      a[i] = static_cast<Index>(number(0, body_count / 2));
      b[i] = static_cast<Index>(number(body_count / 2, body_count));
      seat[i] = static_cast<Index>(2 * i + (number.coin() ? 1 : 0));
      if (number.coin())
        history[seat[i]] = {number.vector(1e-3), number(0, 1e-4), number.coin() ? number.unit() : -number.unit(), 0};
      pair.young_eff[i] = number(1e6, 1e9);
      pair.shear_eff[i] = number(1e6, 1e9);
      pair.stiffness_n[i] = number(1e2, 1e4);
      pair.stiffness_t[i] = number(1e2, 1e4);
      pair.friction[i] = number(0, 1);
      pair.damping[i] = number(0, 0.5);
    }
  }
};

void put(Lane3& lane, std::size_t i, const Vec3d& v) {
  lane.x[i] = v.x;
  lane.y[i] = v.y;
  lane.z[i] = v.z;
}
Vec3d get(const Lane3& lane, std::size_t i) { return {lane.x[i], lane.y[i], lane.z[i]}; }

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

SphereMeetings stage_by_stage(const KernelSet& set, bool hertz, const Lattice* lattice, Case& c) {
  static LawChunk l;
  static SphereChunk s;
  l.pair = c.pair;
  if (lattice != nullptr)
    set.periodic_gather(c.motion.data(), c.a, c.b, chunk_size, *lattice, s, l);
  else
    set.gather_spheres(c.motion.data(), c.a, c.b, chunk_size, s, l);
  set.load_history(c.history.data(), c.seat, chunk_size, l);
  const SphereMeetings now = set.spheres(s, l, c.count);
  (hertz ? set.hertz_mindlin : set.spring_dashpot)(l, c.count, c.dt, c.options);
  set.sphere_torques(s, l, c.count);
  set.store_history(l, c.seat, c.count, c.history.data());
  set.store_slots(l, c.seat, c.count, c.slot.data());
  for (std::size_t i = 0; i < c.count; ++i) {
    if ((now.touching >> i & 1) != 0) continue;
    c.history[c.seat[i]] = {};
    c.slot[c.seat[i]] = {{}, c.slot[c.seat[i]].lever_a, {}, c.slot[c.seat[i]].lever_b};
  }
  return now;
}

std::uint32_t stage_by_stage(const KernelSet& set, bool hertz, Case& c) {
  static LawChunk l;
  l.pair = c.pair;
  std::vector<Vec3d> arm_a, arm_b;
  std::uint32_t touching = 0;
  for (std::size_t i = 0; i < c.count; ++i) {
    const Motion& m = c.motion[c.a[i]];
    const PlaneRows& p = c.plane[c.b[i] % 3];
    const double overlap = m.bounding_radius - dot(p.normal, m.position - p.position);
    const Vec3d normal = -p.normal, lever = normal * (m.bounding_radius - 0.5 * overlap),
                wall_arm = m.position + lever - p.position;
    put(l.normal, i, normal);
    l.overlap[i] = overlap;
    put(l.velocity, i, m.velocity + cross(m.spin, lever) - p.velocity - cross(p.spin, wall_arm));
    l.turn[i] = 0.5 * dot(m.spin + p.spin, normal);
    l.radius_eff[i] = m.bounding_radius;
    l.mass_eff[i] = 1 / m.inverse_mass;
    arm_a.push_back(lever);
    arm_b.push_back(wall_arm);
    touching |= static_cast<std::uint32_t>(overlap > 0 ? 1 : 0) << i;
  }
  set.load_history(c.history.data(), c.seat, chunk_size, l);
  (hertz ? set.hertz_mindlin : set.spring_dashpot)(l, c.count, c.dt, c.options);
  set.store_history(l, c.seat, c.count, c.history.data());
  for (std::size_t i = 0; i < c.count; ++i) {
    Slot* slot = &c.slot[2 * c.seat[i]];
    const Vec3d f = get(l.force, i);
    const bool touches = (touching >> i & 1) != 0;
    if (!touches) c.history[c.seat[i]] = {};
    slot[0] = touches ? Slot{f, 1, cross(arm_a[i], f) + Vec3d{}, 0} : Slot{{}, 1, {}, 0};
    slot[1] = touches ? Slot{f, 0, -cross(arm_b[i], f) - Vec3d{}, 1} : Slot{{}, 0, {}, 1};
    if (touches) continue;
    const Vec3d nothing_a = cross(arm_a[i], Vec3d{}) + Vec3d{}, nothing_b = -cross(arm_b[i], Vec3d{}) - Vec3d{};
    slot[0].couple = nothing_a;
    slot[1].couple = nothing_b;
  }
  return touching;
}

std::uint32_t lanes_below(std::size_t n) { return n < 32 ? (std::uint32_t(1) << n) - 1 : ~std::uint32_t(0); }

TEST(SphereContacts, InOneGoAreTheSameBits) {
  Lattice box;
  box.length = {3 * radius, 4 * radius, 0};
  box.inverse = {1 / box.length.x, 1 / box.length.y, 0};
  box.rate = {1, -2, 3};
  int touched = 0, apart = 0, turned = 0;
  for (const KernelSet* set : kernel_sets())
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
      Case one(seed), other(seed);
      const bool hertz = seed % 2 == 0;
      const Lattice* lattice = seed % 3 == 0 ? &box : nullptr;
      Lane before;
      const SphereContacts contacts{one.motion.data(), one.a,     one.b,  one.seat,     one.count,
                                    lattice,           &one.pair, one.dt, &one.options, one.history.data(),
                                    one.slot.data(),   &before};
      const SphereMeetings got = (hertz ? set->sphere_contacts_hertz : set->sphere_contacts_linear)(contacts);
      for (std::size_t i = 0; i < one.count; ++i) EXPECT_EQ(before[i], other.history[one.seat[i]].overlap);
      const SphereMeetings expected = stage_by_stage(*set, hertz, lattice, other);
      SCOPED_TRACE(std::string(set->name) + ", case " + std::to_string(seed));
      const std::uint32_t all = lanes_below(one.count);
      EXPECT_EQ(got.touching & all, expected.touching & all);
      EXPECT_EQ(got.turned & all, expected.turned & all);
      // The couple of those that do not touch is nothing, with either sign.
      for (std::size_t i = 0; i < one.count; ++i) {
        const bool touches = (got.touching >> i & 1) != 0;
        ++(touches ? touched : apart);
        turned += static_cast<int>(got.turned >> i & 1);
        if (touches) continue;
        Slot& s = one.slot[one.seat[i]];
        EXPECT_EQ(shapes::norm(s.couple) + shapes::norm(s.force), 0);
        s.couple = {};
        s.force = {};
      }
      EXPECT_TRUE(same(one.history, other.history));
      EXPECT_TRUE(same(one.slot, other.slot));
      if (HasFailure()) return;
    }
  EXPECT_GT(touched, 3000);
  EXPECT_GT(apart, 3000);
  EXPECT_GT(turned, 1000);
}

TEST(SphereContacts, WithPlanesInOneGoAreTheSameBits) {
  int touched = 0, apart = 0;
  for (const KernelSet* set : kernel_sets())
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
      Case one(seed), other(seed);
      const bool hertz = seed % 2 == 0;
      Index wall[chunk_size];
      for (std::size_t i = 0; i < chunk_size; ++i) wall[i] = one.b[i] % 3;
      Lane before;
      const PlaneContacts contacts{one.motion.data(), one.plane.data(),   one.a,           wall,
                                   one.seat,          one.count,          &one.pair,       one.dt,
                                   &one.options,      one.history.data(), one.slot.data(), &before};
      const SphereMeetings got = (hertz ? set->plane_contacts_hertz : set->plane_contacts_linear)(contacts);
      const std::uint32_t expected = stage_by_stage(*set, hertz, other);
      SCOPED_TRACE(std::string(set->name) + ", case " + std::to_string(seed));
      EXPECT_EQ(got.touching & lanes_below(one.count), expected);
      for (std::size_t i = 0; i < one.count; ++i) ++((expected >> i & 1) != 0 ? touched : apart);
      EXPECT_TRUE(same(one.history, other.history));
      EXPECT_TRUE(same(one.slot, other.slot));
      if (HasFailure()) return;
    }
  EXPECT_GT(touched, 3000);
  EXPECT_GT(apart, 1000);
}

}  // namespace
}  // namespace contact::kernels
