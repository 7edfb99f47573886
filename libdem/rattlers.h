// Bodies that the others do not hold: with fewer than `least` contacts, leaving out those of other such bodies, until
// nothing changes. What is left (the least-core of the graph) does not depend on the order of removal.
// Cost: O(bodies + pairs). Tests: tests/libdem/analysis_coordination.cpp.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace dem {

using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

// pairs: each once. fixed: contacts per body with what is never removed (walls); empty: none. 1 where a body rattles.
std::vector<std::uint8_t> rattlers(std::size_t bodies, const std::vector<BodyPair>& pairs,
                                   const std::vector<std::uint32_t>& fixed, std::uint32_t least);

}  // namespace dem
