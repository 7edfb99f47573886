// Contacts of ellipsoids and of ellipses in lanes, from bodies to what laws take: the same bits on every kernel set,
// the answers of the scalar query within their intervals, the kinematics of a rigid body.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/smooth.h"
#include "shapes/math/random.h"
#include "tests/libcontact/same_bits.h"

namespace contact {
namespace {

using kernels::chunk_size;
using kernels::Index;
using kernels::Lane3;
using kernels::LawChunk;
using kernels::SmoothChunk;
using shapes::Kind;
using shapes::Quatd;

constexpr Kind kinds[] = {Kind::ellipsoid, Kind::ellipse};

struct Bodies {
  std::vector<Motion> motion;
  std::vector<Quatd> orientation;
  std::vector<Vec3d> size, inertia;
  kernels::SmoothBodies arrays() const { return {motion.data(), orientation.data(), size.data(), inertia.data()}; }
  Body body(Kind kind, std::size_t i) const {
    Body b;
    b.kind = kind;
    b.size = size[i];
    b.rotation = rotation_matrix(orientation[i]);
    return b;
  }
};

// Bodies 2 i and 2 i + 1 are a pair: apart by a little, overlapping, or deeper than the lanes go.
Bodies sample(Kind kind, double unit, std::size_t pairs) {
  const bool plane = kind == Kind::ellipse;
  Bodies out;
  for (std::size_t i = 0; i < 2 * pairs; ++i) {
    shapes::Random draw(5, 1, i);
    const auto vector = [&](double scale, bool about_z) {
      const Vec3d v = scale * Vec3d{draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
      return !plane ? v : about_z ? Vec3d{0, 0, v.z} : Vec3d{v.x, v.y, 0};
    };
    out.orientation.push_back(plane ? draw.turn() : draw.rotation());
    out.size.push_back(unit * Vec3d{draw.uniform(0.4, 1), draw.uniform(0.4, 1), plane ? 0 : draw.uniform(0.4, 1)});
    out.inertia.push_back((unit * unit) * Vec3d{draw.uniform(1, 2), draw.uniform(1, 2), draw.uniform(1, 2)});
    Motion m;
    m.velocity = vector(unit, false);
    m.spin = vector(1, true);
    m.inverse_mass = draw.uniform(1, 2);
    m.equivalent_radius = unit * draw.uniform(0.4, 1);
    m.position = vector(unit, false);
    if (i % 2 == 1) {
      const Vec3d n = normalized(vector(1, false));
      const auto height = [&](std::size_t j) {
        return norm(scaled(out.size[j], transposed_times(rotation_matrix(out.orientation[j]), n)));
      };
      const double parts[] = {0.9, 0.99, 0.9999, 1.01, 0.3};
      m.position = out.motion.back().position + (parts[i / 2 % 5] * (height(i - 1) + height(i))) * n;
    }
    out.motion.push_back(m);
  }
  return out;
}

Vec3d get(const Lane3& lane, std::size_t i) { return {lane.x[i], lane.y[i], lane.z[i]}; }
double inverse_mass(const Bodies& bodies, std::size_t i, const Vec3d& arm, const Vec3d& n) {
  const Vec3d t = transposed_times(rotation_matrix(bodies.orientation[i]), cross(arm, n)), &inertia = bodies.inertia[i];
  return bodies.motion[i].inverse_mass + t.x * t.x / inertia.x + t.y * t.y / inertia.y + t.z * t.z / inertia.z;
}

bool same_lane(const LawChunk& x, const LawChunk& y, std::size_t i) {
  bool same = same_bits(x.overlap[i], y.overlap[i]) && same_bits(x.turn[i], y.turn[i]) &&
              same_bits(x.mass_eff[i], y.mass_eff[i]) && same_bits(x.radius_eff[i], y.radius_eff[i]);
  for (const auto lanes : {&LawChunk::normal, &LawChunk::velocity, &LawChunk::couple, &LawChunk::couple_b})
    for (const auto part : {&Lane3::x, &Lane3::y, &Lane3::z})
      same = same && same_bits((x.*lanes.*part)[i], (y.*lanes.*part)[i]);
  return same;
}

TEST(SmoothKernels, answer_as_the_query_and_move_as_rigid_bodies) {
  constexpr std::size_t pairs = 320;
  for (const Kind kind : kinds)
    for (const double unit : {1.0, 0x1p-12}) {
      const Bodies bodies = sample(kind, unit, pairs);
      std::size_t answered = 0, left = 0;
      for (std::size_t first = 0; first < pairs; first += chunk_size) {
        const bool swapped = first % 64 == 0;
        struct Answers {
          LawChunk law;
          kernels::SmoothMeetings now;
        };
        std::vector<Answers> reference;
        for (const kernels::KernelSet* set : kernels::kernel_sets()) {
          static LawChunk law;
          static SmoothChunk chunk;
          law = {};
          Index a[chunk_size], b[chunk_size];
          for (std::size_t i = 0; i < chunk_size; ++i) {
            a[i] = static_cast<Index>(2 * (first + i) + (swapped ? 1 : 0));
            b[i] = static_cast<Index>(2 * (first + i) + (swapped ? 0 : 1));
            if (i % 3 == 0) continue;  // begins cold
            const Contact before = query(bodies.body(kind, a[i]), bodies.body(kind, b[i]),
                                         bodies.motion[b[i]].position - bodies.motion[a[i]].position);
            const Vec3d n = normalized(before.normal + Vec3d{1e-4, -2e-4, kind == Kind::ellipse ? 0 : 1e-4});
            law.history_normal.x[i] = n.x;
            law.history_normal.y[i] = n.y;
            law.history_normal.z[i] = n.z;
          }
          const kernels::SmoothKernels& smooth =
              kind == Kind::ellipse ? set->smooth->ellipses : set->smooth->ellipsoids;
          smooth.gather(bodies.arrays(), a, b, chunk_size, nullptr, chunk, law);
          const kernels::SmoothMeetings now = smooth.meet(chunk, law, chunk_size, 0);
          for (std::size_t i = 0; i < chunk_size; ++i) {
            law.force.x[i] = 1 + static_cast<double>(i);
            law.force.y[i] = 2;
            law.force.z[i] = kind == Kind::ellipse ? 0 : -3;
          }
          const Vec3d moment{kind == Kind::ellipse ? 0 : 0.5, 0, -0.25};
          const bool rolls = first % 96 == 0;
          for (std::size_t i = 0; i < chunk_size; ++i) {
            law.couple.x[i] = moment.x;
            law.couple.y[i] = moment.y;
            law.couple.z[i] = moment.z;
          }
          smooth.torques(chunk, law, chunk_size, rolls);
          for (std::size_t i = 0; i < chunk_size; ++i) {
            const Vec3d d = bodies.motion[b[i]].position - bodies.motion[a[i]].position;
            const Contact c = query(bodies.body(kind, a[i]), bodies.body(kind, b[i]), d);
            if ((now.overlapping >> i & 1) == 0) {
              EXPECT_TRUE(c.gap > 0 || !(c.gap < -1e-3 * unit) || -c.gap > 0.1 * unit) << c.gap;
              ++left;
              continue;
            }
            ++answered;
            EXPECT_TRUE(c.certified);
            EXPECT_LT(c.gap_lower, -law.overlap[i]);
            EXPECT_GT(c.gap_upper, -law.overlap[i]);
            const Vec3d n = get(law.normal, i), arm_a = get(chunk.a.arm, i), arm_b = get(chunk.b.arm, i);
            EXPECT_LT(norm(n - c.normal), 1e-13);
            EXPECT_LT(norm(arm_a - c.patch.centre), 1e-13 * unit);
            EXPECT_LT(norm(arm_a - d - arm_b), 1e-15 * unit);
            const Motion &ma = bodies.motion[a[i]], &mb = bodies.motion[b[i]];
            const Vec3d v = ma.velocity + cross(ma.spin, arm_a) - mb.velocity - cross(mb.spin, arm_b);
            EXPECT_LT(norm(get(law.velocity, i) - v), 1e-14 * unit);
            EXPECT_NEAR(law.turn[i], 0.5 * dot(ma.spin + mb.spin, n), 1e-14);
            EXPECT_NEAR(law.mass_eff[i] * (inverse_mass(bodies, a[i], arm_a, n) + inverse_mass(bodies, b[i], arm_b, n)),
                        1, 1e-13);
            EXPECT_NEAR(law.radius_eff[i] * (1 / ma.equivalent_radius + 1 / mb.equivalent_radius), 1, 1e-14);
            const Vec3d f = get(law.force, i);
            const Vec3d added = rolls ? moment : Vec3d{};
            EXPECT_LT(norm(get(law.couple, i) - cross(arm_a, f) - added), 1e-14 * (1 + 100 * unit));
            EXPECT_LT(norm(get(law.couple_b, i) + cross(arm_b, f) + added), 1e-14 * (1 + 100 * unit));
            EXPECT_EQ(norm(get(law.relative_spin, i) - (ma.spin - mb.spin)), 0);
          }
          if (reference.empty()) reference = {{law, now}};
          EXPECT_EQ(now.overlapping, reference[0].now.overlapping) << set->name;
          for (std::size_t i = 0; i < chunk_size; ++i)
            EXPECT_TRUE((now.overlapping >> i & 1) == 0 || same_lane(law, reference[0].law, i)) << set->name;
        }
      }
      EXPECT_GT(answered, 150U);
      EXPECT_GT(left, 100U);
    }
}

}  // namespace
}  // namespace contact
