#include <algorithm>
#include <cmath>
#include <ctime>

#include "bench/pairs/entries.h"
#include "shapes/math/random.h"

namespace pairs {

namespace {

double clock_seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> v) {
  if (v.empty()) return no_number;
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

double seconds(const Entry& e, std::size_t runs) {
  double spent = 0;
  e.run();  // what other ways have put out of the caches comes back: else a sample of one pass times the memory
  for (int attempt = 0; attempt < 4; ++attempt) {
    const double begin = clock_seconds(CLOCK_THREAD_CPUTIME_ID), wall = clock_seconds(CLOCK_MONOTONIC);
    for (std::size_t i = 0; i < runs; ++i) e.run();
    spent = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - begin;
    if (spent >= 0.93 * (clock_seconds(CLOCK_MONOTONIC) - wall)) break;
  }
  return spent;
}

}  // namespace

void note_errors(Entry& entry, std::vector<double> errors) {
  if (errors.empty()) return;
  entry.error_worst = *std::max_element(errors.begin(), errors.end());
  entry.error_median = median(std::move(errors));
}

void time_all(std::vector<Entry>& entries, int repetitions, double sample) {
  std::vector<std::size_t> runs(entries.size()), order(entries.size());
  std::vector<std::vector<double>> ns(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    order[i] = i;
    if (entries[i].queries == 0) continue;
    runs[i] = 1;
    for (double t = seconds(entries[i], 1); t < sample && runs[i] < 100000;) {
      runs[i] = static_cast<std::size_t>(static_cast<double>(runs[i]) * std::clamp(1.2 * sample / t, 1.5, 10.0)) + 1;
      t = seconds(entries[i], runs[i]);
    }
  }
  shapes::Random draw(3, 0, 0);
  for (int r = 0; r < repetitions; ++r) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[draw.bits() % i]);
    for (const std::size_t i : order) {
      if (runs[i] == 0) continue;
      const auto queries = static_cast<double>(runs[i] * entries[i].queries);
      ns[i].push_back(1e9 * seconds(entries[i], runs[i]) / queries);
    }
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (ns[i].empty()) continue;
    entries[i].ns_low = *std::min_element(ns[i].begin(), ns[i].end());
    entries[i].ns_high = *std::max_element(ns[i].begin(), ns[i].end());
    entries[i].ns = median(std::move(ns[i]));
  }
}

}  // namespace pairs
