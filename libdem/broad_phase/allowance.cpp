#include "libdem/broad_phase/allowance.h"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

// What a rebuild costs for each body and each pair over what a step costs for each pair that does not touch, as
// measured for spheres to grains; (1) takes the root of it.
constexpr double per_body = 100, per_pair = 25;
constexpr double fewest = 4, most = 4096;  // steps
constexpr double widest = 0.7;             // of a body's radius: from there on its neighbours are too many
constexpr double widest_of_walls = 7;      // of half the skin of bodies at rest, a tenth of the smallest radius

// The farthest any body may be allowed to go, m: in a periodic box one image of each has to do.
double farthest(const World& world) {
  double limit = std::numeric_limits<double>::infinity();
  if (!world.cell.periodic) return limit;
  for (int k = 0; k < 3; ++k)
    if (const double length = world.cell.lattice.length[k]; length > 0)
      limit = std::min(limit, length / 4 - world.contacts.largest_sum / 2);
  return std::max(limit, 0.5 * world.skin);
}

}  // namespace

double best_steps(double bodies, double listed, double touching, double steps) {
  const double spare = std::max(listed - touching, 1.0);
  const double best = std::sqrt((per_body * bodies + per_pair * listed) * steps / spare);
  return std::clamp(best, fewest, most);
}

void choose_allowances(World& world) {
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
  const double half = 0.5 * world.skin;
  c.allowance.assign(p.count(), half);
  for (Wall& w : world.walls) w.allowance = half;
  if (world.scene.run.skin >= 0) return;
  ListLife& life = world.list_life;
  if (!c.reference.empty()) {  // there was a list
    const auto touching = static_cast<double>(std::count(c.touching.begin(), c.touching.end(), 1));
    const double best =
        best_steps(static_cast<double>(p.count()), static_cast<double>(c.count()), touching, life.steps);
    life.steps = std::clamp(best, 0.5 * life.steps, 2 * life.steps);  // by and by
    // Bodies that come and go end lists before their time.
    if (c.stale) life.steps = std::clamp(3 * static_cast<double>(world.step - life.since), fewest, life.steps);
  }
  life.since = world.step;
  const double time = life.steps * world.time_step.dt, limit = farthest(world);
  for (std::size_t i = 0; i < p.count(); ++i) {
    const Motion& m = p.motion[i];
    double speed = norm(m.velocity);
    if (p.kind[i] == shapes::Kind::compound) speed += norm(m.spin) * m.bounding_radius;  // parts are listed
    const double most_of_it = std::min(limit, std::max(widest * m.equivalent_radius, half));
    c.allowance[i] = std::min(half + speed * time, most_of_it);
  }
  for (Wall& w : world.walls)
    w.allowance = std::min(half + (norm(w.velocity) + norm(w.spin) * w.extent) * time, widest_of_walls * half);
}

}  // namespace dem
