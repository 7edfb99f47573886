#include "libdem/rattlers.h"

namespace dem {

std::vector<std::uint8_t> rattlers(std::size_t bodies, const std::vector<BodyPair>& pairs,
                                   const std::vector<std::uint32_t>& fixed, std::uint32_t least) {
  std::vector<std::uint32_t> start(bodies + 1, 0), degree(bodies, 0);
  for (const auto& [a, b] : pairs) {
    ++degree[a];
    ++degree[b];
  }
  for (std::size_t i = 0; i < bodies; ++i) start[i + 1] = start[i] + degree[i];
  std::vector<std::uint32_t> partner(2 * pairs.size()), next(start.begin(), start.end());
  for (const auto& [a, b] : pairs) {
    partner[next[a]++] = b;
    partner[next[b]++] = a;
  }
  std::vector<std::uint8_t> rattles(bodies, 0);
  std::vector<std::uint32_t> removed;
  const auto judge = [&](std::uint32_t i) {
    if (rattles[i] != 0 || degree[i] + (fixed.empty() ? 0 : fixed[i]) >= least) return;
    rattles[i] = 1;
    removed.push_back(i);
  };
  for (std::uint32_t i = 0; i < bodies; ++i) judge(i);
  for (std::size_t k = 0; k < removed.size(); ++k)
    for (std::uint32_t p = start[removed[k]]; p < start[removed[k] + 1]; ++p) {
      --degree[partner[p]];
      judge(partner[p]);
    }
  return rattles;
}

}  // namespace dem
