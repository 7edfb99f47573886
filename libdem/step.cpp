// One step of the loop: kick – drift – kick with positions, velocities and forces at the same time at its ends.
//   v += ½ dt (F/m + g), L += ½ dt T;  x += dt v, q turns freely;  walls move;  contacts at the new positions with the
//   half-step velocities give F, T;  v += ½ dt (F/m + g), L += ½ dt T;  in a cell that deforms see deformation.h
// The order is second; forces are kept in the state, nothing is recomputed at a start.
#include <chrono>
#include <cmath>

#include "libdem/broad_phase/candidates.h"
#include "libdem/build.h"
#include "libdem/coherence.h"
#include "libdem/deformation.h"
#include "libdem/events/events.h"
#include "libdem/fields/drag_force.h"
#include "libdem/forces.h"
#include "libdem/insertion/rain.h"
#include "libdem/integrators/rotation.h"
#include "libdem/outlets.h"
#include "libdem/walls.h"

namespace dem {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// One body at a time, all its arrays at hand.
struct BodyAt {
  Particles& p;
  Motion& m;
  std::size_t i;
  bool sphere;
  BodyAt(Particles& particles, std::size_t index)
      : p(particles), m(particles.motion[index]), i(index), sphere(turns_uniformly(particles.kind[index])) {}

  [[gnu::always_inline]] void kick(const Vec3d& gravity, double h) {
    m.velocity += (p.force[i] * m.inverse_mass + gravity) * h;
    p.angular_momentum[i] += p.torque[i] * h;
  }
  [[gnu::always_inline]] void set_spin() {
    m.spin = sphere ? p.angular_momentum[i] * (1 / p.inertia[i].x)
                    : spin_of(p.orientation[i], p.angular_momentum[i], p.inertia[i]);
  }
  [[gnu::always_inline]] void turn(double dt) {
    Quatd& q = p.orientation[i];
    if (sphere) {
      set_spin();
      q = rotated_uniformly(q, m.spin, dt);
    } else {
      q = rotated_freely(q, p.angular_momentum[i], p.inertia[i], dt);
      set_spin();
    }
    p.rotation[i] += m.spin * dt;
  }
};

// In a cell that deforms, a body is slowed by the flow (half of it here), drifts half the way, is carried along with
// the box, and drifts the other half.
void kick_and_drift(World& world, int threads, double dt, const CellStep& flow) {
  Particles& p = world.particles;
  const Vec3d gravity = world.scene.gravity;
  const Cell& cell = world.cell;
  const bool periodic = cell.periodic, deforms = cell.deforms;
  double* travel = world.contacts.travel.empty() || world.contacts.stale ? nullptr : world.contacts.travel.data();
  double farthest = 0;
#pragma omp parallel for schedule(static) num_threads(threads) reduction(max : farthest)
  for (std::size_t i = 0; i < p.count(); ++i) {
    BodyAt body(p, i);
    const Vec3d before = body.m.position;
    const Quatd turned = p.orientation[i];
    body.kick(gravity, 0.5 * dt);
    if (deforms) {
      Vec3d& x = body.m.position;
      body.m.velocity = scaled(body.m.velocity, flow.slowed);
      const Vec3d way = body.m.velocity * (0.5 * dt);
      x = cell.centre + scaled(x + way - cell.centre, flow.scale) + way;
    } else {
      body.m.position += body.m.velocity * dt;
    }
    const Vec3d moved = body.m.position - before;
    if (periodic) cell.wrap(body.m.position);
    body.turn(dt);
    if (travel == nullptr) {
      farthest = std::max(farthest, dot(moved, moved));
      continue;
    }
    const double way = travel_of(moved, turned, p.orientation[i], body.m.bounding_radius);
    travel[i] += way;
    farthest = std::max(farthest, way);
  }
  world.contacts.step_way = travel == nullptr ? std::sqrt(farthest) : farthest;
}

void kick_again(World& world, int threads, double dt, const CellStep& flow) {
  Particles& p = world.particles;
  const Vec3d gravity = world.scene.gravity;
  const bool deforms = world.cell.deforms;
  std::size_t bad = p.count();
#pragma omp parallel for schedule(static) num_threads(threads) reduction(min : bad)
  for (std::size_t i = 0; i < p.count(); ++i) {
    BodyAt body(p, i);
    if (deforms) body.m.velocity = scaled(body.m.velocity, flow.slowed);
    body.kick(gravity, 0.5 * dt);
    body.set_spin();
    const Motion& m = body.m;
    const double probe = (m.position.x + m.position.y + m.position.z) + (m.velocity.x + m.velocity.y + m.velocity.z) +
                         (m.spin.x + m.spin.y + m.spin.z);
    if (!std::isfinite(probe) && i < bad) bad = i;
  }
  if (bad < p.count())
    throw RunError(
        "step " + std::to_string(world.step) + ": body " + std::to_string(p.id[bad]) +
        " has a position or velocity that is not finite; the step is too long or the scene's numbers are wrong");
}

// ∫ (external forces) dt over the step, as the two kicks saw them.
void book_impulse(World& world, double h) {
  Vec3d f{};
  for (const Wall& w : world.walls) f -= w.force;
  f += world.scene.gravity * world.balance.present.value() + world.drag_force;
  for (int k = 0; k < 3; ++k) world.balance.impulse[static_cast<std::size_t>(k)].add(f[k] * h);
}

constexpr std::uint64_t monitor_every = 64;  // steps between looks at the actual stability limit

void monitor(World& world) {
  const Counters& n = world.counters;
  const double doubtful = static_cast<double>(n.not_converged + n.uncertified);
  if (doubtful > world.scene.run.max_uncertified_share * static_cast<double>(n.contact_steps) && doubtful > 100)
    throw RunError("step " + std::to_string(world.step) + ": " + std::to_string(n.not_converged) +
                   " contact queries did not converge and " + std::to_string(n.uncertified) +
                   " were not certified, of " + std::to_string(n.contact_steps) + " contact-steps; allowed share: " +
                   std::to_string(world.scene.run.max_uncertified_share) + " (run.max_uncertified_share)");
  const double limit = present_limit(world);
  world.tightest_limit = std::min(world.tightest_limit, limit);
  if (world.time_step.dt > limit)
    throw RunError("step " + std::to_string(world.step) + ": run.dt = " + std::to_string(world.time_step.dt) +
                   " s has passed the stability limit of the present contacts, " + std::to_string(limit) + " s");
}

}  // namespace

void advance(World& world, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  const double dt = world.time_step.dt;
  const bool deforms = world.cell.deforms;
  book_impulse(world, 0.5 * dt);
  CellStep flow;
  if (deforms) {
    flow = deform_box(world.cell, dt);
    book_flow(world, flow);
  }
  kick_and_drift(world, threads, dt, flow);
  ++world.step;
  world.times.integrate += seconds_since(begin);

  const auto walls = std::chrono::steady_clock::now();
  move_walls(world);
  remove_behind_outlets(world);
  if (!world.rains.empty()) insert_rain(world);
  world.times.walls += seconds_since(walls);

  if (candidates_outdated(world)) {
    // A body thrown off by a step that is too long may be out of reach: its contact would be gone unseen.
    if (!world.contacts.stale) check_contacts(world);
    rebuild_candidates(world, threads);
  }
  compute_forces(world, threads, dt);
  sum_forces(world, threads);
  add_drag(world, threads, dt);
  book_wall_loads(world, dt);
  check_inserted_walls(world);

  const auto end = std::chrono::steady_clock::now();
  kick_again(world, threads, dt, flow);
  if (deforms) book_flow(world, flow);
  book_impulse(world, 0.5 * dt);
  if (deforms) finish_cell_step(world, threads, dt);
  if (world.step % monitor_every == 0) monitor(world);
  if (!world.events.empty() || !world.until.empty()) apply_events(world);
  world.times.particle_steps += world.particles.count();
  world.times.integrate += seconds_since(end);
  world.times.loop += seconds_since(begin);
}

}  // namespace dem
