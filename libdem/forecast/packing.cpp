#include "libdem/forecast/packing.h"

#include <algorithm>
#include <cmath>

#include "libdem/build.h"
#include "libdem/random.h"

namespace dem::forecast {
namespace {

// How dear a body's contacts are, relative to a sphere's; decides the size of the sample only.
double dearness(shapes::Kind k) {
  if (k == shapes::Kind::compound || k == shapes::Kind::potential_particle) return 30;
  if (is_round(k)) return 1;
  return k == shapes::Kind::ellipse || k == shapes::Kind::ellipsoid ? 4 : 12;
}

// The world's shapes, materials, law and step, and nothing else of it; it cannot stop for its doubts.
World emptied(const World& world) {
  const Scene& scene = world.scene;
  World w;
  w.scene.path = scene.path;
  w.scene.run = scene.run;
  w.scene.output = scene.output;
  w.scene.dimension = scene.dimension;
  w.scene.disc_model = scene.disc_model;
  w.scene.thickness = scene.thickness;
  w.scene.method = scene.method;
  w.scene.law = scene.law;
  w.scene.materials = scene.materials;
  w.scene.pairs = scene.pairs;
  w.scene.run.rebuild_every = 0;
  w.scene.run.max_uncertified_share = 1;
  w.shapes = world.shapes;
  w.materials = world.materials;
  w.pairs = world.pairs;
  w.law = world.law;
  w.law_options = world.law_options;
  w.skin = world.skin;
  w.time_step = world.time_step;
  return w;
}

void add_copy(World& sample, const World& world, std::size_t i, const Vec3d& position, const Quatd& orientation) {
  const Particles& p = world.particles;
  const double scale = p.size[i].x / world.shapes[p.shape[i]].size.x;
  add_particle(sample, p.shape[i], p.material[i], scale, position, orientation, {}, {});
}

void set_box(World& w, int dimension, double length) {
  w.cell.periodic = true;
  for (int k = 0; k < dimension; ++k) {
    w.cell.lattice.length[k] = length;
    w.cell.lattice.inverse[k] = 1 / length;
  }
}

// Half of all motion goes; what is pressed together still moves apart within a few steps.
void damp(World& w) {
  for (Motion& m : w.particles.motion) {
    m.velocity *= 0.5;
    m.spin *= 0.5;
  }
  for (Vec3d& l : w.particles.angular_momentum) l *= 0.5;
}

double touching_share(const World& w) {
  const auto touching = std::count_if(w.contacts.touching.begin(), w.contacts.touching.end(), [](auto t) { return t; });
  return static_cast<double>(touching) / static_cast<double>(w.particles.count());
}

struct Sizes {
  double smallest = 0, largest = 0, bounding = 0;  // equivalent radii; largest bounding radius
  double solid = 0;                                // volume, m³; of the plane: area, m²
};
Sizes sizes_of(const World& w) {
  Sizes s;
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Motion& m = w.particles.motion[i];
    const double r = m.equivalent_radius;
    s.smallest = i == 0 ? r : std::min(s.smallest, r);
    s.largest = std::max(s.largest, r);
    s.bounding = std::max(s.bounding, m.bounding_radius);
    s.solid += w.scene.dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3 * std::numbers::pi * r * r * r;
  }
  return s;
}

}  // namespace

World lone_body(const World& world) {
  World w = emptied(world);
  if (world.particles.count() > 0) add_copy(w, world, 0, {}, {});
  return w;
}

Packing packed_sample(const World& world) {
  const Particles& p = world.particles;
  const int dimension = world.scene.dimension;
  double dear = 0;
  for (const shapes::Kind k : p.kind) dear += dearness(k);
  dear /= static_cast<double>(p.count());
  const double wanted = std::clamp(3000 / dear, 216.0, 3000.0);
  const auto side = static_cast<std::size_t>(dimension == 2 ? std::sqrt(wanted) : std::cbrt(wanted));
  const std::size_t n = dimension == 2 ? side * side : side * side * side;

  // Bodies evenly by id, at random places of the lattice.
  Packing sample{emptied(world)};
  World& w = sample.world;
  const std::vector<std::uint32_t> order = order_by_id(world);
  std::vector<std::size_t> place(n);
  for (std::size_t i = 0; i < n; ++i) place[i] = i;
  for (std::size_t i = n; i > 1; --i) std::swap(place[i - 1], place[Random(1, 0, i).bits() % i]);
  double bounding = 0;
  for (const Motion& m : p.motion) bounding = std::max(bounding, m.bounding_radius);
  const double pitch = 2 * bounding;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = n <= p.count() ? i * p.count() / n : i % p.count();
    const std::size_t at[3] = {place[i] % side, place[i] / side % side, place[i] / (side * side)};
    Vec3d x;
    for (int k = 0; k < dimension; ++k) x[k] = (static_cast<double>(at[k]) + 0.5) * pitch;
    Random random(1, 1, i);
    add_copy(w, world, order[from], x, dimension == 2 ? random.turn() : random.rotation());
  }
  double length = static_cast<double>(side) * pitch;
  set_box(w, dimension, length);
  const Sizes sizes = sizes_of(w);
  const double shortest = 2 * (2 * sizes.bounding + w.skin) * (1 + 1e-6);
  const double evenness = sizes.smallest / sizes.largest;
  const double goal = dimension == 2 ? 1.8 : 2.4;  // touching pairs per body
  w.time_step.dt = 0.4 * world.time_step.limit;
  try {
    for (int i = 0; i < 300 && length > shortest && !sample.packed; ++i) {
      advance(w, 1);
      w.step = 0;  // the monitor of the time step looks at real runs only
      damp(w);
      const double touching = touching_share(w);
      sample.packed = touching >= goal;
      if (sample.packed) break;
      const double shrink = 1 - std::min(touching > 0 ? 0.005 : 0.02, (touching > 0 ? 0.05 : 0.25) * evenness);
      length *= shrink;
      set_box(w, dimension, length);
      for (Motion& m : w.particles.motion) m.position *= shrink;
      w.contacts.stale = true;
    }
  } catch (const RunError&) {
    sample.packed = false;
  }
  w.time_step.dt = world.time_step.dt;
  for (Motion& m : w.particles.motion) m.velocity = m.spin = {};
  for (Vec3d& l : w.particles.angular_momentum) l = {};
  sample.solid_fraction = sizes.solid / std::pow(length, dimension);
  sample.contacts_per_body = touching_share(w);
  sample.records_per_body = static_cast<double>(w.contacts.count()) / static_cast<double>(n);
  return sample;
}

}  // namespace dem::forecast
