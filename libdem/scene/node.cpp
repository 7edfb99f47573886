#include "libdem/scene/node.h"

#include <fmt/format.h>

#include <algorithm>

namespace dem {

Node Node::of(bool v) {
  Node n;
  n.kind = Kind::boolean;
  n.boolean = v;
  return n;
}
Node Node::of(std::int64_t v) {
  Node n;
  n.kind = Kind::integer;
  n.integer = v;
  return n;
}
Node Node::of(double v) {
  Node n;
  n.kind = Kind::number;
  n.number = v;
  return n;
}
Node Node::of(std::string v) {
  Node n;
  n.kind = Kind::text;
  n.text = std::move(v);
  return n;
}
Node Node::array_of(std::vector<Node> v) {
  Node n;
  n.kind = Kind::array;
  n.items = std::move(v);
  return n;
}

Node::Entry* Node::find(std::string_view name) {
  const auto it = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  return it == entries.end() ? nullptr : &*it;
}
const Node::Entry* Node::find(std::string_view name) const { return const_cast<Node*>(this)->find(name); }
const Node* Node::get(std::string_view name) const {
  const Entry* e = find(name);
  return e ? &e->value : nullptr;
}

namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string number_text(double v) {
  std::string s = fmt::format("{}", v);
  // Without a point or an exponent TOML reads an integer, which has no -0.
  return s.find_first_of(".en") == std::string::npos ? s + ".0" : s;
}

}  // namespace

std::string to_toml(const Node& node) {
  switch (node.kind) {
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::integer:
      return fmt::format("{}", node.integer);
    case Node::Kind::number:
      return number_text(node.number);
    case Node::Kind::text:
      return quoted(node.text);
    case Node::Kind::array: {
      std::string out = "[";
      for (std::size_t i = 0; i < node.items.size(); ++i) out += (i ? ", " : "") + to_toml(node.items[i]);
      return out + "]";
    }
    case Node::Kind::table: {
      std::string out = "{";
      for (std::size_t i = 0; i < node.entries.size(); ++i)
        out += fmt::format("{}{} = {}", i ? ", " : " ", node.entries[i].name, to_toml(node.entries[i].value));
      return out + " }";
    }
    case Node::Kind::none:
    case Node::Kind::other:
      break;
  }
  return node.text;
}

}  // namespace dem
