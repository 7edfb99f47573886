// Ellipsoid pairs answered in chunks: the same bits as one by one, for every kernel set, whatever stands beside a pair;
// warm starts answer within the interval of cold ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/ellipsoid_search.h"
#include "shapes/math/random.h"
#include "tests/libcontact/same_bits.h"

namespace contact {
namespace {

// Apart, touching, deep, contained, on one centre, flat beyond the kernels' range, and no pairs at all.
Pairs sample(std::uint64_t seed, std::size_t count) {
  Pairs p;
  for (std::size_t i = 0; i < count; ++i) {
    shapes::Random draw(seed, 1, i);
    const auto body = [&](double aspect) {
      Body b;
      b.kind = shapes::Kind::ellipsoid;
      b.size = {1, std::pow(aspect, -draw.uniform()), std::pow(aspect, -draw.uniform())};
      b.rotation = rotation_matrix(draw.rotation());
      return b;
    };
    const double aspects[] = {1.5, 4, 20, 400, 1e6};
    const double aspect = aspects[i % 5];
    Body a = body(aspect), b = body(aspect);
    b.size *= i % 7 == 0 ? 1e-3 : 1;
    const Vec3d n = draw.direction();
    const auto support = [&](const Body& s) {
      return s.rotation * shapes::support(shapes::Ellipsoid{s.size}, transposed_times(s.rotation, n));
    };
    const double parts[] = {1.5, 1.01, 1.0, 0.999, 0.8, 0.2, 0};
    Vec3d offset = parts[(i / 5) % 7] * (support(a) + support(b));
    if (i % 37 == 36) offset.y = std::numeric_limits<double>::quiet_NaN();
    if (i % 41 == 40) b.rotation.row[1].z = std::numeric_limits<double>::infinity();
    if (i % 43 == 42) a.size.y = -1;
    const double units[] = {1, 0x1p-40, 0x1p300};
    const double unit = units[i % 3];
    a.size *= unit;
    b.size *= unit;
    p.a.push_back(a);
    p.b.push_back(b);
    p.offset.push_back(unit * offset);
  }
  return p;
}

const Options options[] = {
    {}, {.overlap_only = true}, {.warm_start = true}, {.overlap_only = true, .warm_start = true}};

TEST(EllipsoidChunks, answer_as_one_by_one) {
  const ChunkQuery query = find(shapes::Kind::ellipsoid, shapes::Kind::ellipsoid);
  const Pairs p = sample(1, 1000);
  AnswersCounted n;
  for (const Options& o : options)
    expect_chunks_as_one_by_one(
        query, p, o, [](std::size_t, Cache&, Cache&) {}, n);
  EXPECT_GT(n.solved, 1000);
  EXPECT_GT(n.proven, 300);
  EXPECT_GT(n.uncertified, 100);
  EXPECT_GT(n.none, 100);
}

TEST(EllipsoidChunks, warm_starts_stay_within_the_interval) {
  const ChunkQuery query = find(shapes::Kind::ellipsoid, shapes::Kind::ellipsoid);
  const Pairs p = sample(2, 400);
  std::vector<Cache> cache(p.size());
  std::vector<Contact> cold(p.size()), warm(p.size());
  query(p.size(), p.a.data(), p.b.data(), p.offset.data(), {.warm_start = true}, cache.data(), warm.data());
  std::vector<Vec3d> moved = p.offset;
  for (std::size_t i = 0; i < p.size(); ++i) moved[i] = moved[i] * (1 + 1e-3);
  query(p.size(), p.a.data(), p.b.data(), moved.data(), {}, nullptr, cold.data());
  query(p.size(), p.a.data(), p.b.data(), moved.data(), {.warm_start = true}, cache.data(), warm.data());
  int compared = 0;
  double steps_cold = 0, steps_warm = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!cold[i].certified || !warm[i].certified) continue;
    ++compared;
    steps_cold += cold[i].iterations;
    steps_warm += warm[i].iterations;
    EXPECT_LE(warm[i].gap_lower, cold[i].gap_upper) << i;
    EXPECT_GE(warm[i].gap_upper, cold[i].gap_lower) << i;
  }
  EXPECT_GT(compared, 200);
  EXPECT_LT(steps_warm, 0.8 * steps_cold);
}

// S_A + S_B of needles in line is singular to rounding: no direction to begin with may come of it.
TEST(EllipsoidChunks, needles_in_line_have_unit_normals) {
  int with_direction = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    shapes::Random draw(4, 1, i);
    Body a, b;
    a.kind = b.kind = shapes::Kind::ellipsoid;
    a.rotation = b.rotation = rotation_matrix(draw.rotation());
    a.size = {1.25, 2.5e-6, 2e-6};
    b.size = {1e-8, 6e-10, 1.2e-7};
    const Contact c = contact::query(a, b, (0.22 + draw.uniform()) * a.rotation.column(0));
    EXPECT_NEAR(norm(c.normal), 1, 1e-14) << i;
    with_direction += c.status != Status::refused;
  }
  EXPECT_EQ(with_direction, 200);
}

namespace kernels_test {

using kernels::EllipsoidChunk;

EllipsoidPair<double> pair_of(const Pairs& p, std::size_t i) {
  return {p.a[i].size, p.b[i].size, p.a[i].rotation, p.b[i].rotation, p.offset[i]};
}

void fill(EllipsoidChunk& c, const Pairs& p, std::size_t first) {
  const auto put = [](EllipsoidChunk::Lane* lane, std::size_t i, const Vec3d& v) {
    for (int k = 0; k < 3; ++k) lane[k][i] = v[k];
  };
  for (std::size_t i = 0; i < EllipsoidChunk::size; ++i) {
    const EllipsoidPair<double> e = pair_of(p, first + i);
    put(c.in, i, e.axes_a);
    put(c.in + 3, i, e.axes_b);
    for (int k = 0; k < 3; ++k) {
      put(c.in + 6 + 3 * k, i, e.rotation_a.row[k]);
      put(c.in + 15 + 3 * k, i, e.rotation_b.row[k]);
    }
    put(c.in + 24, i, e.d);
    put(c.in + 27, i, i % 3 == 0 ? normalized(Vec3d{1, 2, static_cast<double>(i)}) : Vec3d{});
  }
}

}  // namespace kernels_test

TEST(EllipsoidKernels, every_set_gives_the_bits_of_the_scalar_search) {
  using kernels::EllipsoidChunk;
  Pairs p = sample(3, 43 * 32);
  for (std::size_t i = 0; i < p.size(); ++i) {  // near one unit, as the kernels are given them
    const double unit = 0.25 / p.a[i].size.x;
    p.a[i].size *= unit;
    p.b[i].size *= unit;
    p.offset[i] *= unit;
  }
  int straggling = 0, answered = 0;
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (std::size_t first = 0; first + EllipsoidChunk::size <= p.size(); first += EllipsoidChunk::size)
      for (const bool stop : {false, true}) {
        static EllipsoidChunk c;
        kernels_test::fill(c, p, first);
        const double tolerance = first % 64 == 0 ? 0 : 1e-5;
        set->pairs.ellipsoid_search(c, EllipsoidChunk::size, stop, tolerance);
        for (std::size_t i = 0; i < EllipsoidChunk::size; ++i) {
          const EllipsoidAnswer<double> r = EllipsoidSearch<double>(kernels_test::pair_of(p, first + i))
                                                .solve({c.in[27][i], c.in[28][i], c.in[29][i]}, stop, tolerance);
          EXPECT_EQ(r.outcome, c.outcome[i]) << set->name;
          EXPECT_EQ(r.iterations, c.iterations[i]) << set->name;
          EXPECT_TRUE(same_bits(r.normal, {c.normal[0][i], c.normal[1][i], c.normal[2][i]})) << set->name << i;
          if (r.outcome == EllipsoidAnswer<double>::straggler) {
            const double length = norm(r.normal);  // where the other search begins
            EXPECT_TRUE(length == 0 || std::abs(length - 1) < 1e-15) << length;
            ++straggling;
            continue;
          }
          EXPECT_TRUE(same_bits(r.lower, c.lower[i])) << set->name;
          if (r.outcome != EllipsoidAnswer<double>::solved) continue;
          ++answered;
          EXPECT_TRUE(same_bits(r.gap, c.gap[i]) && same_bits(r.upper, c.upper[i])) << set->name;
          EXPECT_TRUE(same_bits(r.inner_a, {c.inner_a[0][i], c.inner_a[1][i], c.inner_a[2][i]})) << set->name;
          EXPECT_TRUE(same_bits(r.inner_b, {c.inner_b[0][i], c.inner_b[1][i], c.inner_b[2][i]})) << set->name;
        }
      }
  EXPECT_GT(straggling, 100);
  EXPECT_GT(answered, 500);
}

}  // namespace
}  // namespace contact
