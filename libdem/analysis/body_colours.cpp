#include "libdem/analysis/body_colours.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "libdem/analysis/displacement.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/pairs.h"
#include "libdem/analysis/stress.h"
#include "libdem/scene/where.h"

namespace dem::analysis {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Band {
  const char *word, *group, *label;
};
constexpr std::array<Band, 7> bands{{{"layers", "layers", "layers"},
                                     {"layers_x", "x", "layers along x"},
                                     {"layers_y", "y", "layers along y"},
                                     {"layers_z", "z", "layers along z"},
                                     {"position", "position", "position"},
                                     {"density", "density", "density"},
                                     {"sizes", "size", "radius"}}};

struct Field {
  const char *word, *label;
  bool since;  // the reference
};
constexpr std::array<Field, 8> fields{{{"displacement", "displacement (m)", true},
                                       {"strain", "shear strain", true},
                                       {"volume_change", "volume change", true},
                                       {"rotation", "rotation (rad)", true},
                                       {"non_affine", "non-affine (m)", true},
                                       {"vorticity", "vorticity (1/s)", false},
                                       {"shear_rate", "shear rate (1/s)", false},
                                       {"contacts", "contacts", false}}};

template <class Of>
std::vector<double> of_fitted(const std::vector<LocalGradient>& list, Of of) {
  std::vector<double> values;
  for (const LocalGradient& g : list) values.push_back(g.fitted ? of(g) : none);
  return values;
}

std::vector<double> since_reference(const Snapshot& s, const std::string& word, const Snapshot& reference) {
  const Displacements u = displacements(s, reference);
  if (word == "displacement") {
    std::vector<double> values;
    for (std::size_t i = 0; i < s.count(); ++i)
      values.push_back(u.reference[i] == Groups::none ? none : norm(u.of_body[i]));
    return values;
  }
  const std::vector<LocalGradient> local = displacement_gradients(s, reference, u);
  if (word == "strain")
    return of_fitted(local, [&](const LocalGradient& g) { return deviator(finite_strain(g.gradient), s.dimension); });
  if (word == "volume_change")
    return of_fitted(local, [](const LocalGradient& g) { return volume_change(g.gradient); });
  if (word == "rotation") return of_fitted(local, [](const LocalGradient& g) { return norm(curl_of(g.gradient)); });
  return of_fitted(local, [](const LocalGradient& g) { return std::sqrt(g.left_over); });
}

std::vector<double> of_now(const Snapshot& s, const std::string& word) {
  if (word == "contacts") {
    std::vector<double> count(s.count(), 0.0);
    const Pairs pairs = pairs_of(s);
    for (const Pair& p : pairs.bodies) {
      count[p.a] += 1;
      count[p.b] += 1;
    }
    for (const Pair& p : pairs.walls) count[p.a] += 1;
    return count;
  }
  const std::vector<LocalGradient> rate = velocity_gradients(s);
  if (word == "vorticity") return of_fitted(rate, [](const LocalGradient& g) { return norm(curl_of(g.gradient)); });
  return of_fitted(rate, [&](const LocalGradient& g) { return deviator(symmetric_part(g.gradient), s.dimension); });
}

}  // namespace

const std::vector<std::string>& body_colour_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> list;
    for (const Band& b : bands) list.emplace_back(b.word);
    for (const Field& f : fields) list.emplace_back(f.word);
    return list;
  }();
  return words;
}

bool needs_reference(const std::string& word) {
  for (const Field& f : fields)
    if (word == f.word) return f.since;
  return true;
}

BodyColours body_colours(const Snapshot& s, const std::string& word, const Snapshot* given) {
  const Snapshot& reference = given != nullptr ? *given : s;
  BodyColours colours;
  for (const Band& b : bands) {
    if (word != b.word) continue;
    const Groups groups = groups_of(reference, b.group, &reference);
    colours.label = b.label;
    colours.names = groups.names;
    for (const std::uint32_t at : places_in(s, reference)) {
      const std::uint32_t group = at == Groups::none ? Groups::none : groups.of_body[at];
      colours.values.push_back(group == Groups::none ? none : static_cast<double>(group));
    }
    return colours;
  }
  for (const Field& f : fields) {
    if (word != f.word) continue;
    colours.label = f.label;
    colours.values = f.since ? since_reference(s, word, reference) : of_now(s, word);
    return colours;
  }
  throw InputError(fmt::format("colour '{}' is unknown; one of {}", word, fmt::join(body_colour_words(), ", ")));
}

}  // namespace dem::analysis
