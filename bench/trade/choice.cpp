#include <fmt/format.h>

#include <cmath>

#include "bench/trade/trade.h"

namespace trade {

namespace {

const Row* find(const std::vector<Row>& rows, const std::string& pair, const char* config, const std::string& by,
                const char* use) {
  for (const Row& r : rows)
    if (r.set->family == pair && r.set->config == config && r.by == by && r.use == use) return &r;
  return nullptr;
}

bool answers_all(const Row& r) { return r.answered == r.pairs; }

// The fastest way whose 99 % error of the gap is at most this.
const Row* fastest(const std::vector<Row>& rows, const std::string& pair, double error) {
  const Row* best = nullptr;
  for (const Row& r : rows)
    if (r.set->family == pair && r.set->config == "touch" && r.use == "cold" && answers_all(r) && r.gap.p99 <= error &&
        (best == nullptr || r.ns < best->ns))
      best = &r;
  return best;
}

std::vector<std::string> families(const std::vector<Row>& rows) {
  std::vector<std::string> list;
  for (const Row& r : rows)
    if (list.empty() || (list.back() != r.set->family)) list.push_back(r.set->family);
  return list;
}

}  // namespace

void print_choice(const std::vector<Row>& rows) {
  constexpr double digits[] = {1e-2, 1e-4, 1e-6, 1e-12};
  fmt::print(
      "\n| pair, overlap 1e-3 | error 1e-2 | 1e-4 | 1e-6 | 1e-12 | batch | warm |\n|---|---|---|---|---|---|---|\n");
  for (const std::string& pair : families(rows)) {
    std::string line = fmt::format("| {} |", pair);
    const Row* exact = nullptr;
    for (const double error : digits) {
      const Row* r = fastest(rows, pair, error);
      line += r == nullptr ? " - |" : fmt::format(" {} {:.0f} |", r->by, r->ns);
      exact = r;
    }
    if (exact == nullptr) continue;
    for (const char* use : {"batch", "warm"}) {
      const Row* r = nullptr;
      for (const Row& x : rows)
        if (x.set == exact->set && x.use == use && x.tolerance == 0) r = &x;
      line += r == nullptr ? " - |" : fmt::format(" {:.0f} |", r->ns);
    }
    fmt::print("{}\n", line);
  }
  fmt::print(
      "\nThe fastest way that answers every pair, 99 % of them within the error of the gap over the size; ns per "
      "query, cold. "
      "batch, warm: the exact\nmethod, 32 pairs a call; warm in the pose that follows, from what this one left.\n");
}

int print_bars(const std::vector<Row>& rows) {
  int missed = 0;
  fmt::print("\nasking 1e-6 instead of the exact answer, overlap 1e-3 (bar: 1.3 times as fast)\n");
  for (const std::string& pair : families(rows)) {
    const bool judged = pair.starts_with("ellips") || pair == "poly200" || pair == "poly1000";
    if (!judged) continue;
    for (const char* use : {"cold", "batch"}) {
      const Row *coarse = find(rows, pair, "touch", "auto 1e-06", use), *exact = nullptr;
      for (const Row& r : rows)
        if (coarse != nullptr && r.set == coarse->set && r.use == use &&
            r.by == contact::choose(r.set->a, r.set->b)->name)
          exact = &r;
      if (coarse == nullptr || exact == nullptr) continue;
      const double ratio = exact->ns / coarse->ns;
      missed += !(ratio >= 1.3);
      fmt::print("{:<24}{:<6}{:>8.2f} {}\n", pair, use, ratio, ratio >= 1.3 ? "pass" : "MISSED");
    }
  }
  return missed;
}

}  // namespace trade
