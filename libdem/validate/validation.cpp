#include "libdem/validate/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "libdem/run.h"
#include "libdem/scene/data_files.h"

namespace dem::validate {

namespace {

std::string text(double v, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.5g}", v) : fmt::format("{:.5g} {}", v, unit);
}

}  // namespace

Row in_band(const std::string& criterion, double got, double lower, double upper, const std::string& unit) {
  return {criterion, fmt::format("{:.5g} to {}", lower, text(upper, unit)), text(got, unit),
          got >= lower && got <= upper};
}

Row within(const std::string& criterion, double got, double expected, double relative, const std::string& unit) {
  return {criterion, fmt::format("{} within {:.3g} %", text(expected, unit), 100 * relative), text(got, unit),
          std::abs(got - expected) <= relative * std::abs(expected)};
}

Row near(const std::string& criterion, double got, double expected, double absolute, const std::string& unit) {
  return {criterion, fmt::format("{:.5g} ± {}", expected, text(absolute, unit)), text(got, unit),
          std::abs(got - expected) <= absolute};
}

Row at_most(const std::string& criterion, double got, double upper, const std::string& unit) {
  return {criterion, "<= " + text(upper, unit), text(got, unit), got <= upper};
}

Row at_least(const std::string& criterion, double got, double lower, const std::string& unit) {
  return {criterion, ">= " + text(lower, unit), text(got, unit), got >= lower};
}

Row for_information(const std::string& what, double got, const std::string& unit) {
  return {what, "(for information)", text(got, unit), true, false};
}

Row is_true(const std::string& criterion, bool pass, const std::string& expected, const std::string& got) {
  return {criterion, expected, got, pass};
}

const Wall& wall_named(const World& world, const std::string& name) {
  for (const Wall& w : world.walls)
    if (w.name == name) return w;
  throw RunError("the scene has no wall \"" + name + "\"");
}

Runs::Runs(std::string scene_path, std::string folder, int threads)
    : scene_path_(std::move(scene_path)), folder_(std::move(folder)), threads_(threads) {}

World Runs::build(const std::vector<std::string>& overrides) const {
  return build_world(load_scene(scene_path_, overrides));
}

World Runs::run(const std::vector<std::string>& overrides, const std::string& label, const Observer& observe) {
  World world = build(overrides);
  RunOptions options;
  if (!folder_.empty()) options.folder = label.empty() ? folder_ : folder_ + "/" + label;
  constexpr std::size_t few = 200;  // bodies: a step of so few is shorter than threads take to meet
  options.threads = world.particles.count() < few ? 1 : threads_;
  options.observe = observe;
  if (observe) observe(world);
  dem::run(world, options, false);
  uncertified_ += world.counters.uncertified;
  contact_steps_ += world.counters.contact_steps;
  return world;
}

bool Result::pass() const {
  const auto judged = [](const Row& r) { return r.judged; };
  return std::any_of(rows.begin(), rows.end(), judged) &&
         std::all_of(rows.begin(), rows.end(), [](const Row& r) { return r.pass; });
}

Result carry_out(const Validation& validation, const std::string& folder, int threads) {
  const auto start = std::chrono::steady_clock::now();
  Result result;
  Runs runs((std::filesystem::path(scenes_folder()) / validation.scene).string(), folder, threads);
  try {
    result.rows = validation.check(runs);
    if (runs.contact_steps() > 0) {
      Row certified = for_information("answers that are not certified", 0);
      certified.got = fmt::format("{} of {}", runs.uncertified(), runs.contact_steps());
      result.rows.push_back(certified);
    }
  } catch (const InputError& error) {
    result.rows.push_back(is_true("the scene is accepted", false, "accepted", error.what()));
  } catch (const RunError& error) {
    result.rows.push_back(is_true("the run comes to its end", false, "finished", error.what()));
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace dem::validate
