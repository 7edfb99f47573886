// The law kernels over a chunk, compiled once per instruction set. Lanes run across contacts; lanes past `count` work
// on whatever numbers they hold and are never read.
#include "libcontact/kernels/extreme_sets.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/kernels/stages.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

struct BitOfLane {
  Lane value;
  constexpr BitOfLane() {
    double bit = 1;
    for (double& v : value.v) {
      v = bit;
      bit *= 2;
    }
  }
};
constexpr BitOfLane bit_of_lane;

// Overlap, normal and contact-point velocity of sphere pairs; the contact point is midway in the overlap.
SphereMeetings spheres(const SphereChunk& s, LawChunk& c, std::size_t count) {
  using std::sqrt;
  typename Pack::mask_type turned(false);
  Pack bits(0);  // of the lanes that touch, as a sum of powers of two
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V d = load(s.offset, i);
    const Pack ra = load(s.radius_a, i), rb = load(s.radius_b, i);
    const Pack square = dot(d, d), distance = sqrt(square);
    const V n = d * (Pack(1) / distance);
    const Pack reach = ra + rb, overlap = reach - distance, half = Pack(0.5) * overlap;
    const V wa = load(s.spin_a, i), wb = load(s.spin_b, i);
    const V lever = wa * (ra - half) + wb * (rb - half);
    store(c.overlap, i, overlap);
    store(c.normal, i, n);
    store(c.velocity, i, load(c.velocity, i) + cross(lever, n));
    store(c.turn, i, Pack(0.5) * dot(wa + wb, n));
    store(c.radius_eff, i, ra * rb / (ra + rb));
    turned = turned || dot(load(c.history_normal, i), n) < Pack(0);
    bits += select(square - reach * reach < Pack(0) && overlap > Pack(0), load(bit_of_lane.value, i), Pack(0));
  }
  return {static_cast<std::uint32_t>(reduce(bits)), any_of(turned)};
}

void sphere_torques(const SphereChunk& s, LawChunk& c, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V n = load(c.normal, i), nf = cross(n, load(c.force, i));
    const Pack half = Pack(0.5) * load(c.overlap, i);
    store(c.couple, i, nf);
    store(c.lever_a, i, load(s.radius_a, i) - half);
    store(c.lever_b, i, load(s.radius_b, i) - half);
  }
}

}  // namespace

const KernelSet& kernel_set() {
#define KERNEL_NAME_(x) #x
#define KERNEL_NAME(x) KERNEL_NAME_(x)
  static const KernelSet set{KERNEL_NAME(KERNEL_SET),
                             spheres,
                             sphere_torques,
                             law_kernel<Hertz, false>,
                             law_kernel<Linear, false>,
                             law_kernel<Hertz, true>,
                             law_kernel<Linear, true>,
                             &stage_set(),
                             sphere_clearance,
                             gather_spheres,
                             periodic_clearance,
                             periodic_gather,
                             load_history,
                             store_history,
                             store_slots,
                             store_double,
                             sum_slots,
                             {sphere_pairs, ellipsoid_proofs, ellipsoid_search, ellipse_proofs, ellipse_search},
                             {lowest, lowest_two, reaching},
                             &smooth_set()};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
