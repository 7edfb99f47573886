// What analysis.json says: frames, scalars, tables and their files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dem::report {

struct Frame {
  std::size_t frame = 0, bodies = 0, contacts = 0;
  std::uint64_t step = 0;
  double time = 0;  // s
};

struct ListedScalar {
  std::string name, unit;
  std::size_t frames = 0;      // that have a value
  std::optional<double> last;  // of the last of them
  std::optional<double> mean, error, steady_from;
  bool settled = false;
  bool constant = true;  // of all frames that have a value
};

struct ListedTable {
  std::string name, title;
  std::vector<std::string> columns, units;
  std::vector<std::string> files;                        // one per frame
  std::string unit_of(const std::string& column) const;  // empty: no such column
};

struct ListedQuantity {
  std::string name, what, equation;
  std::vector<ListedScalar> scalars;
  std::vector<ListedTable> tables;
  std::vector<std::string> notes;
  const ListedScalar* scalar(const std::string& name) const;  // null: none
  const ListedTable* table(const std::string& name) const;
};

struct Listing {
  std::string folder, source, version;
  std::vector<Frame> frames;
  std::vector<ListedQuantity> quantities;
  std::vector<std::string> notes;
  const ListedQuantity* quantity(const std::string& name) const;
};

// Throws InputError where the folder holds no complete analysis.
Listing read_listing(const std::string& folder);
bool is_complete(const std::string& folder);

}  // namespace dem::report
