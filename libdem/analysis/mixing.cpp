#include "libdem/analysis/mixing.h"

#include <fmt/format.h>

#include <cmath>

#include "libdem/analysis/table.h"

namespace dem::analysis {

std::optional<double> MixingOfGroup::lacey() const {
  const double span = segregated - random;
  return span > 1e-12 * segregated ? std::optional((segregated - variance) / span) : std::nullopt;
}
std::optional<double> MixingOfGroup::rsd() const {
  return share > 0 ? std::optional(std::sqrt(variance) / share) : std::nullopt;
}
std::optional<double> MixingOfGroup::intensity() const {
  return segregated > 0 ? std::optional(variance / segregated) : std::nullopt;
}

Mixing mixing_of(const Snapshot& s, const Grid& grid, const Groups& groups) {
  Mixing m;
  const std::size_t count = groups.names.size();
  std::vector<double> bodies(grid.size(), 0), of_group(grid.size() * count, 0), total(count, 0);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::size_t box = grid.index(s.position[i]);
    const std::uint32_t g = groups.of_body[i];
    if (box == Grid::none || g == Groups::none) continue;
    bodies[box] += 1;
    of_group[box * count + g] += 1;
    total[g] += 1;
    ++m.bodies;
  }
  for (const double n : bodies) m.boxes += n > 0 ? 1 : 0;
  m.all.share = 1;
  if (m.bodies == 0) return m;
  const auto n = static_cast<double>(m.bodies), k = static_cast<double>(m.boxes);
  for (std::size_t g = 0; g < count; ++g) {
    MixingOfGroup x;
    x.share = total[g] / n;
    for (std::size_t box = 0; box < grid.size(); ++box) {
      if (bodies[box] <= 0) continue;
      const double off = of_group[box * count + g] / bodies[box] - x.share;
      x.variance += bodies[box] * off * off / n;  // (1)
    }
    x.segregated = x.share * (1 - x.share);
    x.random = x.segregated * k / n;
    x.random_exact = n > 1 ? x.segregated * (k - 1) / (n - 1) : 0;
    m.all.variance += x.variance;
    m.all.segregated += x.segregated;
    m.all.random += x.random;
    m.all.random_exact += x.random_exact;
    m.groups.push_back(x);
  }
  return m;
}

Result report_mixing(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  const Groups groups = groups_of(s, settings.split, settings.reference);
  const Mixing m = mixing_of(s, grid_of(s, settings), groups);
  r.add("groups", "1", static_cast<double>(groups.names.size()));
  r.add("boxes", "1", static_cast<double>(m.boxes));
  r.add("bodies_per_box", "1", m.boxes > 0 ? static_cast<double>(m.bodies) / static_cast<double>(m.boxes) : 0);
  std::string names = "groups by " + settings.split + ":";
  for (std::size_t g = 0; g < groups.names.size(); ++g) names += fmt::format(" {} = {};", g, groups.names[g]);
  r.notes.push_back(names);
  const bool by_place = settings.split == "position" || settings.split == "layers" || settings.split.size() == 1;
  if (by_place && settings.reference == nullptr) r.notes.emplace_back("no reference frame: slabs of this one");
  if (!(m.all.segregated > 0)) {
    r.notes.push_back("one group alone: nothing to mix");
    return r;
  }
  r.add("variance", "1", m.all.variance);
  r.add("variance_segregated", "1", m.all.segregated);
  r.add("variance_random", "1", m.all.random);
  r.add("variance_random_exact", "1", m.all.random_exact);
  r.add("segregation_intensity", "1", m.all.intensity().value_or(0));
  if (const auto lacey = m.all.lacey())
    r.add("lacey", "1", *lacey);
  else
    r.notes.emplace_back("no Lacey index: boxes hold one body each; take larger ones");
  Table t = table_of("groups", "Mixing of each group with all others",
                     {{"group", "1"},
                      {"share", "1"},
                      {"variance", "1"},
                      {"variance_segregated", "1"},
                      {"variance_random", "1"},
                      {"rsd", "1"},
                      {"segregation_intensity", "1"}});
  for (std::size_t g = 0; g < m.groups.size(); ++g) {
    const MixingOfGroup& x = m.groups[g];
    add_row(t, g, x.share, x.variance, x.segregated, x.random, x.rsd().value_or(0), x.intensity().value_or(0));
    if (g == 0) r.add("rsd_group_0", "1", x.rsd().value_or(0));
  }
  r.tables.push_back(std::move(t));
  return r;
}

}  // namespace dem::analysis
