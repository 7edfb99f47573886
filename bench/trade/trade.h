// What accuracy costs: every method of the catalogue, `auto` to several tolerances, in chunks and warm, on the same
// pairs, with their errors against the truth and their times.
//
// Errors, of each pair: gap over the size (mean circumradius); angle of the method's normal, rad; distance of the
// method's point from where the exact answer has the force act, over the size; the relative error that a Hertz force
// (overlap^1.5) takes from the method's own overlap. Truth: a reference in 50 digits on the first pairs of a set, the
// exact answer with half the width of its proven interval on the others (and of points always).
#pragma once

#include <string>
#include <vector>

#include "bench/pairs/entries.h"

namespace trade {

using pairs::no_number;

struct Errors {
  double median = no_number, p99 = no_number, most = no_number;
};

struct Row {
  const pairs::Set* set;
  std::string by;   // method, or "auto" and a tolerance
  std::string use;  // cold, batch (32 pairs a call), warm (batch, in the pose that follows, from what this one left)
  double tolerance = 0;
  std::size_t answered = 0, pairs = 0, certified = 0, handed_over = 0;
  Errors gap{}, normal{}, point{}, hertz{};
  double ns = no_number, ns_low = no_number, ns_high = no_number;  // median and range over the repetitions
};

struct Settings {
  std::size_t pairs = 64, truth = 8;
  int repetitions = 7;
  double sample = 2e-4;
};

// One set, all ways to its pairs.
std::vector<Row> measure(const pairs::Set& set, const Settings& settings);

void print_rows(const std::vector<Row>& rows);
// Which way is the fastest to a digit, as a table of the README.
void print_choice(const std::vector<Row>& rows);
// Bars of speed bought with accuracy; how many are missed.
int print_bars(const std::vector<Row>& rows);
void write_csv(const std::vector<Row>& rows, const std::string& path);
void write_json(const std::vector<Row>& rows, const Settings& settings, const std::string& path);

}  // namespace trade
