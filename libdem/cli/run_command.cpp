// dem run and dem resume.
#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <filesystem>

#include "libdem/cli/commands.h"
#include "libdem/cli/folder.h"
#include "libdem/cli/profile.h"
#include "libdem/cli/progress.h"
#include "libdem/io/io.h"
#include "libdem/run.h"

namespace dem::cli {

namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler may not touch it

extern "C" void ask_to_stop(int signal) {
  stop_asked.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);  // a second Ctrl-C ends the program at once
}

void report(const World& world, const std::string& folder) {
  const double per_second = world.times.loop > 0 ? 1 / world.times.loop : 0;
  fmt::print("{}: {} steps, t = {:.6g} s, {} particles\n", folder, world.step, world.time(), world.particles.count());
  fmt::print("time loop {}, output {}\n", duration_text(world.times.loop), duration_text(world.times.output));
  const Counters& c = world.counters;
  fmt::print("queries {}, contact-steps {} ({}per s of the loop), not converged {}, uncertified {}, handed over {}\n",
             c.queries, c.contact_steps, rate_text(static_cast<double>(c.contact_steps) * per_second), c.not_converged,
             c.uncertified, c.handed_over);
  for (const OutletRecord& o : world.outlets) fmt::print("outlet {}: {} bodies, {:.6g} kg\n", o.name, o.count, o.mass);
  for (const RainRecord& r : world.rains)
    fmt::print("rain {}: {} bodies, {:.6g} kg{}\n", r.name, r.count, r.mass,
               r.waits > 0 ? fmt::format(", waited for a free place at {} steps", r.waits) : "");
  for (const EventRecord& e : world.events)
    fmt::print("event {}: {}\n", e.name,
               e.done > 0 ? fmt::format("t = {:.6g} s", static_cast<double>(e.done) * world.time_step.dt) : "not yet");
  if (world.ended_by > 0) fmt::print("ended by {}\n", ended_by(world));
  fmt::print("state_hash {:016x}\n", state_hash(world));
}

int carry_out(World& world, const std::string& folder, int threads, bool quiet, bool resumed) {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  Progress progress(world, total_steps(world));
  RunOptions options;
  options.folder = folder;
  options.threads = threads > 0 ? threads : default_threads(world);
  options.interrupt = &stop_asked;
  if (!quiet) options.progress = [&](const World& w) { progress.show(w); };
  const RunEnd end = run(world, options, resumed);
  if (!quiet) progress.end();
  if (end == RunEnd::interrupted) {
    fmt::print(stderr, "stopped at step {} of {}; go on with: dem resume {}\n", world.step, total_steps(world), folder);
    return interrupted;
  }
  report(world, folder);
  if (world.profile.timed) print_profile(world, options.threads);
  return success;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  check_folder(arguments.folder, arguments.scene, arguments.force);
  World world = build_world(load_scene(arguments.scene, arguments.overrides));  // bad input ends here, nothing written
  if (!arguments.quiet)
    fmt::print(stderr, "{} particles, {} walls, {} steps of {:.4g} s (limit {:.4g} s: {})\n", world.particles.count(),
               world.walls.size(), total_steps(world), world.time_step.dt, world.time_step.limit,
               world.time_step.limited_by);
  if (arguments.force) clear_folder(arguments.folder);
  world.profile.timed = arguments.profile;
  return carry_out(world, arguments.folder, arguments.threads, arguments.quiet, false);
}

int resume_command(const ResumeArguments& arguments) {
  World world = build_world(scene_of_run(arguments.folder));
  world.profile.timed = arguments.profile;
  const auto checkpoint = io::read_last_checkpoint(arguments.folder);
  if (!checkpoint) {
    fmt::print(stderr, "{}: no checkpoint; starts again from the beginning\n", arguments.folder);
    clear_folder(arguments.folder);
    return carry_out(world, arguments.folder, arguments.threads, arguments.quiet, false);
  }
  load_state(world, checkpoint->state);
  const std::filesystem::path folder(arguments.folder);
  if (finished(world) && std::filesystem::exists(folder / "final.csv") &&
      std::filesystem::exists(folder / "summary.json")) {
    fmt::print("{}: finished already, at step {}\n", arguments.folder, world.step);
    return success;
  }
  if (!arguments.quiet) fmt::print(stderr, "goes on at step {} of {}\n", world.step, total_steps(world));
  return carry_out(world, arguments.folder, arguments.threads, arguments.quiet, true);
}

}  // namespace dem::cli
