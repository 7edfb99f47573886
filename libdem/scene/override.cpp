// --set key=value: finds the place in the tree by the schema and puts the value there, before anything is checked.
#include <fmt/format.h>

#include <charconv>

#include "libdem/scene/nearest.h"
#include "libdem/scene/reader.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& problem) {
  throw InputError(fmt::format("--set {}: {}", text, problem));
}

struct Override {
  std::string text, path, value;

  // Takes the next name of the path: up to a dot or a bracket.
  std::string next() {
    if (path.starts_with('.')) path.erase(0, 1);
    const std::size_t end = path.find_first_of(".[");
    std::string name = path.substr(0, end);
    path.erase(0, name.size());
    return name;
  }
  // Takes "[3]"; false when the path goes on otherwise.
  bool next_index(std::size_t& index) {
    if (!path.starts_with('[')) return false;
    const std::size_t end = path.find(']');
    const char* last = path.data() + (end == std::string::npos ? 1 : end);
    const auto [stop, error] = std::from_chars(path.data() + 1, last, index);
    if (error != std::errc() || stop != last) refuse(text, "needs a number from 0 in [ ]");
    path.erase(0, end + 1);
    return true;
  }
};

Node& child(Node& table, const std::string& name, Node::Kind kind) {
  if (Node::Entry* entry = table.find(name)) return entry->value;
  Node fresh;
  fresh.kind = kind;
  table.entries.push_back({name, {}, fresh});
  return table.entries.back().value;
}

Node& entry_of(Node& tables, const Key& key, Override& o) {
  std::size_t index = 0;
  if (!o.next_index(index)) {
    const std::string name = o.next();
    std::vector<std::string> names;
    for (Node& item : tables.items) {
      const Node* own = item.get("name");
      if (own && own->text == name) return item;
      if (own) names.push_back(own->text);
    }
    const std::string how =
        fmt::format("write {}[0] or the name of one of the {} entries", key.name, tables.items.size());
    refuse(o.text, fmt::format("no [[{}]] is named \"{}\": {}{}", key.name, name, how, suggestion(name, names)));
  }
  if (index >= tables.items.size())
    refuse(o.text,
           fmt::format("{}[{}]: the scene has {} of them, counted from 0", key.name, index, tables.items.size()));
  return tables.items[index];
}

void apply(Node& root, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse(text, "needs the form key=value");
  Override o{text, text.substr(0, equals), text.substr(equals + 1)};
  Node* node = &root;
  const Section* section = &schema();
  std::string plain;  // the path without indices, as the reference prints it
  for (;;) {
    const std::string name = o.next();
    if (name.empty()) refuse(text, plain.empty() ? "names no key" : "names no key of " + plain);
    plain += (plain.empty() ? "" : ".") + name;
    const Key* key = section->find(name);
    if (!key) refuse(text, fmt::format("unknown key {}{}", plain, suggestion(plain, key_paths())));
    if (plain == "include") refuse(text, "a list of files is read before overrides: state it in the scene");
    if (o.path.empty()) {
      Node value = read_toml_value(o.value);
      // Text needs no quotes, even when it looks like a number.
      if ((key->type == KeyType::text || key->type == KeyType::file) && value.kind != Node::Kind::text)
        value = Node::of(o.value);
      Node& place = child(*node, name, Node::Kind::none);
      place = std::move(value);
      place.position = {};
      break;
    }
    if (!key->section) refuse(text, fmt::format("{} has no keys inside", plain));
    Node& inner = child(*node, name, key->type == KeyType::table ? Node::Kind::table : Node::Kind::array);
    const Node::Kind needed = key->type == KeyType::table ? Node::Kind::table : Node::Kind::array;
    if (inner.kind != needed) return;  // the scene itself is wrong here; reading it says so
    node = key->type == KeyType::table ? &inner : &entry_of(inner, *key, o);
    section = key->section.get();
  }
  // The two ways to say how long a run is exclude each other: an override of one takes the place of the other.
  if (plain == "run.time" || plain == "run.steps") {
    const std::string other = plain == "run.time" ? "steps" : "time";
    std::erase_if(node->entries, [&](const Node::Entry& e) { return e.name == other && e.position.line > 0; });
  }
}

}  // namespace

void apply_overrides(Node& root, const std::vector<std::string>& overrides) {
  for (const std::string& o : overrides) apply(root, o);
}

}  // namespace dem
