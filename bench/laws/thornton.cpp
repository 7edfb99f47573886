// Oblique impacts of Thornton, Cummins & Cleary, Powder Technol. 210 (2011) 189 (elastic) and 233 (2013) 30 (damped):
// a solid sphere of ν = 0.3, μ = 0.1 on a rigid plane. Curves in Θ = 2 tan(angle)/((1 + e) μ) do not depend on speed
// or modulus; at 0.05 m/s the overlap is small against the radius, as the theory wants it.
#include <fmt/format.h>

#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/reference.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

constexpr double poisson = 0.3, friction = 0.1, speed = 0.05;

struct Setting {
  LawContact contact;
  Ball ball;
  double duration;
};

// `linear`: a spring with the duration of the Hertz contact.
Setting setting(const LawNames& names, double e, const LawOptions& options = {}) {
  Material m;
  m.young = 70e9;
  m.poisson = poisson;
  m.density = 2650;
  m.friction = friction;
  m.restitution = e;
  m.stiffness = 1;
  Material wall = m;
  wall.rigid = true;
  Setting s{contact_of(names, m, wall, options), ball(0.025, 2650), 0};
  s.duration = hertz_duration(s.ball.mass, s.ball.radius, s.contact.pair.young_eff, speed);
  const double pi = std::acos(-1.0);
  s.contact.pair.stiffness_n = s.ball.mass * std::pow(pi / s.duration, 2);
  s.contact.pair.stiffness_t = s.contact.pair.stiffness_n * 2 * (1 - poisson) / (2 - poisson);
  return s;
}

Rebound impact_at(const Setting& s, double theta, double e) {
  return dem::law_driver::impact(s.contact, s.ball, {},
                                 {.normal_speed = speed,
                                  .tangential_speed = 0.5 * theta * (1 + e) * friction * speed,
                                  .dt = s.duration / 1000,
                                  .phase = 0.5});
}

// Columns of the sheet, 4.2: of exact, HMD, HM rescaled, HM plain, linear, each s'/(μ vn) and et.
constexpr double sheet[][11] = {{0.25, .0446, .7652, .1263, .8586, .1285, .8612, .2074, .9513, .1264, .8587},
                                {0.50, .0607, .7490, .1957, .8261, .2498, .8570, .3638, .9222, .2064, .8322},
                                {1.00, -.0043, .7131, .1644, .7613, .4153, .8329, .5038, .8582, .2027, .7722},
                                {1.50, -.2518, .6663, -.1212, .6912, .2710, .7659, .3133, .7740, -.0929, .6966},
                                {2.00, -.6726, .6182, -.6040, .6280, -.1908, .6870, -.1757, .6892, -.5849, .6307},
                                {2.50, -1.0693, .5921, -1.0399, .5954, -.6330, .6419, -.6469, .6404, -1.0184, .5979},
                                {3.00, -1.3916, .5818, -1.3841, .5825, -.9886, .6201, -1.0431, .6149, -1.3618, .5846},
                                {4.00, -1.7638, .5883, -1.7633, .5883, -1.3980, .6144, -1.5600, .6029, -1.7551, .5889},
                                {5.00, -1.7039, .6169, -1.7035, .6169, -1.4356, .6322, -1.6359, .6208, -1.7029, .6170},
                                {6.00, -1, .6667, -1, .6667, -.9814, .6676, -1, .6667, -1, .6667},
                                {9.00, 2, .7778, 2, .7778, 2, .7778, 2, .7778, 2, .7778}};

struct Column {
  const char* name;
  LawNames laws;
  LawOptions options;
  std::size_t at;      // in the sheet
  bool has_reference;  // else the sheet's own numbers are expected
  Across reference;
};

void elastic(Report& r) {
  const std::vector<Column> columns{
      {"hertz + memory_diagram", {"hertz", "memory_diagram"}, {}, 1, true, Across::exact},
      {"hertz + mindlin_deresiewicz as printed", {"hertz", "mindlin_deresiewicz"}, {.deficit = false}, 3, false, {}},
      {"hertz_mindlin", {"hertz", "coulomb_spring"}, {}, 5, true, Across::hertz_rescaled},
      {"hertz_mindlin, rescale = false", {"hertz", "coulomb_spring"}, {.rescale = false}, 7, true, Across::hertz_plain},
      {"linear_spring, kn by (9.22)", {"linear", "coulomb_spring"}, {}, 9, true, Across::linear}};
  std::vector<std::vector<double>> curves;
  for (const auto& row : sheet) curves.push_back({row[0]});
  for (const Column& c : columns) {
    if (!has_tangential_law(c.laws.tangential)) {
      r.note(c.name, "not in the list");
      continue;
    }
    r.heading(fmt::format("{}, elastic; expected {}", c.name,
                          c.has_reference ? "from an independent computation of (1)" : "the sheet's"));
    const Setting s = setting(c.laws, 1, c.options);
    double apart = 0;
    for (std::size_t i = 0; i < std::size(sheet); ++i) {
      const double theta = sheet[i][0];
      const Rebound b = impact_at(s, theta, 1);
      double slip = sheet[i][c.at], et = sheet[i][c.at + 1];
      if (c.has_reference) {
        const Oblique o = oblique_impact(c.reference, theta, poisson, friction);
        apart = std::max({apart, std::abs(o.slip - slip), std::abs(o.restitution - et)});
        slip = o.slip;
        et = o.restitution;
      }
      const double tolerance = theta >= 2 ? 0.01 : 0.02, got = b.contact_slip / (friction * speed);
      r.near(fmt::format("Θ = {:g}: s'/(μ vn)", theta), slip, got, tolerance);
      r.near(fmt::format("Θ = {:g}: et", theta), et, b.tangential_restitution, tolerance);
      for (const double v : {slip, got, et, b.tangential_restitution}) curves[i].push_back(v);
    }
    if (c.has_reference) r.at_most("that computation against the sheet's digits, worst", 4e-4, apart);
  }
  r.csv("thornton2011",
        "theta,exact_expected,exact,exact_et_expected,exact_et,hmd_expected,hmd,hmd_et_expected,hmd_et,hm_expected,hm,"
        "hm_et_expected,hm_et,plain_expected,plain,plain_et_expected,plain_et,linear_expected,linear,"
        "linear_et_expected,linear_et",
        curves);
  r.figure(
      "thornton2011",
      "set xlabel 'Θ'\nset ylabel 'rebound slip of the contact, s''/(μ vn)'\n"
      "plot 'thornton2011.csv' skip 1 using 1:2 with points pt 6 lc 1 title 'exact, expected', '' skip 1 using 1:3 "
      "with lines lc 1 title 'memory_diagram', '' skip 1 using 1:6 with points pt 4 lc 2 title 'Box 9.1, expected', "
      "'' skip 1 using 1:7 with lines lc 2 title 'mindlin_deresiewicz', '' skip 1 using 1:10 with points pt 8 lc 3 "
      "title 'HM, expected', '' skip 1 using 1:11 with lines lc 3 title 'hertz_mindlin', '' skip 1 using 1:18 with "
      "points pt 10 lc 4 title 'linear, expected', '' skip 1 using 1:19 with lines lc 4 title 'linear_spring'");
}

void damped(Report& r) {
  r.heading("damped (2013): et, read off a figure to 0.02; sliding: 1 − 2/Θ");
  for (const char* name : {"hertz_mindlin", "spring_dashpot"}) {
    for (const double e : {0.25, 0.5, 0.75, 0.9}) {
      const Setting s = setting(names_of(name), e);
      r.near(fmt::format("{}, e = {:g}, Θ = 7.68", name, e), 0.742, impact_at(s, 7.68, e).tangential_restitution, 0.02);
      r.near(fmt::format("{}, e = {:g}, Θ = 9.31", name, e), 0.787, impact_at(s, 9.31, e).tangential_restitution, 0.02);
    }
    r.near(fmt::format("{}, e = 0.5, Θ = 1.14", name), name[0] == 'h' ? 0.722 : 0.708,
           impact_at(setting(names_of(name), 0.5), 1.14, 0.5).tangential_restitution, 0.02);
  }
}

// A contact that slides throughout obeys Coulomb's law with the whole normal force: et = 1 − 2/Θ at every restitution.
void sliding(Report& r) {
  r.heading("contacts that slide all the way, Θ = 12: et = 1 − 2/Θ, for every tangential law");
  contact::each_law<contact::TangentialLaws>([&](auto law, std::size_t) {
    const std::string name = law.name;
    if (name == "none" || name == "thornton_peeling") return;
    for (const double e : {1.0, 0.9, 0.5})
      r.near(fmt::format("hertz + {}, e = {:g}", name, e), 1 - 2.0 / 12,
             impact_at(setting({"hertz", name}, e), 12, e).tangential_restitution, 0.002);
  });
}

}  // namespace

void thornton(Report& r) {
  elastic(r);
  damped(r);
  sliding(r);
}

}  // namespace laws
