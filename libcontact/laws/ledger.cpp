#include "libcontact/laws/ledger.h"

namespace contact {

void book(const kernels::LawChunk& c, const kernels::LawWork& w, std::size_t i, double dt, Loss loss, Ledger& l) {
  const auto get = [i](const kernels::Lane3& lane) { return shapes::Vec3d{lane.x[i], lane.y[i], lane.z[i]}; };
  const auto add = [&](Mechanism m, double work) { l.lost[static_cast<std::size_t>(m)] += work; };
  const shapes::Vec3d n = get(c.normal), v = get(c.velocity);
  const double closing = dot(v, n);
  const shapes::Vec3d slip = v - n * closing;

  const double elastic = w.normal.elastic[i], dashpot = w.normal.force[i] - elastic;
  const double energy = w.normal.energy[i];
  add(Mechanism::viscous, 0.5 * (l.dashpot + dashpot) * closing * dt);
  const double rest = 0.5 * (l.elastic + elastic) * closing * dt - (energy - l.normal_energy);
  if (loss == Loss::plastic) add(Mechanism::plastic, rest);
  if (loss == Loss::adhesive) add(Mechanism::adhesive, rest);

  const double pull = w.pull[i], pull_energy = w.pull_energy[i];
  add(Mechanism::adhesive, -0.5 * (l.pull + pull) * closing * dt - (pull_energy - l.pull_energy));

  const shapes::Vec3d force = get(w.tangential), spring = get(c.history_force), damped = force - spring;
  const double viscous = 0.5 * dot(l.tangential_dashpot + damped, slip) * dt;
  add(Mechanism::viscous, viscous);
  add(Mechanism::friction,
      0.5 * dot(l.tangential + force, slip) * dt - viscous - (w.tangential_energy[i] - l.tangential_energy));
  const shapes::Vec3d moment = get(w.moment);
  add(Mechanism::friction,
      -0.5 * dot(l.moment + moment, get(c.relative_spin)) * dt - (w.moment_energy[i] - l.moment_energy));

  l.elastic = elastic;
  l.dashpot = dashpot;
  l.pull = pull;
  l.tangential = force;
  l.tangential_dashpot = damped;
  l.moment = moment;
  l.normal_energy = energy;
  l.tangential_energy = w.tangential_energy[i];
  l.moment_energy = w.moment_energy[i];
  l.pull_energy = pull_energy;
}

}  // namespace contact
