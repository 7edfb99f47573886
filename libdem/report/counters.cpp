#include "libdem/report/counters.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "libdem/report/html.h"
#include "libdem/report/words.h"

namespace dem::report {

namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::string cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.8g}", value.get<double>());
  if (value.is_null()) return "";
  if (value.empty()) return "none";
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& v : value) text += (text.empty() ? "" : ", ") + cell(v);
  return text;
}

// A row per entry, of an object in an object with both names.
void add_rows(const Json& object, const std::string& before, Rows& rows) {
  for (const auto& [name, value] : object.items())
    if (value.is_object())
      add_rows(value, before + words(name) + ": ", rows);
    else
      rows.push_back({before + words(name), cell(value)});
}

// A row per object, a column per key of the first.
std::string table_of_objects(const Json& list) {
  Rows rows(1);
  for (const auto& [name, value] : list[0].items()) rows[0].push_back(words(name));
  for (const Json& object : list) {
    rows.emplace_back();
    for (const auto& [name, value] : list[0].items()) rows.back().push_back(cell(object.value(name, Json())));
  }
  return table_of(rows);
}

}  // namespace

std::string counters_html(const std::string& summary_file) {
  std::ifstream file(summary_file);
  const Json all = file ? Json::parse(file, nullptr, false) : Json();
  if (!all.is_object()) return "";
  Rows rows{{"of the run", "SI units"}};
  std::string rest;
  for (const auto& [name, value] : all.items()) {
    if (value.is_array() && !value.empty() && value[0].is_object()) {
      rest += folded(words(name), table_of_objects(value));
    } else if (value.is_object()) {
      Rows inner{{words(name), "SI units"}};
      add_rows(value, "", inner);
      rest += folded(words(name), table_of(inner), name == "counters");
    } else {
      rows.push_back({words(name), cell(value)});
    }
  }
  return table_of(rows) + rest;
}

}  // namespace dem::report
