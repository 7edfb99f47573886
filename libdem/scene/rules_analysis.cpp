// Rules of [analysis]: quantities that there are, whole numbers of boxes, a region that is one.
#include <fmt/format.h>

#include <cmath>

#include "libdem/analysis/quantities.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/rules.h"

namespace dem {

void check_analysis_rules(const RuleContext& context) {
  const AnalysisSpec& a = context.scene.analysis;
  std::vector<std::string> names{"all"};
  for (const analysis::Quantity& q : analysis::quantities()) names.emplace_back(q.name);
  for (const std::string& name : a.what)
    if (name != "all" && analysis::find_quantity(name) == nullptr)
      context.wrong("analysis", 0, "what",
                    fmt::format("there is no quantity \"{}\"{}; dem list quantities shows them all", name,
                                suggestion(name, names)));
  for (int k = 0; k < 3; ++k)
    if (a.boxes[k] != std::floor(a.boxes[k]) || a.boxes[k] > 1e6)
      return context.wrong("analysis", 0, "boxes", "allowed whole numbers, 0 to 1000000");
  if (a.region_lower == a.region_upper) return;
  for (int k = 0; k < context.scene.dimension; ++k)
    if (!(a.region_lower[k] < a.region_upper[k]))
      return context.wrong("analysis", 0, "region_upper",
                           fmt::format("allowed region_upper > region_lower in {}", "xyz"[k]));
}

}  // namespace dem
