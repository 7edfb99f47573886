#include "libdem/sleep.h"

#include <omp.h>

#include <limits>

#include "libcontact/methods/polygon_regions.h"

namespace dem {
namespace {

constexpr double steps_ahead = 16;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Round bodies that have not met: awake are those that are not farther apart than `way`. In order, whoever looks.
void wake_round(const World& world, Bin& bin, double way, int threads) {
  const Contacts& c = world.contacts;
  const Motion* motion = world.particles.motion.data();
  const auto count = static_cast<std::uint32_t>(bin.records.size());
  bin.awake.clear();
#pragma omp parallel num_threads(threads)
  {
    std::vector<std::uint32_t> mine;
#pragma omp for schedule(static) nowait
    for (std::uint32_t r = 0; r < count; ++r) {
      if (c.seat[bin.records[r]] != none) continue;
      const Motion &a = motion[bin.a_index[r]], &b = motion[bin.b_index[r]];
      Vec3d d = b.position - a.position;
      if (world.cell.periodic) d = world.cell.lattice.nearest(d);
      // What rounds is held as in coherence.h.
      const double reach = (a.bounding_radius + b.bounding_radius) * (1 + 0x1p-36) + way * (1 + 0x1p-19);
      if (!(dot(d, d) > reach * reach)) mine.push_back(r);
    }
#pragma omp for schedule(static, 1) ordered
    for (int t = 0; t < omp_get_num_threads(); ++t)
#pragma omp ordered
      bin.awake.insert(bin.awake.end(), mine.begin(), mine.end());
  }
}

}  // namespace

void wake(World& world, int threads) {
  Contacts& c = world.contacts;
  c.way += c.step_way;
  if (!(c.way > c.way_allowed)) return;
  // In a cell that deforms bodies are carried along beside their own ways.
  const bool first = c.way_allowed < 0, known = !first && !c.travel.empty();
  const double w = world.cell.deforms ? infinity : first ? 0 : steps_ahead * c.step_way;
  for (Bin& bin : c.bins) {
    if (bin.round()) {
      wake_round(world, bin, 2 * w, threads);
      continue;
    }
    if (bin.query == nullptr) continue;
    const std::uint32_t step = bin.regions ? contact::max_regions : 1;
    bin.awake.clear();
    bin.met.clear();
    for (std::uint32_t r = 0; r < bin.records.size(); r += step) {
      const std::uint32_t k = bin.records[r];
      if (known && travels(world, bin, r) + 2 * w < c.apart_until[k]) continue;
      bin.awake.push_back(r);
    }
  }
  c.way = 0;
  c.way_allowed = w;
}

}  // namespace dem
