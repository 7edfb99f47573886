// The reference pages that the program prints, from the schema alone.
#include <fmt/format.h>

#include "libdem/scene/nearest.h"
#include "libdem/scene/schema.h"

namespace dem {

namespace {

struct Found {
  const Section* section = nullptr;
  const Key* key = nullptr;
};

Found find(std::string_view path) {
  const Section* section = &schema();
  for (;;) {
    const std::size_t dot = path.find('.');
    const Key* key = section->find(path.substr(0, dot));
    if (!key) return {};
    if (dot == std::string_view::npos) return {section, key};
    if (!key->section) return {};
    section = key->section.get();
    path.remove_prefix(dot + 1);
  }
}

void collect(const Section& section, const std::string& prefix, std::vector<std::string>& out) {
  for (const Key& key : section.keys) {
    out.push_back(prefix + key.name);
    if (key.section) collect(*key.section, prefix + key.name + ".", out);
  }
}

std::string default_of(const Found& f, std::string_view path) {
  if (f.key->section) return "";
  const Node value = f.section->default_of(*f.key);
  return fault(*f.key, std::string(path), value) ? "" : to_toml(value);
}

// How --set addresses the key: entries of arrays of tables by name or by number.
std::string set_form(std::string_view path) {
  const Section* section = &schema();
  std::string out = "--set ";
  for (;;) {
    const std::size_t dot = path.find('.');
    const Key& key = *section->find(path.substr(0, dot));
    out += key.name;
    if (dot == std::string_view::npos) return out + "=…";
    if (key.type == KeyType::tables) out += key.section->find("name") ? ".NAME" : "[0]";
    out += ".";
    section = key.section.get();
    path.remove_prefix(dot + 1);
  }
}

// "material[0].young" and "material.glass.young" mean material.young.
std::string without_entries(std::string_view path) {
  const Section* section = &schema();
  std::string out;
  bool entry = false;  // the next word may be the name of an entry
  while (!path.empty()) {
    const std::size_t end = path.find('.');
    std::string word(path.substr(0, end));
    path.remove_prefix(end == std::string_view::npos ? path.size() : end + 1);
    const std::size_t bracket = word.find('[');
    const bool indexed = bracket != std::string::npos;
    if (indexed) word.erase(bracket);
    const Key* key = section ? section->find(word) : nullptr;
    if (!key && entry && !path.empty()) {
      entry = false;
      continue;
    }
    out += (out.empty() ? "" : ".") + word;
    entry = key && key->type == KeyType::tables && !indexed;
    section = key ? key->section.get() : nullptr;
  }
  return out;
}

}  // namespace

const Key* find_key(std::string_view path) { return find(path).key; }

std::vector<std::string> key_paths() {
  std::vector<std::string> out;
  collect(schema(), "", out);
  return out;
}

std::string default_text(std::string_view path) {
  const Found f = find(path);
  return f.key && !f.key->required ? default_of(f, path) : "";
}

std::string explain(std::string_view address) {
  const std::string path = without_entries(address);
  const Found f = find(path);
  if (!f.key) throw InputError(fmt::format("unknown key {}{}", path, suggestion(path, key_paths())));
  const Key& key = *f.key;
  std::string out = fmt::format("{}\n  {}\n", path, key.sentence);
  out += fmt::format("  type     {}{}\n", name_of(key.type), key.unit.empty() ? "" : ", in " + key.unit);
  if (!key.choices.empty()) out += fmt::format("  allowed  {}\n", fmt::join(key.choices, ", "));
  if (key.range.bounded()) out += fmt::format("  allowed  {}\n", key.range.text(key.name));
  if (!key.refers_to.empty()) out += fmt::format("  names    a [[{}]]\n", key.refers_to);
  if (!key.section && path != "include") out += fmt::format("  set      {}\n", set_form(path));
  if (!key.catalogue.empty()) out += fmt::format("  names    see dem list {}\n", key.catalogue);
  if (!key.selector.empty())
    out += fmt::format("  applies  where {} = {}\n", key.selector, fmt::join(key.selected, ", "));
  const std::string standard = default_of(f, path);
  if (key.required)
    out += key.needing.empty() ? "  required\n"
                               : fmt::format("  required where {} = {}\n", key.selector, fmt::join(key.needing, ", "));
  else if (!standard.empty())
    out += fmt::format("  default  {}\n", standard);
  if (key.section) {
    out += "  keys\n";
    for (const Key& inner : key.section->keys) {
      const std::string head = fmt::format("{}{}", inner.name, inner.unit.empty() ? "" : " [" + inner.unit + "]");
      out += fmt::format("    {:<24} {}\n", head, inner.sentence);
    }
  }
  return out;
}

}  // namespace dem
