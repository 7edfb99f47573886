// The schema of a scene as JSON Schema (draft 2020-12), for editors that check TOML while one types. What joins keys by
// code (rules.cpp: names that must exist, time or steps) it cannot say.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "libdem/scene/material_library.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

using Json = nlohmann::ordered_json;

Json number_schema(const Key& key, const char* type) {
  Json out{{"type", type}};
  const Range& r = key.range;
  if (std::isfinite(r.lower)) out[r.lower_open ? "exclusiveMinimum" : "minimum"] = r.lower;
  if (std::isfinite(r.upper)) out[r.upper_open ? "exclusiveMaximum" : "maximum"] = r.upper;
  return out;
}

Json list_of(const Json& item, std::size_t least, std::size_t most = 0) {
  Json out{{"type", "array"}, {"items", item}, {"minItems", least}};
  if (most > 0) out["maxItems"] = most;
  return out;
}

std::vector<std::string> catalogue_names(const std::string& catalogue) {
  std::vector<std::string> names;
  if (catalogue == "materials")
    for (const NamedMaterial& m : named_materials()) names.push_back(m.name);
  if (catalogue == "friction")
    for (const PublishedFriction& f : published_friction()) names.push_back(f.name);
  return names;
}

Json text_schema(const Key& key) {
  Json out{{"type", "string"}};
  if (!key.choices.empty()) out["enum"] = key.choices;
  if (key.unique || !key.refers_to.empty() || key.type == KeyType::file) out["minLength"] = 1;
  if (!key.catalogue.empty()) out["examples"] = catalogue_names(key.catalogue);
  return out;
}

Json table_schema(const Section& section, const std::string& path, bool complete);

Json value_schema(const Key& key, const std::string& path, bool complete) {
  Json number = number_schema(key, "number");
  switch (key.type) {
    case KeyType::text:
    case KeyType::file:
    case KeyType::condition:
      return text_schema(key);
    case KeyType::texts:
      return key.choices.empty() ? list_of({{"type", "string"}, {"minLength", 1}}, 1) : list_of(text_schema(key), 1);
    case KeyType::boolean:
      return {{"type", "boolean"}};
    case KeyType::integer:
      return number_schema(key, "integer");
    case KeyType::number:
      return number;
    case KeyType::number_or_auto:
      return {{"anyOf", {number, {{"const", "auto"}}}}};
    case KeyType::vector:
      return list_of(number, 3, 3);
    case KeyType::quaternion:
      return list_of(number, 4, 4);
    case KeyType::vectors:
      return list_of(list_of(number, 3, 3), 1);
    case KeyType::outlines:
      return list_of(list_of(list_of(number, 3, 3), 1), 1);
    case KeyType::planes:
      return list_of(list_of(number, 4, 4), 1);
    case KeyType::pairs:
      return list_of(list_of(number, 2, 2), 1);
    case KeyType::triangles:
      return list_of(list_of(number_schema(key, "integer"), 3, 3), 1);
    case KeyType::number_or_range:
      return {{"anyOf", {number, list_of(number, 2, 2)}}};
    case KeyType::table:
      return table_schema(*key.section, path, complete);
    case KeyType::tables: {
      Json out{{"type", "array"}, {"items", table_schema(*key.section, path, true)}};
      if (key.required) out["minItems"] = 1;
      return out;
    }
  }
  return Json::object();
}

Json described(const Key& key, const std::string& path, bool complete) {
  Json out = value_schema(key, path, complete);
  out["description"] = key.unit.empty() ? key.sentence : fmt::format("{} Unit: {}.", key.sentence, key.unit);
  const std::string standard = key.section ? "" : default_text(path);
  if (!standard.empty()) out["default"] = Json::parse(standard, nullptr, false);
  if (out.contains("default") && out["default"].is_discarded()) out.erase("default");
  return out;
}

// What a table must have, and what its selectors (kind, motion, …) allow and ask for.
void add_conditions(Json& out, const Section& section) {
  Json required = Json::array(), conditions = Json::array();
  std::map<std::pair<std::string, std::vector<std::string>>, std::vector<const Key*>> groups;
  for (const Key& key : section.keys) {
    if (!key.selector.empty())
      groups[{key.selector, key.selected}].push_back(&key);
    else if (key.required)
      required.push_back(key.name);
  }
  for (const auto& [when, keys] : groups) {
    const auto& [selector, selected] = when;
    Json test{{"properties", {{selector, {{"enum", selected}}}}}};
    // A selector left out has its default.
    const Key& chooser = *section.find(selector);
    const Node standard = section.default_of(chooser);
    const bool by_default =
        !chooser.required && std::find(selected.begin(), selected.end(), standard.text) != selected.end();
    if (!by_default) test["required"] = {selector};
    Json needed = Json::array(), refused = Json::object();
    for (const Key* key : keys) {
      if (key->required && key->needing.empty()) needed.push_back(key->name);
      if (!key->needing.empty())
        conditions.push_back(
            {{"if", {{"properties", {{selector, {{"enum", key->needing}}}}}, {"required", {selector}}}},
             {"then", {{"required", {key->name}}}}});
      refused[key->name] = false;
    }
    Json condition{{"if", test}};
    if (!needed.empty()) condition["then"] = {{"required", needed}};
    condition["else"] = {{"properties", refused}};
    conditions.push_back(condition);
  }
  if (!required.empty()) out["required"] = required;
  if (!conditions.empty()) out["allOf"] = conditions;
}

// `complete`: with what the table must have. A table of a scene that includes other files may be completed by them.
Json table_schema(const Section& section, const std::string& path, bool complete) {
  Json out{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
  for (const Key& key : section.keys)
    out["properties"][key.name] = described(key, path.empty() ? key.name : path + "." + key.name, complete);
  if (complete) add_conditions(out, section);
  return out;
}

}  // namespace

std::string json_schema() {
  Json out{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
           {"title", "Scene of the program dem"},
           {"description", "SI units. The reference: dem list keys, dem explain KEY."}};
  out.update(table_schema(schema(), "", false));
  // Only a scene that stands alone must hold everything that is required.
  Json alone = Json::object(), tables = Json::object();
  add_conditions(alone, schema());
  for (const Key& key : schema().keys) {
    if (key.type != KeyType::table) continue;
    Json conditions = Json::object();
    add_conditions(conditions, *key.section);
    if (!conditions.empty()) tables[key.name] = conditions;
  }
  if (!tables.empty()) alone["properties"] = tables;
  out["if"] = {{"not", {{"required", {"include"}}}}};
  out["then"] = alone;
  return out.dump(1);
}

}  // namespace dem
