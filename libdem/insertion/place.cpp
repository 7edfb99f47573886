#include "libdem/insertion/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "libdem/build.h"
#include "libdem/insertion/occupancy.h"

namespace dem {
namespace {

constexpr double touching = 1 - 1e-9;  // a sphere shrunk by this may touch what it would overlap by round-off

// How many cells or sites are looked at for so many bodies: where less than one in 64 is free, a lattice is no use.
double most_sites(std::size_t bodies) { return 64 * static_cast<double>(bodies) + 1e6; }

struct Job {
  const World& world;
  const FillSpec& fill;
  const Region& region;
  const Recipe& recipe;
  const std::vector<Draft>& drafts;
  std::uint64_t stream;

  double radius(std::size_t i) const { return recipe.radius(drafts[i]); }
  Quatd orientation(Random& random) const {
    return fill.turned == Turned::given ? fill.orientation : random_orientation(world, random);
  }
  double largest() const {
    double r = 0;
    for (const Draft& d : drafts) r = std::max(r, recipe.radius(d));
    return r;
  }
};

// A cubic lattice of spacing twice the largest bounding radius, filled from below; each body sits at random within the
// free room of its cell. Cells that bodies or walls reach into are passed over. Nothing when the cells do not suffice.
std::optional<std::vector<Place>> jittered_lattice(const Job& job, const Occupancy& there) {
  const double cell = 2 * job.largest();
  const Vec3d extent = job.region.upper() - job.region.lower();
  const bool flat = extent.z == 0;
  std::uint64_t n[3];
  double cells = 1;
  for (int k = 0; k < 3; ++k) {
    const double along = k == 2 && flat ? 1 : std::clamp(std::floor(extent[k] / cell), 0.0, 1e15);
    n[k] = static_cast<std::uint64_t>(along);
    cells *= along;
  }
  if (cells < static_cast<double>(job.drafts.size())) return {};
  const auto room = static_cast<std::uint64_t>(std::min(cells, most_sites(job.drafts.size())));
  // Rows are filled evenly; the last axis, that of height, from below.
  const auto even = [&](int k) { return extent[k] / static_cast<double>(n[k]); };
  const Vec3d pitch{even(0), flat ? cell : even(1), flat ? 0 : cell};
  std::vector<Place> found;
  for (std::uint64_t c = 0; c < room && found.size() < job.drafts.size(); ++c) {
    const std::size_t i = found.size();
    Random random(job.world.scene.run.seed, placing_streams + job.stream, i);
    const double r = job.radius(i);
    const std::uint64_t cell_of[3] = {c % n[0], c / n[0] % n[1], c / (n[0] * n[1])};
    Vec3d x;
    for (int k = 0; k < (flat ? 2 : 3); ++k)
      x[k] = job.region.lower()[k] + pitch[k] * (static_cast<double>(cell_of[k]) + 0.5) +
             (0.5 * pitch[k] - r) * random.uniform(-1, 1);
    if (!job.region.holds_sphere(x, r) || there.blocked(x, r * touching)) continue;
    found.push_back({x, job.orientation(random)});
  }
  if (found.size() < job.drafts.size()) return {};
  return found;
}

// Random sequential placement: the largest bodies first, each at the first of its random positions that is free.
std::vector<Place> random_places(const Job& job, Occupancy taken) {
  constexpr int tries = 20000;
  std::vector<std::size_t> order(job.drafts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return job.radius(a) > job.radius(b); });
  std::vector<Place> found(job.drafts.size());
  std::size_t placed = 0;
  for (const std::size_t i : order) {
    const double r = job.radius(i);
    Random random(job.world.scene.run.seed, random_streams + job.stream, i);
    int k = 0;
    Vec3d x;
    do {
      x = job.region.sample(random, r);
    } while (taken.blocked(x, r) && ++k < tries);
    if (k == tries)
      input_error(job.fill.where,
                  fmt::format("fill: {} of {} bodies found a place, the next (bounding radius {:.4g} m) found none in "
                              "{} tries at random; make the region larger or the amount smaller, or use a lattice",
                              placed, job.drafts.size(), r, tries));
    taken.add(x, r);
    found[i] = {x, job.orientation(random)};
    ++placed;
  }
  return found;
}

// visit(x) for every site of a regular lattice whose sphere lies in the region, row by row along x, then y, then z. The
// first sphere touches the lower faces of the region's bounding box.
template <class Visit>
void each_site(const Job& job, double radius, Visit visit) {
  const double s = job.fill.spacing > 0 ? job.fill.spacing : 2 * radius;
  if (s < 2 * radius * touching)
    input_error(job.fill.where, fmt::format("fill.spacing = {}: bounding spheres of diameter {:.6g} m would overlap; "
                                            "allowed from that on",
                                            s, 2 * radius));
  const Vec3d low = job.region.lower(), high = job.region.upper();
  const bool flat = low.z == high.z;
  struct Step {  // between rows, in spacings; how far odd rows and odd layers are shifted
    double x, y, z;
    bool staggered;
  } step{1, 1, 1, false};
  const double half_root2 = std::sqrt(0.5), half_root3 = std::sqrt(0.75);
  if (job.fill.arrangement == Arrangement::hexagonal) step = {1, half_root3, 0, true};
  if (job.fill.arrangement == Arrangement::fcc) step = {half_root2, half_root2, half_root2, false};
  const auto number = [&](int k, double pitch) -> std::int64_t {
    const double span = high[k] - low[k] - 2 * radius;
    if (span < -1e-9 * radius) return 0;
    return static_cast<std::int64_t>(std::min(std::floor(span / (pitch * s) + 1e-9), 1e15)) + 1;
  };
  const std::int64_t nx = number(0, step.x), ny = number(1, step.y), nz = flat || step.z == 0 ? 1 : number(2, step.z);
  double left = most_sites(job.drafts.empty() ? most_bodies / 64 : job.drafts.size());
  for (std::int64_t k = 0; k < nz; ++k)
    for (std::int64_t j = 0; j < ny; ++j)
      for (std::int64_t i = 0; i < nx; ++i) {
        if (--left < 0)
          input_error(job.fill.where,
                      "fill: the lattice has too many sites in the region; make fill.spacing larger, "
                      "the region smaller or give another arrangement");
        // Face-centred cubic: the points of a cubic net of half the cell's edge whose indices have an even sum.
        if (job.fill.arrangement == Arrangement::fcc && ((i + j + k) & 1) != 0) continue;
        Vec3d x{low.x + radius + s * step.x * static_cast<double>(i),
                low.y + radius + s * step.y * static_cast<double>(j),
                low.z + radius + s * step.z * static_cast<double>(k)};
        if (step.staggered && (j & 1) != 0) x.x += 0.5 * s;
        if (flat) x.z = low.z;
        if (!flat && step.z == 0) x.z = 0.5 * (low.z + high.z);
        if (job.region.holds_sphere(x, radius) && !visit(x)) return;
      }
}

std::vector<Place> regular_lattice(const Job& job, const Occupancy& there) {
  std::vector<Place> found;
  const double largest = job.largest();
  each_site(job, largest, [&](const Vec3d& x) {
    const std::size_t i = found.size();
    if (i == job.drafts.size()) return false;
    Random random(job.world.scene.run.seed, placing_streams + job.stream, i);
    if (!there.blocked(x, job.radius(i) * touching)) found.push_back({x, job.orientation(random)});
    return true;
  });
  if (found.size() < job.drafts.size())
    input_error(job.fill.where, fmt::format("fill: {} bodies asked for, the lattice has {} free sites in the region "
                                            "(bounding radius {:.4g} m)",
                                            job.drafts.size(), found.size(), largest));
  return found;
}

}  // namespace

std::uint64_t site_count(const World& world, const FillSpec& fill, const Region& region, double radius) {
  const Recipe none(world, {}, fill.where);
  const Occupancy there(world, region.lower(), region.upper());
  std::uint64_t count = 0;
  each_site(Job{world, fill, region, none, {}, 0}, radius, [&](const Vec3d& x) {
    if (!there.blocked(x, radius * touching)) ++count;
    return true;
  });
  return count;
}

std::vector<Place> places(const World& world, const FillSpec& fill, const Region& region, const Recipe& recipe,
                          const std::vector<Draft>& drafts, std::uint64_t stream) {
  const Job job{world, fill, region, recipe, drafts, stream};
  const double largest = job.largest();
  if (!region.has_room_for(largest))
    input_error(
        fill.where,
        fmt::format("fill: the region has no room for the largest bounding sphere (diameter {:.4g} m)", 2 * largest));
  const Occupancy there(world, region.lower(), region.upper());
  switch (fill.arrangement) {
    case Arrangement::automatic:
      if (auto found = jittered_lattice(job, there)) return *found;
      return random_places(job, there);
    case Arrangement::random:
      return random_places(job, there);
    case Arrangement::lattice:
      if (auto found = jittered_lattice(job, there)) return *found;
      input_error(fill.where,
                  fmt::format("fill: the lattice has too few free cells for {} bodies whose largest bounding "
                              "sphere has the diameter {:.4g} m; make the region larger or the amount "
                              "smaller, or use arrangement = \"random\"",
                              drafts.size(), 2 * largest));
    default:
      return regular_lattice(job, there);
  }
}

}  // namespace dem
