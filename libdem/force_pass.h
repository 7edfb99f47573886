// What the force passes share: one thread's working set, and the way of a contact from a query's answer through the law
// kernels back to its record. Inner header of forces.cpp and forces_compound.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/smooth.h"
#include "libcontact/overlap_depth.h"
#include "libcontact/overlap_volume.h"
#include "libdem/integrators/bodies.h"
#include "libdem/law_map.h"
#include "libdem/world.h"

namespace dem {

using contact::kernels::chunk_size;
using contact::kernels::KernelSet;
using contact::kernels::Lane3;
using contact::kernels::LawChunk;
using contact::kernels::SphereChunk;

inline void put(Lane3& lane, std::size_t i, const Vec3d& v) {
  lane.x[i] = v.x;
  lane.y[i] = v.y;
  lane.z[i] = v.z;
}
inline Vec3d get(const Lane3& lane, std::size_t i) { return {lane.x[i], lane.y[i], lane.z[i]}; }

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct WallFrame {  // of this step
  contact::Body body;
  Vec3d normal;  // plane, line
};

// One thread's working set; reused over its chunks.
struct Scratch {
  std::vector<Change> changed;
  std::vector<std::uint32_t> through;  // records whose normal has turned round
  LawChunk law;
  contact::kernels::LawWork work;  // where laws run in stages
  // Where a potential of the overlap acts, `gained`: J; m, couple along n over the elastic force.
  bool gained = false;
  double gain[chunk_size] = {}, screw[chunk_size] = {};
  SphereChunk spheres;
  contact::kernels::SmoothChunk smooth;
  contact::kernels::Lane clearance, overlap_before;
  std::uint32_t entry[chunk_size] = {};
  std::uint32_t pair[chunk_size];        // the pair of materials that each lane of `law` holds
  std::uint32_t pair_everywhere = none;  // that all of them hold, where that is known
  std::uint32_t record[chunk_size] = {}, seat[chunk_size] = {}, index_a[chunk_size] = {}, index_b[chunk_size] = {};
  std::vector<Tally> tally;  // by bin; last: the groups
  SlotRing ring;             // of round pairs
  contact::Body a[chunk_size], b[chunk_size];
  Vec3d offset[chunk_size];
  contact::Cache cache[chunk_size];
  contact::Contact answer[chunk_size];
  Vec3d arm_a[chunk_size], arm_b[chunk_size];
};

// visit(i) for each bit i that is set.
template <class Visit>
void each_bit(std::uint32_t bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}
constexpr std::uint32_t lanes_below(std::size_t n) {
  return n < chunk_size ? (std::uint32_t(1) << n) - 1 : ~std::uint32_t(0);
}

class ForcePass {
 public:
  ForcePass(World& world, double dt)
      : world_(world), c_(world.contacts), p_(world.particles), set_(contact::kernels::kernels()), dt_(dt) {
    wanted_.tolerance = world.scene.tolerance;
    wanted_.overlap_only = !world.law.lingers;  // else the gap is wanted of those that hold on
    staged_ = c_.words > 0;
    lingers_ = world.law.lingers;
    far_ = c_.history.size() * sizeof(contact::History) > near_bytes;
    map_ = c_.words > world.law.words + 1 ? world.scene.law.map : LawMap::automatic;
    by_volume_ = map_ == LawMap::volume;
    by_depth_ = wanted_.measure = measures_depth(world);
    by_area_ = measures_area(world);
    for (const ShapeEntry& e : world.shapes)
      if (e.kind == shapes::Kind::polyhedron) thinnest_ = std::min(thinnest_, e.inscribed_radius / e.circumradius);
    lattice_ = world.cell.periodic ? &world.cell.lattice : nullptr;
    for (const Wall& w : world.walls) {
      contact::Body b;
      b.kind = w.kind;
      b.geometry = w.polygon ? static_cast<const void*>(w.polygon.get()) : w.mesh.get();
      b.size = {1, 1, 1};
      b.rotation = shapes::rotation_matrix(w.orientation);
      walls_.push_back({b, b.rotation.column(w.kind == shapes::Kind::line ? 1 : 2)});
      planes_.push_back({w.position, 0, w.velocity, 0, w.spin, 0, walls_.back().normal, 0});
    }
  }

 protected:
  // What is read of body i of a pair that is not round.
  [[gnu::always_inline]] void prefetch_body(std::size_t i) const {
    __builtin_prefetch(&p_.motion[i]);
    __builtin_prefetch(&p_.motion[i].spin);
    __builtin_prefetch(&p_.orientation[i]);
    __builtin_prefetch(&p_.size[i]);
    __builtin_prefetch(&p_.inertia[i]);
  }

  // To a tolerance, contact is what is proven: a search that stops early and a proof of separation agree on it.
  bool overlap(const contact::Contact& q) const { return (wanted_.tolerance > 0 ? q.gap_upper : q.gap) < 0; }

  // Whether record k is to pass the law although its bodies may be apart: it has met, and may hold on.
  bool may_hold(std::size_t k) const { return lingers_ && c_.touching[k] != 0; }

  void begin(std::size_t k, Scratch& s) const {
    if (c_.touching[k] != 0) return;
    c_.touching[k] = 1;
    // At the start, when all come at once, nobody asks for round pairs.
    if (dt_ > 0 || c_.seat[k] < c_.round_seats) s.changed.push_back({static_cast<std::uint32_t>(k), 0});
  }

  void forget(std::size_t k, Scratch& s) const {
    if (c_.touching[k] == 0) return;
    end(k, c_.history_of(k).overlap, s);
  }
  // The contact of record k, which had this overlap before the step.
  void end(std::size_t k, double overlap, Scratch& s) const {
    s.changed.push_back({static_cast<std::uint32_t>(k), overlap});
    if (!c_.ledger.empty()) {
      contact::close(world_.law.loss, dt_, c_.ledger[k]);
      s.changed.back().lost = c_.ledger[k].lost;
      c_.ledger[k] = {};
    }
    c_.touching[k] = 0;
    silence(k);
  }
  // Nothing acts in record k, nothing is remembered.
  void silence(std::size_t k) const {
    std::fill_n(c_.memory.begin() + static_cast<std::ptrdiff_t>(k * c_.words), c_.words, 0.0);
    c_.history_of(k) = {};
    c_.slot[c_.slot_of(k)] = c_.slot[c_.slot_of_b(k)] = {};
  }

  void load_pair(std::size_t i, std::uint32_t pair, Scratch& s) const {
    if (pair == s.pair[i]) return;  // lanes keep their pair of materials from chunk to chunk: it seldom changes
    contact::each_parameter(s.law.pair, world_.pairs[pair],
                            [i](contact::kernels::Lane& lane, double value) { lane[i] = value; });
    s.pair[i] = pair;
    s.pair_everywhere = none;
  }

  // The record numbers of a chunk's lanes, padded for the kernels that take four at a time.
  static void pad(std::uint32_t* list, std::size_t n) {
    for (; n % 4 != 0; ++n) list[n] = list[n - 1];
  }
  // Histories and slots of a chunk back to their seats; the slots are force, couple and couple_b.
  void store_double(const std::uint32_t* seat, std::size_t n, Scratch& s) const {
    set_.store_history(s.law, seat, n, c_.history.data());
    set_.store_double(s.law, seat, n, c_.slot.data());
  }

  void run_law(std::size_t n, bool patch, Scratch& s) const {
    if (staged_) return run_stages(n, patch, s);
    const bool hertz = world_.law.hertzian;
    const auto kernel = patch ? (hertz ? set_.hertz_mindlin_patch : set_.spring_dashpot_patch)
                              : (hertz ? set_.hertz_mindlin : set_.spring_dashpot);
    kernel(s.law, n, dt_, world_.law_options);
  }

  void run_stages(std::size_t n, bool patch, Scratch& s) const {
    contact::kernels::LawWork& w = s.work;
    const std::size_t words = world_.law.words;  // then the map's, and last the energy
    for (std::size_t i = 0; i < n; ++i) {
      const double* memory = &c_.memory[s.record[i] * c_.words];
      for (std::size_t j = 0; j < words; ++j) w.memory[j][i] = memory[j];
      w.gain[i] = s.gained ? s.gain[i] : 1;
    }
    // Idle lanes of the last pack: at rest, without memory.
    for (std::size_t i = n; i % 8 != 0; ++i) {
      for (std::size_t j = 0; j < words; ++j) w.memory[j][i] = 0;
      w.gain[i] = 1;
      s.law.overlap[i] = s.law.history_overlap[i] = 0;
    }
    world_.law.run(s.law, w, n, dt_, world_.law_options, patch);
    for (std::size_t i = 0; i < n; ++i) {
      double* memory = &c_.memory[s.record[i] * c_.words];
      for (std::size_t j = 0; j < words; ++j) memory[j] = w.memory[j][i];
      memory[c_.words - 1] = contact::stored_energy(s.law, w, i);
      if (!c_.ledger.empty() && !over(i, s)) book(i, s);
    }
  }

  void book(std::size_t i, Scratch& s) const {
    const std::size_t k = s.record[i];
    contact::Ledger& ledger = c_.ledger[k];
    const std::uint32_t ib = c_.index_b[k];
    const Vec3d spin_a = p_.motion[c_.index_a[k]].spin;
    const Vec3d spin_b = c_.key[k].b >= wall_base ? world_.walls[ib].spin : p_.motion[ib].spin;
    const Vec3d before =
        get(s.law.velocity, i) + cross(spin_a, ledger.arm_a - s.arm_a[i]) - cross(spin_b, ledger.arm_b - s.arm_b[i]);
    contact::book(s.law, s.work, i, world_.law.loss, dt_, before, ledger);
    ledger.arm_a = s.arm_a[i];
    ledger.arm_b = s.arm_b[i];
    if (dt_ == 0) ledger.lost = {};  // what is there at the start has not been lost
  }

  // After the law: whether the contact of a lane is over.
  bool over(std::size_t i, const Scratch& s) const {
    return !(s.law.history_overlap[i] > 0) && !(lingers_ && s.work.bond[i] > 0);
  }
  void let_go(std::size_t n, Scratch& s) const {
    for (std::size_t i = 0; i < n; ++i)
      if (over(i, s)) forget(s.record[i], s);
  }

  // The n contacts that have been gathered: law, torques about the centres, back to their records.
  void finish(std::size_t n, bool patch, Scratch& s) const {
    LawChunk& l = s.law;
    for (std::size_t i = 0; i < n; ++i) s.seat[i] = c_.seat[s.record[i]];
    pad(s.seat, n);
    set_.load_history(c_.history.data(), s.seat, n, l);
    run_law(n, patch, s);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d f = get(l.force, i);
      Vec3d couple = patch || staged_ ? get(l.couple, i) : Vec3d{};
      if (s.gained && s.screw[i] != 0) {  // of all that goes with the overlap; a force that is cut off has none
        const double elastic = s.work.normal.force[i] != 0 ? s.work.normal.elastic[i] : 0;
        couple -= get(l.normal, i) * (s.screw[i] * (elastic - s.work.pull[i]));
      }
      put(l.couple, i, cross(s.arm_a[i], f) + couple);
      put(l.couple_b, i, -cross(s.arm_b[i], f) - couple);
    }
    store_double(s.seat, n, s);
    if (lingers_) let_go(n, s);
  }

  contact::Body body_of(std::uint32_t i) const {
    const ShapeEntry& e = world_.shapes[p_.shape[i]];
    contact::Body b;
    b.kind = e.kind;
    b.geometry = e.geometry();
    b.size = p_.size[i];
    if (!is_round(e.kind)) b.rotation = shapes::rotation_matrix(p_.orientation[i]);
    return b;
  }

  // 1/m of the point at `arm` along the unit vector n.
  double inverse_mass(std::uint32_t i, const Mat3d& rotation, const Vec3d& arm, const Vec3d& n) const {
    const Vec3d t = transposed_times(rotation, cross(arm, n));
    const Vec3d& inertia = p_.inertia[i];
    return p_.motion[i].inverse_mass + (t.x * t.x / inertia.x + t.y * t.y / inertia.y + t.z * t.z / inertia.z);
  }

  // Where the force of a contact that holds on across a gap acts: midway; of faces in the patch that the same bodies
  // would have if they overlapped by as much: it goes on from where they parted and grows with the gap.
  contact::Patch across_gap(contact::ChunkQuery query, bool faces, std::size_t k, const contact::Body& a,
                            const contact::Body& b, const Vec3d& offset, const contact::Contact& q) const {
    contact::Patch patch{.centre = 0.5 * (q.point_a + q.point_b)};
    if (!faces) return patch;
    const double way = 2 * q.gap + 1e-6 * p_.motion[c_.index_a[k]].bounding_radius;
    const Vec3d moved = offset - q.normal * way;
    contact::Cache cache;
    contact::Contact touch;
    query(1, &a, &b, &moved, {.overlap_only = true, .patch = true}, &cache, &touch);
    if (!(touch.gap < 0) || !(touch.patch.weight > 0)) return patch;
    patch = touch.patch;
    patch.centre += q.normal * (0.5 * way);
    return patch;
  }

  // A touching contact as a query answered it.
  struct Meeting {
    std::uint32_t a, b;    // their places
    bool wall;             // b is one
    double overlap;        // m
    Vec3d normal, centre;  // relative to a's centre
    const double* spread;  // of the patch
    Vec3d offset;          // b's centre less a's, of two bodies
    const Mat3d &rotation_a, &rotation_b;
    double radius_a, radius_b;   // of curvature, as the law takes them; a wall has none
    Vec3d mass_at;               // where the effective mass is that of the contact, relative to a's centre
    double gain = 1, screw = 0;  // of a potential of the overlap: J; h, m
  };

  // Kinematics of contact k into lane n of the law chunk.
  void gather(std::size_t k, std::size_t n, const Meeting& q, Scratch& s) const {
    const std::uint32_t ia = q.a, ib = q.b;
    const Motion& a = p_.motion[ia];
    LawChunk& l = s.law;
    const Vec3d arm_a = q.centre;
    Vec3d velocity = a.velocity + cross(a.spin, arm_a), arm_b, spin_b;
    double radius = q.radius_a, w = inverse_mass(ia, q.rotation_a, q.mass_at, q.normal);
    if (q.wall) {
      const Wall& wall = world_.walls[ib];
      arm_b = a.position + arm_a - wall.position;
      spin_b = wall.spin;
      velocity -= wall.velocity + cross(wall.spin, arm_b);
    } else {
      const Motion& b = p_.motion[ib];
      arm_b = arm_a - q.offset;
      spin_b = b.spin;
      velocity -= b.velocity + cross(b.spin, arm_b);
      if (lattice_ != nullptr) velocity -= lattice_->flow(q.offset);
      radius = radius * q.radius_b / (radius + q.radius_b);
      w += inverse_mass(ib, q.rotation_b, q.mass_at - q.offset, q.normal);
    }
    c_.centre[k] = arm_a;
    s.gain[n] = q.gain;
    s.screw[n] = q.screw;
    l.overlap[n] = q.overlap;
    put(l.normal, n, q.normal);
    put(l.velocity, n, velocity);
    l.turn[n] = 0.5 * dot(a.spin + spin_b, q.normal);
    l.radius_eff[n] = radius;
    l.mass_eff[n] = 1 / w;
    put(l.relative_spin, n, a.spin - spin_b);
    const double* m = q.spread;
    l.spread_xx[n] = m[0];
    l.spread_yy[n] = m[1];
    l.spread_zz[n] = m[2];
    l.spread_xy[n] = m[3];
    l.spread_xz[n] = m[4];
    l.spread_yz[n] = m[5];
    s.arm_a[n] = arm_a;
    s.arm_b[n] = arm_b;
  }
  // Map `volume`: the overlap that q has found, measured. False, and forgotten: a graze by rounding, or one body lies
  // in the other, which is counted.
  bool measure(std::size_t k, const contact::Body& a, const contact::Body& b, const Vec3d& offset,
               const contact::Contact& q, contact::OverlapVolume& out, Tally& t, Scratch& s) const {
    if (contact::overlap_volume(a, b, offset, out)) return true;
    if (-q.gap > 1e-3 * p_.motion[c_.index_a[k]].bounding_radius) ++t.not_converged;
    forget(k, s);
    return false;
  }
  // Lane n of contact k as the map has it; normal from a to b.
  void apply_map(std::size_t k, std::size_t n, const contact::Body& a, const contact::Body& b, const Vec3d& normal,
                 const contact::OverlapVolume& v, Scratch& s) const {
    if (map_ == LawMap::automatic) return;
    double& word = c_.memory[k * c_.words + world_.law.words];
    if (by_volume_) {
      apply_volume(n, v.volume, v.section, v.screw, s);
      word = s.gain[n];
      return;
    }
    if (!(word > 0)) word = radius_of_curvature(a, b, normal, s.law.radius_eff[n]);
    s.law.radius_eff[n] = word;
  }

  // The same of map `volume`: what is gathered with R* in its lane goes to the law as δ_eq.
  void apply_volume(std::size_t n, double volume, double section, double screw, Scratch& s) const {
    EquivalentOverlap e{0, 1};
    if (volume > 0 && section > 0) e = equivalent_overlap(volume, section, s.law.radius_eff[n], by_area_);
    s.law.overlap[n] = e.overlap;
    s.gain[n] = e.gain;
    s.screw[n] = screw;
  }
  // Of a sphere or disc with another one, or with a wall: infinite.
  void apply_round_volume(std::size_t n, double radius_a, double radius_b, Scratch& s) const {
    const double overlap = s.law.overlap[n];
    const contact::VolumeSection v = by_area_ ? contact::disc_overlap(overlap, radius_a, radius_b)
                                              : contact::sphere_overlap(overlap, radius_a, radius_b);
    apply_volume(n, v.volume, v.section, 0, s);
  }
  void apply_round_volumes(std::size_t n, Scratch& s) const {
    for (std::size_t i = 0; i < n; ++i) apply_round_volume(i, s.spheres.radius_a[i], s.spheres.radius_b[i], s);
  }

  World& world_;
  Contacts& c_;
  const Particles& p_;
  const KernelSet& set_;
  double dt_;
  contact::Options wanted_{.overlap_only = true, .patch = true};
  bool staged_ = false, lingers_ = false;
  bool far_ = false;  // histories are too many for the caches near the core: data is fetched ahead
  bool by_volume_ = false, by_depth_ = false, by_area_ = false;
  double thinnest_ = 1;                        // least inscribed over circumradius of the polyhedra
  LawMap map_ = LawMap::automatic;             // where records keep a word of it
  const contact::Lattice* lattice_ = nullptr;  // null: bodies have no images
  std::vector<WallFrame> walls_;
  std::vector<contact::kernels::PlaneRows> planes_;  // of all walls; that of a mesh is not used
};

}  // namespace dem
