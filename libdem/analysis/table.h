// Tables row by row.
#pragma once

#include <cassert>
#include <initializer_list>
#include <string>
#include <utility>

#include "libdem/analysis/result.h"

namespace dem::analysis {

// Columns as (name, unit), without rows.
inline Table table_of(std::string name, std::string title,
                      std::initializer_list<std::pair<std::string, std::string>> columns) {
  Table t{std::move(name), std::move(title), {}};
  for (const auto& [column, unit] : columns) t.columns.push_back({column, unit, {}});
  return t;
}

// One number of any kind for each of the first columns.
template <class... Number>
void add_row(Table& table, Number... values) {
  assert(sizeof...(values) <= table.columns.size());
  std::size_t k = 0;
  (table.columns[k++].values.push_back(static_cast<double>(values)), ...);
}

// A name of the user's as part of a file's or a column's: what is no letter, digit, dot or minus becomes an underscore.
inline std::string file_word(std::string name) {
  for (char& c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (!plain) c = '_';
  }
  return name;
}

}  // namespace dem::analysis
