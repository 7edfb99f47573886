// The schema of a scene: one table that drives reading, --set, writing, and the reference that the program prints.
// Every key knows its type, unit, allowed range, when it applies, what it means, and the member of Scene that it fills.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

enum class KeyType {
  text,
  texts,      // a list of text
  file,       // a path, resolved and checked to exist
  condition,  // text, see libdem/events/condition.h
  boolean,
  integer,
  number,
  number_or_auto,
  vector,           // [x, y, z]
  quaternion,       // [w, x, y, z]
  vectors,          // list of [x, y, z]
  outlines,         // list of lists of [x, y, z]
  planes,           // list of [nx, ny, nz, offset]
  triangles,        // list of [i, j, k]
  pairs,            // list of [x, y]
  number_or_range,  // a number, or [min, max]
  table,
  tables,  // an array of tables
};
const char* name_of(KeyType type);

struct Range {
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  bool lower_open = false, upper_open = false;
  bool bounded() const;
  bool holds(double v) const;
  std::string text(const std::string& name) const;  // "0 < name <= 0.5"
};

// In a namespace of their own: the keys of contacts (contacts.h) have the same name.
namespace scene_format {

struct Section;

struct Key {
  std::string name;
  KeyType type = KeyType::text;
  std::string unit;  // "" = a pure number or no number
  std::string sentence;
  Range range;                        // of a number, or of every component
  bool infinite = false;              // a number may be inf
  bool required = false;              // where it applies …
  std::vector<std::string> needing;   // … and its selector has one of these values; empty: any
  std::vector<std::string> choices;   // text, texts: the only words allowed
  std::string selector;               // the key applies only when this key of the same table …
  std::vector<std::string> selected;  // … has one of these values
  std::string refers_to;              // text: the name of an entry of this array of tables
  std::string catalogue;              // text: a name of `dem list CATALOGUE`
  bool unique = false;                // text: no two tables of the array have the same

  // Value keys: into and out of the struct of their section.
  void (*set)(void* spec, const Node& value) = nullptr;
  Node (*get)(const void* spec) = nullptr;
  // Keys of type table and tables: the struct of the section inside this one.
  std::shared_ptr<const Section> section;
  void* (*append)(void* spec) = nullptr;  // table: the one member
  std::size_t (*count)(const void* spec) = nullptr;
  const void* (*at)(const void* spec, std::size_t index) = nullptr;

  Key& above(double v) { return range.lower = v, range.lower_open = true, *this; }
  Key& from(double v) { return range.lower = v, *this; }
  Key& to(double v) { return range.upper = v, *this; }
  Key& or_infinite() { return infinite = true, *this; }
  Key& must() { return required = true, *this; }
  Key& must_for(std::vector<std::string> values) { return needing = std::move(values), must(); }
  Key& one_of(std::vector<std::string> words) { return choices = std::move(words), *this; }
  Key& when(std::string key, std::vector<std::string> values) {
    return selector = std::move(key), selected = std::move(values), *this;
  }
  Key& refers(std::string table) { return refers_to = std::move(table), *this; }
  Key& named_in(std::string list) { return catalogue = std::move(list), *this; }
  Key& as_file() { return type = KeyType::file, *this; }
  Key& as_condition() { return type = KeyType::condition, *this; }
  Key& own_name() { return unique = required = true, *this; }
};

struct Section {
  std::vector<Key> keys;
  Node (*default_of)(const Key& key) = nullptr;  // the value of a key that is left out
  Where* (*where)(void* spec) = nullptr;         // null when the struct keeps no position
  const Key* find(std::string_view name) const;
  std::vector<std::string> names() const;
};

}  // namespace scene_format
using scene_format::Key;
using scene_format::Section;

const Section& schema();

// What is wrong with a value by the key's type, range and choices, and at which part of it; empty when it is fine.
struct Fault {
  std::string text;
  const Node* at = nullptr;
  explicit operator bool() const { return !text.empty(); }
};
Fault fault(const Key& key, const std::string& path, const Node& value);
// Whether the key has a meaning for this struct: its selector has one of the values that the key asks for.
bool applies(const Section& section, const Key& key, const void* spec);
// Whether this struct cannot do without the key.
bool needed(const Section& section, const Key& key, const void* spec);

// A key of the whole schema by its path ("material.young", "fill.items.scale"), or null; and all paths in order.
const Key* find_key(std::string_view path);
std::vector<std::string> key_paths();
// Whether a value left out has a meaning that can be printed ("" when the key is then simply not set).
std::string default_text(std::string_view path);
// The whole schema as JSON Schema, draft 2020-12.
std::string json_schema();
// The reference entry of a key or a table, several lines of text.
std::string explain(std::string_view path);

}  // namespace dem
