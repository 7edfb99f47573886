#include "libdem/sweep.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace dem {

using contact::kernels::chunk_size;

void plan_sweep(World& world) {
  Contacts& c = world.contacts;
  Sweep& s = c.sweep;
  const std::size_t blocks = (world.particles.count() + bodies_at_once - 1) / bodies_at_once;
  s.bin = none;
  s.chunks = 0;
  for (std::size_t i = 0; i < c.bins.size(); ++i) {
    const std::size_t whole = c.bins[i].round() ? c.bins[i].met.count / chunk_size : 0;
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
  // Blocks whose last chunks are near go in order of storage, as memory streams best.
  const auto widest = [&s] {
    std::uint32_t chunks = 0;
    for (std::size_t b = 0; b < s.last.size(); ++b)
      if (s.last[b] != none) chunks = std::max(chunks, s.last[b] - s.first[b]);
    return chunks;
  };
  const std::uint32_t run = std::bit_ceil(std::max<std::uint32_t>(widest() / 8, 8));
  for (std::uint32_t& last : s.last)
    if (last != none) last = std::min(last | (run - 1), static_cast<std::uint32_t>(s.chunks) - 1);
  s.widest = widest();
  s.order.resize(blocks);
  std::iota(s.order.begin(), s.order.end(), 0U);
  std::stable_sort(s.order.begin(), s.order.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return s.last[x] < s.last[y]; });
}

// Blocks that two threads share have all their chunks within the widest span of a block of the border between their
// ranges: those keep places of their own.
SlotRing ring_of(const World& world, std::size_t thread, std::size_t threads) {
  const Contacts& c = world.contacts;
  const Sweep& s = c.sweep;
  const std::size_t widest = s.widest;
  ChunkRange zone(s.chunks, thread, threads);
  if (thread > 0) zone.first += widest;
  if (thread + 1 < threads) zone.last -= std::min(zone.last, widest);
  const std::size_t ring = std::bit_ceil(widest + chunks_at_once + 1);
  if (zone.first + ring >= zone.last) return {};
  const std::size_t slot = c.first_slot(c.bins[s.bin].met.seat[zone.first * chunk_size]);
  return {static_cast<std::uint32_t>(slot), static_cast<std::uint32_t>((zone.last - zone.first) * chunk_size),
          static_cast<std::uint32_t>(ring * chunk_size - 1)};
}

void plan_sweep_again(World& world) {
  std::size_t most = 0;
  for (const Bin& b : world.contacts.bins)
    if (b.round()) most = std::max(most, b.met.count / chunk_size);
  if (most > 2 * world.contacts.sweep.chunks) plan_sweep(world);
}

BodyPass::BodyPass(World& world, const BodyStep& step)
    : step_(step), kernel_(body_kernel()), count_(world.particles.count()) {
  Particles& p = world.particles;
  Contacts& c = world.contacts;
  arrays_ = {reinterpret_cast<const std::uint8_t*>(p.kind.data()),
             p.motion.data(),
             p.orientation.data(),
             p.rotation.data(),
             p.angular_momentum.data(),
             p.inertia.data(),
             p.force.data(),
             p.torque.data(),
             c.travel.empty() || c.stale ? nullptr : c.travel.data()};
  step_.uniform = kinds_that(turns_uniformly);
  step_.still = world.scene.run.turn_spheres ? 0 : kinds_that(is_round);
  step_.periodic = world.cell.periodic;
  step_.lower = world.cell.lower;
  step_.centre = world.cell.centre;
  step_.lattice = world.cell.lattice;
  step_.gravity = world.scene.gravity;
  step_.dt = world.time_step.dt;
  step_.deforms = world.cell.deforms;
  if (step.sum)
    lists_ = {c.slot.data(), c.active.data(), c.incidence_start.data(), c.active_count.data(),
              c.slot.size() * sizeof(contact::Slot) > near_bytes};
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
