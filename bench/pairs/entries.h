// What is timed: a subject (a way to answer) on a set of pairs, all pairs per run.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/pairs/sets.h"

namespace pairs {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// What a loop keeps of an answer.
struct Kept {
  Vec3d normal, point;
  double gap;
};

inline constexpr std::size_t largest_chunk = 32;

// The first `count` pairs of a set, `chunk` a call, gathered as libdem gathers them: as placed, or in the pose that
// follows. `cache`: null, or one for each; `kept`: one for each.
void ask(const Set& set, contact::ChunkQuery query, const contact::Options& options, bool next, std::size_t count,
         std::size_t chunk, contact::Cache* cache, Kept* kept);

struct Entry {
  const Set* set;
  std::string subject;
  std::size_t queries;                                       // per run
  std::function<void()> run;                                 // once over all pairs
  double error_median = no_number, error_worst = no_number;  // of the gap, over the size of the pair
  std::size_t lost = 0;                                      // pairs that it does not answer: not timed
  double ns = no_number;                                     // per query: median over the repetitions
  double ns_low = no_number, ns_high = no_number;            // and their range
  std::string key() const { return set->name() + "/" + subject; }
};

void add_own(const Set& set, std::vector<Entry>& entries);
void add_peers(const Set& set, std::vector<Entry>& entries);  // none where libccd and FCL are absent
const char* peers_note();

// Median and largest of the errors.
void note_errors(Entry& entry, std::vector<double> errors);

// Interleaved repetitions in random order, each of at least `sample` seconds of this thread's processor time. One that
// had less than 93 % of a core is taken anew, up to three times. Before each comes a pass that is not timed.
void time_all(std::vector<Entry>& entries, int repetitions, double sample);

void print_table(const std::vector<Entry>& entries);
void print_csv(const std::vector<Entry>& entries, const std::string& path);
// The bars that the entries at hand allow to be judged. Returns how many are missed.
int print_bars(const std::vector<Entry>& entries);

}  // namespace pairs
