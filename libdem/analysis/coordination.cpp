#include "libdem/analysis/coordination.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/analysis/grid.h"
#include "libdem/rattlers.h"

namespace dem::analysis {

Coordination coordination_of(const Snapshot& s, const Pairs& pairs, const std::optional<Domain>& region) {
  Coordination c;
  c.of_body.resize(s.count());
  c.walls_of_body.assign(s.count(), 0);
  c.counted.assign(s.count(), 1);
  for (const Pair& p : pairs.walls) ++c.walls_of_body[p.a];
  if (region) {
    const Grid whole(s, *region, {1, 1, 1});
    for (std::size_t i = 0; i < s.count(); ++i) c.counted[i] = whole.index(s.position[i]) != Grid::none ? 1 : 0;
  }
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::uint32_t n = c.of_body[i] = pairs.contacts_of(i);
    if (c.counted[i] == 0) continue;
    ++c.bodies;
    c.none += n == 0 ? 1 : 0;
    c.one += n == 1 ? 1 : 0;
    c.contacts += n;
    c.wall_contacts += c.walls_of_body[i];
  }
  if (c.bodies == 0) return c;
  const auto np = static_cast<double>(c.bodies), n1 = static_cast<double>(c.one), n0 = static_cast<double>(c.none);
  c.mean = c.contacts / np;  // (9.42)
  c.mean_with_walls = (c.contacts + c.wall_contacts) / np;
  if (np > n1 + n0) {
    c.mechanical = (c.contacts - n1) / (np - n1 - n0);  // (9.43)
    c.mechanical_both_ends = (c.contacts - 2 * n1) / (np - n1 - n0);
  }
  return c;
}

Backbone backbone_of(const Snapshot& s, const Pairs& pairs, const Coordination& of, std::uint32_t least) {
  std::vector<BodyPair> list;
  list.reserve(pairs.bodies.size());
  for (const Pair& p : pairs.bodies) list.emplace_back(p.a, p.b);
  Backbone b;
  b.least = least;
  b.rattles = rattlers(s.count(), list, of.walls_of_body, least);
  double ends = 0, walls = 0;
  for (const auto& [i, j] : list)
    if (b.rattles[i] == 0 && b.rattles[j] == 0) ends += of.counted[i] + of.counted[j];
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (of.counted[i] == 0) continue;
    b.rattlers += b.rattles[i];
    if (b.rattles[i] == 0) walls += of.walls_of_body[i];
  }
  if (of.bodies > b.rattlers) {
    const auto n = static_cast<double>(of.bodies - b.rattlers);
    b.mean = ends / n;
    b.mean_with_walls = (ends + walls) / n;
  }
  return b;
}

double line_of_ordered(double d) { return std::numbers::pi / (1 - d); }        // (9.44)
double line_of_random(double d) { return 14 - 10.4 * std::pow(1 - d, 0.38); }  // (9.45)

}  // namespace dem::analysis
