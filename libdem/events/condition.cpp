#include "libdem/events/condition.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "libdem/scene/nearest.h"
#include "libdem/world.h"

namespace dem {
namespace {

struct Name {
  const char* text;
  Quantity quantity;
};
constexpr Name plain_names[] = {{"time", Quantity::time},
                                {"step", Quantity::step},
                                {"count", Quantity::count},
                                {"mass", Quantity::mass},
                                {"energy", Quantity::kinetic_energy},
                                {"kinetic_energy", Quantity::kinetic_energy},
                                {"kinetic_energy_per_body", Quantity::kinetic_energy_per_body},
                                {"max_speed", Quantity::max_speed},
                                {"mean_speed", Quantity::mean_speed},
                                {"unbalanced_force", Quantity::unbalanced_force},
                                {"contacts", Quantity::contacts},
                                {"contacts_per_body", Quantity::contacts_per_body},
                                {"max_overlap", Quantity::max_overlap},
                                {"inserted_count", Quantity::inserted_count},
                                {"inserted_mass", Quantity::inserted_mass},
                                {"discharged_count", Quantity::discharged_count},
                                {"discharged_mass", Quantity::discharged_mass}};

class Parser {
 public:
  Parser(const std::string& text, const Scene& scene, ConditionFault& fault)
      : text_(text), scene_(scene), fault_(fault) {}

  bool conditions(Condition& out) {
    do {
      Term term{};
      if (!name(term) || !comparison(term) || !number(term)) return false;
      out.push_back(term);
      skip();
      if (at_ == text_.size()) return true;
    } while (word("and"));
    return wrong(at_, "needs \"and\" or the end here");
  }

 private:
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool wrong(std::size_t at, const std::string& problem) {
    fault_ = {at, problem};
    return false;
  }
  bool word(const std::string& w) {
    if (text_.compare(at_, w.size(), w) != 0) return false;
    at_ += w.size();
    return true;
  }
  static bool ends_name(char c) { return c == ' ' || c == '\t' || c == '<' || c == '>' || c == '='; }

  bool name(Term& term) {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
    const std::string found = text_.substr(begin, at_ - begin);
    if (found.empty()) return wrong(begin, "needs a quantity here");
    for (const Name& n : plain_names)
      if (found == n.text) return term.quantity = n.quantity, true;
    const std::size_t first = found.find('.'), last = found.rfind('.');
    if (first != last)
      return part(term, begin, found.substr(0, first), found.substr(first + 1, last - first - 1),
                  found.substr(last + 1));
    std::vector<std::string> known;
    for (const Name& n : plain_names) known.emplace_back(n.text);
    for (const char* more : {"outlet.NAME.count", "outlet.NAME.mass", "rain.NAME.count", "rain.NAME.mass",
                             "wall.NAME.force", "wall.NAME.torque"})
      known.emplace_back(more);
    const std::string near = nearest_name(found, known);
    std::string list;
    for (const std::string& k : known) list += (list.empty() ? "" : ", ") + k;
    return wrong(
        begin, "there is no quantity " + found + (near.empty() ? "; known: " + list : "; did you mean " + near + "?"));
  }

  template <class Specs>
  bool find(Term& term, std::size_t at, const Specs& specs, const std::string& table, const std::string& own) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < specs.size(); ++i) {
      if (specs[i].name == own) return term.index = i, true;
      names.push_back(specs[i].name);
    }
    return wrong(at, "no [[" + table + "]] is named \"" + own + "\"" + suggestion(own, names));
  }

  bool part(Term& term, std::size_t at, const std::string& table, const std::string& own, const std::string& what) {
    const auto pick = [&](const char* first, Quantity one, const char* second, Quantity two) {
      if (what == first) return term.quantity = one, true;
      if (what == second) return term.quantity = two, true;
      return wrong(at, "of a [[" + table + "]] there are " + first + " and " + second + ", not " + what);
    };
    if (table == "outlet")
      return find(term, at, scene_.outlets, table, own) &&
             pick("count", Quantity::outlet_count, "mass", Quantity::outlet_mass);
    if (table == "rain")
      return find(term, at, scene_.rains, table, own) &&
             pick("count", Quantity::rain_count, "mass", Quantity::rain_mass);
    if (table == "wall")
      return find(term, at, scene_.walls, table, own) &&
             pick("force", Quantity::wall_force, "torque", Quantity::wall_torque);
    return wrong(at, "needs outlet.NAME, rain.NAME or wall.NAME, found " + table);
  }

  bool comparison(Term& term) {
    skip();
    if (word("<=")) return term.comparison = Comparison::less_equal, true;
    if (word(">=")) return term.comparison = Comparison::greater_equal, true;
    if (word("<")) return term.comparison = Comparison::less, true;
    if (word(">")) return term.comparison = Comparison::greater, true;
    return wrong(at_, "needs <, <=, > or >= here");
  }

  bool number(Term& term) {
    skip();
    const char *begin = text_.data() + at_, *end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(begin, end, term.value);
    if (error != std::errc() || !std::isfinite(term.value)) return wrong(at_, "needs a number here");
    at_ += static_cast<std::size_t>(stop - begin);
    if (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != '\t')
      return wrong(at_, "needs a space after the number; units are SI and not written");
    return true;
  }

  const std::string& text_;
  const Scene& scene_;
  ConditionFault& fault_;
  std::size_t at_ = 0;
};

double kinetic(const World& world) {
  const Energies e = energies(world);
  return e.translational + e.rotational;
}

double share(double sum, std::size_t count) { return count > 0 ? sum / static_cast<double>(count) : 0; }

// Mean length of (force on a body + its weight) over mean contact force; infinite without contacts.
double unbalanced_force(const World& world) {
  const Particles& p = world.particles;
  double net = 0, force = 0;
  for (const std::uint32_t i : order_by_id(world)) net += norm(p.force[i] + world.scene.gravity * p.mass[i]);
  const auto contacts = touching_contacts(world);
  for (const ContactReport& c : contacts) force += norm(c.force);
  return force > 0 ? share(net, p.count()) / share(force, contacts.size()) : std::numeric_limits<double>::infinity();
}

double max_overlap(const World& world) {
  const Contacts& c = world.contacts;
  double largest = 0;
  for (std::size_t k = 0; k < c.count(); ++k) {
    if (c.touching[k] == 0) continue;
    double radius = world.particles.motion[c.index_a[k]].equivalent_radius;
    if (c.key[k].b < wall_base) radius = std::min(radius, world.particles.motion[c.index_b[k]].equivalent_radius);
    largest = std::max(largest, c.history_of(k).overlap / radius);
  }
  return largest;
}

double touching(const World& world) {
  std::size_t n = 0;
  for (const std::uint8_t t : world.contacts.touching) n += t != 0 ? 1 : 0;
  return static_cast<double>(n);
}

double speed(const World& world, bool mean) {
  double sum = 0, largest = 0;
  for (const std::uint32_t i : order_by_id(world)) {
    const double v = norm(world.particles.motion[i].velocity);
    sum += v;
    largest = std::max(largest, v);
  }
  return mean ? share(sum, world.particles.count()) : largest;
}

double discharged(const World& world, bool mass) {
  double count = 0, sum = 0;
  for (const OutletRecord& o : world.outlets) {
    count += static_cast<double>(o.count);
    sum += o.mass;
  }
  return mass ? sum : count;
}

}  // namespace

bool parse_condition(const std::string& text, const Scene& scene, Condition& condition, ConditionFault& fault) {
  condition.clear();
  return Parser(text, scene, fault).conditions(condition);
}

double measure(const World& world, const Term& t) {
  switch (t.quantity) {
    case Quantity::time:
      return world.time();
    case Quantity::step:
      return static_cast<double>(world.step);
    case Quantity::count:
      return static_cast<double>(world.particles.count());
    case Quantity::mass:
      return world.balance.present.value();
    case Quantity::kinetic_energy:
      return kinetic(world);
    case Quantity::kinetic_energy_per_body:
      return share(kinetic(world), world.particles.count());
    case Quantity::max_speed:
      return speed(world, false);
    case Quantity::mean_speed:
      return speed(world, true);
    case Quantity::unbalanced_force:
      return unbalanced_force(world);
    case Quantity::contacts:
      return touching(world);
    case Quantity::contacts_per_body:
      return share(touching(world), world.particles.count());
    case Quantity::max_overlap:
      return max_overlap(world);
    case Quantity::inserted_count:
      return static_cast<double>(world.balance.inserted_count);
    case Quantity::inserted_mass:
      return world.balance.inserted_mass;
    case Quantity::discharged_count:
      return discharged(world, false);
    case Quantity::discharged_mass:
      return discharged(world, true);
    case Quantity::outlet_count:
      return static_cast<double>(world.outlets[t.index].count);
    case Quantity::outlet_mass:
      return world.outlets[t.index].mass;
    case Quantity::rain_count:
      return static_cast<double>(world.rains[t.index].count);
    case Quantity::rain_mass:
      return world.rains[t.index].mass;
    case Quantity::wall_force:
      return norm(world.walls[t.index].force);
    case Quantity::wall_torque:
      return norm(world.walls[t.index].torque);
  }
  return 0;
}

bool holds(const World& world, const Condition& condition) {
  return !condition.empty() && std::all_of(condition.begin(), condition.end(), [&](const Term& t) {
    const double v = measure(world, t);
    switch (t.comparison) {
      case Comparison::less:
        return v < t.value;
      case Comparison::less_equal:
        return v <= t.value;
      case Comparison::greater:
        return v > t.value;
      case Comparison::greater_equal:
        return v >= t.value;
    }
    return false;
  });
}

}  // namespace dem
