#include "libcontact/laws/ledger.h"

namespace contact {

namespace {

// A step's forces, each the mean of its two ends, and what they leave stored.
struct Work {
  double acts, way;           // s, m of overlap
  shapes::Vec3d before, now;  // m/s, where the last step's and this step's tangential force acts
  shapes::Vec3d spin;
  Loss loss;
  Ledger& l;

  void add(Mechanism m, double work) { l.lost[static_cast<std::size_t>(m)] += work; }
  void normal(double elastic, double dashpot, double energy) {
    add(Mechanism::viscous, 0.5 * (l.dashpot + dashpot) * way);
    const double rest = 0.5 * (l.elastic + elastic) * way - (energy - l.normal_energy);
    if (loss == Loss::plastic) add(Mechanism::plastic, rest);
    if (loss == Loss::adhesive) add(Mechanism::adhesive, rest);
    l.elastic = elastic;
    l.dashpot = dashpot;
    l.normal_energy = energy;
  }
  void pull(double force, double energy) {
    add(Mechanism::adhesive, -0.5 * (l.pull + force) * way - (energy - l.pull_energy));
    l.pull = force;
    l.pull_energy = energy;
  }
  void tangential(const shapes::Vec3d& force, const shapes::Vec3d& dashpot, double energy) {
    const double viscous = 0.5 * (dot(l.tangential_dashpot, before) + dot(dashpot, now)) * acts;
    add(Mechanism::viscous, viscous);
    add(Mechanism::friction,
        0.5 * (dot(l.tangential, before) + dot(force, now)) * acts - viscous - (energy - l.tangential_energy));
    l.tangential = force;
    l.tangential_dashpot = dashpot;
    l.tangential_energy = energy;
  }
  void moment(const shapes::Vec3d& moment, double energy) {
    add(Mechanism::friction, -0.5 * dot(l.moment + moment, spin) * acts - (energy - l.moment_energy));
    l.moment = moment;
    l.moment_energy = energy;
  }
};

double twist_energy(const kernels::LawChunk& c, const kernels::LawWork& w, std::size_t i) {
  const double spring = w.normal.stiffness_t[i] * (c.spread_xx[i] + c.spread_yy[i] + c.spread_zz[i]);
  return c.history_twist[i] != 0 && spring > 0 ? 0.5 * c.history_twist[i] * (c.history_twist[i] / spring) : 0;
}

}  // namespace

double stored_energy(const kernels::LawChunk& c, const kernels::LawWork& w, std::size_t i) {
  return w.normal.energy[i] + w.tangential_energy[i] + (w.moment_energy[i] + twist_energy(c, w, i)) + w.pull_energy[i];
}

void book(const kernels::LawChunk& c, const kernels::LawWork& w, std::size_t i, Loss loss, double acts,
          const shapes::Vec3d& before, Ledger& l) {
  const auto get = [i](const kernels::Lane3& lane) { return shapes::Vec3d{lane.x[i], lane.y[i], lane.z[i]}; };
  const shapes::Vec3d n = get(c.normal), v = get(c.velocity);
  const double closing = dot(v, n), gain = w.gain[i];  // of the overlap that the law has: J times as fast
  l.closing = closing * gain;
  l.slip = v - n * closing;
  l.relative_spin = get(c.relative_spin);
  Work work{acts, l.begun > 0 ? c.overlap[i] - l.overlap : l.closing * acts, before, l.slip, l.relative_spin, loss, l};
  const double elastic = w.normal.elastic[i] / gain;
  work.normal(elastic, w.normal.force[i] / gain - elastic, w.normal.energy[i]);
  work.pull(w.pull[i] / gain, w.pull_energy[i]);
  work.tangential(get(w.tangential), get(w.tangential) - get(c.history_force), w.tangential_energy[i]);
  work.moment(get(c.couple), w.moment_energy[i] + twist_energy(c, w, i));
  l.begun = 1;
  l.overlap = c.overlap[i];
}

void close(Loss loss, double acts, Ledger& l) {
  Work work{acts, l.closing * acts, l.slip, l.slip, l.relative_spin, loss, l};
  work.normal(0, 0, 0);
  work.pull(0, 0);
  work.tangential({}, {}, 0);
  work.moment({}, 0);
}

}  // namespace contact
