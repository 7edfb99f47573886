// Validation: a shipped scene is run and what it must show is compared with a known answer or a published band.
//
// A new entry is one source file in this folder that defines a Validation, and its name in list.cpp:
//
//   const Validation my_scene{"my_scene", "my_scene.toml", "the ratio of stresses at failure is that of the exact
//   solution",
//                             [](Runs& runs) -> std::vector<Row> {
//                               std::vector<Row> rows;
//                               for (const double mu : {0.0, 0.2}) {
//                                 double peak = 0;
//                                 runs.run({fmt::format("material.disc.friction={}", mu)}, fmt::format("mu_{}", mu),
//                                          [&](const World& w) { peak = std::max(peak, ratio(w)); });
//                                 rows.push_back(within("peak ratio", peak, exact(mu), 0.03));
//                               }
//                               return rows;
//                             }};
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libdem/world.h"

namespace dem::validate {

struct Row {  // one criterion as judged
  std::string criterion;
  std::string expected, got;  // as printed, with units
  bool pass = false;
  bool judged = true;  // false: told for information, decides nothing
};

// Rows from numbers. `unit` stands behind the numbers, "" for a ratio or a count.
Row in_band(const std::string& criterion, double got, double lower, double upper, const std::string& unit = "");
// |got − expected| <= relative · |expected|.
Row within(const std::string& criterion, double got, double expected, double relative, const std::string& unit = "");
// |got − expected| <= absolute.
Row near(const std::string& criterion, double got, double expected, double absolute, const std::string& unit = "");
Row at_most(const std::string& criterion, double got, double upper, const std::string& unit = "");
Row at_least(const std::string& criterion, double got, double lower, const std::string& unit = "");
// Told, not judged: there is nothing that it must be.
Row for_information(const std::string& what, double got, const std::string& unit = "");
Row is_true(const std::string& criterion, bool pass, const std::string& expected, const std::string& got);

// The wall of this name; RunError when the scene has none.
const Wall& wall_named(const World& world, const std::string& name);

// Seen after every step (and once before the first), on one thread. Must not be slow.
using Observer = std::function<void(const World&)>;

// What a validation has at hand: runs of its scene.
class Runs {
 public:
  // `folder` empty: nothing is written. Else each run writes what `dem run` writes, into the folder, or into
  // folder/label when it has a label.
  Runs(std::string scene_path, std::string folder, int threads);
  // Loads the scene with overrides as of --set, runs it to its end, returns the last state. Throws InputError,
  // RunError.
  World run(const std::vector<std::string>& overrides = {}, const std::string& label = "",
            const Observer& observe = nullptr);
  // The world at t = 0, for what a criterion needs before the run.
  World build(const std::vector<std::string>& overrides = {}) const;
  int threads() const { return threads_; }
  // Of all runs that came to their end: answers that were not certified, and all answers of touching pairs.
  std::uint64_t uncertified() const { return uncertified_; }
  std::uint64_t contact_steps() const { return contact_steps_; }

 private:
  std::string scene_path_, folder_;
  int threads_;
  std::uint64_t uncertified_ = 0, contact_steps_ = 0;
};

struct Validation {
  const char* name;       // as of `dem validate NAME`
  const char* scene;      // file in the folder of shipped scenes
  const char* criterion;  // one sentence
  std::vector<Row> (*check)(Runs& runs);
};

struct Result {
  std::vector<Row> rows;  // a run that fails is a row that does not pass
  double seconds = 0;     // wall time
  bool pass() const;      // something is judged, and all of it passes
};
// Carries a validation out; `folder` as for Runs. Throws nothing but what comes of a full memory or disk.
Result carry_out(const Validation& validation, const std::string& folder, int threads);

}  // namespace dem::validate
