#include "libdem/scene/nearest.h"

#include <algorithm>

namespace dem {

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t m = b.size();
  std::vector<int> before(m + 1), last(m + 1), row(m + 1);
  for (std::size_t j = 0; j <= m; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= m; ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[m];
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  const int allowed = std::max(2, static_cast<int>(name.size()) / 3);
  std::string best;
  int fewest = allowed + 1;
  for (const std::string& c : candidates) {
    const int d = edit_distance(name, c);
    if (d < fewest && d < static_cast<int>(std::max(name.size(), c.size()))) {
      fewest = d;
      best = c;
    }
  }
  return best;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string near = nearest_name(name, candidates);
  if (!near.empty()) return "; did you mean " + near + "?";
  if (candidates.empty() || candidates.size() > 12) return "";
  std::string out = "; known:";
  for (const std::string& c : candidates) out += " " + c;
  return out;
}

}  // namespace dem
