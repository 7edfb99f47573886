#include "libdem/analysis/energy.h"

#include "libcontact/laws/ledger.h"

namespace dem::analysis {

Vec3d inertia_of(const Snapshot& s, std::size_t i) {
  const ShapeEntry& shape = s.shape_of(i);
  const double scale = s.radius[i] / shape.equivalent_radius;
  return shape.inertia * (s.mass[i] / shape.volume * (scale * scale));
}

BodyEnergies energies_of(const Snapshot& s) {
  BodyEnergies e;
  for (std::size_t i = 0; i < s.count(); ++i) {
    const Vec3d spin = transposed_times(shapes::rotation_matrix(s.orientation[i]), s.spin[i]);
    e.translational += 0.5 * s.mass[i] * dot(s.velocity[i], s.velocity[i]);
    e.rotational += 0.5 * dot(spin, scaled(inertia_of(s, i), spin));
    e.potential -= s.mass[i] * dot(s.gravity, s.position[i]);
  }
  return e;
}

Result report_energy(const Snapshot& s, const Settings&) {
  Result r;
  if (s.count() == 0) r.notes.emplace_back("no bodies: no energy");
  if (!s.has_mass) {
    r.notes.emplace_back("no masses in the source: no energy");
    return r;
  }
  const BodyEnergies e = energies_of(s);
  if (s.has_velocity) {
    r.add("translational", "J", e.translational);
    r.add("rotational", "J", e.rotational);
  } else {
    r.notes.emplace_back("no velocities in the source: no kinetic energy");
  }
  r.add("potential", "J", e.potential);
  if (s.elastic)
    r.add("elastic", "J", *s.elastic);
  else
    r.notes.emplace_back("energy stored in contacts: not in the source");
  if (s.dissipated.empty())
    r.notes.emplace_back("energy lost by mechanism: of a run under way with law.ledger ([analysis] in the scene)");
  for (std::size_t m = 0; m < s.dissipated.size(); ++m)
    r.add(std::string("lost_") + contact::mechanism_names[m], "J", s.dissipated[m]);
  return r;
}

}  // namespace dem::analysis
