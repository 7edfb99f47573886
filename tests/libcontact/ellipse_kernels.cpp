// Pairs of ellipses answered in chunks: the same bits as one by one, for every kernel set, whatever stands beside a
// pair; a search that begins elsewhere answers within the interval of a cold one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/ellipse_search.h"
#include "shapes/math/random.h"
#include "tests/libcontact/same_bits.h"

namespace contact {
namespace {

// Apart, touching, deep, contained, on one centre, along an axis, needles, and no pairs at all.
Pairs sample(std::uint64_t seed, std::size_t count) {
  Pairs p;
  for (std::size_t i = 0; i < count; ++i) {
    shapes::Random draw(seed, 1, i);
    const double aspects[] = {1.5, 4, 20, 400, 1e6};
    const auto body = [&] {
      Body b;
      b.kind = shapes::Kind::ellipse;
      b.size = {1, std::pow(aspects[i % 5], -draw.uniform()), 0};
      if (draw.uniform() < 0.5) std::swap(b.size.x, b.size.y);
      b.rotation = rotation_matrix(draw.turn());
      return b;
    };
    Body a = body(), b = body();
    b.size *= i % 7 == 0 ? 1e-3 : 1;
    const double angle = 6.283 * draw.uniform();
    const Vec3d n{i % 17 == 0 ? 0 : std::cos(angle), std::sin(angle), 0};
    const auto support = [&](const Body& s) {
      const Vec3d u = scaled(s.size, transposed_times(s.rotation, n));
      return s.rotation * scaled(s.size, u * (1 / norm(u)));
    };
    const double parts[] = {1.5, 1.01, 1.0, 0.999, 0.8, 0.2, 0};
    Vec3d offset = parts[(i / 5) % 7] * (support(a) + support(b));
    if (i % 37 == 36) offset.y = std::numeric_limits<double>::quiet_NaN();
    if (i % 41 == 40) b.rotation.row[1].x = std::numeric_limits<double>::infinity();
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

TEST(EllipseChunks, answer_as_one_by_one) {
  const ChunkQuery query = find(shapes::Kind::ellipse, shapes::Kind::ellipse);
  const Pairs p = sample(1, 1000);
  AnswersCounted n;
  for (const Options& o : {Options{}, Options{.overlap_only = true}, Options{.tolerance = 1e-5}})
    expect_chunks_as_one_by_one(
        query, p, o,
        [](std::size_t i, Cache& alone, Cache& in_chunks) {
          if (i % 11 == 0) alone.axis *= 3;  // an axis that is not a unit vector
          in_chunks = alone;
        },
        n);
  EXPECT_GT(n.solved, 1000);
  EXPECT_GT(n.proven, 100);
  EXPECT_GT(n.uncertified, 100);
  EXPECT_GT(n.none, 100);
}

using kernels::EllipseChunk;

FlatEllipse<double> flat(const Body& b) { return {b.size.x, b.size.y, b.rotation.row[0].x, b.rotation.row[1].x}; }

void put(EllipseChunk::Lane* lane, std::size_t i, const FlatEllipse<double>& e) {
  lane[0][i] = e.a;
  lane[1][i] = e.b;
  lane[2][i] = e.cosine;
  lane[3][i] = e.sine;
}

TEST(EllipseKernels, every_set_gives_the_bits_of_the_scalar_search) {
  Pairs p = sample(3, 43 * 32);
  for (std::size_t i = 0; i < p.size(); ++i) {  // near one unit, as the kernels are given them
    const double unit = 0.25 / std::max(p.a[i].size.x, p.a[i].size.y);
    p.a[i].size *= unit;
    p.b[i].size *= unit;
    p.offset[i] *= unit;
  }
  int straggling = 0, answered = 0, warm_lanes = 0, cold_steps = 0, warm_steps = 0;
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (std::size_t first = 0; first + EllipseChunk::size <= p.size(); first += EllipseChunk::size) {
      static EllipseChunk c;
      const double tolerance = first % 64 == 0 ? 0 : 1e-5;
      const auto search = [&](std::size_t i) {
        const Vec3d& d = p.offset[first + i];
        return EllipseSearch<double>(flat(p.a[first + i]), flat(p.b[first + i]), {d.x, d.y});
      };
      std::vector<EllipseAnswer<double>> cold;
      for (std::size_t i = 0; i < EllipseChunk::size; ++i) {
        put(c.a, i, flat(p.a[first + i]));
        put(c.b, i, flat(p.b[first + i]));
        c.d[0][i] = p.offset[first + i].x;
        c.d[1][i] = p.offset[first + i].y;
        cold.push_back(search(i).solve({0, 0}, 0));
        const double turn = i % 3 == 0 ? 1e-4 : 0;  // others begin cold
        const Flat<double> near = cold[i].normal + turn * cold[i].normal.turned();
        const double length = turn > 0 && cold[i].solved != 0 ? std::sqrt(dot(near, near)) : 0;
        c.start[0][i] = length > 0 ? near.x / length : 0;
        c.start[1][i] = length > 0 ? near.y / length : 0;
      }
      set->pairs.ellipse_search(c, EllipseChunk::size, tolerance);
      for (std::size_t i = 0; i < EllipseChunk::size; ++i) {
        const EllipseAnswer<double> r = search(i).solve({c.start[0][i], c.start[1][i]}, tolerance);
        EXPECT_EQ(r.solved, c.outcome[i]) << set->name;
        if (r.solved == 0) {
          ++straggling;
          continue;
        }
        ++answered;
        EXPECT_EQ(r.iterations, c.iterations[i]) << set->name;
        EXPECT_TRUE(same_bits(r.gap, c.gap[i]) && same_bits(r.lower, c.lower[i]) && same_bits(r.upper, c.upper[i]));
        for (int k = 0; k < 2; ++k) {
          const auto at = [k](const Flat<double>& v) { return k == 0 ? v.x : v.y; };
          EXPECT_TRUE(same_bits(at(r.normal), c.normal[k][i]) && same_bits(at(r.inner_a), c.inner_a[k][i]) &&
                      same_bits(at(r.inner_b), c.inner_b[k][i]))
              << set->name;
        }
        EXPECT_NEAR(dot(r.normal, r.normal), 1, 1e-14);
        if (c.start[0][i] == 0 && c.start[1][i] == 0) continue;
        ++warm_lanes;
        EXPECT_LE(r.lower, cold[i].upper);
        EXPECT_GE(r.upper, cold[i].lower);
        if (tolerance > 0) continue;
        cold_steps += static_cast<int>(cold[i].iterations);
        warm_steps += static_cast<int>(r.iterations);
      }
    }
  EXPECT_GT(straggling, 100);
  EXPECT_GT(answered, 500);
  EXPECT_GT(warm_lanes, 100);
  EXPECT_LT(warm_steps, 0.8 * cold_steps);
}

}  // namespace
}  // namespace contact
