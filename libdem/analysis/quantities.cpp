#include "libdem/analysis/quantities.h"

namespace dem::analysis {

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{};
  return list;
}

const Quantity* find_quantity(std::string_view name) {
  for (const Quantity& q : quantities())
    if (name == q.name) return &q;
  return nullptr;
}

}  // namespace dem::analysis
