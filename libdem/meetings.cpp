#include "libdem/meetings.h"

#include <algorithm>

#include "libcontact/kernels/chunk.h"

namespace dem {
namespace {

using contact::kernels::chunk_size;

// Those of the awake pairs of a bin whose spheres overlap: their places in the bin, in order.
std::vector<std::uint32_t> overlapping(const World& world, const Bin& bin, int threads) {
  const contact::kernels::KernelSet& set = contact::kernels::kernels();
  const Motion* motion = world.particles.motion.data();
  const std::size_t all = bin.awake.size(), chunks = (all + chunk_size - 1) / chunk_size;
  std::vector<std::uint32_t> found;
#pragma omp parallel for schedule(static) num_threads(threads) if (chunks > 64)
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    const std::uint32_t* place = &bin.awake[chunk * chunk_size];
    const std::size_t n = std::min(chunk_size, all - chunk * chunk_size);
    std::uint32_t a[chunk_size], b[chunk_size];
    for (std::size_t i = 0; i < chunk_size; ++i) {
      a[i] = bin.a_index[place[std::min(i, n - 1)]];
      b[i] = bin.b_index[place[std::min(i, n - 1)]];
    }
    contact::kernels::Lane clearance;
    if (world.cell.periodic)
      set.periodic_clearance(motion, a, b, n, world.cell.lattice, clearance);
    else
      set.sphere_clearance(motion, a, b, n, clearance);
    for (std::size_t i = 0; i < n; ++i) {
      if (!(clearance[i] < 0)) continue;
#pragma omp critical(meeting)
      found.push_back(place[i]);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Of the awake pairs of smooth bodies those that touch: from now on in lanes, whenever the awake were listed.
void meet_smooth(Contacts& c, Bin& bin) {
  std::erase_if(bin.awake, [&](std::uint32_t place) {
    const std::uint32_t k = bin.records[place];
    if (c.touching[k] == 0) return false;
    bin.met.add(k, bin.a_index[place], bin.b_index[place], bin.pair[place], c.seat[k]);
    bin.met.place.push_back(place);
    c.centre[k] = {};  // as lanes leave it
    return true;
  });
}

}  // namespace

void relist(Contacts& c, std::uint32_t k) {
  const auto body = [&](std::uint32_t i) {
    const std::uint32_t first = c.incidence_start[i];
    std::uint32_t n = 0;
    for (std::uint32_t e = first; e < c.incidence_start[i + 1]; ++e)
      if (c.counts(c.incidence[e] >> 1)) c.active[first + n++] = c.active_entry(c.incidence[e]);
    c.active_count[i] = n;
  };
  body(c.index_a[k]);
  if (c.key[k].b < wall_base) body(c.index_b[k]);
}

std::vector<Tally> meet(World& world, int threads) {
  Contacts& c = world.contacts;
  std::vector<Tally> tally(c.bins.size() + 1);
  std::size_t seats = c.history.size();
  for (std::size_t i = 0; i < c.bins.size(); ++i) {
    Bin& bin = c.bins[i];
    if (bin.smooth) meet_smooth(c, bin);
    if (!bin.round()) continue;
    const std::vector<std::uint32_t> found = overlapping(world, bin, threads);
    for (const std::uint32_t place : found) {
      const std::uint32_t k = bin.records[place];
      c.seat[k] = static_cast<std::uint32_t>(seats++);
      bin.met.add(k, bin.a_index[place], bin.b_index[place], bin.pair[place], c.seat[k]);
      relist(c, k);
    }
    if (!found.empty())
      std::erase_if(bin.awake, [&](std::uint32_t place) { return c.seat[bin.records[place]] != none; });
    tally[i].candidates = tally[i].by_spheres = bin.awake.size();
  }
  if (seats > c.history.size()) c.make_seats(seats);
  return tally;
}

}  // namespace dem
