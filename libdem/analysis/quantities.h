// The list of quantities: what `dem analyse --what` knows, `dem list quantities` prints and the tests run over.
#pragma once

#include <string_view>
#include <vector>

#include "libdem/analysis/result.h"

namespace dem::analysis {

struct Snapshot;
struct Settings;

struct Quantity {
  const char* name;      // snake_case, one word where it can be
  const char* what;      // one line
  const char* equation;  // source: "(9.42), (9.43)"
  bool needs_contacts;
  bool costly;  // only when it is named, or with --what all
  Result (*of)(const Snapshot&, const Settings&);
};

const std::vector<Quantity>& quantities();
const Quantity* find_quantity(std::string_view name);  // null: unknown

}  // namespace dem::analysis
