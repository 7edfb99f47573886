#include "libdem/laws_of_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"

namespace dem {
namespace {

const contact::NamedLaw& combination(const LawSpec& law) {
  return contact::named_laws[static_cast<std::size_t>(law.name)];
}

}  // namespace

contact::LawNames law_names(const LawSpec& law) {
  const contact::NamedLaw& own = combination(law);
  const auto pick = [](const std::string& given, std::string_view of_combination) {
    return given.empty() ? std::string(of_combination) : given;
  };
  return {pick(law.normal, own.normal), pick(law.tangential, own.tangential), pick(law.rolling, own.rolling),
          pick(law.cohesion, own.cohesion)};
}

contact::LawModel law_model_of(const LawSpec& law) {
  if (const auto model = contact::law_model(law_names(law))) return *model;
  throw std::logic_error("law " + law_title(law) + " is in no list");
}

contact::LawOptions law_options_of(const LawSpec& law) {
  return {law.rescale, law.clip, law.deficit, law.surface_tension, law.bridge_volume};
}

contact::Material material_of(const MaterialSpec& m, const LawSpec& law) {
  contact::Material out;
  out.young = m.young;
  out.poisson = m.poisson;
  out.density = m.density;
  out.restitution = combination(law).damped ? m.restitution : 1;
  out.friction = m.friction;
  out.stiffness = m.stiffness;
  out.rigid = m.rigid;
  out.viscous_time = m.viscous_time;
  out.yield_pressure = m.yield_pressure;
  out.work_of_adhesion = m.surface_energy > 0 ? 2 * m.surface_energy : m.work_of_adhesion;
  out.plastic_stiffness = m.plastic_stiffness;
  out.adhesive_stiffness = m.adhesive_stiffness;
  out.plastic_depth = m.plastic_depth;
  out.rolling_friction = m.rolling_friction;
  out.rolling_viscosity = m.rolling_viscosity;
  out.rolling_damping = m.rolling_damping;
  out.twisting_friction = m.twisting_friction;
  out.cohesion = m.cohesion;
  out.contact_angle = m.contact_angle;
  return out;
}

void override_pair(contact::PairParameters& q, const MaterialPairSpec& p, bool clip) {
  if (!std::isnan(p.friction)) q.friction = p.friction;
  if (!std::isnan(p.stiffness)) {
    q.stiffness_t = p.stiffness * (q.stiffness_n > 0 ? q.stiffness_t / q.stiffness_n : 1);
    q.stiffness_n = p.stiffness;
  }
  if (!std::isnan(p.restitution)) contact::set_restitution(q, p.restitution, clip);
  if (!std::isnan(p.work_of_adhesion)) q.work_of_adhesion = p.work_of_adhesion;
  if (!std::isnan(p.rolling_friction)) q.rolling_friction = p.rolling_friction;
  if (!std::isnan(p.twisting_friction)) q.twisting_friction = p.twisting_friction;
  if (!std::isnan(p.cohesion)) q.cohesion = p.cohesion;
}

std::vector<std::pair<std::string, std::string>> split_parameters(std::string_view list) {
  std::vector<std::pair<std::string, std::string>> parameters;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(", "), list.size());
    const std::string_view word = list.substr(0, end);
    const std::size_t space = std::min(word.find(' '), word.size());
    parameters.emplace_back(word.substr(0, space), word.substr(space));
    list.remove_prefix(std::min(end + 2, list.size()));
  }
  return parameters;
}

std::string law_title(const LawSpec& law) {
  std::string title(combination(law).name);
  const auto add = [&](const char* family, const std::string& name) {
    if (!name.empty()) title += fmt::format(", {} {}", family, name);
  };
  add("normal", law.normal);
  add("tangential", law.tangential);
  add("rolling", law.rolling);
  add("cohesion", law.cohesion);
  return title;
}

}  // namespace dem
