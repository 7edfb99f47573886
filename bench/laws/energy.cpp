// Energy of impacts. (a) ΔKE = Σ F·v̄ dt + Σ T·ω̄ dt; (b) kinetic + stored + dissipated stays what it was: at the
// automatic step of a scene, and with the square of the step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"

namespace laws {

void energy(Report& r) {
  const Ball a = ball(1e-3, 2500), b = ball(1.5e-3, 2500);
  const double speed = 0.3;
  for (const LawNames& n : every_law()) {
    const bool dissipates = contact::law_model(n)->damping_factor > 0 || n.normal == "viscoelastic_hertz";
    for (const bool damped : {false, true}) {
      if (damped && !dissipates) continue;
      Material m = stone();
      if (!damped) m.restitution = 1, m.viscous_time = 0;
      LawContact c = contact_of(n, m, m, wet());
      c.pair.loading_ratio = 0.36;
      const double dt = dem::law_driver::automatic_step(c, a, b);
      const auto run = [&](double h) {
        return dem::law_driver::impact(c, a, b,
                                       {.normal_speed = speed,
                                        .tangential_speed = 0.5 * speed,
                                        .spin_a = 100,
                                        .spin_b = -30,
                                        .dt = h,
                                        .phase = 0.4},
                                       {}, 400000);
      };
      const Rebound full = run(dt), half = run(0.5 * dt), quarter = run(0.25 * dt);
      const std::string name = title(n) + (damped ? ", damped" : "");
      r.at_most(name + ": work less change of kinetic energy, over the largest", 1e-12,
                std::max({full.work_error / full.largest_kinetic, half.work_error / half.largest_kinetic,
                          quarter.work_error / quarter.largest_kinetic}));
      const auto share = [](const Rebound& x) { return x.energy_error / x.kinetic_before; };
      r.at_most(fmt::format("{}: balance at the automatic step ({} steps)", name, full.steps), 5e-3, share(full));
      const double order = 0.5 * std::log2(share(full) / share(quarter));
      const std::string item =
          fmt::format("{}: at half and quarter of it {:.1e} {:.1e}; order", name, share(half), share(quarter));
      // Attraction that jumps as it lets go is met within a step only.
      if (c.model.lingers || n.cohesion != "none")
        r.note(item + " (force jumps)", order);
      else
        r.at_least(item, 1.8, order);
    }
  }
}

}  // namespace laws
