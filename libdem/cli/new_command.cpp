// dem new: a shipped scene, with its comments, as the beginning of one's own. dem schema: the format for editors.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "libdem/cli/commands.h"
#include "libdem/io/files.h"
#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/node.h"
#include "libdem/scene/schema.h"

namespace dem::cli {

namespace {

namespace fs = std::filesystem;

// Where each text value of a key of type file, or an included file, stands.
void collect_files(const Section& section, const Node& table, std::vector<const Node*>& out) {
  for (const Node::Entry& entry : table.entries) {
    const Key* key = section.find(entry.name);
    if (!key) continue;
    if (key->type == KeyType::table) collect_files(*key->section, entry.value, out);
    if (key->type == KeyType::tables)
      for (const Node& item : entry.value.items) collect_files(*key->section, item, out);
    if (key->type == KeyType::file) out.push_back(&entry.value);
    if (key->name == "include")
      for (const Node& item : entry.value.items) out.push_back(&item);
  }
}

std::size_t offset_of(const std::string& text, const Position& position) {
  std::size_t at = 0;
  for (int line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
  return at + static_cast<std::size_t>(position.column - 1);
}

// The text of a scene that will stand elsewhere: paths relative to its folder become absolute, the rest stays as it is.
std::string with_absolute_paths(const std::string& path) {
  std::string text = io::read_file(path);
  const Node root = read_toml_file(path);
  std::vector<const Node*> files;
  collect_files(schema(), root, files);
  std::erase_if(files, [](const Node* n) { return is_shipped(n->text) || fs::path(n->text).is_absolute(); });
  const auto place = [](const Node* n) { return std::pair(n->position.line, n->position.column); };
  std::sort(files.begin(), files.end(), [&](const Node* a, const Node* b) { return place(a) > place(b); });
  for (const Node* n : files) {
    const std::size_t at = offset_of(text, n->position), length = n->text.size() + 2;  // with its quotes
    const std::string absolute = resolve_file(n->text, fs::path(path).parent_path().string());
    if (text.compare(at + 1, n->text.size(), n->text) == 0) text.replace(at, length, to_toml(Node::of(absolute)));
  }
  return text;
}

}  // namespace

int new_command(const NewArguments& arguments) {
  const std::vector<std::string> known = shipped_scenes();
  std::string name =
      fs::path(arguments.from).extension() == ".toml" ? fs::path(arguments.from).stem().string() : arguments.from;
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    std::string text = fmt::format("--from {}: no shipped scene{}\n", arguments.from, suggestion(name, known));
    for (const std::string& k : known) text += fmt::format("  {:<20} {}\n", k, title_of_scene(k));
    text.pop_back();
    throw InputError(text);
  }
  const std::string path = fs::path(arguments.name).extension() == ".toml" ? arguments.name : arguments.name + ".toml";
  if (fs::exists(path)) throw InputError(fmt::format("{}: is there already; choose another name", path));
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder))
    throw InputError(fmt::format("{}: no such folder", folder.string()));
  io::write_file(path, with_absolute_paths(path_of_scene(name)));
  const std::string run = (folder / fs::path(path).stem()).string() + "-run";
  fmt::print("{}: {}\n", path, title_of_scene(name));
  fmt::print("what it is and costs:  dem check {}\n", path);
  fmt::print("run it:                dem run {} --out {}\n", path, run);
  fmt::print("what a key means:      dem explain run.time    all keys: dem list keys\n");
  return success;
}

int schema_command() {
  fmt::print("{}\n", json_schema());
  return success;
}

}  // namespace dem::cli
