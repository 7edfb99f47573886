#include "libdem/contact_share.h"

#include <algorithm>

namespace dem {

void share_stiffness(std::span<PartContact> contacts, std::vector<double>& depth) {
  const std::size_t n = contacts.size();
  for (std::size_t k = 0; k < n; ++k)  // deepest ways (Floyd and Warshall's order)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        depth[i * n + j] = std::max(depth[i * n + j], std::min(depth[i * n + k], depth[k * n + j]));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      double& same = depth[i * n + j];  // (4)
      same = i == j ? 1 : std::clamp(same / std::min(contacts[i].overlap, contacts[j].overlap), 0.0, 1.0);
    }
  for (std::size_t i = 0; i < n; ++i) {
    PartContact& c = contacts[i];
    double sum = 0, joined = 0;
    Vec3d first{};
    c.common_overlap = c.overlap;
    for (std::size_t j = 0; j < n; ++j) {
      const PartContact& o = contacts[j];
      const double same = depth[i * n + j], weight = same * o.cover * o.weight;
      if (!(weight > 0)) continue;
      sum += weight;
      first += weight * o.centre;
      if (i == j) continue;
      joined = std::max(joined, same);
      c.common_overlap = std::max(c.common_overlap, same * o.overlap);  // (2)
    }
    const double whole = sum + (1 - joined) * (1 - c.cover) * c.weight, own = c.cover * c.weight;
    c.share = own > 0x1p-40 * whole ? own / whole : 0;         // (1)
    c.common_centre = sum > 0 ? first * (1 / sum) : c.centre;  // (3)
  }
}

void pool_histories(std::span<const PartContact> contacts, const std::vector<double>& same,
                    std::span<contact::History> histories) {
  const std::size_t n = contacts.size();
  std::vector<contact::History> pooled(histories.begin(), histories.end());
  for (std::size_t j = 0; j < n; ++j) {
    const contact::History& from = histories[j];
    if (!(from.overlap > 0)) continue;
    double whole = 0;
    for (std::size_t i = 0; i < n; ++i) whole += same[i * n + j] * contacts[i].share;
    for (std::size_t i = 0; i < n; ++i) {
      const double part = same[i * n + j] * contacts[i].share / std::max(1.0, whole);
      if (i == j || !(part > 0)) continue;
      pooled[i].force_t += part * from.force_t;
      pooled[i].twist += part * from.twist;
      pooled[j].force_t -= part * from.force_t;
      pooled[j].twist -= part * from.twist;
      if (!(histories[i].overlap > 0) && same[i * n + j] > 0.5 && from.overlap > pooled[i].overlap) {
        pooled[i].overlap = from.overlap;
        pooled[i].normal = from.normal;
      }
    }
  }
  std::copy(pooled.begin(), pooled.end(), histories.begin());
}

}  // namespace dem
