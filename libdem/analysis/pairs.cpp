#include "libdem/analysis/pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "libdem/analysis/grid.h"

namespace dem::analysis {

namespace {

Pair merged(const Snapshot& s, const std::vector<std::uint32_t>& records, std::size_t first, std::size_t last) {
  const SnapshotContact& lead = s.contacts[records[first]];
  Pair p;
  p.a = lead.a;
  p.b = lead.b;
  p.wall = lead.wall;
  p.first = static_cast<std::uint32_t>(first);
  p.count = static_cast<std::uint32_t>(last - first);
  p.branch = lead.branch;
  p.overlap = lead.overlap;
  if (p.count == 1) {
    p.force = lead.force;
    p.point = lead.point;
    p.normal = lead.normal;
  } else {
    double total = 0;
    for (std::size_t k = first; k < last; ++k) total += std::abs(s.contacts[records[k]].pressing());
    double weights = 0;
    Vec3d normal{}, offset{};  // points relative to the first, so that nothing is lost far from the origin
    for (std::size_t k = first; k < last; ++k) {
      const SnapshotContact& c = s.contacts[records[k]];
      const double w = total > 0 ? std::abs(c.pressing()) / total : 1;
      weights += w;
      normal += c.normal * w;
      offset += (c.point - lead.point) * w;
      p.force += c.force;
      p.overlap = std::max(p.overlap, c.overlap);
    }
    p.point = lead.point + offset * (1 / weights);
    const double length = norm(normal);
    p.normal = length > 1e-12 * weights ? normal * (1 / length) : lead.normal;
    if (lead.wall) p.branch += offset * (1 / weights);
  }
  p.pressing = -dot(p.force, p.normal);
  p.tangential = norm(p.force + p.normal * p.pressing);
  return p;
}

void join(Pairs& pairs, std::size_t bodies) {
  pairs.start.assign(bodies + 1, 0);
  for (const Pair& p : pairs.bodies) {
    ++pairs.start[p.a + 1];
    ++pairs.start[p.b + 1];
  }
  std::partial_sum(pairs.start.begin(), pairs.start.end(), pairs.start.begin());
  pairs.pair_of.resize(2 * pairs.bodies.size());
  std::vector<std::uint32_t> next(pairs.start.begin(), pairs.start.end() - 1);
  for (std::uint32_t k = 0; k < pairs.bodies.size(); ++k) {
    pairs.pair_of[next[pairs.bodies[k].a]++] = k;
    pairs.pair_of[next[pairs.bodies[k].b]++] = k;
  }
}

}  // namespace

double Pairs::mean_pressing() const {
  double sum = 0;
  for (const Pair& p : bodies) sum += p.pressing;
  return bodies.empty() ? 0 : sum / static_cast<double>(bodies.size());
}

Pairs pairs_of(const Snapshot& s) {
  const auto order = [&](std::uint32_t i, std::uint32_t j) {
    const SnapshotContact &c = s.contacts[i], &d = s.contacts[j];
    return std::tie(c.wall, c.a, c.b) < std::tie(d.wall, d.a, d.b);
  };
  Pairs pairs;
  pairs.records.resize(s.contacts.size());
  std::iota(pairs.records.begin(), pairs.records.end(), 0u);
  std::stable_sort(pairs.records.begin(), pairs.records.end(), order);
  for (std::size_t first = 0; first < pairs.records.size();) {
    std::size_t last = first + 1;
    while (last < pairs.records.size() && !order(pairs.records[first], pairs.records[last])) ++last;
    auto& list = s.contacts[pairs.records[first]].wall ? pairs.walls : pairs.bodies;
    list.push_back(merged(s, pairs.records, first, last));
    first = last;
  }
  join(pairs, s.count());
  return pairs;
}

Pairs within(Pairs pairs, const Snapshot& s, const std::optional<Domain>& region) {
  if (!region) return pairs;
  const Grid whole(s, *region, {1, 1, 1});
  const auto out = [&](const Pair& p) { return whole.index(p.point) == Grid::none; };
  std::erase_if(pairs.bodies, out);
  std::erase_if(pairs.walls, out);
  join(pairs, s.count());
  return pairs;
}

bool lacks_contacts(const Snapshot& s, Result& result) {
  if (s.count() == 0) result.notes.emplace_back("no bodies");
  if (!s.has_contacts) result.notes.emplace_back("contacts are not known: the file has none");
  return s.count() == 0 || !s.has_contacts;
}

bool lacks_forces(const Snapshot& s, Result& result) {
  if (lacks_contacts(s, result)) return true;
  if (!s.has_forces) result.notes.emplace_back("forces are not known: contacts were found from places and sizes");
  return !s.has_forces;
}

}  // namespace dem::analysis
