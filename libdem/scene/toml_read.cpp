// The only source file that includes the TOML library: it is slow to compile.
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

namespace {

Position position_of(const toml::source_region& s, std::uint16_t file) {
  return {static_cast<int>(s.begin.line), static_cast<int>(s.begin.column), file};
}

Node convert(const toml::node& in, std::uint16_t file) {
  Node out;
  if (const auto* t = in.as_table()) {
    out.kind = Node::Kind::table;
    for (const auto& [key, value] : *t)
      out.entries.push_back({std::string(key.str()), position_of(key.source(), file), convert(value, file)});
    std::stable_sort(out.entries.begin(), out.entries.end(), [](const Node::Entry& a, const Node::Entry& b) {
      return std::pair(a.position.line, a.position.column) < std::pair(b.position.line, b.position.column);
    });
  } else if (const auto* a = in.as_array()) {
    out.kind = Node::Kind::array;
    out.items.reserve(a->size());
    for (const auto& value : *a) out.items.push_back(convert(value, file));
  } else if (const auto b = in.value_exact<bool>()) {
    out = Node::of(*b);
  } else if (const auto i = in.value_exact<std::int64_t>()) {
    out = Node::of(*i);
  } else if (const auto d = in.value_exact<double>()) {
    out = Node::of(*d);
  } else if (const auto s = in.value_exact<std::string>()) {
    out = Node::of(*s);
  } else {
    out.kind = Node::Kind::other;
    out.text = "date or time";
  }
  out.position = position_of(in.source(), file);
  return out;
}

void forget_positions(Node& node) {
  node.position = {};
  for (Node& item : node.items) forget_positions(item);
  for (Node::Entry& entry : node.entries) {
    entry.position = {};
    forget_positions(entry.value);
  }
}

}  // namespace

Node read_toml_file(const std::string& path, std::uint16_t number) {
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) input_error({path, 0, 0}, "the scene file cannot be read");
  try {
    return convert(toml::parse(text, path), number);
  } catch (const toml::parse_error& e) {
    const Position p = position_of(e.source(), number);
    input_error({path, p.line, p.column}, "TOML syntax: " + std::string(e.description()));
  }
}

Node read_toml_value(const std::string& text) {
  try {
    const toml::table t = toml::parse("value = " + text);
    if (t.size() == 1 && t.contains("value")) {
      Node node = convert(*t.get("value"), 0);
      forget_positions(node);
      return node;
    }
  } catch (const toml::parse_error&) {  // no TOML value: plain text
  }
  return Node::of(text);
}

}  // namespace dem
