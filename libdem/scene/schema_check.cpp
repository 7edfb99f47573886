// The part of the schema that judges values: types, ranges, choices, and when a key applies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/scene/nearest.h"
#include "libdem/scene/schema.h"

namespace dem {

const char* name_of(KeyType type) {
  switch (type) {
    case KeyType::text:
      return "text";
    case KeyType::texts:
      return "a list of text";
    case KeyType::file:
      return "a file name";
    case KeyType::condition:
      return "a condition";
    case KeyType::boolean:
      return "true or false";
    case KeyType::integer:
      return "an integer";
    case KeyType::number:
      return "a number";
    case KeyType::number_or_auto:
      return "a number or \"auto\"";
    case KeyType::vector:
      return "a list of 3 numbers";
    case KeyType::quaternion:
      return "a list of 4 numbers w, x, y, z";
    case KeyType::vectors:
      return "a list of lists of 3 numbers";
    case KeyType::outlines:
      return "a list of outlines, each a list of lists of 3 numbers";
    case KeyType::planes:
      return "a list of lists of 4 numbers";
    case KeyType::triangles:
      return "a list of lists of 3 integers";
    case KeyType::pairs:
      return "a list of lists of 2 numbers";
    case KeyType::number_or_range:
      return "a number or [min, max]";
    case KeyType::table:
      return "a table";
    case KeyType::tables:
      return "an array of tables";
  }
  return "";
}

bool Range::bounded() const { return std::isfinite(lower) || std::isfinite(upper); }
bool Range::holds(double v) const {
  return (lower_open ? v > lower : v >= lower) && (upper_open ? v < upper : v <= upper);
}
std::string Range::text(const std::string& name) const {
  if (!std::isfinite(upper)) return fmt::format("{} {} {}", name, lower_open ? ">" : ">=", lower);
  std::string out = fmt::format("{} {} {}", name, upper_open ? "<" : "<=", upper);
  return std::isfinite(lower) ? fmt::format("{} {} {}", lower, lower_open ? "<" : "<=", out) : out;
}

const Key* scene_format::Section::find(std::string_view name) const {
  const auto it = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
  return it == keys.end() ? nullptr : &*it;
}

std::vector<std::string> scene_format::Section::names() const {
  std::vector<std::string> out;
  for (const Key& k : keys) out.push_back(k.name);
  return out;
}

bool applies(const Section& section, const Key& key, const void* spec) {
  if (key.selector.empty()) return true;
  const std::string value = section.find(key.selector)->get(spec).text;
  return std::find(key.selected.begin(), key.selected.end(), value) != key.selected.end();
}

bool needed(const Section& section, const Key& key, const void* spec) {
  if (!key.required || !applies(section, key, spec)) return false;
  if (key.needing.empty()) return true;
  const std::string value = section.find(key.selector)->get(spec).text;
  return std::find(key.needing.begin(), key.needing.end(), value) != key.needing.end();
}

namespace {

const char* found(const Node& n) {
  switch (n.kind) {
    case Node::Kind::boolean:
      return "true or false";
    case Node::Kind::integer:
    case Node::Kind::number:
      return "a number";
    case Node::Kind::text:
      return "text";
    case Node::Kind::array:
      return "a list";
    case Node::Kind::table:
      return "a table";
    case Node::Kind::none:
    case Node::Kind::other:
      break;
  }
  return "a date or time";
}

Fault number_fault(const Key& key, const std::string& path, const Node& n, bool whole) {
  if (!n.is_number()) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
  const double v = n.as_number();
  if (key.infinite && v == std::numeric_limits<double>::infinity()) return {};
  if (!std::isfinite(v)) return {"must be finite", &n};
  if (whole && (v != std::floor(v) || std::abs(v) > 0x1p53)) return {"needs " + std::string(name_of(key.type)), &n};
  if (!key.range.holds(v)) return {"allowed " + key.range.text(path), &n};
  return {};
}

// A list of `size` numbers (0: any number of lists of `inner` numbers).
Fault list_fault(const Key& key, const std::string& path, const Node& n, std::size_t size, bool whole) {
  if (n.kind != Node::Kind::array) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
  if (n.items.size() != size) return {fmt::format("needs {}, found {} entries", name_of(key.type), n.items.size()), &n};
  for (const Node& item : n.items)
    if (Fault f = number_fault(key, path, item, whole)) return f;
  return {};
}

Fault lists_fault(const Key& key, const std::string& path, const Node& n, std::size_t size, bool whole) {
  if (n.kind != Node::Kind::array) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
  if (n.items.empty()) return {"is empty", &n};
  for (const Node& item : n.items)
    if (Fault f = list_fault(key, path, item, size, whole)) return f;
  return {};
}

Fault text_fault(const Key& key, const Node& n) {
  if (n.kind != Node::Kind::text) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
  const bool is_name = key.unique || !key.refers_to.empty() || !key.catalogue.empty() || key.type == KeyType::file ||
                       key.type == KeyType::condition;
  if (is_name && n.text.empty()) return {"is empty", &n};
  if (key.choices.empty() || std::find(key.choices.begin(), key.choices.end(), n.text) != key.choices.end()) return {};
  const std::string near = nearest_name(n.text, key.choices);
  return {fmt::format("allowed {}{}", fmt::join(key.choices, ", "), near.empty() ? "" : "; did you mean " + near + "?"),
          &n};
}

Fault texts_fault(const Key& key, const Node& n) {
  if (n.kind != Node::Kind::array) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
  if (n.items.empty()) return {"is empty", &n};
  for (const Node& item : n.items) {
    if (item.kind != Node::Kind::text)
      return {fmt::format("needs {}, found {}", name_of(key.type), found(item)), &item};
    if (item.text.empty()) return {"has an empty name", &item};
    if (!key.choices.empty() && std::find(key.choices.begin(), key.choices.end(), item.text) == key.choices.end())
      return {fmt::format("allowed {}", fmt::join(key.choices, ", ")), &item};
  }
  return {};
}

Fault range_fault(const Key& key, const std::string& path, const Node& n) {
  if (n.kind != Node::Kind::array) return number_fault(key, path, n, false);
  if (Fault f = list_fault(key, path, n, 2, false)) return f;
  if (n.items[0].as_number() > n.items[1].as_number()) return {"allowed [min, max] with min <= max", &n};
  return {};
}

Fault quaternion_fault(const Key& key, const std::string& path, const Node& n) {
  if (Fault f = list_fault(key, path, n, 4, false)) return f;
  double square = 0;
  for (const Node& item : n.items) square += item.as_number() * item.as_number();
  if (std::abs(square - 1) > 1e-3)
    return {fmt::format("allowed w² + x² + y² + z² = 1 within 0.001, found {}", square), &n};
  return {};
}

}  // namespace

Fault fault(const Key& key, const std::string& path, const Node& n) {
  switch (key.type) {
    case KeyType::text:
    case KeyType::file:
    case KeyType::condition:
      return text_fault(key, n);
    case KeyType::texts:
      return texts_fault(key, n);
    case KeyType::boolean:
      if (n.kind != Node::Kind::boolean) return {fmt::format("needs true or false, found {}", found(n)), &n};
      return {};
    case KeyType::integer:
      return number_fault(key, path, n, true);
    case KeyType::number:
      return number_fault(key, path, n, false);
    case KeyType::number_or_auto:
      if (n.kind == Node::Kind::text && n.text == "auto") return {};
      return number_fault(key, path, n, false);
    case KeyType::vector:
      return list_fault(key, path, n, 3, false);
    case KeyType::quaternion:
      return quaternion_fault(key, path, n);
    case KeyType::vectors:
      return lists_fault(key, path, n, 3, false);
    case KeyType::outlines:
      if (n.kind != Node::Kind::array) return {fmt::format("needs {}, found {}", name_of(key.type), found(n)), &n};
      if (n.items.empty()) return {"is empty", &n};
      for (const Node& item : n.items)
        if (Fault f = lists_fault(key, path, item, 3, false)) return f;
      return {};
    case KeyType::planes:
      return lists_fault(key, path, n, 4, false);
    case KeyType::triangles:
      return lists_fault(key, path, n, 3, true);
    case KeyType::pairs:
      return lists_fault(key, path, n, 2, false);
    case KeyType::number_or_range:
      return range_fault(key, path, n);
    case KeyType::table:
      if (n.kind != Node::Kind::table) return {fmt::format("is a table: write [{}], found {}", path, found(n)), &n};
      return {};
    case KeyType::tables:
      if (n.kind == Node::Kind::table) return {fmt::format("is an array of tables: write [[{}]]", path), &n};
      if (n.kind != Node::Kind::array) return {fmt::format("needs an array of tables, found {}", found(n)), &n};
      for (const Node& item : n.items)
        if (item.kind != Node::Kind::table) return {fmt::format("needs tables, found {}", found(item)), &item};
      return {};
  }
  return {};
}

}  // namespace dem
