// Results of an analysis as files, units first. For each quantity
//   <quantity>_<table>.csv          its tables; of several frames <quantity>_<table>_<step>.csv, written frame by frame
//   <quantity>_<surface>.vtp        lines for pictures (VTK), likewise, and of a single frame polygons; values per cell
//   <quantity>_series.csv           a row per frame: time, step, its scalars, their errors as <scalar>_error
//   <quantity>_blocks.csv           of 20 frames or more: means over blocks of time, with their errors
// and of all together
//   series_summary.csv              a row per scalar: last value, mean and error over its steady part (series.h)
//   analysis.json                   all of it but the rows of tables: units, frames, scalars, notes, files
// CSV files begin with a comment line of units (`# units: time s, …`) and are read by io::read_csv; what a frame does
// not have, or what is not finite, is an empty cell (JSON: null) and a note. Each file is whole or not there. Rows of
// tables are not kept: memory grows with frames and scalars alone.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libdem/analysis/quantities.h"
#include "libdem/analysis/series.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

// A table as the text of its file.
std::string csv_of(const Table& table);
// A VTK PolyData file.
void write_surface(const Surface& surface, const std::string& path);
// As short as reads back to the same bits; empty where it is not finite.
std::string csv_number(double value);

struct ScalarSeries {
  std::string name, unit;
  std::vector<std::optional<double>> values, errors;  // one per frame
  // Of the frames that have a value: where it is steady, and the mean over that part, or over all when it is not.
  std::vector<double> present() const;
  SteadyPart steady() const { return steady_part(present()); }
  MeanOverTime mean() const;
};

struct QuantitySeries {
  const Quantity* quantity = nullptr;
  std::vector<ScalarSeries> scalars;  // in the order of their first frame
  struct Note {
    std::string text;
    std::size_t frames = 0;        // that have it
    std::uint64_t first_step = 0;  // of the first of them
  };
  std::vector<Note> notes;
  struct TableFiles {
    Table head;  // without values
    std::vector<std::string> files;
  };
  std::vector<TableFiles> tables;
};

class Writer {
 public:
  // `source`: what is analysed, for the reader. Of a single frame names carry no step.
  Writer(std::string folder, std::string source, const std::vector<const Quantity*>& quantities, bool single);
  // Frame by frame: its place in the source and what it is, then its results, in the order of the quantities.
  void begin_frame(std::size_t frame, const Snapshot& snapshot);
  void add(const Quantity& quantity, const Result& result);
  // A table over all frames together: <quantity>_<table>.csv.
  void add_of_all(const Quantity& quantity, const Table& table);
  // Series, summary and analysis.json, the last file: where it stands the analysis is complete.
  void finish();
  const std::vector<QuantitySeries>& series() const { return series_; }
  const std::vector<double>& times() const { return times_; }

 private:
  QuantitySeries& series_of(const Quantity& quantity);
  void write_table(QuantitySeries& series, const Table& table, const std::string& name);
  std::string file(const std::string& name, const std::string& text);
  void write_series(const QuantitySeries& series);
  void write_blocks(const QuantitySeries& series);
  void write_summary();
  void write_json();

  std::string folder_, source_;
  bool single_;
  std::vector<QuantitySeries> series_;
  std::vector<std::size_t> frames_, bodies_, contacts_;
  std::vector<std::uint64_t> steps_;
  std::vector<double> times_;
  std::vector<std::string> notes_, files_;
};

// Makes the folder ready: a new or empty one, or that of an earlier analysis, whose files go. Until the new one is
// complete its analysis.json says that it is not. Throws InputError, and changes nothing, where it holds anything else.
void prepare_folder(const std::string& folder);
// Removes the files of an analysis, and the folder where it holds nothing else. No analysis there: nothing.
void clear_analysis(const std::string& folder);

}  // namespace dem::analysis
