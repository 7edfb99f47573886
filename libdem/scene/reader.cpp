#include "libdem/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

std::string join(const std::string& prefix, const std::string& name) {
  return prefix.empty() ? name : prefix + "." + name;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? text : text.substr(0, longest - 4) + " ...";
}

std::string with_value(const std::string& path, const Node& value, const std::string& problem) {
  const bool plain = value.kind != Node::Kind::table && !(value.kind == Node::Kind::array && value.items.empty());
  return plain ? fmt::format("{} = {}: {}", path, shortened(to_toml(value)), problem) : path + ": " + problem;
}

class Reader {
 public:
  explicit Reader(Errors& errors) : errors_(errors) {}

  void table(const Section& section, const Node& node, const std::string& path, void* spec) {
    if (Where* where = section.where(spec)) *where = errors_.where(node.position);
    for (const Key& key : section.keys) {
      const Node::Entry* entry = node.find(key.name);
      if (entry)
        present(section, key, *entry, node, join(path, key.name), spec);
      else if (needed(section, key, spec))
        missing(key, node, path);
    }
    for (const Node::Entry& entry : node.entries)
      if (!section.find(entry.name)) unknown(section, entry, path);
  }

 private:
  void present(const Section& section, const Key& key, const Node::Entry& entry, const Node& node,
               const std::string& path, void* spec) {
    if (const Fault f = fault(key, path, entry.value)) {
      const Position at = f.at->position.line > 0 ? f.at->position : entry.value.position;
      return errors_.add(at, with_value(path, entry.value, f.text));
    }
    if (!applies(section, key, spec)) {
      const std::string now = section.find(key.selector)->get(spec).text;
      // A selector that is missing or wrong itself has been reported: nothing to add.
      const Node* given = node.get(key.selector);
      if (now.empty() || (given && given->text != now)) return;
      return errors_.add(entry.position, fmt::format("{}: applies only where {} = {}, not \"{}\"", path, key.selector,
                                                     fmt::join(key.selected, ", "), now));
    }
    if (key.type == KeyType::table) return table(*key.section, entry.value, path, key.append(spec));
    if (key.type == KeyType::tables) return array(key, entry.value, path, spec);
    if (key.type == KeyType::file) return file(key, entry.value, path, spec);
    key.set(spec, entry.value);
  }

  void array(const Key& key, const Node& node, const std::string& path, void* spec) {
    if (key.required && node.items.empty()) errors_.add(node.position, path + ": is empty");
    for (const Node& item : node.items) table(*key.section, item, path, key.append(spec));
    for (const Key& inner : key.section->keys)
      if (inner.unique) unique(inner, node, join(path, inner.name));
  }

  void unique(const Key& key, const Node& tables, const std::string& path) {
    std::set<std::string> seen;
    for (const Node& item : tables.items) {
      const Node* value = item.get(key.name);
      if (value && value->kind == Node::Kind::text && !seen.insert(value->text).second)
        errors_.add(value->position, with_value(path, *value, "this name is taken already"));
    }
  }

  void file(const Key& key, const Node& node, const std::string& path, void* spec) {
    const std::string resolved =
        resolve_file(node.text, std::filesystem::path(errors_.file(node.position)).parent_path().string());
    if (!std::filesystem::is_regular_file(resolved)) {
      const std::string near = is_shipped(node.text) ? suggestion(node.text, shipped_names()) : "";
      return errors_.add(node.position, with_value(path, node, fmt::format("no such file ({}){}", resolved, near)));
    }
    key.set(spec, Node::of(resolved));
  }

  void missing(const Key& key, const Node& node, const std::string& path) {
    std::string what = join(path, key.name);
    if (key.section) what = key.type == KeyType::tables ? "[[" + what + "]]" : "[" + what + "]";
    const Position at = path.empty() && node.position.line <= 0 ? Position{1, 1} : node.position;
    errors_.add(at,
                fmt::format("{} is missing: {}{}", what, key.sentence, key.unit.empty() ? "" : " [" + key.unit + "]"));
  }

  void unknown(const Section& section, const Node::Entry& entry, const std::string& path) {
    std::string hint;
    const std::string near = nearest_name(entry.name, section.names());
    if (!near.empty()) hint = "; did you mean " + join(path, near) + "?";
    for (const std::string& other : key_paths())  // right name, wrong table
      if (hint.empty() && other.ends_with("." + entry.name)) hint = "; did you mean " + other + "?";
    if (hint.empty()) hint = fmt::format("; known: {}", fmt::join(section.names(), ", "));
    errors_.add(entry.position, fmt::format("unknown key {}{}", join(path, entry.name), hint));
  }

  Errors& errors_;
};

// Second pass: every key that names an entry of an array of tables must find it there.
void references(const Section& section, const Node& node, const std::string& path, const Node& root, Errors& errors) {
  for (const Key& key : section.keys) {
    const Node* value = node.get(key.name);
    if (!value) continue;
    if (key.type == KeyType::table && value->kind == Node::Kind::table)
      references(*key.section, *value, join(path, key.name), root, errors);
    if (key.type == KeyType::tables)
      for (const Node& item : value->items) references(*key.section, item, join(path, key.name), root, errors);
    if (key.refers_to.empty() || value->kind != Node::Kind::text || value->text.empty()) continue;
    std::vector<std::string> names;
    if (const Node* tables = root.get(key.refers_to))
      for (const Node& item : tables->items)
        if (const Node* name = item.get("name")) names.push_back(name->text);
    if (std::find(names.begin(), names.end(), value->text) == names.end())
      errors.add(value->position,
                 with_value(join(path, key.name), *value,
                            fmt::format("no [[{}]] has this name{}", key.refers_to, suggestion(value->text, names))));
  }
}

}  // namespace

void read_table(const Section& section, const Node& root, void* spec, Errors& errors) {
  Reader(errors).table(section, root, "", spec);
  references(section, root, "", root, errors);
}

void read_by_schema(const Node& root, Scene& scene, Errors& errors) { read_table(schema(), root, &scene, errors); }

}  // namespace dem
