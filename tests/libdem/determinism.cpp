// The same bits for any number of threads, any skin and rebuild, across a restart, whoever looks on, on every
// instruction set: a tray into which bodies of every shape collapse.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "libcontact/kernels/chunk.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr std::uint64_t bodies = 300, steps = 600;

// The reference: one thread, automatic skin.
struct Reference {
  Scene scene = scenes::every_shape(bodies);
  World world = scenes::run(scene, steps);
  std::uint64_t hash = state_hash(world);
};
const Reference& reference() {
  static const Reference r;
  return r;
}

TEST(Determinism, TheSceneHasContactsOfEveryKind) {
  const World& w = reference().world;
  const auto n = [&](shapes::Kind a, shapes::Kind b) {
    return w.profile.pairs[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)].touching;
  };
  using shapes::Kind;
  for (const Kind b : {Kind::sphere, Kind::ellipsoid, Kind::polyhedron, Kind::plane, Kind::mesh})
    for (const Kind a : {Kind::sphere, Kind::ellipsoid, Kind::polyhedron})
      EXPECT_TRUE(a > b || n(a, b) > 0) << static_cast<int>(a) << " with " << static_cast<int>(b);
  std::printf("  %.2f contacts per particle, %llu rebuilds\n", contacts_per_particle(w),
              static_cast<unsigned long long>(w.counters.rebuilds));
  EXPECT_EQ(w.counters.not_converged, 0u);
}

TEST(Determinism, TwoThreadsDoNotMatter) {
  EXPECT_EQ(state_hash(scenes::run(reference().scene, steps, 2)), reference().hash);
}
TEST(Determinism, ThreeThreadsDoNotMatter) {
  EXPECT_EQ(state_hash(scenes::run(reference().scene, steps, 3)), reference().hash);
}

void expect_same_with_skin(double factor) {
  Scene s = reference().scene;
  s.run.skin = factor * reference().world.skin;
  const World w = scenes::run(s, steps);
  EXPECT_NE(w.counters.rebuilds, reference().world.counters.rebuilds);
  EXPECT_EQ(state_hash(w), reference().hash);
}
TEST(Determinism, ASmallSkinDoesNotMatter) { expect_same_with_skin(0.1); }
TEST(Determinism, ALargeSkinDoesNotMatter) { expect_same_with_skin(4); }

TEST(Determinism, ARebuildAtEveryStepDoesNotMatter) {
  Scene s = reference().scene;
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, steps)), reference().hash);
}

// run.turn_spheres = false: where spheres point is not followed, and nothing else asks for it.
TEST(Determinism, TheOrientationsOfSpheresDoNotMatter) {
  Scene s = reference().scene;
  s.run.turn_spheres = false;
  const World w = scenes::run(s, steps, 2), start = build_world(s);
  const Particles &p = w.particles, &of_start = start.particles, &expected = reference().world.particles;
  const std::vector<std::uint32_t> order = order_by_id(w), before = order_by_id(start),
                                   turned = order_by_id(reference().world);
  ASSERT_EQ(order.size(), turned.size());
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  std::size_t turning = 0;  // spheres, in the reference
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::uint32_t i = order[n], j = turned[n], k = before[n];
    EXPECT_TRUE(same(p.motion[i], expected.motion[j]));
    EXPECT_TRUE(same(p.angular_momentum[i], expected.angular_momentum[j]));
    if (!is_round(p.kind[i])) {
      EXPECT_TRUE(same(p.orientation[i], expected.orientation[j]));
      EXPECT_TRUE(same(p.rotation[i], expected.rotation[j]));
      continue;
    }
    if (!same(expected.orientation[j], of_start.orientation[k])) ++turning;
    EXPECT_TRUE(same(p.orientation[i], of_start.orientation[k]));
    EXPECT_TRUE(same(p.rotation[i], Vec3d{}));
  }
  EXPECT_GT(turning, 20u);
}

TEST(Determinism, ARestartDoesNotMatter) {
  for (const std::uint64_t at : {std::uint64_t(350), std::uint64_t(561)}) {
    World first = scenes::run(reference().scene, at);
    ASSERT_FALSE(touching_contacts(first).empty());
    const auto bytes = save_state(first);
    World second = build_world(reference().scene);
    load_state(second, bytes);
    EXPECT_EQ(state_hash(second), state_hash(first));
    EXPECT_EQ(second.step, at);
    while (second.step < steps) advance(second, 1);
    EXPECT_EQ(state_hash(second), reference().hash) << "saved at step " << at;
  }
}

// A step that another follows at once ends with the drift of that one.
World run_on(const Scene& scene, std::uint64_t to, int threads) {
  World w = build_world(scene);
  while (w.step < to) advance(w, threads, w.step + 1 < to && w.step % 37 != 0);
  return w;
}
TEST(Determinism, StepsThatAreDoneTogetherDoNotMatter) {
  for (const int threads : {1, 2, 3}) {
    const World w = run_on(reference().scene, steps, threads);
    EXPECT_FALSE(w.ahead);
    EXPECT_EQ(state_hash(w), reference().hash) << threads << " threads";
  }
}
// Enough of them that threads share the chunks of their pairs, and that some have met since the list was made.
TEST(Determinism, ASweepThroughSpheresDoesNotMatter) {
  Scene s = scenes::every_shape(1500);
  s.fills[0].items.resize(1);
  s.fills[0].upper.z = 0.6;
  s.run.skin = 0.002;
  const World expected = scenes::run(s, steps);
  EXPECT_GT(expected.contacts.sweep.chunks, 6u);
  EXPECT_GT(expected.counters.rebuilds, 3u);
  for (const int threads : {1, 2, 3})
    EXPECT_EQ(state_hash(run_on(s, steps, threads)), state_hash(expected)) << threads << " threads";
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(run_on(s, steps, 2)), state_hash(expected));
}

TEST(Determinism, LookingOnDoesNotMatter) {
  World w = build_world(reference().scene);
  double seen = 0;
  for (std::uint64_t i = 0; i < steps; ++i) {
    advance(w, 1);
    if (i % 50 != 7) continue;
    seen += static_cast<double>(touching_contacts(w).size()) + energies(w).elastic + scenes::length(momentum(w)) +
            static_cast<double>(save_state(w).size()) + contacts_per_particle(w);
  }
  EXPECT_GT(seen, 0);
  EXPECT_EQ(state_hash(w), reference().hash);
}

TEST(Determinism, ADifferentSeedIsSeen) {  // the hash can tell
  Scene s = reference().scene;
  s.run.seed = 2;
  EXPECT_NE(state_hash(scenes::run(s, 1)), state_hash(scenes::run(reference().scene, 1)));
}

// What another process, asked for another instruction set, prints.
TEST(Determinism, PrintsItsHash) {
  const World w = scenes::run(scenes::every_shape(200), 500);
  std::printf("kernels %s hash %016llx\n", contact::kernels::kernels().name,
              static_cast<unsigned long long>(state_hash(w)));
  EXPECT_GT(w.counters.contact_steps, 1000u);
}

std::string hash_under(const std::string& set) {
  const std::string command = "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX DEM_SIMD=" + set + " '/proc/" +
                              std::to_string(getpid()) + "/exe' --gtest_filter=Determinism.PrintsItsHash 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "no process";
  std::string line;
  char buffer[512];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) {
    char name[16];
    unsigned long long hash;
    if (std::sscanf(buffer, "kernels %15s hash %llx", name, &hash) == 2)
      line = name == set ? std::to_string(hash) : "ran " + std::string(name);
  }
  pclose(pipe);
  return line;
}

TEST(Determinism, InstructionSetsDoNotMatter) {
  const auto sets = contact::kernels::kernel_sets();
  if (sets.size() < 2) GTEST_SKIP() << "this processor runs one kernel set only";
  const std::string first = hash_under(sets[0]->name);
  ASSERT_NE(first, "");
  for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_EQ(hash_under(sets[i]->name), first) << sets[i]->name;
}

}  // namespace
}  // namespace dem
