#include "libdem/forecast/cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/broad_phase/candidates.h"
#include "libdem/forecast/clock.h"
#include "libdem/forecast/output_cost.h"
#include "libdem/forecast/packing.h"
#include "libdem/run.h"

namespace dem::forecast {
namespace {

// Steps of a world that is thrown away, on one thread: what one takes, and what one rebuild of its list takes. The
// first step pays for fresh memory and does not count.
StepCost measure(World world) {
  constexpr double enough = 0.4, longest = 3;  // s
  constexpr int fewest = 5, most = 2000;
  StepCost cost;
  if (world.particles.count() == 0) return cost;
  world.scene.run.max_uncertified_share = 1;
  try {
    advance(world, 1);
    double begin = thread_seconds();
    for (int i = 0; i < 2; ++i) rebuild_candidates(world, 1);
    cost.rebuild = 0.5 * (thread_seconds() - begin);
    const std::uint64_t rebuilds = world.counters.rebuilds;
    int done = 0;
    double elapsed = 0;
    begin = thread_seconds();
    while (done < most && elapsed < (done < fewest ? longest : enough)) {
      advance(world, 1);
      ++done;
      elapsed = thread_seconds() - begin;
    }
    const double rebuilding = static_cast<double>(world.counters.rebuilds - rebuilds) * cost.rebuild;
    cost.step = std::max(0.1 * elapsed, elapsed - rebuilding) / done;
  } catch (const RunError&) {  // the run will say so itself
  }
  return cost;
}

// How much faster `threads` threads are than one, by the clock on the wall: the best of three turns each.
double speed_up(const World& world, int threads, double step) {
  if (threads <= 1 || world.particles.count() == 0) return 1;
  const int steps = static_cast<int>(std::clamp(0.05 / std::max(step, 1e-9), 2.0, 500.0));
  double best[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  try {
    World copy = world;
    copy.scene.run.max_uncertified_share = 1;
    advance(copy, threads);
    for (int turn = 0; turn < 6; ++turn) {
      const double begin = wall_seconds();
      for (int i = 0; i < steps; ++i) advance(copy, turn % 2 == 0 ? 1 : threads);
      best[turn % 2] = std::min(best[turn % 2], wall_seconds() - begin);
    }
  } catch (const RunError&) {
    return 1;
  }
  return std::clamp(best[0] / best[1], 1.0, static_cast<double>(threads));
}

// Contacts with walls per body of a packed bed on a ground of `area`: bodies that stand along the floor and the sides.
double wall_contacts(const World& world, const Loads& loads) {
  const double n = static_cast<double>(world.particles.count());
  bool enclosed = world.walls.size() > 1;
  for (const Wall& w : world.walls) enclosed = enclosed || w.mesh;
  if (world.walls.empty() || !(loads.ground_area > 0)) return 0;
  double radius = 0;
  for (const Motion& m : world.particles.motion) radius += m.equivalent_radius / n;
  if (world.scene.dimension == 2) {
    const double width = loads.ground_area / loads.thickness;
    return (width + (enclosed ? 2 * loads.bed_height : 0)) / (2 * radius * n);
  }
  const double sides = enclosed ? 4 * std::sqrt(loads.ground_area) * loads.bed_height : 0;
  return std::min(1.0, (loads.ground_area + sides) / (4 * radius * radius * n));
}

std::uint64_t times_in(double time, double interval) {
  return interval > 0 ? static_cast<std::uint64_t>(std::floor(time / interval * (1 + 1e-12))) : 0;
}

// Rebuilds per step where bodies move at `speed`.
double rebuilds_per_step(const World& world, double speed) {
  const double moved = speed * world.time_step.dt / (0.5 * world.skin);
  const double own = world.skin > 0 ? std::min(1.0, moved) : 1;
  const auto every = static_cast<double>(world.scene.run.rebuild_every);
  return every > 0 ? std::max(own, 1 / every) : own;
}

// Share of a run in which bodies lie on each other, when all have come down after `fall` seconds: it grows evenly from
// none at the start to all after twice that, as bodies bounce before they lie (as seen in a hopper that fills).
double packed_share(double fall, double time) {
  if (!(fall > 0) || !(time > 0)) return 1;
  return time < 2 * fall ? time / (4 * fall) : 1 - fall / time;
}

// Share of a run that its bodies count for when they can leave: once the last gate is open (without gates: once they
// have come down), all the time but three tenths, which is within a factor of 2 of none and of half of them leaving.
double present_share(const World& world, double fall, double time) {
  if (world.outlets.empty() || !(time > 0)) return 1;
  double open = fall;
  for (const Wall& w : world.walls)
    if (std::isfinite(w.motion.remove_at)) open = std::max(open, w.motion.remove_at);
  return 1 - 0.3 * std::max(0.0, 1 - open / time);
}

bool driven(const World& world) {
  return world.cell.deforms || std::any_of(world.walls.begin(), world.walls.end(),
                                           [](const Wall& w) { return w.motion.motion != WallMotion::fixed; });
}

bool all_round(const World& world) {
  const auto& k = world.particles.kind;
  return std::all_of(k.begin(), k.end(), is_round) &&
         std::all_of(world.walls.begin(), world.walls.end(), [](const Wall& w) { return is_half_space(w.kind); });
}

}  // namespace

Cost expected_cost(const World& world, const Loads& loads, int threads, double set_up) {
  constexpr std::size_t fewest_of_a_bed = 8;
  const double n = static_cast<double>(world.particles.count());
  const double time = static_cast<double>(total_steps(world)) * world.time_step.dt;
  Cost c;
  c.set_up = set_up;
  c.threads = threads;
  c.steps = total_steps(world);
  c.beginning = c.packed = measure(world);
  double records = static_cast<double>(world.contacts.count()) / std::max(1.0, n);
  double with_walls = static_cast<double>(world.contacts.wall_records.size()) / std::max(1.0, n);
  const bool falls = norm(world.scene.gravity) > 0 && loads.unsupported < world.particles.count();
  c.packs = world.particles.count() >= fewest_of_a_bed && (falls || driven(world));
  OutputCost output = output_cost(world);
  if (c.packs) {
    const Packing bed = packed_sample(world);
    const double bodies = static_cast<double>(bed.world.particles.count());
    const StepCost lone = measure(lone_body(world)), sample = measure(bed.world);
    const double walls = wall_contacts(world, loads);
    const double dearer = 1 + walls / std::max(0.1, bed.contacts_per_body);
    c.packed.step = std::max(c.beginning.step, lone.step + n / bodies * (sample.step - lone.step) * dearer);
    c.packed.rebuild = std::max(c.beginning.rebuild, n / bodies * sample.rebuild);
    records = std::max(records, bed.records_per_body + 2 * walls);
    with_walls = std::max(with_walls, 2 * walls);
    const OutputCost of_sample = output_cost(bed.world);
    output.frame = std::max(output.frame, n / bodies * of_sample.frame);
    output.analysis = std::max(output.analysis, n / bodies * of_sample.analysis);
    output.frame_bytes = std::max(output.frame_bytes, n / bodies * of_sample.frame_bytes);
    output.checkpoint_bytes = std::max(output.checkpoint_bytes, n / bodies * of_sample.checkpoint_bytes);
  }
  const double falling = c.packs && time > 0 ? std::min(1.0, loads.fall_time / time) : 0;
  if (c.packs) c.packed_share = packed_share(loads.fall_time, time) * present_share(world, loads.fall_time, time);
  const auto steps = static_cast<double>(c.steps);
  const double early = loads.body_speed + 0.5 * (loads.impact - loads.body_speed);
  // A bed that runs out or is stirred moves, one at rest does not.
  const double late = c.packs ? loads.wall_speed + (world.outlets.empty() ? 0 : 0.25 * loads.impact) : early;
  const double falling_rebuilds = steps * falling * rebuilds_per_step(world, early);
  const double later_rebuilds = steps * (1 - falling) * rebuilds_per_step(world, late);
  c.rebuilds = 1 + falling_rebuilds + later_rebuilds;
  c.loop = steps * (c.packed_share * c.packed.step + (1 - c.packed_share) * c.beginning.step) +
           falling_rebuilds * 0.5 * (c.beginning.rebuild + c.packed.rebuild) + later_rebuilds * c.packed.rebuild;

  c.frame = output.frame;
  c.checkpoint = output.checkpoint;
  c.frame_bytes = output.frame_bytes;
  c.checkpoint_bytes = output.checkpoint_bytes;
  c.frames = 2 + times_in(time, world.scene.output.interval);
  c.checkpoints = 1 + times_in(time, world.scene.output.checkpoint_interval);
  const PictureCost picture = picture_cost(world);
  c.picture = picture.seconds;
  c.picture_memory = picture.bytes;
  const AnalysisSpec& found = world.scene.analysis;
  const std::uint64_t analyses = found.interval > 0 ? 2 + times_in(time, found.interval) : c.frames;
  c.output = static_cast<double>(analyses) * output.analysis + static_cast<double>(c.frames) * c.frame +
             static_cast<double>(c.checkpoints) * c.checkpoint + c.picture;
  c.disk = output.other_bytes + static_cast<double>(c.frames) * c.frame_bytes +
           static_cast<double>(std::min<std::uint64_t>(2, c.checkpoints)) * c.checkpoint_bytes;
  c.speed_up = speed_up(world, threads, c.beginning.step);
  c.total = c.set_up + c.loop + c.output;
  c.total_on_threads = c.set_up + c.loop / c.speed_up + c.output - c.picture + c.picture / static_cast<double>(threads);
  c.memory = bytes_of_packed(world, n, records, with_walls, all_round(world));
  return c;
}

}  // namespace dem::forecast
