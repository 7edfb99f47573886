// Analysis of a run as it goes, [analysis] of its scene: the scalars of each quantity over time, into the run's folder
// as analysis_<quantity>.csv. It reads the world and never changes it: the run has the same bits with and without.
//
// Columns are time, step, then the scalars as they come (errors as <scalar>_error), after a comment line with their
// units; a scalar that comes later than the first row adds its column, and rows without it have an empty cell. Rows are
// appended, so a run that is killed leaves what it has found; a resumed run drops the rows after its checkpoint.
// Displacements and mixing refer to the scene's start; `before` (settings.h) is not set.
#pragma once

#include <string>
#include <vector>

#include "libdem/analysis/quantities.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

// One such file.
class GrowingSeries {
 public:
  // Begins the file, or goes on with its rows up to `time` (s).
  GrowingSeries(std::string path, bool append, double time);
  bool ends_at(double time) const;
  void add(double time, std::uint64_t step, const Result& result);

 private:
  struct Name {
    std::string name, unit;
  };
  std::string heading() const;
  void begin() const;  // writes heading and rows anew

  std::string path_, rows_;  // rows_: kept until they are on the disk under the present heading
  std::vector<Name> columns_;
  std::string last_;  // time of the last row, as written
};

// The quantities that a scene's [analysis] names, and its settings.
std::vector<const Quantity*> quantities_of(const AnalysisSpec& spec);
Settings settings_of(const AnalysisSpec& spec);
// Of a quantity that needs contacts and has none at hand: a note.
Result result_of(const Quantity& quantity, const Snapshot& snapshot, const Settings& settings);

class InRun {
 public:
  InRun(const World& world, const std::string& folder, bool resumed);
  void write(const World& world);  // a row in each file, unless it ends with a row of this time

 private:
  std::vector<const Quantity*> quantities_;
  std::vector<GrowingSeries> files_;
  Snapshot reference_;
  Settings settings_;
};

}  // namespace dem::analysis
