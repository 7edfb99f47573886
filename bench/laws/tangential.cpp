// Loops and paths of micro-slip. Expected: Mindlin & Deresiewicz's formulas, and for paths of changing load the same
// theory with every segment kept, in 50 digits (micro_slip.h).
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/laws/contacts.h"
#include "bench/laws/digits.h"
#include "bench/laws/micro_slip.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

constexpr double poisson = 0.3, friction = 0.3, radius = 0.0125, depth = 1e-5;

LawContact contact_for(const std::string& tangential, double young_eff, const LawOptions& options = {}) {
  Material m;
  m.young = 1;
  m.poisson = poisson;
  m.friction = friction;
  LawContact c = contact_of({"hertz", tangential}, m, m, options);
  c.pair.young_eff = young_eff;
  c.pair.shear_eff = young_eff * (2 * (1 - poisson)) / (4 * (2 - poisson));
  c.radius_eff = radius;
  c.mass_eff = 1;
  return c;
}

// A contact that is pressed and then pulled to and fro; time counts for nothing.
class Hand {
 public:
  explicit Hand(const LawContact& c) : drive_(c) {}
  // Straight to (z, x) in `steps`; the tangential force there.
  double go(double z, double x, int steps) {
    const double z0 = z_, x0 = x_;
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps, next = x0 + part * (x - x0), before = ft_;
      Move move;
      move.overlap = i == steps ? z : z0 + part * (z - z0);
      move.velocity = {next - x_, 0, move.overlap - z_};
      move.dt = 1;
      ft_ = drive_.step(move).tangential.x;
      work_ += 0.5 * (before + ft_) * (next - x_);
      x_ = next;
      z_ = move.overlap;
    }
    return ft_;
  }
  double normal() const { return drive_.answer().normal; }
  double work() const { return work_; }

 private:
  Drive drive_;
  double z_ = 0, x_ = 0, ft_ = 0, work_ = 0;
};

struct Cycle {
  Digits slip, work;  // amplitude, m; per cycle, J
};
// Of amplitude t = Ft*/(μ Fn).
Cycle cycle(const LawContact& c, const Digits& t) {
  using std::pow;
  const Digits e = c.pair.young_eff, g = c.pair.shear_eff, mu = friction, d = depth, a = sqrt(Digits(radius) * d);
  const Digits fn = Digits(4) / 3 * e * a * d, unit = 3 * mu * fn / (16 * g * a), third = Digits(1) / 3;
  const Digits rest = pow(1 - t, third);  // (1 − t)^⅓
  Cycle out;
  out.slip = unit * (1 - rest * rest);
  out.work = Digits(9) / 10 * mu * mu * fn * fn / (g * a) *
             (1 - rest * rest * rest * rest * rest - 5 * t / 6 * (1 + rest * rest));
  return out;
}

void loops_of(Report& r, const std::string& law, const LawOptions& options, double tolerance, int steps) {
  const double t_of[] = {0.3, 0.6, 0.9}, published_slip[] = {.770925e-6, 1.665210e-6, 2.858027e-6},
               published_work[] = {9.82120e-7, 1.07169e-5, 6.28396e-5};
  const LawContact c = contact_for(law, 38e9, options);
  for (int i = 0; i < 3; ++i) {
    const Cycle k = cycle(c, Digits(t_of[i]));
    const double x = as_double(k.slip);
    Hand hand(c);
    hand.go(depth, 0, 1);
    const double cap = friction * hand.normal();
    const std::string at = fmt::format("{}, Ft* = {:g} μ Fn: ", law, t_of[i]);
    r.close(at + "force at the slip (N)", t_of[i] * cap, hand.go(depth, x, steps), tolerance);
    hand.go(depth, -x, steps);
    hand.go(depth, x, steps);
    const double before = hand.work();
    hand.go(depth, -x, steps);
    hand.go(depth, x, steps);
    r.close(at + "work of a cycle (J)", as_double(k.work), hand.work() - before, tolerance);
    if (tolerance < 1e-7) {
      r.close(at + "slip, published digits (m)", published_slip[i], x, 1e-6);
      r.close(at + "work, published digits (J)", published_work[i], as_double(k.work), 1e-5);
    }
  }
}

struct Point {
  double z, x;    // over z0 and X = κ μ z0
  double stated;  // Ft/(μ N0) in the sheet; NaN: none
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();
struct Path {
  const char* name;
  std::vector<Point> points;
  double literal, deficit;  // what Box 9.1 makes of the last point, as stated; NaN: as exact
};

std::vector<Path> paths() {
  return {{"A", {{1, 0, none}, {1, .5, .64645}, {.8, .5, .55122}}, none, none},
          {"B", {{1, 0, none}, {1, .5, .64645}, {1.2, .9, 1.15022}, {1.2, 0, -.17981}, {1.2, .9, 1.15022}}, none, none},
          {"C", {{1, 0, none}, {1, .6, .74702}, {.9, .1, .06453}, {1, .6, .74702}}, none, none},
          {"D", {{1, 0, none}, {1, .5, .64645}, {1.5, .6, .81387}, {1.5, 1.2, 1.67280}}, 1.569, 1.722},
          {"E", {{1, .5, .5}, {.5, .5, .35355}}, .3067, .35355}};
}

void all_paths(Report& r) {
  r.heading("paths A to E of the sheet, Ft/(μ N0)");
  const double young_eff = 38.46153846e9, kappa = (2 - poisson) / (2 * (1 - poisson)), unit = kappa * friction * depth;
  for (const Path& p : paths()) {
    MicroSlip<Digits> exact{Digits(kappa), Digits(friction)};
    Hand diagram(contact_for("memory_diagram", young_eff)),
        printed(contact_for("mindlin_deresiewicz", young_eff, {.deficit = false})),
        with_deficit(contact_for("mindlin_deresiewicz", young_eff, {.deficit = true}));
    double z = 0, x = 0, last = 0, got_printed = 0, got_deficit = 0;
    const double n0 = 4.0 / 3 * young_eff * std::sqrt(radius) * depth * std::sqrt(depth), cap = friction * n0;
    int number = 0;
    for (const Point& q : p.points) {
      const Digits to = Digits(q.z), step = Digits(q.x * friction * kappa) - Digits(x * friction * kappa);
      last = as_double(exact.move(to, step) / Digits(friction));
      const std::string at = fmt::format("path {}, point {} ({:g} z0, {:g} X)", p.name, ++number, q.z, q.x);
      r.near(at + ": memory_diagram", last, diagram.go(q.z * depth, q.x * unit, 1) / cap, 1e-10);
      if (!std::isnan(q.stated)) r.near(at + ": in 50 digits, published", q.stated, last, 6e-6);
      got_printed = printed.go(q.z * depth, q.x * unit, 20000) / cap;
      got_deficit = with_deficit.go(q.z * depth, q.x * unit, 20000) / cap;
      z = q.z;
      x = q.x;
    }
    (void)z;
    const bool apart = !std::isnan(p.literal);
    r.near(fmt::format("path {}, end: Box 9.1 as printed{}", p.name, apart ? ", as stated" : ""),
           apart ? p.literal : last, got_printed, apart ? 1e-3 : 1e-4);
    r.near(fmt::format("path {}, end: Box 9.1 with the deficit{}", p.name, apart ? ", as stated" : ""),
           apart ? p.deficit : last, got_deficit, 1e-3);
  }
}

// A pair that turns as one body, one turn about a slanted axis: the force turns with it.
void turns(Report& r) {
  r.heading("a pressed pair turns once as one body in 200 steps: the tangential force in its own frame");
  contact::each_law<contact::TangentialLaws>([&](auto law, std::size_t) {
    const std::string name = law.name;
    if (name == "none") return;
    std::string normal = "hertz";
    for (const contact::Partners& q : contact::partners)
      if (q.law == name) normal = std::string(q.normal.substr(0, q.normal.find(',')));
    Material m = stone();
    m.restitution = 1;
    m.viscous_time = 0;
    LawContact c = contact_of({normal, name}, m, m, wet());
    c.radius_eff = 1e-3;
    Drive drive(c);
    drive.step({.overlap = 1e-5, .velocity = {0, 0, 1e-5}, .dt = 1});
    drive.step({.overlap = 1e-5, .velocity = {1e-7, 2e-7, 0}, .dt = 1});
    const Vec3d before = drive.step({.overlap = 1e-5, .dt = 1}).tangential;
    const Vec3d axis = normalized(Vec3d{1, 2, 1.5});
    const int steps = 200;
    double least = 1e300, largest = 0;
    const auto turned = [&](const Vec3d& v, double angle) {
      return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - std::cos(angle)));
    };
    Vec3d now = before;
    for (int i = 1; i <= steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      Move move;
      move.overlap = 1e-5;
      move.normal = turned({0, 0, 1}, angle);
      move.turn = 2 * std::numbers::pi / steps * dot(axis, move.normal);
      move.dt = 1;
      now = drive.step(move).tangential;
      least = std::min(least, norm(now) / norm(before));
      largest = std::max(largest, norm(now) / norm(before));
    }
    r.at_most(name + ": |Ft| changes by, relative", 1e-12, largest - least);
    const double aside =
        std::acos(std::min(1.0, dot(now, before) / (norm(now) * norm(before)))) * 180 / std::numbers::pi;
    r.at_most(name + ": its direction after the turn, degrees off", 0.02, aside);
  });
}

// (9.33), (9.34) at constant force: the closed forms of the sheet, 1.3.
void latching(Report& r) {
  if (!has_tangential_law("latching_tangential")) return;
  r.heading("Walton & Braun's tangential spring at constant normal force");
  Material m = stone();
  m.restitution = 1;
  LawContact c = contact_of({"latching_spring", "latching_tangential"}, m, m);
  c.radius_eff = 1e-3;
  Hand hand(c);
  hand.go(1e-5, 0, 1);
  const double cap = c.pair.friction * hand.normal(), k0 = c.pair.stiffness_t, x = 0.9 * cap / k0;
  const Digits mu_f = cap, k = k0;
  const auto way = [&](const Digits& length, const Digits& slip) {
    return length * (1 - pow(1 - 2 * k * slip / (3 * length), Digits(1.5)));
  };
  const Digits turn = way(mu_f, Digits(x));
  r.close("first loading (N)", as_double(turn), hand.go(1e-5, x, 1000), 1e-10);
  const Digits back = turn - way(mu_f + turn, Digits(0.4 * x));
  r.close("back by 0.4 of it (N)", as_double(back), hand.go(1e-5, 0.6 * x, 1000), 1e-10);
  const Digits again = back + way(mu_f - back, Digits(0.3 * x));
  r.close("forth again by 0.3 (N)", as_double(again), hand.go(1e-5, 0.9 * x, 1000), 1e-10);
}

void pictures(Report& r) {
  if (!r.draws()) return;
  std::vector<std::vector<double>> rows;
  for (const auto& [number, law] :
       {std::pair{0.0, "memory_diagram"}, std::pair{1.0, "mindlin_deresiewicz"}, std::pair{2.0, "coulomb_spring"}}) {
    Hand hand(contact_for(law, 38e9));
    hand.go(depth, 0, 1);
    double x = 0;
    for (const double to : {2.858027e-6, -2.858027e-6, 2.858027e-6}) {
      const double from = x;
      for (int i = 1; i <= 200; ++i) {
        x = from + (to - from) * i / 200;
        rows.push_back({number, x, hand.go(depth, x, 5)});
      }
    }
  }
  r.csv("mindlin_deresiewicz", "law,slip,force", rows);
  r.figure("mindlin_deresiewicz",
           "set xlabel 'slip (m)'\nset ylabel 'tangential force (N)'\nplot 'mindlin_deresiewicz.csv' skip 1 using "
           "($1==0?$2:1/0):3 with lines title 'memory_diagram', '' skip 1 using ($1==1?$2:1/0):3 with lines title "
           "'mindlin_deresiewicz', '' skip 1 using ($1==2?$2:1/0):3 with lines title 'coulomb_spring'");
}

}  // namespace

void tangential(Report& r) {
  r.heading("Mindlin & Deresiewicz's loops at constant force: exact");
  loops_of(r, "memory_diagram", {}, 1e-8, 20000);
  r.heading("Box 9.1 is of first order: 1000 steps a stroke");
  loops_of(r, "mindlin_deresiewicz", {}, 5e-3, 1000);
  all_paths(r);
  turns(r);
  latching(r);
  pictures(r);
}

}  // namespace laws
