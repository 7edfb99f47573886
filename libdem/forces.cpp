#include "libdem/forces.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "libcontact/kernels/chunk.h"
#include "libdem/walls.h"

namespace dem {
namespace {

using contact::kernels::chunk_size;
using contact::kernels::KernelSet;
using contact::kernels::Lane3;
using contact::kernels::LawChunk;
using contact::kernels::SphereChunk;

void put(Lane3& lane, std::size_t i, const Vec3d& v) {
  lane.x[i] = v.x;
  lane.y[i] = v.y;
  lane.z[i] = v.z;
}
Vec3d get(const Lane3& lane, std::size_t i) { return {lane.x[i], lane.y[i], lane.z[i]}; }

struct WallFrame {  // of this step
  contact::Body body;
  Vec3d normal;  // plane, line
};

struct Tally {
  std::uint64_t queries = 0, touching = 0, not_converged = 0, uncertified = 0;
  Tally& operator+=(const Tally& t) {
    queries += t.queries;
    touching += t.touching;
    not_converged += t.not_converged;
    uncertified += t.uncertified;
    return *this;
  }
};

// One thread's working set; reused over its chunks.
struct Scratch {
  std::vector<std::uint32_t> changed;  // records whose contact came or went
  LawChunk law;
  SphereChunk spheres;
  contact::kernels::Lane clearance;
  std::uint32_t entry[chunk_size] = {};
  std::uint32_t pair[chunk_size];  // the pair of materials that each lane of `law` holds
  std::uint32_t record[chunk_size] = {}, index_a[chunk_size] = {}, index_b[chunk_size] = {};
  contact::Body a[chunk_size], b[chunk_size];
  Vec3d offset[chunk_size];
  contact::Cache cache[chunk_size];
  contact::Contact answer[chunk_size];
  Vec3d arm_a[chunk_size], arm_b[chunk_size];
};

class ForcePass {
 public:
  ForcePass(World& world, double dt)
      : world_(world), c_(world.contacts), p_(world.particles), set_(contact::kernels::kernels()), dt_(dt) {
    rescale_ = world.scene.law.rescale;
    hertz_ = world.scene.law.name == LawName::hertz_mindlin;
    lattice_ = world.cell.periodic ? &world.cell.lattice : nullptr;
    for (const Wall& w : world.walls) {
      contact::Body b;
      b.kind = w.kind;
      b.geometry = w.mesh.get();
      b.size = {1, 1, 1};
      b.rotation = shapes::rotation_matrix(w.orientation);
      walls_.push_back({b, b.rotation.column(w.kind == shapes::Kind::line ? 1 : 2)});
    }
  }

  // Records first … last of a bin, chunk by chunk.
  Tally answer(const Bin& bin, std::size_t first, std::size_t last, Scratch& s) const {
    Tally t;
    for (; first < last; first += chunk_size) {
      const std::size_t count = std::min(chunk_size, last - first);
      if (bin.query != nullptr)
        t += general(bin, first, count, s);
      else
        t += is_half_space(bin.b) ? sphere_planes(bin, first, count, s) : sphere_pairs(bin, first, count, s);
    }
    return t;
  }

 private:
  void begin(std::size_t k, Scratch& s) const {
    if (c_.touching[k] != 0) return;
    c_.touching[k] = 1;
    s.changed.push_back(static_cast<std::uint32_t>(k));
  }

  void forget(std::size_t k, Scratch& s) const {
    if (c_.touching[k] == 0) return;
    c_.history[k] = {};
    c_.touching[k] = 0;
    c_.slot[k] = {};
    s.changed.push_back(static_cast<std::uint32_t>(k));
  }

  void load_pair(std::size_t i, std::uint32_t pair, Scratch& s) const {
    if (pair == s.pair[i]) return;  // lanes keep their pair of materials from chunk to chunk: it seldom changes
    LawChunk& l = s.law;
    const PairParameters& q = world_.pairs[pair];
    l.young_eff[i] = q.young_eff;
    l.shear_eff[i] = q.shear_eff;
    l.stiffness_n[i] = q.stiffness_n;
    l.stiffness_t[i] = q.stiffness_t;
    l.friction[i] = q.friction;
    l.damping[i] = q.damping;
    s.pair[i] = pair;
  }

  // The record numbers of a chunk's lanes, padded for the kernels that take four at a time.
  static void pad(std::uint32_t* list, std::size_t n) {
    for (; n % 4 != 0; ++n) list[n] = list[n - 1];
  }
  void load_histories(std::size_t n, Scratch& s) const {
    pad(s.record, n);
    set_.load_history(c_.history.data(), s.record, n, s.law);
  }
  // Histories and slots of a chunk back to their records; the slots are force, couple and couple_b.
  void store(std::size_t n, Scratch& s) const {
    set_.store_history(s.law, s.record, n, c_.history.data());
    set_.store_slots(s.law, s.record, n, c_.slot.data());
  }

  void run_law(LawChunk& l, std::size_t n, bool patch) const {
    const auto kernel = patch ? (hertz_ ? set_.hertz_mindlin_patch : set_.spring_dashpot_patch)
                              : (hertz_ ? set_.hertz_mindlin : set_.spring_dashpot);
    kernel(l, n, dt_, rescale_);
  }

  // Sphere pairs: squared distances first, branch-free, while the memory of those that touch is on its way; then the
  // few that do go through the kernels.
  Tally sphere_pairs(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
    Tally t;
    std::size_t n = 0;
    LawChunk& l = s.law;
    const std::uint32_t *records = &bin.records[first], *a = &bin.a_index[first], *b = &bin.b_index[first];
    if (lattice_ != nullptr)
      set_.periodic_clearance(p_.motion.data(), a, b, count, *lattice_, s.clearance);
    else
      set_.sphere_clearance(p_.motion.data(), a, b, count, s.clearance);
    for (std::size_t r = 0; r < count; ++r) {
      const bool touches = s.clearance[r] < 0;
      s.entry[n] = static_cast<std::uint32_t>(r);
      n += touches ? 1 : 0;
      if (touches != (c_.touching[records[r]] != 0)) {  // seldom
        if (touches)
          begin(records[r], s);
        else
          forget(records[r], s);
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t r = s.entry[i];
      const std::uint32_t k = records[r];
      __builtin_prefetch(&c_.history[k], 1);
      __builtin_prefetch(&c_.slot[k], 1);
      s.record[i] = k;
      s.index_a[i] = a[r];
      s.index_b[i] = b[r];
      load_pair(i, bin.pair[first + r], s);
    }
    pad(s.index_a, n);
    pad(s.index_b, n);
    if (lattice_ != nullptr)
      set_.periodic_gather(p_.motion.data(), s.index_a, s.index_b, n, *lattice_, s.spheres, l);
    else
      set_.gather_spheres(p_.motion.data(), s.index_a, s.index_b, n, s.spheres, l);
    load_histories(n, s);
    set_.spheres(s.spheres, l, n);
    run_law(l, n, false);
    set_.sphere_torques(s.spheres, l, n);
    store(n, s);
    // The squares said touching, the root may round to no overlap.
    for (std::size_t i = 0; i < n; ++i)
      if (!(l.history_overlap[i] > 0)) forget(s.record[i], s);
    t.queries = count;
    t.touching = n;
    return t;
  }

  Tally sphere_planes(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
    const std::uint32_t* records = &bin.records[first];
    Tally t;
    std::size_t n = 0;
    LawChunk& l = s.law;
    for (std::size_t r = 0; r < count; ++r) {
      const std::size_t k = records[r];
      const std::uint32_t w = c_.index_b[k];
      const Wall& wall = world_.walls[w];
      const Motion& a = p_.motion[c_.index_a[k]];
      const Vec3d m = walls_[w].normal;
      const double height = dot(m, a.position - wall.position), overlap = a.bounding_radius - height;
      if (!(overlap > 0)) {
        forget(k, s);
        continue;
      }
      const double arm = a.bounding_radius - 0.5 * overlap;
      const Vec3d normal = -m, lever = normal * arm;
      const Vec3d wall_arm = a.position + lever - wall.position;
      put(l.normal, n, normal);
      l.overlap[n] = overlap;
      put(l.velocity, n, a.velocity + cross(a.spin, lever) - wall.velocity - cross(wall.spin, wall_arm));
      l.turn[n] = 0.5 * dot(a.spin + wall.spin, normal);
      l.radius_eff[n] = a.bounding_radius;
      l.mass_eff[n] = 1 / a.inverse_mass;
      load_pair(n, bin.pair[first + r], s);
      s.arm_a[n] = lever;
      s.arm_b[n] = wall_arm;
      begin(k, s);
      s.record[n++] = static_cast<std::uint32_t>(k);
    }
    load_histories(n, s);
    run_law(l, n, false);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d f = get(l.force, i);
      put(l.couple, i, cross(s.arm_a[i], f));
      put(l.couple_b, i, -cross(s.arm_b[i], f));
    }
    store(n, s);
    t.queries = count;
    t.touching = n;
    return t;
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
  double inverse_mass(std::uint32_t i, const contact::Body& b, const Vec3d& arm, const Vec3d& n) const {
    const Vec3d t = transposed_times(b.rotation, cross(arm, n));
    const Vec3d& inertia = p_.inertia[i];
    return p_.motion[i].inverse_mass + (t.x * t.x / inertia.x + t.y * t.y / inertia.y + t.z * t.z / inertia.z);
  }

  Tally general(const Bin& bin, std::size_t first, std::size_t count, Scratch& s) const {
    const std::uint32_t* records = &bin.records[first];
    for (std::size_t r = 0; r < count; ++r) {
      const std::size_t k = records[r];
      const std::uint32_t ia = c_.index_a[k], ib = c_.index_b[k];
      s.a[r] = body_of(ia);
      const Vec3d& x = p_.motion[ia].position;
      if (c_.key[k].b >= wall_base) {
        s.b[r] = walls_[ib].body;
        s.b[r].part = c_.key[k].part;
        s.offset[r] = world_.walls[ib].position - x;
        // The plane's own origin may be far away: its foot below the body serves as well and keeps every digit.
        if (is_half_space(bin.b)) s.offset[r] = walls_[ib].normal * dot(walls_[ib].normal, s.offset[r]);
      } else {
        s.b[r] = body_of(ib);
        s.offset[r] = p_.motion[ib].position - x;
        if (lattice_ != nullptr) s.offset[r] = lattice_->nearest(s.offset[r]);
      }
      s.cache[r] = c_.cache[k];
    }
    bin.query(count, s.a, s.b, s.offset, {.overlap_only = true, .patch = true}, s.cache, s.answer);
    Tally t;
    t.queries = count;
    LawChunk& l = s.law;
    std::size_t n = 0;
    for (std::size_t r = 0; r < count; ++r) {
      const std::size_t k = records[r];
      const contact::Contact& q = s.answer[r];
      c_.cache[k] = s.cache[r];
      const bool refused = q.status == contact::Status::refused;
      if (refused || q.status == contact::Status::not_converged) ++t.not_converged;
      if (refused || !(q.gap < 0)) {
        forget(k, s);
        continue;
      }
      if (!q.certified) ++t.uncertified;
      load_pair(n, bin.pair[first + r], s);
      gather(k, r, n, q, s);
      begin(k, s);
      s.record[n++] = static_cast<std::uint32_t>(k);
    }
    t.touching = n;
    const bool patch = bin.a == shapes::Kind::polyhedron || bin.a == shapes::Kind::rounded_polyhedron ||
                       bin.a == shapes::Kind::polygon;
    load_histories(n, s);
    run_law(l, n, patch);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d f = get(l.force, i), couple = patch ? get(l.couple, i) : Vec3d{};
      put(l.couple, i, cross(s.arm_a[i], f) + couple);
      put(l.couple_b, i, -cross(s.arm_b[i], f) - couple);
    }
    store(n, s);
    return t;
  }

  // Kinematics of contact k, answered as q from entry r of the query, into lane n of the law chunk.
  void gather(std::size_t k, std::size_t r, std::size_t n, const contact::Contact& q, Scratch& s) const {
    const std::uint32_t ia = c_.index_a[k], ib = c_.index_b[k];
    const Motion& a = p_.motion[ia];
    LawChunk& l = s.law;
    const Vec3d arm_a = q.patch.centre;
    Vec3d velocity = a.velocity + cross(a.spin, arm_a), arm_b, spin_b;
    double radius = a.equivalent_radius, w = inverse_mass(ia, s.a[r], arm_a, q.normal);
    if (c_.key[k].b >= wall_base) {
      const Wall& wall = world_.walls[ib];
      arm_b = a.position + arm_a - wall.position;
      spin_b = wall.spin;
      velocity -= wall.velocity + cross(wall.spin, arm_b);
    } else {
      const Motion& b = p_.motion[ib];
      arm_b = arm_a - s.offset[r];
      spin_b = b.spin;
      velocity -= b.velocity + cross(b.spin, arm_b);
      if (lattice_ != nullptr) velocity -= lattice_->flow(s.offset[r]);
      radius = radius * b.equivalent_radius / (radius + b.equivalent_radius);
      w += inverse_mass(ib, s.b[r], arm_b, q.normal);
    }
    c_.centre[k] = arm_a;
    l.overlap[n] = -q.gap;
    put(l.normal, n, q.normal);
    put(l.velocity, n, velocity);
    l.turn[n] = 0.5 * dot(a.spin + spin_b, q.normal);
    l.radius_eff[n] = radius;
    l.mass_eff[n] = 1 / w;
    put(l.relative_spin, n, a.spin - spin_b);
    const double* m = q.patch.spread;
    l.spread_xx[n] = m[0];
    l.spread_yy[n] = m[1];
    l.spread_zz[n] = m[2];
    l.spread_xy[n] = m[3];
    l.spread_xz[n] = m[4];
    l.spread_yz[n] = m[5];
    s.arm_a[n] = arm_a;
    s.arm_b[n] = arm_b;
  }

  World& world_;
  Contacts& c_;
  const Particles& p_;
  const KernelSet& set_;
  double dt_;
  bool rescale_ = true, hertz_ = true;
  const contact::Lattice* lattice_ = nullptr;  // null: bodies have no images
  std::vector<WallFrame> walls_;
};

// Lists the touching records of both bodies of record k anew; the order stays that of the partners.
void relist(Contacts& c, std::uint32_t k) {
  const auto body = [&](std::uint32_t i) {
    const std::uint32_t first = c.incidence_start[i];
    std::uint32_t n = 0;
    for (std::uint32_t e = first; e < c.incidence_start[i + 1]; ++e)
      if (c.touching[c.incidence[e] >> 1] != 0) c.active[first + n++] = c.incidence[e];
    c.active_count[i] = n;
  };
  body(c.index_a[k]);
  if (c.key[k].b < wall_base) body(c.index_b[k]);
}

}  // namespace

void compute_forces(World& world, int threads, double dt) {
  const auto begin = std::chrono::steady_clock::now();
  const ForcePass pass(world, dt);
  // Tasks of about ten microseconds, the dear ones first, so that threads end together.
  struct Task {
    const Bin* bin;
    std::size_t first, last;
  };
  std::vector<Task> tasks;
  const auto add = [&tasks](const Bin& bin, std::size_t size) {
    for (std::size_t i = 0; i < bin.records.size(); i += size)
      tasks.push_back({&bin, i, std::min(i + size, bin.records.size())});
  };
  for (const Bin& b : world.contacts.bins)
    if (b.query != nullptr) add(b, chunk_size / 2);
  for (const Bin& b : world.contacts.bins)
    if (b.query == nullptr) add(b, 8 * chunk_size);
  Tally total;
  std::vector<std::uint32_t> changed;
#pragma omp parallel num_threads(threads)
  {
    static thread_local Scratch scratch;
    std::fill(std::begin(scratch.pair), std::end(scratch.pair), ~std::uint32_t(0));
    Tally mine;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      mine += pass.answer(*tasks[i].bin, tasks[i].first, tasks[i].last, scratch);
    }
#pragma omp critical
    {
      total += mine;
      changed.insert(changed.end(), scratch.changed.begin(), scratch.changed.end());
      scratch.changed.clear();
    }
  }
  for (const std::uint32_t k : changed) relist(world.contacts, k);
  world.counters.queries += total.queries;
  world.counters.contact_steps += total.touching;
  world.counters.not_converged += total.not_converged;
  world.counters.uncertified += total.uncertified;
  world.times.query += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void sum_forces(World& world, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  const Contacts& c = world.contacts;
  Particles& p = world.particles;
  const KernelSet& set = contact::kernels::kernels();
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < p.count(); ++i) {
    contact::kernels::Total total;
    set.sum_slots(c.slot.data(), c.active.data() + c.incidence_start[i], c.active_count[i], total);
    p.force[i] = {total.force[0], total.force[1], total.force[2]};
    p.torque[i] = {total.torque[0], total.torque[1], total.torque[2]};
  }
  for (Wall& w : world.walls) w.force = w.torque = {};
  for (const std::uint32_t k : c.wall_records) {
    if (c.touching[k] == 0) continue;
    Wall& w = world.walls[c.index_b[k]];
    w.force -= c.slot[k].force;
    w.torque += c.slot[k].torque_b;
  }
  sum_resistance(world);
  world.times.sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dem
