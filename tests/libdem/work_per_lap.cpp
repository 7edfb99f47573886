// No contact gives back more than it was given: laws whose force is a slope of their stored energy, led round closed
// paths of pose with every pair of shapes under the default map. All laws and maps: bench_laws --only shape_loops.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/libdem/loop_laws.h"
#include "tests/libdem/pose_loops.h"
#include "tests/libdem/shape_samples.h"

namespace dem {
namespace {

// Pairs whose contacts are one potential; of the others libdem/README.md tells.
bool one_potential(const samples::SamplePair& pair) {
  using shapes::Kind;
  for (const auto* s : {&pair.moving, &pair.resting}) {
    if (s->kind == Kind::compound || s->name == "mesh with a ridge" || s->name == "polyline") return false;
    if (s->kind == Kind::rounded_polyhedron && pair.resting.kind != Kind::plane) return false;
  }
  return true;
}

std::vector<std::size_t> measured() {
  const auto all = samples::every_pair();
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (one_potential(all[i])) list.push_back(i);
  return list;
}

class WorkPerLap : public testing::TestWithParam<std::size_t> {};

// Smooth paths never apart; of the second kind features change, there the force has kinks and the rule of trapezoids
// the error of those.
TEST_P(WorkPerLap, IsNothing) {
  const samples::SamplePair pair = samples::every_pair()[GetParam()];
  const bool planar = pair.planar();
  const auto variant = [](LawName law) { return loops::variant_of(static_cast<std::size_t>(law), 0, true); };
  std::vector<loops::Variant> laws = {variant(planar ? LawName::linear_spring : LawName::hertz_mindlin)};
  if (!planar) laws.push_back(variant(LawName::dmt));  // a pull goes with the slope as well
  loops::Arena arena(samples::scene_of(pair, laws[0].law, laws[0].material));
  shapes::Random random(GetParam(), 23, 0);
  for (const loops::Style& style :
       {loops::Style{true, false, false, false, 0.02}, loops::Style{true, true, true, false, 0.1}}) {
    const auto [along, rest] = loops::random_meeting(planar, pair.resting.is_wall(), random);
    arena.rest(rest);
    ASSERT_TRUE(arena.put_under(laws[0].law, laws[0].material));
    const auto path = loops::random_path(arena, along, planar, style, samples::size, random);
    const loops::Loop loop(path, rest, false, 2048);
    for (const loops::Variant& v : laws) {
      ASSERT_TRUE(arena.put_under(v.law, v.material));
      const loops::Lap lap = loops::go_round(arena, loop, 2048, 1, 2e-3);
      ASSERT_GT(lap.stored, 0) << pair.name();
      if (&v != laws.data() && lap.apart > 0) continue;  // the pull begins and ends with a jump
      const double share = lap.created / lap.stored;
      EXPECT_NEAR(share, 0, 1e-6) << pair.name() << ", " << v.name;
      std::printf("  %s, %s: %.1e of the largest energy\n", pair.name().c_str(), v.name.c_str(), share);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, WorkPerLap, testing::ValuesIn(measured()));

}  // namespace
}  // namespace dem
