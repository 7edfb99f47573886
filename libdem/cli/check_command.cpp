// dem check: what a scene is, what its bodies will feel, and what running it would cost.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "libdem/cli/check_parts.h"
#include "libdem/cli/commands.h"
#include "libdem/forecast/clock.h"
#include "libdem/forecast/warnings.h"
#include "libdem/run.h"

namespace dem::cli {

void head(const std::string& title) { fmt::print("\n{}\n", title); }
void line(const std::string& name, const std::string& text) { fmt::print("  {:<14}{}\n", name, text); }

namespace {

using nlohmann::json;

json as_json(const World& world, const forecast::Cost& cost, double base, const std::vector<std::string>& warnings) {
  const TimeStep& t = world.time_step;
  return {{"bodies", world.particles.count()},
          {"dt", t.dt},
          {"limit", std::isfinite(t.limit) ? json(t.limit) : json(nullptr)},
          {"limited_by", t.limited_by},
          {"steps", cost.steps},
          {"seconds", cost.total},
          {"threads", cost.threads},
          {"seconds_on_threads", cost.total_on_threads},
          {"seconds_set_up", cost.set_up},
          {"seconds_loop", cost.loop},
          {"seconds_output", cost.output},
          {"bytes", base + cost.memory.total() + cost.picture_memory},
          {"disk_bytes", cost.disk},
          {"warnings", warnings}};
}

}  // namespace

int check_command(const CheckArguments& arguments) {
  const double base = forecast::peak_of_process(), begin = forecast::thread_seconds();
  const World world = build_world(load_scene(arguments.scene, arguments.overrides));
  const double set_up = forecast::thread_seconds() - begin;
  const forecast::Loads loads = forecast::expected_loads(world);
  const std::vector<BodyGroup> groups = body_groups(world);
  const auto pairs = forecast::pair_forecasts(world, groups, loads);
  std::vector<std::string> warnings = forecast::dynamic_warnings(world, loads, pairs);
  for (const std::string& hint : forecast::unit_hints(world)) warnings.push_back(hint);
  if (!arguments.json) {
    fmt::print("{}{}{}\n", arguments.scene, world.scene.title.empty() ? "" : ": ", world.scene.title);
    print_inventory(world);
    print_model(world);
    print_time_step(world, groups, loads, pairs);
    print_loads(world, loads, pairs);
    std::fflush(stdout);  // what follows is measured and takes a moment
  }
  const forecast::Cost cost = forecast::expected_cost(world, loads, default_threads(world), set_up);
  for (const std::string& w : forecast::cost_warnings(cost)) warnings.push_back(w);
  if (arguments.json) {
    fmt::print("{}\n", as_json(world, cost, base, warnings).dump(2));
    return success;
  }
  print_cost(cost, base);
  head(warnings.empty() ? "warnings: none" : "warnings");
  for (const std::string& w : warnings) fmt::print("  {}\n", w);
  return success;
}

}  // namespace dem::cli
