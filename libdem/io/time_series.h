// A CSV file that grows by blocks of rows of one time each, and that a resumed run goes on with.
#pragma once

#include <string>

#include "libdem/world.h"

namespace dem::io {

class TimeSeries {
 public:
  // Begins the file with its line of columns (the first is the time), or goes on with the rows that it has up to the
  // world's time: a resume drops later and broken ones.
  TimeSeries(std::string path, const std::string& columns, const World& world, bool append);
  static std::string text_of(double time);  // as it stands in the file: 17 digits
  bool ends_at(double time) const { return text_of(time) == last_; }
  // Appends rows of this time, each with its end of line.
  void append(double time, const std::string& rows);

 private:
  std::string path_, last_;  // last_: the time in the last row, as written
};

}  // namespace dem::io
