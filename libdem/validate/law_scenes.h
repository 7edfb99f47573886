// The two scenes that the cases of law_extremes.h are made of, with what a case sets, and how a case says what it
// found.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "libdem/validate/law_extremes.h"

namespace dem::validate {

// A scene with the settings of a case.
class Case {
 public:
  Case(const std::string& law, bool two_balls) : two_(two_balls) { set("law.name", law); }
  Case& set(const std::string& key, double value) { return set(key, fmt::format("{}", value)); }
  Case& set(const std::string& key, const Vec3d& v) { return set(key, fmt::format("[{}, {}, {}]", v.x, v.y, v.z)); }
  Case& set(const std::string& key, const std::string& value) {
    list_.push_back(key + "=" + value);
    return *this;
  }
  World build() const;

 private:
  bool two_;
  std::vector<std::string> list_;
};

struct Ball {  // of law_extremes.toml
  static constexpr double radius = 1e-3, density = 2500, young = 1e8, stiffness = 1e4, poisson = 0.3;
  static constexpr double mass = density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
};
constexpr double earth = 9.81;  // m/s²
constexpr double infinity = std::numeric_limits<double>::infinity();

// `within` with the relative error beside what was found.
Row right(const std::string& criterion, double got, double expected, double relative, const std::string& unit = "");
// The scene is refused, or the run stops within so many steps, by a message that holds these words.
Row refused(const std::string& criterion, const Case& setting, const std::string& words);
Row stops(const std::string& criterion, const Case& setting, std::uint64_t steps, const std::string& words);

// Steps on until a contact has been and is over; the largest overlap on the way. Throws RunError after `most` steps.
double until_parted(World& world, std::uint64_t most = 4000000);
void step_for(World& world, double time);
Motion motion_of(const World& world, std::uint64_t id);
double total(const Energies& e);

}  // namespace dem::validate
