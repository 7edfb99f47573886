// Restitution 0.1 … 0.98 of each damped law and end of contact: at 1000 steps per (undamped) contact within 1e-3, in
// every phase of the step in which the bodies meet; and what the automatic step of a scene makes of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

constexpr double speed = 1, radius = 0.01;  // m/s, m

double worst_error(const LawContact& c, const Ball& a, double e, double dt) {
  double worst = 0;
  for (const double phase : {0.0, 0.13, 0.38, 0.63, 0.88})
    worst = std::max(
        worst,
        std::abs(dem::law_driver::impact(c, a, a, {.normal_speed = speed, .dt = dt, .phase = phase}).restitution - e));
  return worst;
}

}  // namespace

void restitution(Report& r) {
  Material m = stone();
  m.young = 5e6;
  m.friction = m.work_of_adhesion = m.adhesive_stiffness = 0;
  m.plastic_stiffness = m.stiffness;  // what is damped and yields besides: here it does not
  const Ball a = ball(radius, m.density);
  std::vector<std::vector<double>> curve;
  for (const LawNames& n : every_law()) {
    if (n.tangential != "coulomb_spring" || n.rolling != "none" || n.cohesion != "none") continue;
    if (!(contact::law_model(n)->damping_factor > 0)) continue;
    m.restitution = 1;
    const LawContact undamped = contact_of(n, m, m);
    const double automatic = dem::law_driver::automatic_step(undamped, a, a);
    const double duration = dem::law_driver::impact(undamped, a, a, {.normal_speed = speed, .dt = automatic}).duration;
    for (const bool clip : {true, false}) {
      std::string coarse;
      for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98}) {
        m.restitution = e;
        const LawContact c = contact_of(n, m, m, {.clip = clip});
        const double fine = worst_error(c, a, e, duration / 1000);
        const double dt = dem::law_driver::automatic_step(c, a, a), own = worst_error(c, a, e, dt);
        r.near(fmt::format("{} {}, e = {:g}; at the automatic step ({:.0f} a contact) {:.1e}", title(n),
                           clip ? "clipped" : "not clipped", e, duration / dt, own),
               e, e + fine, 1e-3);
        curve.push_back({e, clip ? 1.0 : 0.0, fine, own});
      }
    }
  }
  r.csv("restitution", "restitution,clipped,error_at_1000_steps,error_at_automatic_step", curve);
}

}  // namespace laws
