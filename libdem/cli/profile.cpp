#include "libdem/cli/profile.h"

#include <fmt/format.h>

#include "libdem/cli/progress.h"
#include "libdem/detection.h"
#include "libdem/laws_of_scene.h"

namespace dem::cli {
namespace {

void phases(const PhaseTimes& t) {
  const double steps = static_cast<double>(t.particle_steps);
  const auto line = [&](const char* name, double seconds) {
    fmt::print("{:<24} {:>10.3f} {:>8.1f} {:>22.1f}\n", name, seconds, t.loop > 0 ? 100 * seconds / t.loop : 0,
               steps > 0 ? 1e9 * seconds / steps : 0);
  };
  fmt::print("\n{:<24} {:>10} {:>8} {:>22}\n", "phase", "seconds", "% loop", "ns per particle-step");
  line("candidates", t.broad);
  line("contacts and laws", t.query);
  line("sums and motion", t.integrate);
  line("walls, rain, outlets", t.walls);
  line("loop", t.loop);
  line("output", t.output);
}

const char* method_of(const World& world, shapes::Kind a, shapes::Kind b) {
  const contact::MethodInfo* m = detection::choose(a, b, world.scene);
  if (m != nullptr) return detection::closed_form(a, b, world.scene) ? "spheres" : m->name.data();
  return "-";
}

void candidates(const std::string& pair, const char* method, const Tally& t) {
  if (t.candidates == 0) return;
  const auto n = static_cast<double>(t.candidates), contacts = static_cast<double>(t.touching);
  const auto share = [n](std::uint64_t count) { return 100 * static_cast<double>(count) / n; };
  const auto of_contacts = [&](std::uint64_t count) {
    return t.touching > 0 ? fmt::format("{:.2g}", static_cast<double>(count) / contacts) : "-";
  };
  const std::uint64_t known = t.by_displacement + t.by_spheres + t.by_axis + t.touching;
  fmt::print("{:<36} {:<18} {:>8} {:>10.1f} {:>8.1f} {:>6.1f} {:>7.1f} {:>9.1f} {:>8.1f} {:>13} {:>11} {:>11}\n", pair,
             method, rate_text(n), share(t.by_displacement), share(t.by_spheres), share(t.by_axis),
             t.candidates > known ? share(t.candidates - known) : 0, share(t.touching), 1e9 * t.seconds / n,
             t.touching > 0 ? fmt::format("{:.1f}", 1e9 * t.seconds / contacts) : "-", of_contacts(t.uncertified),
             of_contacts(t.handed_over));
}

}  // namespace

void print_profile(const World& world, int threads) {
  phases(world.times);
  fmt::print("\nlaw {}\n", law_title(world.scene.law));
  fmt::print("{:<36} {:<18} {:>8} {:>10} {:>8} {:>6} {:>7} {:>9} {:>8} {:>13} {:>11} {:>11}\n", "pair", "method",
             "asked", "% way", "% ball", "% axis", "% apart", "% touching", "ns", "ns / contact", "uncertified",
             "handed over");
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = 0; b < shapes::kind_count; ++b) {
      const auto ka = static_cast<shapes::Kind>(a), kb = static_cast<shapes::Kind>(b);
      candidates(fmt::format("{}, {}", shapes::name_of(ka), shapes::name_of(kb)), method_of(world, ka, kb),
                 world.profile.pairs[a][b]);
    }
  candidates("bodies of parts", "by parts", world.profile.parts);
  fmt::print(
      "asked: candidates times steps; refused without a query since they have not moved enough (way), or by bounding "
      "spheres (ball),\nor by one axis, as a rule that of the last proof (axis); apart: after a full query. Times are "
      "of "
      "one thread{}, laws included.\n",
      threads > 1 ? fmt::format(" of {}", threads) : "");
}

}  // namespace dem::cli
