// What the laws of a scene need and what its materials give: refused where the two do not meet.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"
#include "libdem/laws_of_scene.h"
#include "libdem/scene/rules.h"

namespace dem {
namespace {

enum class Must { no, soft, somewhere };  // given by: none; every material that deforms; one at least

struct Parameter {
  const char* name;
  double MaterialSpec::*value;
  Must must;
  bool common;  // may stand in a material that no law of the scene reads it from: libraries of materials do
};
constexpr Parameter parameters[] = {
    {"young", &MaterialSpec::young, Must::soft, true},
    {"poisson", &MaterialSpec::poisson, Must::no, true},
    {"restitution", &MaterialSpec::restitution, Must::no, true},
    {"friction", &MaterialSpec::friction, Must::no, true},
    {"stiffness", &MaterialSpec::stiffness, Must::soft, true},
    {"viscous_time", &MaterialSpec::viscous_time, Must::somewhere, false},
    {"yield_pressure", &MaterialSpec::yield_pressure, Must::somewhere, false},
    {"work_of_adhesion", &MaterialSpec::work_of_adhesion, Must::somewhere, false},
    {"surface_energy", &MaterialSpec::surface_energy, Must::no, false},
    {"plastic_stiffness", &MaterialSpec::plastic_stiffness, Must::soft, false},
    {"adhesive_stiffness", &MaterialSpec::adhesive_stiffness, Must::no, false},
    {"plastic_depth", &MaterialSpec::plastic_depth, Must::soft, false},
    {"rolling_friction", &MaterialSpec::rolling_friction, Must::somewhere, false},
    {"rolling_viscosity", &MaterialSpec::rolling_viscosity, Must::somewhere, false},
    {"rolling_damping", &MaterialSpec::rolling_damping, Must::no, false},
    {"twisting_friction", &MaterialSpec::twisting_friction, Must::no, false},
    {"cohesion", &MaterialSpec::cohesion, Must::somewhere, false},
    {"contact_angle", &MaterialSpec::contact_angle, Must::no, false},
};

class LawRules : RuleContext {
 public:
  explicit LawRules(const RuleContext& context) : RuleContext(context), names_(law_names(context.scene.law)) {}

  void check() {
    if (!partners_meet()) return;
    read();
    for (std::size_t i = 0; i < scene.materials.size(); ++i) material(i);
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) pair(i);
    for (const Parameter& p : parameters) somewhere(p);
    liquid();
  }

 private:
  bool partners_meet() {
    for (const contact::Partners& p : contact::partners) {
      if (p.law != names_.tangential) continue;
      if ((", " + std::string(p.normal) + ", ").find(", " + names_.normal + ", ") != std::string::npos) continue;
      wrong("law", 0, scene.law.tangential.empty() ? scene.law.normal.empty() ? "name" : "normal" : "tangential",
            fmt::format("tangential law {} goes with the normal laws {}, found {}", p.law, p.normal, names_.normal));
      return false;
    }
    return true;
  }

  void read() {
    const auto add = [&](auto list, const std::string& name) {
      contact::each_law<decltype(list)>([&](auto law, std::size_t) {
        if (name == law.name)
          for (auto& [parameter, unit] : split_parameters(law.parameters)) read_.emplace(parameter, unit);
      });
    };
    add(contact::NormalLaws{}, names_.normal);
    add(contact::TangentialLaws{}, names_.tangential);
    add(contact::RollingLaws{}, names_.rolling);
    add(contact::CohesionLaws{}, names_.cohesion);
    if (scene.law.reference_speed > 0) {
      if (read_.erase("stiffness") == 0)
        wrong("law", 0, "reference_speed", fmt::format("is for linear laws, found normal law {}", names_.normal));
      for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (scene.materials[i].stiffness > 0)
          wrong("material", i, "stiffness", "give it or law.reference_speed, not both");
      read_.emplace("young", " (Pa)");
    }
    damped_ = contact::named_laws[static_cast<std::size_t>(scene.law.name)].damped && read_.contains("restitution");
    title_ = law_title(scene.law);
  }

  // A clipped contact always rebounds, and the step goes to zero with the restitution (libcontact/laws/mix.h).
  void restitution(const char* table, std::size_t i, double e) {
    if (damped_ && scene.law.clip && e < contact::least_clipped_restitution)
      wrong(table, i, "restitution",
            fmt::format("allowed {0} <= {1}.restitution <= 1: a contact that ends at zero force always rebounds; with "
                        "law.clip = false, which lets the dashpot pull until the overlap is zero, from 0",
                        contact::least_clipped_restitution, table));
    if (!damped_ && e < 1 && node(table, i, "restitution"))
      wrong(table, i, "restitution", fmt::format("law {} has no such parameter", title_));
  }

  void material(std::size_t i) {
    const MaterialSpec& m = scene.materials[i];
    restitution("material", i, m.restitution);
    if (m.work_of_adhesion > 0 && m.surface_energy > 0)
      wrong("material", i, "surface_energy", "is half the work of adhesion: give one of the two");
    for (const Parameter& p : parameters) {
      const auto unit = read_.find(p.name);
      if (unit != read_.end()) {
        if (p.must == Must::soft && !m.rigid && m.*p.value == 0)
          wrong("material", i, nullptr,
                fmt::format("\"{}\" needs {}{} for law {}", m.name, p.name, unit->second, title_));
        continue;
      }
      const bool half = std::string_view(p.name) == "surface_energy" && read_.contains("work_of_adhesion");
      if (!p.common && !half && m.*p.value > 0) unread("material", i, p.name);
    }
  }

  void pair(std::size_t i) {
    restitution("material_pair", i, scene.pairs[i].restitution);
    const bool linear = read_.contains("stiffness") || scene.law.reference_speed > 0;
    if (!linear && node("material_pair", i, "stiffness"))
      wrong("material_pair", i, "stiffness", fmt::format("law {} takes the stiffness from young and poisson", title_));
    for (const char* key : {"work_of_adhesion", "rolling_friction", "twisting_friction", "cohesion"})
      if (!read_.contains(key) && node("material_pair", i, key)) unread("material_pair", i, key);
  }

  void unread(const char* table, std::size_t i, const char* key) {
    wrong(table, i, key, fmt::format("law {} does not read it; see dem list laws", title_));
  }

  void somewhere(const Parameter& p) {
    const auto unit = read_.find(p.name);
    if (p.must != Must::somewhere || unit == read_.end()) return;
    for (const MaterialSpec& m : scene.materials)
      if (m.*p.value > 0 || (std::string_view(p.name) == "work_of_adhesion" && m.surface_energy > 0)) return;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i)
      if (node("material_pair", i, p.name)) return;
    wrong("law", 0, nullptr,
          fmt::format("law {} reads {}{}, which no material gives: allowed material.{} > 0", title_, p.name,
                      unit->second, p.name));
  }

  void liquid() {
    const bool bridges = names_.cohesion.starts_with("liquid_bridge");
    for (const auto& [key, value] : {std::pair{"surface_tension", scene.law.surface_tension},
                                     std::pair{"bridge_volume", scene.law.bridge_volume}}) {
      if (bridges && !(value > 0))
        wrong("law", 0, key, fmt::format("allowed law.{} > 0 with cohesion {}", key, names_.cohesion));
      if (!bridges && value > 0) unread("law", 0, key);
    }
  }

  contact::LawNames names_;
  std::map<std::string, std::string> read_;  // what the laws of the scene read, with units
  bool damped_ = false;
  std::string title_;
};

}  // namespace

void check_law_rules(const RuleContext& context) { LawRules(context).check(); }

}  // namespace dem
