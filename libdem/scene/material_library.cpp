#include "libdem/scene/material_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/io/io.h"
#include "libdem/scene/data_files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/reader.h"

namespace dem {

namespace {

std::optional<double> number_or_blank(const io::Table& t, std::size_t row, std::size_t column) {
  if (t.cell(row, column).empty()) return std::nullopt;
  return io::number(t, row, column);
}

std::vector<NamedMaterial> read_materials() {
  const io::Table t = io::read_csv(materials_folder() + "/materials.csv");
  const auto at = [&](const char* name) { return io::column(t, name); };
  std::vector<NamedMaterial> out;
  for (std::size_t r = 0; r < t.row_count(); ++r)
    out.push_back({t.cell(r, at("name")), io::number(t, r, at("young")), io::number(t, r, at("poisson")),
                   number_or_blank(t, r, at("density")), t.cell(r, at("source"))});
  return out;
}

std::vector<PublishedFriction> read_friction() {
  const io::Table t = io::read_csv(materials_folder() + "/friction.csv");
  const auto at = [&](const char* name) { return io::column(t, name); };
  std::vector<PublishedFriction> out;
  for (std::size_t r = 0; r < t.row_count(); ++r)
    out.push_back({t.cell(r, at("pair")), io::number(t, r, at("mu")), number_or_blank(t, r, at("uncertainty")),
                   number_or_blank(t, r, at("mu_high")), t.cell(r, at("reference")), ""});
  for (PublishedFriction& f : out) {
    const auto same = std::count_if(out.begin(), out.end(), [&](const auto& other) { return other.pair == f.pair; });
    f.name = same > 1 ? f.pair + " (" + f.reference + ")" : f.pair;
  }
  return out;
}

std::string reversed(const std::string& pair) {
  const std::size_t middle = pair.find(" - ");
  return middle == std::string::npos ? pair : pair.substr(middle + 3) + " - " + pair.substr(0, middle);
}

}  // namespace

const std::vector<NamedMaterial>& named_materials() {
  static const std::vector<NamedMaterial> table = read_materials();
  return table;
}

const std::vector<PublishedFriction>& published_friction() {
  static const std::vector<PublishedFriction> table = read_friction();
  return table;
}

std::vector<const PublishedFriction*> find_friction(const std::string& name) {
  std::vector<const PublishedFriction*> out;
  for (const PublishedFriction& f : published_friction()) {
    const std::string tail = " (" + f.reference + ")";
    for (const std::string& pair : {f.pair, reversed(f.pair)})
      if (name == pair || name == pair + tail) {
        out.push_back(&f);
        break;
      }
  }
  return out;
}

std::string text_of(const PublishedFriction& f) {
  std::string value = fmt::format("{}", f.friction);
  if (f.highest) value += fmt::format(" to {}", *f.highest);
  if (f.uncertainty) value += fmt::format(" ± {}", *f.uncertainty);
  return fmt::format("{} ({})", value, f.reference);
}

namespace {

// What a material takes from the named one; the source names the quantities whose values are its.
void take_material(const Node& node, MaterialSpec& m, Errors& errors) {
  const Node* like = node.get("like");
  if (!like) return;
  std::vector<std::string> names;
  for (const NamedMaterial& n : named_materials()) names.push_back(n.name);
  const auto it = std::find(names.begin(), names.end(), m.like);
  if (it == names.end())
    return errors.add(like->position, fmt::format("material.like = \"{}\": no named material{}; see dem list materials",
                                                  m.like, suggestion(m.like, names)));
  const NamedMaterial& n = named_materials()[static_cast<std::size_t>(it - names.begin())];
  if (!node.get("young") && !m.rigid) m.young = n.young;
  if (!node.get("poisson")) m.poisson = n.poisson;
  if (!node.get("density") && n.density) m.density = *n.density;
  std::string taken;
  const auto add = [&](const char* name, bool same) {
    if (same) taken += (taken.empty() ? "" : ", ") + std::string(name);
  };
  add("young", m.young == n.young);
  add("poisson", m.poisson == n.poisson);
  add("density", n.density && m.density == *n.density);
  if (!taken.empty()) m.source = taken + ": " + n.source;
}

void take_friction(const Node& node, MaterialPairSpec& p, Errors& errors) {
  const Node* published = node.get("published");
  if (!published) return;
  const std::vector<const PublishedFriction*> found = find_friction(p.published);
  const std::string what = fmt::format("material_pair.published = \"{}\"", p.published);
  if (found.empty()) {
    std::vector<std::string> names;
    for (const PublishedFriction& f : published_friction()) names.push_back(f.name);
    return errors.add(published->position, fmt::format("{}: no published pair{}; see dem list friction", what,
                                                       suggestion(p.published, names)));
  }
  if (found.size() > 1) {
    std::string all;
    for (const PublishedFriction* f : found)
      all += fmt::format("{}\"{}\" = {}", all.empty() ? "" : ", ", f->name, text_of(*f));
    return errors.add(published->position, fmt::format("{}: reported more than once; allowed {}", what, all));
  }
  const PublishedFriction& f = *found.front();
  if (!std::isnan(p.friction) && p.friction != f.friction)
    return errors.add(
        node.get("friction")->position,
        fmt::format("material_pair.friction = {}: published says {}; give one of the two", p.friction, text_of(f)));
  p.friction = f.friction;
  p.source = fmt::format("{}: {}", f.pair, text_of(f));
}

template <class Spec, class Take>
void each(const Node& root, const char* table, std::vector<Spec>& specs, Errors& errors, Take take) {
  const Node* nodes = root.get(table);
  for (std::size_t i = 0; nodes && i < specs.size(); ++i) take(nodes->items[i], specs[i], errors);
}

}  // namespace

void apply_libraries(const Node& root, Scene& scene, Errors& errors) {
  each(root, "material", scene.materials, errors, take_material);
  each(root, "material_pair", scene.pairs, errors, take_friction);
}

}  // namespace dem
