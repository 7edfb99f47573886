// dem list and dem explain: catalogues from the lists and the schema.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "libcontact/dispatch.h"
#include "libcontact/laws/list.h"
#include "libcontact/laws/model.h"
#include "libdem/analysis/quantities.h"
#include "libdem/cli/commands.h"
#include "libdem/cli/list_maps.h"
#include "libdem/laws_of_scene.h"
#include "libdem/scene/data_files.h"
#include "libdem/scene/material_library.h"
#include "libdem/scene/schema.h"

namespace dem::cli {

namespace {

using Json = nlohmann::ordered_json;

// The kind that a word of the schema stands for: its own name, or what it generates.
shapes::Kind kind_of_word(const std::string& word, bool wall) {
  for (std::size_t i = 0; i < shapes::kind_count; ++i)
    if (word == shapes::name_of(static_cast<shapes::Kind>(i))) return static_cast<shapes::Kind>(i);
  if (wall) return shapes::Kind::mesh;
  if (word == "clump" || word == "union") return shapes::Kind::compound;
  return word == "regular_polygon" ? shapes::Kind::polygon : shapes::Kind::polyhedron;
}

// What each kind of scene becomes: the schema's words for bodies and walls. What makes a polyhedron makes a rounded one
// with shape.rounding.
Json shapes_json() {
  Json out = Json::array();
  for (std::size_t i = 0; i < shapes::kind_count; ++i) {
    const auto kind = static_cast<shapes::Kind>(i);
    const bool wall = shapes::is_wall(kind), rounded = kind == shapes::Kind::rounded_polyhedron;
    const shapes::Kind made = rounded ? shapes::Kind::polyhedron : kind;
    Json words = Json::array();
    const Key* key = find_key(wall ? "wall.kind" : "shape.kind");
    for (const std::string& word : key->choices)
      if (kind_of_word(word, wall) == made) words.push_back(rounded ? word + " with rounding" : word);
    out.push_back({{"name", shapes::name_of(kind)}, {"use", wall ? "wall" : "body"}, {"scene_kinds", words}});
  }
  return out;
}

Json method_json(const contact::MethodInfo& m) {
  return {{"name", m.name},           {"a", shapes::name_of(m.a)}, {"b", shapes::name_of(m.b)},
          {"cost_rank", m.cost_rank}, {"certified", m.certified},  {"exact", m.exact},
          {"remark", m.remark}};
}

Json methods_json() {
  Json out = Json::array();
  for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m) out.push_back(method_json(*m));
  return out;
}

// Why no method answers a pair of kinds.
const char* no_method(shapes::Kind a, shapes::Kind b) {
  if (shapes::is_wall(a) && shapes::is_wall(b)) return "refused: walls do not meet each other";
  if (shapes::dimension_of(a) != shapes::dimension_of(b)) return "refused: one is of the plane, one of space";
  if (a == shapes::Kind::compound || b == shapes::Kind::compound) return "part by part, by the methods of the parts";
  return "refused: no method";
}

Json pairs_json() {
  Json out = Json::array();
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = a; b < shapes::kind_count; ++b) {
      Json names = Json::array();
      const auto kind_a = static_cast<shapes::Kind>(a), kind_b = static_cast<shapes::Kind>(b);
      for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m)
        if (m->a == kind_a && m->b == kind_b) names.push_back(m->name);
      out.push_back({{"a", shapes::name_of(kind_a)},
                     {"b", shapes::name_of(kind_b)},
                     {"methods", names},
                     {"remark", names.empty() ? no_method(kind_a, kind_b) : ""}});
    }
  return out;
}

// "young (Pa), poisson" -> "young > 0 Pa, 0 <= poisson <= 0.5".
std::string with_ranges(std::string_view parameters) {
  std::vector<std::string> list;
  for (const auto& [name, unit] : split_parameters(parameters)) {
    const Key* key = find_key("material." + name);
    if (key == nullptr) throw std::logic_error("material has no key " + name);
    list.push_back(key->range.text(name) + (key->unit.empty() ? "" : " " + key->unit));
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

std::string needs_of(std::string_view law) {
  for (const contact::Partners& p : contact::partners)
    if (p.law == law) return fmt::format("normal law {}", p.normal);
  return law.starts_with("liquid_bridge") ? "law.surface_tension, law.bridge_volume" : "";
}

// A law of one family; `beside`: words of its memory that are elsewhere.
template <class List>
void add_laws(const char* family, std::size_t beside, Json& out) {
  contact::each_law<List>([&](auto law, std::size_t) {
    const std::size_t words = contact::state_words<decltype(law)>;
    out.push_back({{"family", family},
                   {"name", law.name},
                   {"material", with_ranges(law.parameters)},
                   {"needs", needs_of(law.name)},
                   {"memory_bytes", 8 * (words - std::min(words, beside))},
                   {"remark", law.remark},
                   {"source", law.source}});
  });
}

Json laws_json() {
  Json out = Json::array();
  for (const contact::NamedLaw& l : contact::named_laws) {
    const auto model = contact::law_model(*contact::named_law(l.name));
    out.push_back({{"family", "combination"},
                   {"name", l.name},
                   {"material", fmt::format("{} + {}, rolling {}, cohesion {}{}", l.normal, l.tangential, l.rolling,
                                            l.cohesion, l.damped ? "" : "; no restitution")},
                   {"needs", ""},
                   {"memory_bytes", 8 * model->words},
                   {"remark", l.remark},
                   {"source", ""}});
  }
  add_laws<contact::NormalLaws>("normal", 0, out);
  add_laws<contact::TangentialLaws>("tangential", 3, out);
  add_laws<contact::RollingLaws>("rolling", 0, out);
  add_laws<contact::CohesionLaws>("cohesion", 0, out);
  return out;
}

Json maps_json() {
  Json out = Json::array();
  for (const MapRow& row : map_rows()) {
    Json line;
    for (const auto& [name, text] : row) line[name] = text;
    out.push_back(line);
  }
  return out;
}

Json keys_json() {
  Json out = Json::array();
  for (const std::string& path : key_paths()) {
    const Key& key = *find_key(path);
    Json entry{{"key", path}, {"type", name_of(key.type)}, {"unit", key.unit}, {"required", key.required}};
    entry["default"] = default_text(path);
    entry["allowed"] = key.range.bounded() ? key.range.text(key.name) : fmt::format("{}", fmt::join(key.choices, ", "));
    entry["meaning"] = key.sentence;
    out.push_back(entry);
  }
  return out;
}

Json materials_json() {
  Json out = Json::array();
  for (const NamedMaterial& m : named_materials())
    out.push_back({{"name", m.name},
                   {"young_Pa", m.young},
                   {"poisson", m.poisson},
                   {"density_kg_m3", m.density ? Json(*m.density) : Json("-")},
                   {"source", m.source}});
  return out;
}

Json friction_json() {
  Json out = Json::array();
  const auto or_dash = [](const std::optional<double>& v) { return v ? Json(*v) : Json("-"); };
  for (const PublishedFriction& f : published_friction())
    out.push_back({{"published", f.name},
                   {"friction", f.friction},
                   {"uncertainty", or_dash(f.uncertainty)},
                   {"up_to", or_dash(f.highest)},
                   {"source", f.reference}});
  return out;
}

Json scenes_json() {
  Json out = Json::array();
  for (const std::string& name : shipped_scenes()) out.push_back({{"name", name}, {"title", title_of_scene(name)}});
  return out;
}

Json grains_json() {
  Json out = Json::array();
  for (const std::string& name : shipped_names()) out.push_back(name);
  return out;
}

Json quantities_json() {
  Json out = Json::array();
  for (const analysis::Quantity& q : analysis::quantities())
    out.push_back({{"name", q.name},
                   {"equation", q.equation},
                   {"contacts", q.needs_contacts ? "needed" : ""},
                   {"cost", q.costly ? "high: only when named" : ""},
                   {"what", q.what}});
  return out;
}

Json topic_json(const std::string& topic) {
  if (topic == "shapes") return shapes_json();
  if (topic == "methods") return methods_json();
  if (topic == "laws") return laws_json();
  if (topic == "maps") return maps_json();
  if (topic == "pairs") return pairs_json();
  if (topic == "keys") return keys_json();
  if (topic == "materials") return materials_json();
  if (topic == "friction") return friction_json();
  if (topic == "scenes") return scenes_json();
  if (topic == "quantities") return quantities_json();
  return grains_json();
}

std::string cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string out;
  for (const Json& item : value) out += (out.empty() ? "" : " ") + cell(item);
  return out.empty() ? "-" : out;
}

// A list of objects as columns; a list of words as lines.
void print_table(const Json& rows) {
  if (rows.empty() || !rows[0].is_object()) {
    for (const Json& row : rows) fmt::print("{}\n", cell(row));
    return;
  }
  std::vector<std::size_t> widths;
  std::vector<std::vector<std::string>> lines{{}};
  for (const auto& [name, value] : rows[0].items()) lines[0].push_back(name);
  for (const Json& row : rows) {
    lines.emplace_back();
    for (const auto& [name, value] : row.items()) lines.back().push_back(cell(value));
  }
  widths.resize(lines[0].size());
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) fmt::print("{:<{}}  ", line[i], widths[i]);
    fmt::print("{}\n", line.back());
  }
}

// Pair by pair: every method that answers it, by cost, or why none does.
void print_pairs() {
  for (const Json& row : pairs_json())
    fmt::print("{:<20}{:<20}{}\n", cell(row["a"]), cell(row["b"]),
               row["methods"].empty() ? cell(row["remark"]) : cell(row["methods"]));
}

// The verdicts as a table, the reasons below it by their numbers.
void print_maps() {
  std::vector<std::string> notes;
  Json short_rows = Json::array();
  for (const Json& row : maps_json()) {
    Json line;
    for (const auto& [name, value] : row.items()) {
      std::string text = value.get<std::string>();
      if (const std::size_t colon = text.find(": "); colon != std::string::npos && name != "of") {
        const std::string why = text.substr(colon + 2);
        auto note = std::find(notes.begin(), notes.end(), why);
        if (note == notes.end()) note = notes.insert(note, why);
        text = fmt::format("{} [{}]", text.substr(0, colon), note - notes.begin() + 1);
      }
      line[name] = text;
    }
    short_rows.push_back(line);
  }
  print_table(short_rows);
  for (std::size_t i = 0; i < notes.size(); ++i) fmt::print("[{}] {}\n", i + 1, notes[i]);
}

}  // namespace

const std::vector<std::string>& list_topics() {
  static const std::vector<std::string> topics{"shapes",    "methods",  "laws",   "maps",   "pairs",     "keys",
                                               "materials", "friction", "scenes", "grains", "quantities"};
  return topics;
}

int list_command(const ListArguments& arguments) {
  const std::vector<std::string> topics =
      arguments.what.empty() ? list_topics() : std::vector<std::string>{arguments.what};
  if (arguments.json) {
    Json out;
    for (const std::string& topic : topics) out[topic] = topic_json(topic);
    fmt::print("{}\n", out.dump(1));
    return success;
  }
  for (const std::string& topic : topics) {
    if (topics.size() > 1) fmt::print("{}{}\n", &topic == &topics[0] ? "" : "\n", topic);
    if (topic == "pairs")
      print_pairs();
    else if (topic == "maps")
      print_maps();
    else
      print_table(topic_json(topic));
  }
  return success;
}

int explain_command(const std::string& key) {
  fmt::print("{}", explain(key));
  return success;
}

}  // namespace dem::cli
