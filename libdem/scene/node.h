// A scene file as a tree of values with their positions: what the reader checks against the schema and what the writer
// prints. It stands between the TOML library (one source file) and everything else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dem {

struct Position {  // in a file, from 1; line 0: the value came from --set
  int line = 0, column = 0;
  std::uint16_t file = 0;  // 0: the scene itself; else one that it includes
};

struct Node {
  enum class Kind { none, boolean, integer, number, text, array, table, other };
  struct Entry;
  Kind kind = Kind::none;
  Position position;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0;
  std::string text;            // text; kind other: the name of the TOML type, which no key takes
  std::vector<Node> items;     // array
  std::vector<Entry> entries;  // table, in the order of the file

  static Node of(bool v);
  static Node of(std::int64_t v);
  static Node of(double v);
  static Node of(std::string v);
  static Node array_of(std::vector<Node> v);

  Entry* find(std::string_view name);
  const Entry* find(std::string_view name) const;
  const Node* get(std::string_view name) const;  // null when absent
  bool is_number() const { return kind == Kind::number || kind == Kind::integer; }
  double as_number() const { return kind == Kind::integer ? static_cast<double>(integer) : number; }
};

struct Node::Entry {
  std::string name;
  Position position;  // of the key
  Node value;
};

// As TOML writes it; numbers in the shortest form that reads back to the same bits.
std::string to_toml(const Node& node);

// Reads a TOML file; positions carry `file`. Throws InputError with the position of a syntax error.
Node read_toml_file(const std::string& path, std::uint16_t file = 0);
// The value of a --set override: TOML, or plain text when it is no TOML value (so that names need no quotes).
Node read_toml_value(const std::string& text);

}  // namespace dem
