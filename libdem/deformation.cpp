#include "libdem/deformation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/build.h"
#include "libdem/rattlers.h"

namespace dem {
namespace {

constexpr double largest_strain = 0.01;  // of a length in one step

struct Resistance {  // of springs and dashpots to a strain, times V: V M, J; V η, J s
  double stiffness = 0, viscosity = 0;
  void add(double kn, double cn, double overlap_over_strain) {
    const double square = overlap_over_strain * overlap_over_strain;
    stiffness += kn * square;
    viscosity += cn * square;
  }
  Resistance& operator+=(const Resistance& r) {
    stiffness += r.stiffness;
    viscosity += r.viscosity;
    return *this;
  }
};

struct Load {           // of the cell
  Mat3d virial{};       // (2), J
  Resistance along[3];  // to a strain of each axis by itself
  Resistance together;  // to one strain of all axes of the servo
  Load& operator+=(const Load& l) {
    for (int k = 0; k < 3; ++k) {
      virial.row[k] += l.virial.row[k];
      along[k] += l.along[k];
    }
    together += l.together;
    return *this;
  }
};

void add_product(Mat3d& m, const Vec3d& a, const Vec3d& b) {
  for (int k = 0; k < 3; ++k) m.row[k] += b * a[k];
}

// What record k adds; the resistance only where a servo asks for it.
void add_contact(const World& world, std::size_t k, const DeformSpec* servo, Load& sum) {
  const Contacts& c = world.contacts;
  const auto& motion = world.particles.motion;
  const Vec3d d = world.cell.lattice.nearest(motion[c.index_b[k]].position - motion[c.index_a[k]].position);
  add_product(sum.virial, -c.slot[c.slot_of(k)].force, d);
  if (servo == nullptr) return;
  const double kn = contact_stiffness(world, k).n, cn = contact_damping(world, k);
  double all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!servo->follows(axis)) continue;
    const double closing = c.history_of(k).normal[axis] * d[axis];
    sum.along[axis].add(kn, cn, closing);
    all += closing;
  }
  sum.together.add(kn, cn, all);
}

// Each body adds its contacts with bodies of higher id, in order of their ids; then the bodies are added in order of
// id. The order of storage, which depends on rebuilds, does not matter.
Load load_of(const World& world, int threads, const DeformSpec* servo = nullptr) {
  const Contacts& c = world.contacts;
  const Particles& p = world.particles;
  std::vector<Load> of(world.next_id);
  const bool listed = c.active_count.size() == p.count();  // not so in a state that was read from a file
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < p.count(); ++i) {
    Load& sum = of[p.id[i]];
    const Vec3d& v = p.motion[i].velocity;
    add_product(sum.virial, v * p.mass[i], v);
    if (!listed) continue;
    for (std::uint32_t e = c.incidence_start[i]; e < c.incidence_start[i + 1]; ++e) {
      const std::size_t k = c.incidence[e] >> 1;
      if (c.touching[k] != 0 && c.key[k].a == p.id[i] && c.key[k].b < wall_base) add_contact(world, k, servo, sum);
    }
  }
  if (!listed)
    for (std::size_t k = 0; k < c.count(); ++k)
      if (c.touching[k] != 0 && c.key[k].b < wall_base) add_contact(world, k, servo, of[c.key[k].a]);
  Load total;
  for (const Load& l : of) total += l;
  return total;
}

// The entry of periodic.deform that rules the step that begins now; null before the first one.
const DeformSpec* present(const World& world) {
  const DeformSpec* found = nullptr;
  for (const DeformSpec& d : world.scene.periodic.deform)
    if (world.time() >= d.start) found = &d;
  return found;
}

bool is_servo(const DeformSpec* spec) { return spec != nullptr && spec->stress_axes != "none"; }

// (3)
double servo_rate(const DeformSpec& spec, double lacking, const Resistance& resistance, double mass, double volume,
                  double length, double present_rate) {
  const double viscosity = resistance.viscosity / volume;
  const double impedance = length * std::sqrt(mass * resistance.stiffness) / (volume * spec.gain) + viscosity;
  const double wanted = lacking - viscosity * present_rate;
  if (std::abs(wanted) < spec.rate_limit * impedance) return -wanted / impedance;
  return wanted > 0 ? -spec.rate_limit : wanted < 0 ? spec.rate_limit : 0;
}

// The rates of the step that begins now.
void set_rates(World& world, const DeformSpec* spec, const Load& load) {
  Vec3d& rate = world.cell.lattice.rate;
  const Vec3d before = rate;
  rate = spec != nullptr ? spec->strain_rates : Vec3d{};
  if (!is_servo(spec)) return;
  const Vec3d& length = world.cell.lattice.length;
  const double volume = cell_volume(world), mass = world.balance.present.value();
  double lacking = 0, shortest = 0, axes = 0, mean_before = 0;
  for (int k = 0; k < 3; ++k) {
    if (!spec->follows(k)) continue;
    const double lack = spec->target_stress[k] - load.virial.row[k][k] / volume;
    rate[k] = servo_rate(*spec, lack, load.along[k], mass, volume, length[k], before[k]);
    lacking += lack;
    mean_before += before[k];
    shortest = axes == 0 ? length[k] : std::min(shortest, length[k]);
    axes += 1;
  }
  if (!spec->isotropic) return;
  const Resistance mean{load.together.stiffness / axes, load.together.viscosity / axes};
  const double common = servo_rate(*spec, lacking / axes, mean, mass, volume, shortest, mean_before / axes);
  for (int k = 0; k < 3; ++k)
    if (spec->follows(k)) rate[k] = common;
}

// Load of the present state, and the rates that follow from it.
Load steer(World& world, int threads) {
  const DeformSpec* spec = present(world);
  const Load load = load_of(world, threads, is_servo(spec) ? spec : nullptr);
  set_rates(world, spec, load);
  return load;
}

}  // namespace

void make_cell(World& world) {
  const PeriodicSpec& s = world.scene.periodic;
  Cell& cell = world.cell;
  for (int k = 0; k < 3; ++k) {
    if (!s.along(k)) continue;
    cell.periodic = true;
    cell.lower[k] = s.lower[k];
    cell.centre[k] = 0.5 * (s.lower[k] + s.upper[k]);
    cell.lattice.length[k] = s.upper[k] - s.lower[k];
    cell.lattice.inverse[k] = 1 / cell.lattice.length[k];
  }
  cell.deforms = !s.deform.empty();
}

void start_cell(World& world) {
  if (!world.cell.deforms) return;
  const double dt = world.time_step.dt;
  for (const DeformSpec& d : world.scene.periodic.deform) {
    const double fastest = std::max(shapes::max_abs(d.strain_rates), d.rate_limit);
    if (fastest * dt > largest_strain)
      input_error(d.where, fmt::format("periodic.deform: a rate of {} 1/s changes the box by {:.3g} % in one time step "
                                       "of {:.3g} s; allowed: up to {} %",
                                       fastest, 100 * fastest * dt, dt, 100 * largest_strain));
  }
  world.cell.virial = steer(world, 1).virial;
}

CellStep deform_box(Cell& cell, double dt) {
  CellStep step;
  for (int k = 0; k < 3; ++k) {
    const double e = cell.lattice.rate[k] * dt;
    step.slowed[k] = (1 - 0.25 * e) / (1 + 0.25 * e);
    step.scale[k] = (1 + 0.5 * e) / (1 - 0.5 * e);
    cell.stretch[k] *= step.scale[k];
  }
  cell.set_lengths(scaled(cell.lattice.length, step.scale));
  return step;
}

void book_flow(World& world, const CellStep& step) {
  Balance& b = world.balance;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double now = b.initial_momentum[i] + b.impulse[i].value() - b.removed_momentum[i].value();
    b.impulse[i].add(now * (step.slowed[k] - 1));
  }
}

void finish_cell_step(World& world, int threads, double dt) {
  Cell& cell = world.cell;
  const double needed = 2 * world.contacts.largest_sum;
  for (int k = 0; k < 3; ++k) {
    const double length = cell.lattice.length[k];
    if (length > 0 && length < needed)
      throw RunError(
          fmt::format("step {}: the periodic box has become {} m long in {}, too short for one image of "
                      "each body at a time; allowed: from {} m, four times the largest bounding radius",
                      world.step, length, "xyz"[k], needed));
  }
  const Vec3d rate = cell.lattice.rate;
  const Mat3d virial = steer(world, threads).virial;
  for (int k = 0; k < 3; ++k) cell.work.add(-0.5 * dt * rate[k] * (cell.virial.row[k][k] + virial.row[k][k]));
  cell.virial = virial;
}

bool is_whole(const World& world) {
  const Scene& s = world.scene;
  for (int k = 0; k < s.dimension; ++k)
    if (!s.periodic.along(k)) return false;
  return s.dimension == 3 || s.disc_model == DiscModel::prism;
}

double cell_volume(const World& world) {
  const Vec3d& length = world.cell.lattice.length;
  return length.x * length.y * (world.scene.dimension == 2 ? world.scene.thickness : length.z);
}

Mat3d cell_stress(const World& world) {
  Mat3d s = world.cell.deforms ? world.cell.virial : load_of(world, 1).virial;
  for (Vec3d& row : s.row) row *= 1 / cell_volume(world);
  return s;
}

double solid_fraction(const World& world) {
  const bool planar = world.scene.dimension == 2;
  const Vec3d& length = world.cell.lattice.length;
  double sum = 0;
  for (const std::uint32_t i : order_by_id(world)) {
    const double r = world.particles.motion[i].equivalent_radius;
    sum += planar ? r * r : r * r * r;
  }
  if (planar) return sum * std::numbers::pi / (length.x * length.y);
  return sum * (4.0 / 3.0 * std::numbers::pi) / cell_volume(world);
}

Coordination coordination(const World& world) {
  const Contacts& c = world.contacts;
  const std::size_t count = world.particles.count();
  Coordination result;
  if (count == 0) return result;
  std::vector<BodyPair> pairs;
  for (std::size_t k = 0; k < c.count(); ++k)
    if (c.touching[k] != 0 && c.key[k].b < wall_base) pairs.emplace_back(std::minmax(c.index_a[k], c.index_b[k]));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const bool friction =
      std::any_of(world.pairs.begin(), world.pairs.end(), [](const PairParameters& q) { return q.friction > 0; });
  const std::uint32_t least = friction ? 2 : static_cast<std::uint32_t>(world.scene.dimension) + 1;
  const std::vector<std::uint8_t> rattles = rattlers(count, pairs, {}, least);
  const auto rattling = static_cast<std::size_t>(std::count(rattles.begin(), rattles.end(), std::uint8_t(1)));
  const auto held = std::count_if(pairs.begin(), pairs.end(),
                                  [&](const BodyPair& p) { return rattles[p.first] == 0 && rattles[p.second] == 0; });
  const auto n = static_cast<double>(count);
  result.pairs = pairs.size();
  result.all = 2 * static_cast<double>(pairs.size()) / n;
  result.rattlers = static_cast<double>(rattling) / n;
  if (rattling < count) result.backbone = 2 * static_cast<double>(held) / static_cast<double>(count - rattling);
  return result;
}

}  // namespace dem
