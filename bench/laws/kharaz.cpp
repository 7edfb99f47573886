// Rebound angles of Kharaz, Gorham & Salman, Powder Technol. 120 (2001) 281: a 5 mm sphere of aluminium oxide on thick
// glass at 3.9 m/s. e = 0.98, μ = 0.092; moduli as in bench/README.md.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"
#include "libdem/io/io.h"

namespace laws {

void kharaz(Report& r) {
  Material oxide, glass;
  oxide.young = 380e9;
  oxide.poisson = 0.23;
  glass.young = 70e9;
  glass.poisson = 0.25;
  for (Material* m : {&oxide, &glass}) {
    m->friction = 0.092;
    m->restitution = 0.98;
  }
  const Ball sphere = ball(0.0025, 4000);
  const double degree = std::numbers::pi / 180, speed = 3.9;
  const auto angle_of = [&](const LawContact& c, double angle) {
    LawContact here = c;
    dem::law_driver::set_bodies(here, sphere, {});
    const double vn = speed * std::cos(angle * degree), vt = speed * std::sin(angle * degree);
    const double duration = hertz_duration(here.mass_eff, here.radius_eff, here.pair.young_eff, vn);
    const Rebound b = dem::law_driver::impact(
        c, sphere, {}, {.normal_speed = vn, .tangential_speed = vt, .dt = duration / 1000, .phase = 0.5});
    return std::atan2(b.tangential_speed, -b.normal_speed) / degree;
  };
  const dem::io::Table t = dem::io::read_csv(PROJECT_ROOT "/bench/data/kharaz2001_rebound.csv");
  const std::size_t in = dem::io::column(t, "impact_angle_deg"), out = dem::io::column(t, "rebound_angle_deg");
  std::vector<std::vector<double>> measured, curves;
  for (std::size_t i = 0; i < t.row_count(); ++i)
    measured.push_back({dem::io::number(t, i, in), dem::io::number(t, i, out)});
  for (double a = 0; a < 70; a += 1) curves.push_back({a});
  std::string header = "impact_angle_deg", plots;
  for (const char* tangential : {"memory_diagram", "coulomb_spring", "mindlin_deresiewicz"}) {
    if (!has_tangential_law(tangential)) continue;
    const LawContact c = contact_of({"hertz", tangential}, oxide, glass);
    double sum = 0;
    for (const auto& m : measured) {
      const double got = angle_of(c, m[0]);
      sum += (got - m[1]) * (got - m[1]);
      r.note(fmt::format("hertz + {} at {:g} deg, measured {:g} deg", tangential, m[0], m[1]), got);
    }
    const double rms = std::sqrt(sum / static_cast<double>(measured.size()));
    if (std::string(tangential) == "memory_diagram")
      r.at_most(fmt::format("hertz + {}: rms of the rebound angle (deg)", tangential), 1.2, rms);
    else
      r.note(fmt::format("hertz + {}: rms of the rebound angle (deg)", tangential), rms);
    for (auto& row : curves) row.push_back(angle_of(c, row[0]));
    header += std::string(",") + tangential;
    plots +=
        fmt::format(", 'kharaz2001.csv' skip 1 using 1:{} with lines title '{}'", curves.front().size(), tangential);
  }
  r.csv("kharaz2001_measured", "impact_angle_deg,rebound_angle_deg", measured);
  r.csv("kharaz2001", header, curves);
  r.figure("kharaz2001",
           "set xlabel 'impact angle (deg)'\nset ylabel 'rebound angle (deg)'\n"
           "plot 'kharaz2001_measured.csv' skip 1 using 1:2 with points pt 7 title 'measured (2001)'" +
               plots);
}

}  // namespace laws
