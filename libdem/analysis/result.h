// What a quantity gives: numbers and tables with their units. Nothing here knows of files; write.h does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shapes/math/vec.h"

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

struct Surface {                      // polygons or lines, for pictures
  std::string name;                   // the file is <quantity>_<name>.vtp
  std::vector<shapes::Vec3d> points;  // m
  std::vector<std::int32_t> corners;  // of the cells, one after the other: places in points
  std::vector<std::int32_t> ends;     // cell i has corners[ends[i − 1]] … corners[ends[i] − 1]
  std::vector<Column> columns;        // one value per cell
  std::vector<Column> at_points;      // one value per point
  bool lines = false;                 // cells are lines
};

struct Result {
  std::vector<Scalar> scalars;     // one value per frame: they make the series over time
  std::vector<Table> tables;       // of this frame
  std::vector<std::string> notes;  // what a reader must know: "no contacts", "boundary corrected", …
  std::vector<Surface> surfaces;   // of this frame
  void add(std::string name, std::string unit, double value) {
    scalars.push_back({std::move(name), std::move(unit), value, {}});
  }
};

}  // namespace dem::analysis
