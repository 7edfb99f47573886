#include "libdem/fields/drag_force.h"

#include "libdem/fields/drag.h"

namespace dem {

void add_drag(World& world, int threads, double dt) {
  const DragSpec& spec = world.scene.drag;
  const DragLawInfo* info = find_drag_law(spec.law);
  if (info == nullptr) return;
  Flow flow{spec.density, spec.viscosity, spec.drag_coefficient, spec.velocity, {}};
  for (std::size_t i = 0; i < spec.gradient.size() && i < 3; ++i) flow.gradient.row[i] = spec.gradient[i];
  Particles& p = world.particles;
  std::vector<Vec3d> forces(p.count());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < p.count(); ++i) {
    const Motion& m = p.motion[i];
    const Vec3d u = flow.velocity_at(m.position) - m.velocity;
    const double c = drag_per_speed(info->law, flow, 2 * m.equivalent_radius, norm(u)),
                 half = 0.5 * dt * m.inverse_mass;
    forces[i] = (u - p.force[i] * half - world.scene.gravity * (0.5 * dt)) * (c / (1 + c * half));  // (1)
    p.force[i] += forces[i];
  }
  world.drag_force = {};
  for (const std::uint32_t i : order_by_id(world)) world.drag_force += forces[i];
}

}  // namespace dem
