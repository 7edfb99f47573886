#include "libdem/analysis/report_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/analysis/force_chains.h"
#include "libdem/analysis/force_network.h"
#include "libdem/analysis/grid.h"
#include "libdem/analysis/histogram.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

constexpr double far_out = 6;          // mean forces that settings.bins bins reach
constexpr std::size_t longest = 10;    // times as many bins at most
constexpr double no_friction = 1e-12;  // of the mean normal force

double place_or_none(std::uint32_t place) { return place == Clusters::none ? -1.0 : place; }

double share(double part, std::size_t of) { return of > 0 ? part / static_cast<double>(of) : 0; }

void add_distribution(Result& r, const char* name, const char* title, std::vector<double> forces, double mean,
                      int bins) {
  double square = 0;
  for (double& f : forces) {
    f /= mean;
    square += f * f;
  }
  const auto n = static_cast<double>(forces.size());
  r.add(std::string(name) + "_participation", "1", n / square);
  const auto count = static_cast<std::size_t>(std::max(bins, 1));
  const Histogram h = histogram_of(forces, far_out / static_cast<double>(count), longest * count);
  if (h.beyond > 0)
    r.notes.push_back(fmt::format("{}: {} forces beyond {} times the mean are in no bin", name, h.beyond,
                                  far_out * static_cast<double>(longest)));
  r.tables.push_back(histogram_table(name, title, "force_over_mean", "1", h));
}

void add_friction(Result& r, const Pairs& pairs, double mean, int bins) {
  std::vector<double> tangential, ratio;
  double sum = 0, mobilised = 0, largest = 0;
  for (const Pair& p : pairs.bodies) {
    if (!(p.pressing > 0)) continue;
    tangential.push_back(p.tangential);
    ratio.push_back(p.tangential / p.pressing);
    sum += p.tangential;
    mobilised += ratio.back();
    largest = std::max(largest, ratio.back());
  }
  const double mean_tangential = share(sum, tangential.size());
  r.add("mean_tangential_force", "N", mean_tangential);
  r.add("mean_mobilised_friction", "1", share(mobilised, ratio.size()));
  r.add("largest_mobilised_friction", "1", largest);
  if (!(mean_tangential > no_friction * mean)) {
    r.notes.emplace_back("no tangential forces");
    return;
  }
  add_distribution(r, "tangential", "Tangential forces over their mean", std::move(tangential), mean_tangential, bins);
  const double width = 2.0 / std::max(bins, 1);  // up to 1, say, half of the bins
  r.tables.push_back(
      histogram_table("mobilised", "Tangential over normal force", "ratio", "1",
                      histogram_of(ratio, width, longest * static_cast<std::size_t>(std::max(bins, 1)))));
}

Table lines_table(const Snapshot& s, const std::vector<NetworkLine>& lines, const Pairs& pairs,
                  const ForceNetwork& network, const ForceChains& chains) {
  Table t = table_of("network", "Lines of the force network, to the nearest image; cluster and chain -1: none",
                     {{"from_x", "m"},
                      {"from_y", "m"},
                      {"from_z", "m"},
                      {"to_x", "m"},
                      {"to_y", "m"},
                      {"to_z", "m"},
                      {"force", "N"},
                      {"tangential", "N"},
                      {"relative", "1"},
                      {"strong", "1"},
                      {"wall", "1"},
                      {"cluster", "1"},
                      {"chain", "1"},
                      {"a", "1"},
                      {"b", "1"}});
  for (const NetworkLine& l : lines) {
    const Pair& p = l.wall ? pairs.walls[l.pair] : pairs.bodies[l.pair];
    const bool inside = !l.wall && l.strong, chain = !l.wall && chains.link[l.pair] != 0;
    add_row(t, l.from.x, l.from.y, l.from.z, l.to.x, l.to.y, l.to.z, l.force, l.tangential, l.relative, l.strong,
            l.wall, inside ? place_or_none(network.clusters.of_body[p.a]) : -1,
            chain ? place_or_none(chains.of_body[p.a]) : -1, s.id[p.a], l.wall ? p.b : s.id[p.b]);
  }
  return t;
}

Table bodies_table(const Snapshot& s, const ForceNetwork& network, const ForceChains& chains) {
  Table t = table_of("bodies",
                     "Load of each body: its largest principal stress and direction; its cluster and chain, -1: none",
                     {{"id", "1"},
                      {"load", "Pa"},
                      {"direction_x", "1"},
                      {"direction_y", "1"},
                      {"direction_z", "1"},
                      {"cluster", "1"},
                      {"chain", "1"}});
  for (std::size_t i = 0; i < s.count(); ++i) {
    const Vec3d& d = chains.direction[i];
    add_row(t, s.id[i], chains.load[i], d.x, d.y, d.z, place_or_none(network.clusters.of_body[i]),
            place_or_none(chains.of_body[i]));
  }
  return t;
}

void add_network(Result& r, const Snapshot& s, const Pairs& pairs, const ForceNetwork& network) {
  double strong = 0, borne = 0, all = 0;
  for (std::size_t k = 0; k < pairs.bodies.size(); ++k) {
    const double f = std::max(pairs.bodies[k].pressing, 0.0);
    strong += network.strong[k];
    all += f;
    if (network.strong[k] != 0) borne += f;
  }
  r.add("strong_share", "1", share(strong, pairs.bodies.size()));
  r.add("strong_force_share", "1", all > 0 ? borne / all : 0);
  const auto& sizes = network.clusters.sizes;
  r.add("clusters", "1", static_cast<double>(sizes.size()));
  r.add("largest_cluster", "1", sizes.empty() ? 0 : sizes[0]);
  for (int k = 0; k < s.dimension; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    const std::string name{"xyz"[k]};
    r.add("percolates_" + name, "1", network.percolates[axis] ? 1 : 0);
    if (network.critical[axis]) r.add("critical_force_" + name, "1", *network.critical[axis] / network.mean);
  }
  r.notes.emplace_back(
      "critical_force: the largest threshold, over the mean, at which contacts still join opposite sides (periodic: a "
      "cluster and its image); sides are bodies within one mean bounding radius");
}

void add_chains(Result& r, const Snapshot& s, const ForceChains& chains) {
  double bodies = 0, length = 0, branches = 0;
  Table t = table_of("chains", "Force chains, the longest first",
                     {{"bodies", "1"}, {"links", "1"}, {"branches", "1"}, {"length", "m"}});
  for (const Chain& c : chains.chains) {
    bodies += c.bodies;
    length += c.length;
    branches += c.branches;
    add_row(t, c.bodies, c.links, c.branches, c.length);
  }
  const std::size_t n = chains.chains.size();
  r.add("chains", "1", static_cast<double>(n));
  r.add("bodies_in_chains", "1", share(bodies, s.count()));
  r.add("mean_chain_bodies", "1", share(bodies, n));
  r.add("longest_chain_bodies", "1", n > 0 ? chains.chains[0].bodies : 0);
  r.add("mean_chain_length", "m", share(length, n));
  r.add("chain_branches", "1", share(branches, n));
  r.notes.emplace_back(
      "chains: three or more bodies in contact, each bearing more than the mean largest principal stress, the line of "
      "centres within 45 degrees of its direction at both ends (Peters et al., Phys. Rev. E 72 (2005) 041307)");
  r.tables.push_back(std::move(t));
}

}  // namespace

Result report_forces(const Snapshot& s, const Settings& settings) {
  Result r;
  if (lacks_forces(s, r)) return r;
  const Pairs pairs = within(pairs_of(s), s, settings.region);
  const ForceNetwork network = force_network_of(s, pairs, region_of(s, settings), settings.strong_force);
  std::vector<double> normal;
  for (const Pair& p : pairs.bodies)
    if (p.pressing > 0) normal.push_back(p.pressing);
  r.add("contacts", "1", static_cast<double>(pairs.bodies.size()));
  r.add("pulling_contacts", "1", static_cast<double>(pairs.bodies.size() - normal.size()));
  r.add("mean_normal_force", "N", network.mean);
  if (normal.empty()) {
    r.notes.emplace_back(pairs.bodies.empty() ? "no contacts between bodies" : "no contact between bodies pushes");
    return r;
  }
  add_distribution(r, "normal", "Normal forces over their mean", std::move(normal), network.mean, settings.bins);
  add_friction(r, pairs, network.mean, settings.bins);
  add_network(r, s, pairs, network);
  const ForceChains chains = force_chains_of(s, pairs);
  add_chains(r, s, chains);
  const Histogram sizes =
      histogram_of({network.clusters.sizes.begin(), network.clusters.sizes.end()}, 1, s.count() + 1);
  Table clusters = table_of("clusters", "Clusters of the strong network by their number of bodies",
                            {{"bodies", "1"}, {"clusters", "1"}});
  for (std::size_t k = 0; k < sizes.counts.size(); ++k) {
    if (sizes.counts[k] <= 0) continue;
    add_row(clusters, k, sizes.counts[k]);
  }
  r.tables.push_back(std::move(clusters));
  const std::vector<NetworkLine> lines = network_lines(s, pairs, network);
  r.tables.push_back(lines_table(s, lines, pairs, network, chains));
  r.surfaces.push_back(network_surface(lines));
  r.tables.push_back(bodies_table(s, network, chains));
  return r;
}

}  // namespace dem::analysis
