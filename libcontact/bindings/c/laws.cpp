// Law updates behind the C door.
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

#include "libcontact/bindings/c/contact.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/mix.h"

namespace {

using contact::kernels::chunk_size;
using contact::kernels::Lane3;
using contact::kernels::LawChunk;
using shapes::Vec3d;

static_assert(sizeof(contact_history) == sizeof(contact::History));

// The laws that need no memory beside a contact_history.
constexpr const char* law_names[] = {"spring_dashpot", "hertz_mindlin"};
constexpr std::uint32_t law_count = std::size(law_names);

contact::kernels::LawKernel kernel_of(std::uint32_t law) {
  const contact::kernels::KernelSet& set = contact::kernels::kernels();
  return law == 0 ? set.spring_dashpot_patch : set.hertz_mindlin_patch;
}

Vec3d vector(const double* v) { return {v[0], v[1], v[2]}; }
void put(Lane3& lane, std::size_t i, const Vec3d& v) {
  lane.x[i] = v.x;
  lane.y[i] = v.y;
  lane.z[i] = v.z;
}
void get(const Lane3& lane, std::size_t i, double* out) {
  out[0] = lane.x[i];
  out[1] = lane.y[i];
  out[2] = lane.z[i];
}

void load(const contact_pair& p, const contact_motion& m, const contact::History& h, std::size_t i, LawChunk& c) {
  const Vec3d normal = vector(m.normal), spin_a = vector(m.spin_a), spin_b = vector(m.spin_b);
  c.overlap[i] = m.overlap;
  put(c.normal, i, normal);
  put(c.velocity, i, vector(m.velocity));
  c.turn[i] = 0.5 * dot(spin_a + spin_b, normal);
  c.radius_eff[i] = m.radius_eff;
  c.mass_eff[i] = m.mass_eff;
  c.pair.young_eff[i] = p.young_eff;
  c.pair.shear_eff[i] = p.shear_eff;
  c.pair.stiffness_n[i] = p.stiffness_n;
  c.pair.stiffness_t[i] = p.stiffness_t;
  c.pair.friction[i] = p.friction;
  c.pair.damping[i] = p.damping;
  put(c.history_force, i, h.force_t);
  put(c.history_normal, i, h.normal);
  c.history_overlap[i] = h.overlap;
  c.history_twist[i] = h.twist;
  c.spread_xx[i] = m.patch_spread[0];
  c.spread_yy[i] = m.patch_spread[1];
  c.spread_zz[i] = m.patch_spread[2];
  c.spread_xy[i] = m.patch_spread[3];
  c.spread_xz[i] = m.patch_spread[4];
  c.spread_yz[i] = m.patch_spread[5];
  put(c.relative_spin, i, spin_a - spin_b);
}

contact::Material material(const contact_material& m) {
  contact::Material out;
  out.young = m.young;
  out.poisson = m.poisson;
  out.restitution = m.restitution;
  out.friction = m.friction;
  out.stiffness = m.stiffness;
  out.rigid = m.rigid != 0;
  return out;
}

}  // namespace

int contact_law(const char* name, uint32_t* law) {
  if (name == nullptr || law == nullptr) return CONTACT_NULL_POINTER;
  for (std::uint32_t i = 0; i < law_count; ++i)
    if (std::strcmp(name, law_names[i]) == 0) {
      *law = i;
      return CONTACT_OK;
    }
  return CONTACT_UNKNOWN_NAME;
}

int contact_mix(const contact_material* a, const contact_material* b, int clip, contact_pair* pair) {
  if (a == nullptr || b == nullptr || pair == nullptr) return CONTACT_NULL_POINTER;
  if (a->size != sizeof(contact_material) || b->size != sizeof(contact_material)) return CONTACT_BAD_SIZE;
  for (const contact_material* m : {a, b}) {
    const bool sound = m->restitution >= (clip != 0 ? contact::least_clipped_restitution : 0) && m->restitution <= 1 &&
                       m->friction >= 0 && m->poisson >= 0 && m->poisson <= 0.5 && m->young >= 0 && m->stiffness >= 0;
    if (!sound) return CONTACT_BAD_VALUE;
  }
  if (a->rigid != 0 && b->rigid != 0) return CONTACT_BAD_VALUE;
  const contact::PairParameters p = contact::mix(material(*a), material(*b), clip != 0);
  *pair = {p.young_eff, p.shear_eff, p.stiffness_n, p.stiffness_t, p.friction, p.damping, p.restitution};
  return CONTACT_OK;
}

int contact_law_update(uint32_t law, size_t n, const contact_pair* pairs, size_t pair_count, const uint32_t* pair_of,
                       const contact_motion* motions, double dt, const contact_law_options* options,
                       contact_history* histories, contact_load* loads) {
  if (n == 0) return CONTACT_OK;
  if (pairs == nullptr || motions == nullptr || histories == nullptr || loads == nullptr) return CONTACT_NULL_POINTER;
  if (law >= law_count || pair_count == 0 || !(dt >= 0 && std::isfinite(dt))) return CONTACT_BAD_VALUE;
  contact::LawOptions wanted;
  if (options != nullptr) {
    if (options->size != sizeof(contact_law_options)) return CONTACT_BAD_SIZE;
    wanted.rescale = options->rescale != 0;
    wanted.clip = options->clip != 0;
  }
  for (std::size_t i = 0; pair_of != nullptr && i < n; ++i)
    if (pair_of[i] >= pair_count) return CONTACT_BAD_VALUE;
  const auto kernel = kernel_of(law);
  LawChunk c;
  std::size_t lane_of[chunk_size];
  for (std::size_t first = 0; first < n; first += chunk_size) {
    const std::size_t last = first + chunk_size < n ? first + chunk_size : n;
    std::size_t lanes = 0;
    for (std::size_t i = first; i < last; ++i) {
      if (!(motions[i].overlap > 0)) {
        histories[i] = {};
        loads[i] = {};
        continue;
      }
      const auto h = std::bit_cast<contact::History>(histories[i]);
      load(pairs[pair_of == nullptr ? 0 : pair_of[i]], motions[i], h, lanes, c);
      lane_of[lanes++] = i;
    }
    kernel(c, lanes, dt, wanted);
    for (std::size_t k = 0; k < lanes; ++k) {
      const std::size_t i = lane_of[k];
      contact::History h;
      h.force_t = {c.history_force.x[k], c.history_force.y[k], c.history_force.z[k]};
      h.normal = {c.history_normal.x[k], c.history_normal.y[k], c.history_normal.z[k]};
      h.overlap = c.history_overlap[k];
      h.twist = c.history_twist[k];
      histories[i] = std::bit_cast<contact_history>(h);
      get(c.force, k, loads[i].force);
      get(c.couple, k, loads[i].couple);
    }
  }
  return CONTACT_OK;
}
