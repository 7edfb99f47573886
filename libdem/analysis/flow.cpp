#include "libdem/analysis/flow.h"

#include <cmath>

#include "libdem/analysis/groups.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

std::vector<FlowSlab> flow_profile(const Snapshot& s, const Domain& region, int axis, int slabs) {
  std::array<int, 3> boxes{1, 1, 1};
  boxes[static_cast<std::size_t>(axis)] = slabs;
  const Grid grid(s, region, boxes);
  std::vector<FlowSlab> list(grid.size());
  std::vector<std::size_t> slab(s.count());
  for (std::size_t i = 0; i < s.count(); ++i) {
    slab[i] = grid.index(s.position[i]);
    if (slab[i] == Grid::none) continue;
    FlowSlab& f = list[slab[i]];
    f.bodies += 1;
    f.mass += s.mass[i];
    f.velocity += s.velocity[i] * s.mass[i];
    f.spin += s.spin[i];
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    FlowSlab& f = list[k];
    f.middle = grid.centre(k)[axis];
    if (f.bodies <= 0) continue;
    if (grid.box_volume() > 0) f.mass_flux = f.velocity[axis] / grid.box_volume();
    f.velocity *= f.mass > 0 ? 1 / f.mass : 0;
    f.spin *= 1 / f.bodies;
  }
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (slab[i] == Grid::none) continue;
    FlowSlab& f = list[slab[i]];
    const Vec3d v = s.velocity[i] - f.velocity;
    f.temperature += dot(v, v) / (s.dimension * f.bodies);
  }
  return list;
}

Exchange exchange_between(const Snapshot& before, const Snapshot& now) {
  Exchange e;
  e.interval = now.time - before.time;
  const auto missing = [](const Snapshot& s, const Snapshot& other, std::vector<std::uint32_t>& list, double& mass) {
    const std::vector<std::uint32_t> place = places_in(s, other);
    for (std::uint32_t i = 0; i < place.size(); ++i) {
      if (place[i] != Groups::none) continue;
      list.push_back(i);
      mass += s.mass[i];
    }
  };
  missing(before, now, e.left, e.left_mass);
  missing(now, before, e.came, e.came_mass);
  return e;
}

void Residence::add(const Snapshot& s) {
  std::vector<Guest> next;
  std::size_t k = 0;
  const double between = 0.5 * (time_ + s.time);
  const auto leave = [&](const Guest& g) { stays_.push_back({g.id, g.entered, between, g.from_start}); };
  for (const std::uint64_t id : s.id) {
    while (k < present_.size() && present_[k].id < id) leave(present_[k++]);
    if (k < present_.size() && present_[k].id == id)
      next.push_back(present_[k++]);
    else
      next.push_back({id, s.time, first_});
  }
  while (k < present_.size()) leave(present_[k++]);
  present_ = std::move(next);
  time_ = s.time;
  first_ = false;
}

namespace {

Table profile_table(const Snapshot& s, const Domain& region, int axis, int slabs) {
  const std::string name{"xyz"[axis]};
  Table t = table_of(name, "Mean velocity along " + name + ", of the bodies whose centres are in a slab",
                     {{name, "m"},
                      {"bodies", "1"},
                      {"mass", "kg"},
                      {"velocity_x", "m/s"},
                      {"velocity_y", "m/s"},
                      {"velocity_z", "m/s"},
                      {"spin_x", "rad/s"},
                      {"spin_y", "rad/s"},
                      {"spin_z", "rad/s"},
                      {"temperature", "m^2/s^2"},
                      {"mass_flux", "kg/(m^2 s)"}});
  for (const FlowSlab& f : flow_profile(s, region, axis, slabs))
    add_row(t, f.middle, f.bodies, f.mass, f.velocity.x, f.velocity.y, f.velocity.z, f.spin.x, f.spin.y, f.spin.z,
            f.temperature, f.mass_flux);
  return t;
}

void add_exchange(Result& r, const Snapshot& now, const Settings& settings) {
  const Exchange e = exchange_between(*settings.before, now);
  r.add("left", "1", static_cast<double>(e.left.size()));
  r.add("came", "1", static_cast<double>(e.came.size()));
  if (!(e.interval > 0)) {
    r.notes.emplace_back("no rates: the frame before is not earlier");
    return;
  }
  r.add("discharge_rate", "kg/s", e.left_mass / e.interval);
  r.add("discharge_rate_bodies", "1/s", static_cast<double>(e.left.size()) / e.interval);
  r.add("inflow_rate", "kg/s", e.came_mass / e.interval);
  if (settings.reference == nullptr || e.left.empty()) return;
  const Snapshot& reference = *settings.reference;
  const std::vector<std::uint32_t> there = places_in(*settings.before, reference);
  double known = 0;
  for (const std::uint32_t i : e.left) known += there[i] != Groups::none ? 1 : 0;
  r.add("left_since_reference", "1", known);
  if (known > 0) r.add("residence_since_reference", "s", now.time - 0.5 * e.interval - reference.time);
}

}  // namespace

Result report_flow(const Snapshot& s, const Settings& settings) {
  Result r;
  if (settings.before != nullptr)
    add_exchange(r, s, settings);
  else
    r.notes.emplace_back("first frame: no rates");
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  if (!s.has_velocity) {
    r.notes.emplace_back("velocities are not known");
    return r;
  }
  const Domain region = region_of(s, settings);
  const std::array<int, 3> boxes = boxes_of(s, region, settings.boxes);
  for (int axis = 0; axis < s.dimension; ++axis)
    r.tables.push_back(profile_table(s, region, axis, boxes[static_cast<std::size_t>(axis)]));
  return r;
}

}  // namespace dem::analysis
