#include "bench/laws/contacts.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace laws {
namespace {

template <class List>
bool lists(const std::string& name) {
  bool found = false;
  contact::each_law<List>([&](auto law, std::size_t) { found = found || name == law.name; });
  return found;
}

}  // namespace

std::vector<LawNames> every_law() {
  std::vector<LawNames> list;
  const auto partner_of = [](std::string_view tangential) {
    for (const contact::Partners& p : contact::partners)
      if (p.law == tangential) return std::string(p.normal.substr(0, p.normal.find(',')));
    return std::string("hertz");
  };
  contact::each_law<contact::NormalLaws>([&](auto law, std::size_t) { list.push_back({law.name, "coulomb_spring"}); });
  contact::each_law<contact::TangentialLaws>([&](auto law, std::size_t) {
    if (std::string_view(law.name) != "coulomb_spring") list.push_back({partner_of(law.name), law.name});
  });
  contact::each_law<contact::RollingLaws>([&](auto law, std::size_t) {
    if (std::string_view(law.name) != "none") list.push_back({"hertz", "coulomb_spring", law.name});
  });
  contact::each_law<contact::CohesionLaws>([&](auto law, std::size_t) {
    if (std::string_view(law.name) != "none") list.push_back({"hertz", "coulomb_spring", "none", law.name});
  });
  return list;
}

std::string title(const LawNames& n) {
  return n.normal + (n.tangential == "coulomb_spring" ? "" : " + " + n.tangential) +
         (n.rolling == "none" ? "" : " + rolling " + n.rolling) + (n.cohesion == "none" ? "" : " + " + n.cohesion);
}

const contact::NamedLaw& named(const std::string& name) {
  for (const contact::NamedLaw& l : contact::named_laws)
    if (l.name == name) return l;
  throw std::invalid_argument("no law " + name);
}

LawNames names_of(const std::string& name) { return contact::named_law(name).value(); }
bool has_normal_law(const std::string& name) { return lists<contact::NormalLaws>(name); }
bool has_tangential_law(const std::string& name) { return lists<contact::TangentialLaws>(name); }

LawContact contact_of(const LawNames& names, const Material& a, const Material& b, const LawOptions& options) {
  return {contact::law_model(names).value(), contact::mix(a, b, options.clip), options};
}

Ball ball(double radius, double density) {
  return dem::law_driver::solid_ball(radius, density * (4.0 / 3) * std::numbers::pi * radius * radius * radius);
}

double hertz_duration(double mass_eff, double radius_eff, double young_eff, double speed) {
  // 2 ∫₀¹ dx/sqrt(1 − x^{5/2}) = (4/5) sqrt(π) Γ(2/5)/Γ(9/10)
  const double twice = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return twice * hertz_overlap(mass_eff, radius_eff, young_eff, speed) / speed;
}

double hertz_overlap(double mass_eff, double radius_eff, double young_eff, double speed) {
  return std::pow(15 * mass_eff * speed * speed / (16 * young_eff * std::sqrt(radius_eff)), 0.4);
}

}  // namespace laws
