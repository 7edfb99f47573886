// The proof that one facet of the difference of two polyhedra is the nearest, against the search over all axes; and the
// cache, which may hold anything without a bit of the answer changing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

#include "libcontact/methods/expansion.h"
#include "libcontact/methods/sat.h"
#include "libcontact/methods/sat_search.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;

Polyhedron round_grain(Draw& draw, int count, const Vec3d& size) {
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) points.push_back(scaled(size, draw.direction()));
  return shapes::polyhedron_from_points(points, shapes::Frame::principal);
}

std::vector<Polyhedron> zoo() {
  using enum shapes::Platonic;
  Draw draw(1);
  return {shapes::make_box({1, 1, 1}),
          shapes::make_box({1, 0.3, 0.02}),
          shapes::make_platonic(tetrahedron, 0.8),
          shapes::make_platonic(dodecahedron, 0.7),
          shapes::make_prism(7, 0.5, 1.5),
          grain("cement140_01.off"),
          grain("cement140_07.off"),
          round_grain(draw, 12, {0.5, 0.4, 0.6}),
          round_grain(draw, 50, {0.5, 0.4, 0.6}),
          round_grain(draw, 200, {0.5, 0.4, 0.6})};
}

DifferencePair difference(const Placed<Polyhedron>& a, const Placed<Polyhedron>& b, const Vec3d& d) {
  const PolyhedronPair pair{
      a.shape,
      b.shape,
      a.scale,
      b.scale,
      {{transposed_times(b.rotation, a.rotation.column(0)), transposed_times(b.rotation, a.rotation.column(1)),
        transposed_times(b.rotation, a.rotation.column(2))}},
      transposed_times(a.rotation, d)};
  return {pair, norm(d) + a.scale * a.shape->circumradius + b.scale * b.shape->circumradius};
}

struct Pair {
  Placed<Polyhedron> a, b;
  Vec3d d;
};

// Bodies of the zoo that overlap by `overlap` or a little more.
Pair overlapping(const std::vector<Polyhedron>& shapes, Draw& draw, double overlap) {
  const Polyhedron &pa = shapes[draw.index(shapes.size())], &pb = shapes[draw.index(shapes.size())];
  Pair p{place(pa, std::exp2(draw.between(-1, 1)), draw.orientation()), place(pb, 1, draw.orientation()), {}};
  const Vec3d u = draw.direction();
  double inside = 0, outside = p.a.scale * pa.circumradius + pb.circumradius;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    p.d = middle * u;
    (Sat::query(p.a, p.b, p.d, {}, nullptr).gap < -overlap ? inside : outside) = middle;
  }
  p.d = inside * u;
  return p;
}

bool same(const DifferenceFacet& f, const DifferenceFacet& g) { return f.kind == g.kind && f.a == g.a && f.b == g.b; }

TEST(PolyProof, IsOfTheFacetThatTheCompleteSearchFinds) {
  const auto shapes = zoo();
  Draw draw(2);
  int shallow = 0, at_once = 0, deep = 0, at_depth = 0;
  for (int i = 0; i < 1200; ++i) {
    const bool is_deep = i % 3 == 0;
    const Pair p = overlapping(shapes, draw, is_deep ? draw.between(0.02, 0.3) : std::pow(10.0, draw.between(-12, -3)));
    const DifferencePair pair = difference(p.a, p.b, p.d);
    const DifferenceFacet best = search_all(pair, std::numeric_limits<double>::infinity());
    const Exit exit = leave(pair, pair.core);
    (is_deep ? deep : shallow) += 1;
    if (exit.kind == Exit::nearest) {
      EXPECT_TRUE(same(exit.face, best)) << i;
      EXPECT_EQ(exit.axis.value, axis_of(pair, best).value);
      EXPECT_TRUE(exit.axis.normal == axis_of(pair, best).normal);
      (is_deep ? at_depth : at_once) += 1;
    }
    DifferenceFacet found;
    FacetAxis axis{};
    if (exit.kind == Exit::facet && expand(pair, pair.core, exit.corner, found, axis)) {
      EXPECT_TRUE(same(found, best)) << i;
      EXPECT_EQ(axis.value, axis_of(pair, best).value);
      at_depth += is_deep ? 1 : 0;
    }
  }
  // Proofs are the rule, not luck.
  EXPECT_GT(at_once, 0.9 * shallow);
  EXPECT_GT(at_depth, 0.9 * deep);
}

TEST(PolyProof, IsOfNoOtherFacet) {
  const auto shapes = zoo();
  Draw draw(3);
  int proven = 0;
  for (int i = 0; i < 300; ++i) {
    const Pair p = overlapping(shapes, draw, std::pow(10.0, draw.between(-6, -0.5)));
    const DifferencePair pair = difference(p.a, p.b, p.d);
    const DifferenceFacet best = search_all(pair, std::numeric_limits<double>::infinity());
    const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
    const auto try_facet = [&](DifferenceFacet facet) {
      FacetAxis axis{};
      if (prove_nearest(pair, facet, axis) != Nearest::proven) return;
      ++proven;
      EXPECT_TRUE(same(facet, best)) << i;
    };
    for (std::uint32_t f = 0; f < count(pair.self->faces); ++f) try_facet({DifferenceFacet::face_of_a, f, 0});
    for (std::uint32_t f = 0; f < count(pair.other->faces); ++f) try_facet({DifferenceFacet::face_of_b, 0, f});
    if (count(pair.self->edges) * count(pair.other->edges) > 4000) continue;
    for (std::uint32_t e = 0; e < count(pair.self->edges); ++e)
      for (std::uint32_t f = 0; f < count(pair.other->edges); ++f) try_facet({DifferenceFacet::edges, e, f});
  }
  EXPECT_GT(proven, 100);
}

bool same_bits(const Contact& x, const Contact& y) {
  const auto numbers = [](const Contact& c) {
    return std::array<double, 30>{c.gap,
                                  c.gap_lower,
                                  c.gap_upper,
                                  c.normal.x,
                                  c.normal.y,
                                  c.normal.z,
                                  c.point_a.x,
                                  c.point_a.y,
                                  c.point_a.z,
                                  c.point_b.x,
                                  c.point_b.y,
                                  c.point_b.z,
                                  c.patch.centre.x,
                                  c.patch.centre.y,
                                  c.patch.centre.z,
                                  c.patch.spread[0],
                                  c.patch.spread[1],
                                  c.patch.spread[2],
                                  c.patch.spread[3],
                                  c.patch.spread[4],
                                  c.patch.spread[5],
                                  c.patch.weight,
                                  c.method_overlap,
                                  c.method_normal.x,
                                  c.method_normal.y,
                                  c.method_normal.z,
                                  c.method_point.x,
                                  c.method_point.y,
                                  c.method_point.z,
                                  0.0};
  };
  const auto u = numbers(x), v = numbers(y);
  const auto bits = [](double f, double g) {
    return std::bit_cast<std::uint64_t>(f) == std::bit_cast<std::uint64_t>(g);
  };
  return x.status == y.status && x.certified == y.certified && std::equal(u.begin(), u.end(), v.begin(), bits);
}

TEST(PolyProof, AnyCacheGivesTheSameBits) {
  const auto shapes = zoo();
  Draw draw(4);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  int overlapping_pairs = 0;
  for (int i = 0; i < 1500; ++i) {
    Pair p = overlapping(shapes, draw, std::pow(10.0, draw.between(-9, -0.7)));
    if (i % 4 == 0) {  // faces and edges in line: ties that no proof may decide
      p.b.rotation = p.a.rotation;
      p.d = draw.between(0.3, 1) * (p.a.rotation * p.a.shape->faces[draw.index(p.a.shape->faces.size())].normal);
    }
    const Options quick{.overlap_only = true, .patch = true};
    const Contact cold = Sat::query(p.a, p.b, p.d, quick, nullptr), full = Sat::query(p.a, p.b, p.d, {}, nullptr);
    ASSERT_EQ(cold.status, full.status);
    if (cold.status == Status::overlapping) {
      ++overlapping_pairs;
      EXPECT_TRUE(same_bits(cold, full));
    }
    std::vector<Cache> caches(3);
    Sat::query(p.a, p.b, p.d, quick, &caches[0]);
    for (const double step : {1e-12, 1e-6, 1e-3, 0.1}) {  // what a step, or a jump, before left
      Pair before = p;
      before.d += step * draw.direction();
      const double half = step;
      const Vec3d axis = draw.direction();
      before.b.rotation =
          rotation_matrix(normalized(Quatd{1, half * axis.x, half * axis.y, half * axis.z})) * before.b.rotation;
      Sat::query(before.a, before.b, before.d, quick, &caches.emplace_back());
    }
    for (int k = 0; k < 4; ++k) {
      const auto word = [&] { return static_cast<std::uint32_t>(draw.index(1ull << 32)); };
      const auto kind = static_cast<std::uint32_t>(draw.index(4)) << 30;
      caches.push_back({draw.between(0, 2) * draw.direction(), {word(), word()}});
      caches.push_back(
          {{}, {kind | static_cast<std::uint32_t>(draw.index(20)), static_cast<std::uint32_t>(draw.index(20))}});
    }
    caches[1] = {{nan, 0, 1}, {1u << 30, 0}};
    caches[2] = {{infinity, 0, 1}, {2u << 30, 1}};
    for (Cache& cache : caches) {
      for (int again = 0; again < 2; ++again) {
        const Contact warm = Sat::query(p.a, p.b, p.d, quick, &cache);
        ASSERT_EQ(warm.status, cold.status) << i;
        if (cold.status == Status::separated) continue;
        EXPECT_TRUE(same_bits(warm, cold)) << "pair " << i << " cache " << &cache - caches.data();
      }
    }
  }
  EXPECT_GT(overlapping_pairs, 1000);
}

}  // namespace
