// The law kernels over a chunk, compiled once per instruction set. Lanes run across contacts; lanes past `count` work
// on whatever numbers they hold and are never read.
#include "libcontact/kernels/extreme_sets.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/kernels/sphere_meeting.h"
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
  Pack touching(0), turned(0);  // the lanes, as sums of powers of two
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const Pack radius_a = load(s.radius_a, i), radius_b = load(s.radius_b, i);
    const SphereMeeting<Pack> m =
        meeting_of(load(s.offset, i), radius_a, radius_b, radius_a + radius_b, load(c.velocity, i),
                   load(s.inverse_mass, i), load(s.spin_a, i), load(s.spin_b, i));
    store(c.overlap, i, m.overlap);
    store(c.normal, i, m.normal);
    store(c.velocity, i, m.velocity);
    store(c.turn, i, m.turn);
    store(c.radius_eff, i, m.radius_eff);
    store(c.mass_eff, i, m.mass_eff);
    const Pack bits = load(bit_of_lane.value, i);
    touching += select(m.touch, bits, Pack(0));
    turned += select(dot(load(c.history_normal, i), m.normal) < Pack(0), bits, Pack(0));
  }
  return {static_cast<std::uint32_t>(reduce(touching)), static_cast<std::uint32_t>(reduce(turned))};
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
                             sphere_contacts_hertz,
                             sphere_contacts_linear,
                             plane_contacts_hertz,
                             plane_contacts_linear,
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
                             {sphere_pairs, ellipsoid_proofs, ellipsoid_search, ellipse_proofs, ellipse_search},
                             {lowest, lowest_two, reaching},
                             polygon_sides,
                             &smooth_set(),
                             &overlap_set()};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
