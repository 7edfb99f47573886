// The extremes of detection as a list: each dimension turns a pair of kinds into a case at one of its levels.
//
// Cases are made from random samples of the kinds (tests/reference/samples.h), so a new kind takes part by having a
// sample. Used by tests/extremes/extremes.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/reference/samples.h"

namespace extremes {

using reference::Body;
using shapes::Kind;
using shapes::Vec3d;

struct Case {
  Body a, b;
  Vec3d offset;  // m
  double extent() const;
};

struct Dimension {
  const char* name;
  std::vector<double> levels;
  // False when this pair has no such case.
  bool (*make)(double level, Kind a, Kind b, reference::Source& draw, Case& made);
  bool answered = true;  // else: to be refused
};

const std::vector<Dimension>& dimensions();

// `count` cases of a pair of kinds at every level, the same for all who ask; fewer where there are none.
void each_case(const Dimension& dimension, Kind a, Kind b, int count,
               const std::function<void(const Case& made, double level)>& use);

enum class Verdict {
  holds,  // within 64 eps L, and the interval holds the reference
  wider,  // the interval holds the reference, the gap is farther than 64 eps L from it
  refused,
  wrong  // the interval misses the reference, or NaN in what is not refused
};

struct Outcome {
  Verdict verdict;
  double width;    // of the interval, in eps L
  double error;    // of the gap, in eps L
  bool certified;  // else gap_upper is the best that the method knows and no claim
};

contact::Contact ask(const Case& c, std::string_view method);
Outcome judge(const Case& c, const contact::Contact& got);

// The same case in units of 2^300 and 2^-300: every bit of the answer but the exponents.
bool scales(const Case& c, std::string_view method, const contact::Contact& got);

}  // namespace extremes
