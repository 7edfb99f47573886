// What a quantity gives: numbers and tables with their units. Nothing here knows of files; write.h does.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dem::analysis {

struct Scalar {
  std::string name, unit;  // snake_case; SI, "1" of a pure number
  double value = 0;
  std::optional<double> error;  // standard error, of the same unit
};

struct Column {
  std::string name, unit;
  std::vector<double> values;
};

struct Table {        // columns of one length
  std::string name;   // snake_case: the file is <quantity>_<name>.csv, or <quantity>.csv when empty
  std::string title;  // one line for people
  std::vector<Column> columns;
};

struct Result {
  std::vector<Scalar> scalars;     // one value per frame: they make the series over time
  std::vector<Table> tables;       // of this frame
  std::vector<std::string> notes;  // what a reader must know: "no contacts", "boundary corrected", …
  void add(std::string name, std::string unit, double value) {
    scalars.push_back({std::move(name), std::move(unit), value, {}});
  }
};

}  // namespace dem::analysis
