#include "libdem/validate/regular_array.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::validate {

std::vector<bool> in_the_middle(const World& w) {
  const double most = std::numeric_limits<double>::max();
  Vec3d lower{most, most, most}, upper{-most, -most, -most};
  for (const contact::Motion& m : w.particles.motion)
    for (int k = 0; k < 3; ++k) {
      lower[k] = std::min(lower[k], m.position[k]);
      upper[k] = std::max(upper[k], m.position[k]);
    }
  const Vec3d centre = (lower + upper) * 0.5, quarter = (upper - lower) * 0.25;
  std::vector<bool> middle(w.particles.count());
  for (std::size_t i = 0; i < middle.size(); ++i) {
    bool inside = true;
    for (int k = 0; k < 3; ++k)
      inside = inside && std::abs(w.particles.motion[i].position[k] - centre[k]) <= 1.05 * quarter[k];
    middle[w.particles.id[i]] = inside;
  }
  return middle;
}

Vec3d stress_of(const World& w, const std::vector<bool>& bodies) {
  Vec3d sum{};
  for (const ContactReport& c : touching_contacts(w)) {
    const int sides = (bodies[c.a] ? 1 : 0) + (!c.wall && bodies[c.b] ? 1 : 0);
    for (int k = 0; k < 3; ++k) sum[k] -= sides * c.force[k] * c.normal[k];
  }
  return sum;
}

}  // namespace dem::validate
