// One step of the loop: kick – drift – kick with positions, velocities and forces at the same time at its ends.
//   v += ½ dt (F/m + g), L += ½ dt T;  x += dt v, q turns freely;  walls move;  contacts at the new positions with the
//   half-step velocities give F, T;  v += ½ dt (F/m + g), L += ½ dt T;  in a cell that deforms see deformation.h
// The order is second; forces are kept in the state, nothing is recomputed at a start. Where another step follows at
// once and nothing looks at the bodies between, its first line is done with the last one of this step, body by body
// (bodies.h), and World::ahead says so: the bits are the same.
#include <chrono>
#include <cmath>

#include "libdem/broad_phase/candidates.h"
#include "libdem/build.h"
#include "libdem/deformation.h"
#include "libdem/events/events.h"
#include "libdem/fields/drag.h"
#include "libdem/fields/drag_force.h"
#include "libdem/forces.h"
#include "libdem/insertion/rain.h"
#include "libdem/outlets.h"
#include "libdem/stopwatch.h"
#include "libdem/sweep.h"
#include "libdem/walls.h"

namespace dem {
namespace {

void check_finite(const World& world, const BodyTally& moved) {
  if (moved.bad < world.particles.count())
    throw RunError(
        "step " + std::to_string(world.step) + ": body " + std::to_string(world.particles.id[moved.bad]) +
        " has a position or velocity that is not finite; the step is too long or the scene's numbers are wrong");
}

// After bodies have begun a step.
void note_way(World& world, const BodyTally& moved) {
  const bool squared = world.contacts.travel.empty() || world.contacts.stale;
  world.contacts.step_way = squared ? std::sqrt(moved.farthest) : moved.farthest;
}

// ∫ (external forces) dt over the step, as the two kicks saw them.
void book_impulse(World& world, double h) {
  Vec3d f{};
  for (const Wall& w : world.walls) f -= w.force;
  f += world.scene.gravity * world.balance.present.value() + world.drag_force;
  for (int k = 0; k < 3; ++k) world.balance.impulse[static_cast<std::size_t>(k)].add(f[k] * h);
}

constexpr std::uint64_t monitor_every = 64;  // steps between looks at the actual stability limit

void monitor(World& world, int threads) {
  const Counters& n = world.counters;
  const double doubtful = static_cast<double>(n.not_converged + n.uncertified);
  if (doubtful > world.scene.run.max_uncertified_share * static_cast<double>(n.contact_steps) && doubtful > 100)
    throw RunError("step " + std::to_string(world.step) + ": " + std::to_string(n.not_converged) +
                   " contact queries did not converge and " + std::to_string(n.uncertified) +
                   " were not certified, of " + std::to_string(n.contact_steps) + " contact-steps; allowed share: " +
                   std::to_string(world.scene.run.max_uncertified_share) + " (run.max_uncertified_share)");
  const double limit = present_limit(world, threads);
  world.tightest_limit = std::min(world.tightest_limit, limit);
  if (world.time_step.dt > limit)
    throw RunError("step " + std::to_string(world.step) + ": run.dt = " + std::to_string(world.time_step.dt) +
                   " s has passed the stability limit of the present contacts, " + std::to_string(limit) + " s");
}

}  // namespace

void advance(World& world, int threads, bool more) {
  const auto begin = std::chrono::steady_clock::now();
  const double dt = world.time_step.dt;
  const bool deforms = world.cell.deforms;
  book_impulse(world, 0.5 * dt);
  BodyStep start{.begin = true};
  if (deforms) {
    start.flow = deform_box(world.cell, dt);
    book_flow(world, start.flow);
  }
  if (!world.ahead) note_way(world, move_bodies(world, threads, start));
  ++world.step;
  world.times.integrate += seconds_since(begin);

  const auto walls = std::chrono::steady_clock::now();
  move_walls(world);
  remove_behind_outlets(world);
  if (!world.rains.empty()) insert_rain(world);
  world.times.walls += seconds_since(walls);

  if (candidates_outdated(world, threads)) {
    // A body thrown off by a step that is too long may be out of reach: its contact would be gone unseen.
    if (!world.contacts.stale) check_contacts(world);
    rebuild_candidates(world, threads);
  }
  // What acts on bodies beside contacts must be known before they are kicked.
  const bool at_once = !deforms && find_drag_law(world.scene.drag.law) == nullptr;
  const bool looked_at = world.step % monitor_every == 0 || !world.events.empty() || !world.until.empty();
  BodyStep end{.sum = true, .end = at_once, .flow = start.flow};
  end.begin = at_once && more && !looked_at;
  end.keep = !end.begin;
  world.ahead = end.begin;
  BodyTally moved = compute_forces(world, threads, dt, end);
  check_finite(world, moved);
  if (!at_once) {
    add_drag(world, threads, dt);
    moved = move_bodies(world, threads, {.end = true, .flow = start.flow});
    check_finite(world, moved);
  }
  check_inserted_walls(world);

  const auto rest = std::chrono::steady_clock::now();
  if (end.begin) note_way(world, moved);
  if (deforms) book_flow(world, start.flow);
  book_impulse(world, 0.5 * dt);
  if (deforms) finish_cell_step(world, threads, dt);
  if (world.step % monitor_every == 0) monitor(world, threads);
  if (!world.events.empty() || !world.until.empty()) apply_events(world);
  world.times.particle_steps += world.particles.count();
  world.times.integrate += seconds_since(rest);
  world.times.loop += seconds_since(begin);
}

}  // namespace dem
