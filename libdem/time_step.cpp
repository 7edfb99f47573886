// Stability limits of the step.
//   one contact: ω² = largest eigenvalue of K^½ W K^½ ≤ max(kn wn, kt wt + kr/I),  w = inverse mass of the contact
//   point; kr: spring of rolling; that of twisting, k_tw/I, by itself
//   limit = (2/ω)(sqrt(1+β²) − β) with a dashpot that sees half-step velocities                                   (1)
//   (a bound: the law lessens its dashpot by lag_factor, which alone would allow (2/ω)/sqrt(1+2β))
//   many contacts: λmax ≤ max over contacts of (rows of a + rows of b), a weighted-graph bound (Anderson & Morley,
//   1985)
#include "libdem/time_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "libdem/build.h"
#include "libdem/insertion/rain.h"
#include "libdem/law_map.h"
#include "libdem/parts.h"

namespace dem {
namespace {

// Inverse masses of a body: the largest of its surface points, that of its centre, 1/kg; largest inverse moment of
// inertia, 1/(kg m²).
struct Compliance {
  double normal = 0, tangential = 0, centre = 0, turning = 0;
};
Compliance operator+(const Compliance& a, const Compliance& b) {
  return {a.normal + b.normal, a.tangential + b.tangential, a.centre + b.centre, a.turning + b.turning};
}

// A lever reaches at most the bounding radius (spheres: the normal passes through the centre).
Compliance compliance(const World& world, std::size_t i) {
  const Particles& p = world.particles;
  const Motion& m = p.motion[i];
  const Vec3d& inertia = p.inertia[i];
  const double smallest = std::min({inertia.x, inertia.y, inertia.z}), r = m.bounding_radius;
  const bool sphere = is_round(p.kind[i]);
  // Across the body's longest line the lever of a normal force is at most half the difference to the inscribed sphere;
  // a body of parts may be hollow there.
  const double inscribed = inscribed_radius(world, i);
  const bool convex = p.kind[i] != shapes::Kind::compound;
  const double arm2 = sphere ? 0 : r * r - (convex ? inscribed * inscribed : 0);
  return {m.inverse_mass + arm2 / smallest, m.inverse_mass + r * r / smallest, m.inverse_mass, 1 / smallest};
}

double limit_of(double omega_squared, double beta) {
  return 2 / std::sqrt(omega_squared) * (std::sqrt(1 + beta * beta) - beta);
}

// β of the damping as the law applies it: cn = 2 β' sqrt(m* kn), with sqrt(5/6) for Hertz; of a dashpot c that knows no
// mass c/2 sqrt(w/kn). That of a viscous solid is in the same ratio to kt.
double law_beta(const World& world, const PairParameters& q, const Stiffness& s, double inverse_mass) {
  return s.damping > 0 ? 0.5 * s.damping * std::sqrt(inverse_mass / s.n) : world.law.damping_ratio(q);
}

// `record`: whose memory counts; none: a contact pressed for the first time.
constexpr std::size_t no_record = std::numeric_limits<std::size_t>::max();
Stiffness stiffness_at(const World& world, const PairParameters& q, double radius_eff, double overlap,
                       std::size_t record = no_record) {
  const Contacts& c = world.contacts;
  const double* memory = record != no_record && c.words > 0 ? &c.memory[record * c.words] : nullptr;
  return world.law.stiffness(q, world.law_options, radius_eff, overlap, memory);
}

const PairParameters& pair_of(const World& world, std::size_t k) {
  const Contacts& c = world.contacts;
  const std::uint32_t b = c.index_b[k];
  const bool wall = c.key[k].b >= wall_base;
  return world.pairs[world.particles.material[c.index_a[k]] * world.materials.size() +
                     (wall ? world.walls[b].material : world.particles.material[b])];
}

Stiffness stiffness_of(const World& world, std::size_t k, double overlap) {
  const Contacts& c = world.contacts;
  const bool wall = c.key[k].b >= wall_base;
  const std::uint32_t a = c.index_a[k], b = c.index_b[k];
  const double radius_a = part_radius(world, a, c.key[k].part_a);
  const double radius_b = wall ? 0 : part_radius(world, b, c.key[k].part);
  double radius = wall ? radius_a : radius_a * radius_b / (radius_a + radius_b);
  EquivalentOverlap at{overlap, 1};
  if (world.scene.law.map == LawMap::volume)
    at = monitored_overlap(world, k, overlap);
  else if (const double kept = kept_by_map(world, k); kept > 0)
    radius = kept;
  Stiffness s = stiffness_at(world, pair_of(world, k), radius, at.overlap, k);
  const double share = c.share.empty() ? 1 : c.share[k];
  for (double* x : {&s.n, &s.t, &s.damping, &s.rolling, &s.twist, &s.rolling_damping}) *x *= share;
  s.n *= at.gain * at.gain;
  s.damping *= at.gain * at.gain;
  return s;
}

// Of the tangential mode with the rolling that goes with it. Without friction nothing holds the former.
double tangential_omega_squared(const Stiffness& s, const Compliance& w, const PairParameters& q) {
  return (q.friction > 0 ? s.t * w.tangential : 0) + s.rolling * w.turning;
}
double omega_squared(const Stiffness& s, const Compliance& w, const PairParameters& q) {
  return std::max({s.n * w.normal, tangential_omega_squared(s, w, q), s.twist * w.turning});
}

double normal_limit(const World& world, const Stiffness& s, const Compliance& w, const PairParameters& q,
                    double rows = 1) {
  return limit_of(rows * s.n * w.normal, law_beta(world, q, s, w.normal));
}
// Of all other modes; +infinity where there is none. Sliding and rolling go together: ω² and 2βω are bounded by the
// sums of kt w + kr/I and ct w + cr/I. Dry friction of rolling is a dashpot within the step, cr dt/I = φ:
//   ω² dt² + 4βω dt + 2φ <= 4
double tangential_limit(const World& world, const Stiffness& s, const Compliance& w, const PairParameters& q,
                        double rows = 1) {
  const double omega = std::sqrt(tangential_omega_squared(s, w, q)), slides = q.friction > 0 ? s.t * w.tangential : 0;
  // ct = factor · β sqrt(m* kt), m* that of the normal; of a viscous solid c kt/kn.
  double damping = s.damping > 0 ? s.damping / s.n * slides
                                 : 2 * world.law.damping_ratio(q) * std::sqrt(slides * (w.tangential / w.centre));
  double dry = 0;
  if (s.rolling > 0)
    damping += s.rolling_damping * std::sqrt(1 / w.centre) * w.turning;
  else
    dry = s.rolling_damping * (w.turning / w.centre);
  const double beta = omega > 0 ? 0.5 * damping / omega : 0;
  const double limit = 2 / (std::sqrt(rows) * omega) * (std::sqrt(std::max(1 - 0.5 * dry, 0.0) + beta * beta) - beta);
  return s.twist > 0 ? std::min(limit, limit_of(rows * s.twist * w.turning, 0)) : limit;
}

Compliance compliance_of(const World& world, std::size_t k) {
  const Contacts& c = world.contacts;
  const Compliance a = compliance(world, c.index_a[k]);
  return c.key[k].b < wall_base ? a + compliance(world, c.index_b[k]) : a;
}

}  // namespace

Stiffness contact_stiffness(const World& world, std::size_t k) {
  return stiffness_of(world, k, world.contacts.history_of(k).overlap);
}

double contact_limit(const World& world, std::size_t k, double overlap) {
  const PairParameters& q = pair_of(world, k);
  const Stiffness s = stiffness_of(world, k, overlap);
  const Compliance w = compliance_of(world, k);
  return std::min(normal_limit(world, s, w, q), tangential_limit(world, s, w, q));
}

double contact_damping(const World& world, std::size_t k) {
  const Particles& p = world.particles;
  const std::uint32_t a = world.contacts.index_a[k], b = world.contacts.index_b[k];
  const PairParameters& q = pair_of(world, k);
  const double inverse_mass = p.motion[a].inverse_mass + p.motion[b].inverse_mass;
  const Stiffness s = contact_stiffness(world, k);
  return 2 * law_beta(world, q, s, inverse_mass) * std::sqrt(1 / inverse_mass * s.n);
}

double contact_resistance(const World& world, std::size_t k) {
  const Contacts& c = world.contacts;
  const double mass = world.particles.mass[c.index_a[k]];
  const Stiffness s = contact_stiffness(world, k);
  return (1 + 2 * law_beta(world, pair_of(world, k), s, 1 / mass)) * std::sqrt(s.n * mass);
}

namespace {

// The world as it may become: with the smallest bodies that rain will bring and the friction that events will set.
World foreseen(World world) {
  for (const Draft& d : coming_bodies(world)) add_particle(world, d.shape, d.material, d.scale, {}, {}, {}, {});
  const std::size_t n = world.materials.size();
  for (const EventSpec& e : world.scene.events) {
    if (std::isnan(e.friction)) continue;
    const std::size_t i = material_index(world, e.a, e.where), j = material_index(world, e.b, e.where);
    for (PairParameters* q : {&world.pairs[i * n + j], &world.pairs[j * n + i]})
      q->friction = std::max(q->friction, e.friction);
  }
  return world;
}

}  // namespace

std::vector<BodyGroup> body_groups(const World& world) {
  const Particles& p = world.particles;
  std::vector<BodyGroup> groups;
  for (std::size_t i = 0; i < p.count(); ++i) {
    auto g = std::find_if(groups.begin(), groups.end(),
                          [&](const BodyGroup& x) { return x.shape == p.shape[i] && x.material == p.material[i]; });
    if (g == groups.end()) {
      groups.push_back({p.shape[i], p.material[i], 1, i, i});
      continue;
    }
    ++g->count;
    if (compliance(world, i).tangential > compliance(world, g->light).tangential) g->light = i;
    if (p.motion[i].equivalent_radius > p.motion[g->large].equivalent_radius) g->large = i;
  }
  std::sort(groups.begin(), groups.end(), [](const BodyGroup& a, const BodyGroup& b) {
    return std::pair(a.shape, a.material) < std::pair(b.shape, b.material);
  });
  return groups;
}

std::vector<PairLimit> pair_limits(const World& world, const std::vector<BodyGroup>& groups) {
  const std::size_t materials = world.materials.size();
  // A body with many contacts, each as stiff as its stiffest partner makes it.
  const double rows = std::max(1.0, 0.5 * world.scene.run.dt_contacts);
  std::vector<PairLimit> list;
  std::vector<RadiusBound> bounds;
  const auto add = [&](std::size_t group, std::size_t partner, bool wall, const Compliance& w, double radius,
                       const PairParameters& q) {
    const RadiusBound &of_a = bounds[group], *of_b = wall ? nullptr : &bounds[partner];
    EquivalentOverlap at{world.scene.run.dt_overlap * radius, 1};
    if (world.scene.law.map == LawMap::volume) at = steepest_overlap(world, of_a, of_b, at.overlap);
    Stiffness k = stiffness_at(world, q, wall ? radius_bound(of_a) : radius_bound(of_a, *of_b), at.overlap);
    k.n *= at.gain * at.gain;
    k.damping *= at.gain * at.gain;
    list.push_back({group, partner, wall, normal_limit(world, k, w, q, rows), tangential_limit(world, k, w, q, rows)});
  };
  std::vector<Compliance> yields;
  std::vector<double> radii;
  for (const BodyGroup& g : groups) {
    yields.push_back(compliance(world, g.light));
    radii.push_back(world.particles.motion[g.light].equivalent_radius);
    bounds.push_back(radius_bound(world, g.light));
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double r = radii[g];
    for (std::size_t o = g; o < groups.size(); ++o)
      add(g, o, false, yields[g] + yields[o], std::min(r, radii[o]),
          world.pairs[groups[g].material * materials + groups[o].material]);
    for (std::size_t w = 0; w < world.walls.size(); ++w)
      add(g, w, true, yields[g], r, world.pairs[groups[g].material * materials + world.walls[w].material]);
  }
  return list;
}

TimeStep choose_time_step(const World& now) {
  const bool same = now.scene.rains.empty() && now.scene.events.empty();
  const World later = same ? World{} : foreseen(now);
  const World& world = same ? now : later;
  TimeStep best;
  best.limit = std::numeric_limits<double>::infinity();
  const std::vector<BodyGroup> groups = body_groups(world);
  const auto name = [&](std::size_t g) { return "\"" + world.shapes[groups[g].shape].name + "\""; };
  for (const PairLimit& l : pair_limits(world, groups)) {
    if (!(l.limit() < best.limit)) continue;
    best.limit = l.limit();
    best.limited_by = name(l.group) + " against " +
                      (l.wall ? "wall \"" + world.walls[l.partner].name + "\"" : name(l.partner)) +
                      (l.tangential < l.normal ? ", tangential mode" : ", normal mode");
  }
  const RunSpec& run = world.scene.run;
  best.dt = run.dt_auto ? run.dt_fraction * best.limit : run.dt;
  if (run.dt_auto && !std::isfinite(best.dt)) best.dt = run.steps > 0 ? 0 : run.time / 100;  // nothing can touch
  return best;
}

double present_limit(const World& world, int threads) {
  constexpr std::size_t at_once = 1U << 14;  // records, between two of which rows are summed in order
  const Contacts& c = world.contacts;
  std::vector<double> row(world.particles.count());
  std::vector<std::array<double, 2>> squares(std::min(at_once, c.count()));  // ω² as each body of a contact has it
  const auto paired = [&c](std::size_t k) { return c.key[k].b < wall_base; };
  double beta = 0, largest = 0;
#pragma omp parallel num_threads(threads)
  {
    for (std::size_t first = 0; first < c.count(); first += at_once) {
      const std::size_t last = std::min(c.count(), first + at_once);
#pragma omp for schedule(static) reduction(max : beta)
      for (std::size_t k = first; k < last; ++k) {
        if (c.touching[k] == 0) continue;
        const Stiffness s = contact_stiffness(world, k);
        const PairParameters& q = pair_of(world, k);
        const Compliance a = compliance(world, c.index_a[k]),
                         b = paired(k) ? compliance(world, c.index_b[k]) : Compliance{};
        squares[k - first] = {omega_squared(s, a, q), omega_squared(s, b, q)};
        beta = std::max(beta, law_beta(world, q, s, (a + b).normal));
      }
#pragma omp single
      for (std::size_t k = first; k < last; ++k) {
        if (c.touching[k] == 0) continue;
        row[c.index_a[k]] += squares[k - first][0];
        if (paired(k)) row[c.index_b[k]] += squares[k - first][1];
      }
    }
#pragma omp for schedule(static) reduction(max : largest)
    for (std::size_t k = 0; k < c.count(); ++k)
      if (c.touching[k] != 0) largest = std::max(largest, row[c.index_a[k]] + (paired(k) ? row[c.index_b[k]] : 0));
  }
  return largest > 0 ? limit_of(largest, beta) : std::numeric_limits<double>::infinity();
}

}  // namespace dem
