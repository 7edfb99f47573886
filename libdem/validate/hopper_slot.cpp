// Discharge of a flat-bottomed slot bin against the curve of a published simulation (Anand et al. 2008): 6790 spheres,
// of which the steady part runs out at 81.8 g/s there; other codes give 85 to 92 g/s, Beverloo's law for slots 81 to 88
// g/s.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

struct Point {
  double time, mass;  // s since the gate opened, g
};

constexpr Point published[] = {{0.07792, 5.254},  {0.14211, 10.503}, {0.20589, 15.672}, {0.26721, 21.084},
                               {0.33346, 26.292}, {0.39929, 31.4},   {0.46142, 36.69},  {0.52397, 41.939},
                               {0.58611, 47.209}, {0.65194, 52.499}, {0.71737, 57.809}};  // up to 60 g

double grams_at(const World& w, double time) {
  const auto after = std::upper_bound(w.discharge.begin(), w.discharge.end(), time,
                                      [](double t, const DischargePoint& p) { return t < p.time; });
  return after == w.discharge.begin() ? 0 : 1e3 * std::prev(after)->mass;
}

}  // namespace

extern const Validation hopper_slot;
const Validation hopper_slot{"hopper_slot", "hopper_slot.toml",
                             "what runs out of a flat-bottomed slot bin over time, as published",
                             [](Runs& runs) -> std::vector<Row> {
                               const World w = runs.run();
                               const double open = wall_named(w, "gate").motion.remove_at;
                               double worst = 0;
                               double n = 0, t = 0, m = 0, tt = 0, tm = 0;  // of the straight part, from 10 g on
                               for (const Point& p : published) {
                                 const double grams = grams_at(w, open + p.time);
                                 worst = std::max(worst, std::abs(grams / p.mass - 1));
                                 if (p.mass < 10) continue;
                                 n += 1;
                                 t += p.time;
                                 m += grams;
                                 tt += p.time * p.time;
                                 tm += p.time * grams;
                               }
                               return {in_band("steady rate", (n * tm - t * m) / (n * tt - t * t), 78, 96, "g/s"),
                                       at_most("largest deviation of the mass up to 60 g", 100 * worst, 15, "%")};
                             }};

}  // namespace dem::validate
