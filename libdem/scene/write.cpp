// A scene as TOML, by the schema: every key with its value, defaults included. A value that a file may not state (0 for
// a length, infinity for a time, an empty list) is what "left out" looks like in memory, and is left out again.
#include <fmt/format.h>

#include "libdem/scene/data_files.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

std::string inline_table(const Section& section, const void* spec);

std::string value_text(const Key& key, const void* spec) {
  if (key.type == KeyType::tables) {  // inside another array of tables: inline
    std::string out = "[";
    for (std::size_t i = 0; i < key.count(spec); ++i) out += "\n  " + inline_table(*key.section, key.at(spec, i)) + ",";
    return out + "\n]";
  }
  Node value = key.get(spec);
  if (key.type == KeyType::file) value.text = shipped_name(value.text);
  return to_toml(value);
}

bool stated(const Section& section, const Key& key, const void* spec) {
  if (!applies(section, key, spec)) return false;
  return key.section ? key.count(spec) > 0 : !fault(key, key.name, key.get(spec));
}

std::string inline_table(const Section& section, const void* spec) {
  std::string out;
  for (const Key& key : section.keys)
    if (stated(section, key, spec))
      out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", key.name, value_text(key, spec));
  return "{ " + out + " }";
}

std::string lines(const Section& section, const void* spec) {
  std::string out;
  for (const Key& key : section.keys) {
    if (key.type == KeyType::table || !stated(section, key, spec)) continue;
    out += fmt::format("{} = {}", key.name, value_text(key, spec));
    if (!key.unit.empty()) out += fmt::format("  # {}", key.unit);
    out += "\n";
  }
  return out;
}

}  // namespace

std::string scene_to_toml(const Scene& scene) {
  std::string out;
  for (const Key& key : schema().keys) {
    if (!key.section) {
      if (stated(schema(), key, &scene)) out += fmt::format("{} = {}\n", key.name, value_text(key, &scene));
      continue;
    }
    const bool array = key.type == KeyType::tables;
    for (std::size_t i = 0; i < key.count(&scene); ++i)
      out += fmt::format("\n{0}{1}{2}\n", array ? "[[" : "[", key.name, array ? "]]" : "]") +
             lines(*key.section, key.at(&scene, i));
  }
  return out;
}

}  // namespace dem
