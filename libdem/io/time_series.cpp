#include "libdem/io/time_series.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>

#include "libdem/io/files.h"

namespace dem::io {

std::string TimeSeries::text_of(double time) { return fmt::format("{:.17g}", time); }

TimeSeries::TimeSeries(std::string path, const std::string& columns, const World& world, bool append)
    : path_(std::move(path)) {
  std::string kept = columns + "\n";
  std::ifstream file(path_);
  std::string line;
  if (append && std::getline(file, line))
    while (std::getline(file, line) && !file.eof()) {  // a run that was killed may have left half a line
      double time = 0;
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), time);
      if (error != std::errc{} || time > world.time()) break;
      last_ = line.substr(0, static_cast<std::size_t>(end - line.data()));
      kept += line + "\n";
    }
  file.close();
  write_file(path_, kept);
}

void TimeSeries::append(double time, const std::string& rows) {
  last_ = text_of(time);
  std::ofstream file(path_, std::ios::app);
  file << rows;
  file.close();
  if (!file) throw RunError("cannot write " + path_);
}

}  // namespace dem::io
