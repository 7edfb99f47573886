// A scene gives the same bits for any number of threads, skin, rebuild and resume.
#pragma once

#include <gtest/gtest.h>

#include "tests/libdem/scenes_in_code.h"

namespace dem::scenes {

// Gives back the world of the reference.
inline World expect_same_bits(const Scene& s, std::uint64_t steps) {
  World reference = run(s, steps);
  const std::uint64_t hash = state_hash(reference);
  EXPECT_GT(reference.counters.contact_steps, 2000u);
  EXPECT_EQ(state_hash(run(s, steps, 3)), hash);
  Scene other = s;
  other.run.skin = 0.2 * reference.skin;
  EXPECT_EQ(state_hash(run(other, steps)), hash);
  other = s;
  other.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(run(other, steps)), hash);
  const auto bytes = save_state(run(s, steps * 5 / 8 + 27));
  World resumed = build_world(s);
  load_state(resumed, bytes);
  while (resumed.step < steps) advance(resumed, 1);
  EXPECT_EQ(state_hash(resumed), hash);
  return reference;
}

}  // namespace dem::scenes
