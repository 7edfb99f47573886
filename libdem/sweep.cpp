#include "libdem/sweep.h"

#include <algorithm>
#include <numeric>

namespace dem {
namespace {

using contact::kernels::chunk_size;

constexpr std::size_t near_bytes = 8U << 20;  // of slots that the caches near the core hold

}  // namespace

void plan_sweep(World& world) {
  Contacts& c = world.contacts;
  Sweep& s = c.sweep;
  const std::size_t blocks = (world.particles.count() + bodies_at_once - 1) / bodies_at_once;
  s.bin = none;
  s.chunks = 0;
  for (std::size_t i = 0; i < c.bins.size(); ++i) {
    const std::size_t whole = c.bins[i].met.count / chunk_size;
    if (whole <= s.chunks) continue;
    s.bin = static_cast<std::uint32_t>(i);
    s.chunks = whole;
  }
  s.first.assign(blocks, none);
  s.last.assign(blocks, none);
  for (std::uint32_t chunk = 0; chunk < s.chunks; ++chunk) {
    const Met& met = c.bins[s.bin].met;
    for (std::size_t i = chunk * chunk_size; i < (chunk + 1) * chunk_size; ++i)
      for (const std::uint32_t body : {met.a[i], met.b[i]}) {
        const std::size_t block = body / bodies_at_once;
        s.first[block] = std::min(s.first[block], chunk);
        s.last[block] = chunk;
      }
  }
  s.order.resize(blocks);
  std::iota(s.order.begin(), s.order.end(), 0U);
  std::stable_sort(s.order.begin(), s.order.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return s.last[x] < s.last[y]; });
}

BodyPass::BodyPass(World& world, const BodyStep& step)
    : step_(step), kernel_(body_kernel()), count_(world.particles.count()) {
  Particles& p = world.particles;
  Contacts& c = world.contacts;
  arrays_ = {p.kind.data(),    p.motion.data(), p.orientation.data(), p.rotation.data(), p.angular_momentum.data(),
             p.inertia.data(), p.force.data(),  p.torque.data(),
             c.travel.empty() || c.stale ? nullptr : c.travel.data()};
  step_.cell = &world.cell;
  step_.gravity = world.scene.gravity;
  step_.dt = world.time_step.dt;
  step_.deforms = world.cell.deforms;
  if (step.sum)
    lists_ = {c.slot.data(), c.active.data(), c.incidence_start.data(), c.active_count.data(),
              c.sweep.chunks == 0 && c.slot.size() * sizeof(contact::Slot) > near_bytes};
}

BodyTally move_bodies(World& world, int threads, const BodyStep& step) {
  const BodyPass pass(world, step);
  BodyTally all;
#pragma omp parallel num_threads(threads)
  {
    BodyTally mine;
#pragma omp for schedule(static)
    for (std::size_t b = 0; b < pass.blocks(); ++b) pass.block(b, mine);
#pragma omp critical(bodies)
    add(all, mine);
  }
  return all;
}

}  // namespace dem
