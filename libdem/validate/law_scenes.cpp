#include "libdem/validate/law_scenes.h"

#include <algorithm>

#include "libdem/build.h"
#include "libdem/scene/data_files.h"

namespace dem::validate {

World Case::build() const {
  return build_world(load_scene(scenes_folder() + (two_ ? "/law_extremes_pair.toml" : "/law_extremes.toml"), list_));
}

Row right(const std::string& criterion, double got, double expected, double relative, const std::string& unit) {
  Row row = within(criterion, got, expected, relative, unit);
  row.got += fmt::format(" (error {:.1e})", std::abs(got / expected - 1));
  return row;
}

namespace {

Row by_message(const std::string& criterion, const char* how, const std::string& words, const std::string& message) {
  std::string line = message.substr(0, message.find('\n'));
  const bool found = message.find(words) != std::string::npos;
  const std::size_t at = std::min(line.find(words), line.size());
  if (at > 40) line = "… " + line.substr(at - 40);
  return is_true(criterion, found, fmt::format("{}: … {} …", how, words), line);
}

}  // namespace

Row refused(const std::string& criterion, const Case& setting, const std::string& words) {
  try {
    setting.build();
  } catch (const InputError& error) {
    return by_message(criterion, "refused", words, error.what());
  }
  return is_true(criterion, false, "refused: … " + words + " …", "accepted");
}

Row stops(const std::string& criterion, const Case& setting, std::uint64_t steps, const std::string& words) {
  World world = setting.build();
  try {
    for (std::uint64_t i = 0; i < steps; ++i) advance(world, 1);
  } catch (const RunError& error) {
    return by_message(criterion, "stops", words, error.what());
  }
  return is_true(criterion, false, "stops: … " + words + " …", "went on");
}

double until_parted(World& world, std::uint64_t most) {
  double deepest = 0;
  bool met = false;
  for (std::uint64_t i = 0; i < most; ++i) {
    advance(world, 1);
    const std::vector<ContactReport> touching = touching_contacts(world);
    if (met && touching.empty()) return deepest;
    for (const ContactReport& c : touching) deepest = std::max(deepest, c.overlap);
    met = met || !touching.empty();
  }
  throw RunError(met ? "the bodies do not part" : "the bodies do not meet");
}

void step_for(World& world, double time) {
  for (const double end = world.time() + time; world.time() < end;) advance(world, 1);
}

Motion motion_of(const World& world, std::uint64_t id) { return world.particles.motion[order_by_id(world)[id]]; }

double total(const Energies& e) { return e.translational + e.rotational + e.potential + e.elastic; }

}  // namespace dem::validate
