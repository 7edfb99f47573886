#include "libdem/analysis/force_chains.h"

#include <cmath>

#include "libdem/analysis/stress.h"

namespace dem::analysis {

std::vector<Mat3d> body_stresses(const Snapshot& s) {
  std::vector<Mat3d> stress(s.count());
  for (const SnapshotContact& c : s.contacts) {
    const Vec3d arm = c.point - s.position[c.a];
    add_to(stress[c.a], outer(arm, c.force), -1 / s.volume[c.a]);
    if (!c.wall) add_to(stress[c.b], outer(arm - c.branch, c.force), 1 / s.volume[c.b]);
  }
  for (Mat3d& m : stress) m = symmetric_part(m);
  return stress;
}

ForceChains force_chains_of(const Snapshot& s, const Pairs& pairs, double angle) {
  ForceChains result;
  const std::vector<Mat3d> stress = body_stresses(s);
  result.load.assign(s.count(), 0);
  result.direction.resize(s.count());
  std::vector<std::uint8_t> touched(s.count(), 0);
  for (const SnapshotContact& c : s.contacts) {
    touched[c.a] = 1;
    if (!c.wall) touched[c.b] = 1;
  }
  double bearing = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (touched[i] == 0) continue;
    const Principal p = principal_of(stress[i], s.dimension);
    result.load[i] = p.value[0];
    result.direction[i] = p.axis[0];
    result.mean_load += p.value[0];
    bearing += 1;
  }
  if (bearing > 0) result.mean_load /= bearing;
  const auto linked = [&](std::size_t i, const Vec3d& l) {  // (2), (3)
    return result.load[i] > result.mean_load && std::abs(dot(l, result.direction[i])) >= std::cos(angle) * norm(l);
  };
  Clusters clusters(s.count());
  std::vector<std::uint32_t> links(s.count(), 0);
  result.link.assign(pairs.bodies.size(), 0);
  for (std::size_t k = 0; k < pairs.bodies.size(); ++k) {
    const Pair& p = pairs.bodies[k];
    if (!(p.pressing > 0) || !linked(p.a, p.branch) || !linked(p.b, p.branch)) continue;
    result.link[k] = 1;
    clusters.join(p.a, p.b);
    ++links[p.a];
    ++links[p.b];
  }
  const Clusters::List list = clusters.list(3);
  result.of_body = list.of_body;
  result.chains.resize(list.sizes.size());
  for (std::size_t k = 0; k < list.sizes.size(); ++k) result.chains[k].bodies = list.sizes[k];
  for (std::size_t i = 0; i < s.count(); ++i)
    if (list.of_body[i] != Clusters::none && links[i] > 2) ++result.chains[list.of_body[i]].branches;
  for (std::size_t k = 0; k < pairs.bodies.size(); ++k) {
    const Pair& p = pairs.bodies[k];
    if (result.link[k] == 0) continue;
    if (list.of_body[p.a] == Clusters::none) {
      result.link[k] = 0;  // two bodies are no chain
      continue;
    }
    Chain& chain = result.chains[list.of_body[p.a]];
    ++chain.links;
    chain.length += norm(p.branch);
  }
  return result;
}

}  // namespace dem::analysis
