#include "libdem/report/listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "libdem/world.h"

namespace dem::report {

using Json = nlohmann::ordered_json;

namespace {

Json read_json(const std::string& folder) {
  std::ifstream file(std::filesystem::path(folder) / "analysis.json");
  return file ? Json::parse(file, nullptr, false) : Json();
}

std::optional<double> number(const Json& of, const char* key) {
  const auto at = of.find(key);
  return at != of.end() && at->is_number() ? std::optional<double>(at->get<double>()) : std::nullopt;
}

ListedScalar scalar_of(const std::string& name, const Json& from) {
  ListedScalar s{name,
                 from.at("unit"),
                 0,
                 {},
                 number(from, "mean"),
                 number(from, "error"),
                 number(from, "steady_from"),
                 from.value("error_settled", false),
                 true};
  for (const Json& value : from.at("values"))
    if (value.is_number()) {
      ++s.frames;
      s.constant = s.constant && (!s.last || *s.last == value.get<double>());
      s.last = value.get<double>();
    }
  if (const auto errors = from.find("errors"); errors != from.end() && s.frames == 1)
    for (const Json& value : *errors)
      if (value.is_number()) s.error = value.get<double>();
  return s;
}

ListedTable table_of(const Json& from) {
  ListedTable t{from.at("name"), from.at("title"), {}, {}, from.at("files")};
  for (const Json& column : from.at("columns")) {
    t.columns.push_back(column.at("name"));
    t.units.push_back(column.at("unit"));
  }
  return t;
}

template <class List>
auto find_named(const List& list, const std::string& name) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const auto& x) { return x.name == name; });
  return at == list.end() ? nullptr : &*at;
}

}  // namespace

std::string ListedTable::unit_of(const std::string& column) const {
  const auto at = std::find(columns.begin(), columns.end(), column);
  return at == columns.end() ? "" : units[static_cast<std::size_t>(at - columns.begin())];
}

const ListedScalar* ListedQuantity::scalar(const std::string& of) const { return find_named(scalars, of); }
const ListedTable* ListedQuantity::table(const std::string& of) const { return find_named(tables, of); }
const ListedQuantity* Listing::quantity(const std::string& of) const { return find_named(quantities, of); }

bool is_complete(const std::string& folder) {
  const Json all = read_json(folder);
  return all.is_object() && all.value("complete", false);
}

Listing read_listing(const std::string& folder) {
  const Json all = read_json(folder);
  if (!all.is_object() || !all.value("complete", false))
    throw InputError(folder + ": holds no complete analysis (analysis.json)");
  try {
    Listing out{folder, all.at("source"), all.at("version"), {}, {}, all.at("notes")};
    for (const Json& f : all.at("frames"))
      out.frames.push_back({f.at("frame"), f.at("bodies"), f.at("contacts"), f.at("step"), f.at("time")});
    for (const auto& [name, q] : all.at("quantities").items()) {
      ListedQuantity listed{name, q.at("what"), q.at("equation"), {}, {}, {}};
      for (const auto& [scalar, values] : q.at("scalars").items()) listed.scalars.push_back(scalar_of(scalar, values));
      for (const Json& table : q.at("tables")) listed.tables.push_back(table_of(table));
      for (const Json& note : q.at("notes")) {
        const std::size_t of = note.at("frames");
        listed.notes.push_back(
            note.at("text").get<std::string>() +
            (of < out.frames.size() ? fmt::format(" ({} of {} frames)", of, out.frames.size()) : ""));
      }
      out.quantities.push_back(std::move(listed));
    }
    return out;
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}/analysis.json: not as dem analyse writes it: {}", folder, error.what()));
  }
}

}  // namespace dem::report
