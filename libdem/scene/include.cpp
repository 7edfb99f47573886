// include = [...]: other TOML files that a scene is put together from. They are read first, in the order of the list,
// then the file that includes them. Entries of arrays of tables ([[material]], [[wall]], …) add up in that order; any
// other key replaces the same key of what came before. A file is read once, however many files include it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "libdem/scene/errors.h"
#include "libdem/scene/reader.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

namespace fs = std::filesystem;

// Puts `over` on top of `base`.
void merge(const Section& section, Node& base, Node over) {
  for (Node::Entry& entry : over.entries) {
    Node::Entry* there = base.find(entry.name);
    if (!there) {
      base.entries.push_back(std::move(entry));
      continue;
    }
    const Key* key = section.find(entry.name);
    Node &old = there->value, &fresh = entry.value;
    if (key && key->type == KeyType::tables && old.kind == Node::Kind::array && fresh.kind == Node::Kind::array)
      std::move(fresh.items.begin(), fresh.items.end(), std::back_inserter(old.items));
    else if (key && key->type == KeyType::table && old.kind == Node::Kind::table && fresh.kind == Node::Kind::table)
      merge(*key->section, old, std::move(fresh));
    else
      *there = std::move(entry);
  }
}

// The two ways to say how long a run is exclude each other: the file on top takes the place of both.
void drop_other_length(Node& base, const Node& over) {
  const Node* run = over.get("run");
  Node::Entry* there = base.find("run");
  if (!run || !there) return;
  const auto drop = [&](const char* given, const char* other) {
    if (run->get(given)) std::erase_if(there->value.entries, [&](const Node::Entry& e) { return e.name == other; });
  };
  drop("time", "steps");
  drop("steps", "time");
}

class Includer {
 public:
  explicit Includer(std::vector<std::string>& files) : files_(files) {}

  Node read(const std::string& path) {
    if (files_.size() >= std::numeric_limits<std::uint16_t>::max())
      input_error({files_[0], 0, 0}, "includes too many files");
    const auto file = static_cast<std::uint16_t>(files_.size());
    files_.push_back(path);
    seen_.push_back(canonical(path));
    Node own = read_toml_file(path, file);
    const Node::Entry* list = own.find("include");
    if (!list) return own;
    const Where where{path, list->value.position.line, list->value.position.column};
    if (const Fault f = fault(*schema().find("include"), "include", list->value))
      input_error(where, "include: " + f.text);
    open_.push_back(seen_.back());
    Node base;
    base.kind = Node::Kind::table;
    base.position = own.position;
    for (const Node& name : list->value.items) add(base, name, path);
    open_.pop_back();
    std::erase_if(own.entries, [](const Node::Entry& e) { return e.name == "include"; });
    drop_other_length(base, own);
    merge(schema(), base, std::move(own));
    return base;
  }

 private:
  static std::string canonical(const std::string& path) {
    std::error_code unknown;
    const fs::path p = fs::canonical(path, unknown);
    return unknown ? path : p.string();
  }

  void add(Node& base, const Node& name, const std::string& from) {
    const fs::path written(name.text);
    const std::string path = written.is_absolute() ? name.text : (fs::path(from).parent_path() / written).string();
    const Where where{from, name.position.line, name.position.column};
    const std::string what = fmt::format("include = \"{}\"", name.text);
    if (!fs::is_regular_file(path)) input_error(where, fmt::format("{}: no such file ({})", what, path));
    const std::string own = canonical(path);
    if (std::find(open_.begin(), open_.end(), own) != open_.end()) {
      std::string chain;
      for (const std::string& f : open_) chain += f + " -> ";
      input_error(where, fmt::format("{}: the file includes itself ({}{})", what, chain, own));
    }
    if (std::find(seen_.begin(), seen_.end(), own) != seen_.end()) return;
    Node included = read(path);
    drop_other_length(base, included);
    merge(schema(), base, std::move(included));
  }

  std::vector<std::string>& files_;  // as named, in the order of reading: what Position::file counts
  std::vector<std::string> seen_, open_;
};

}  // namespace

Node read_with_includes(const std::string& path, std::vector<std::string>& files) { return Includer(files).read(path); }

}  // namespace dem
