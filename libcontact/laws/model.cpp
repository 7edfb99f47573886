#include "libcontact/laws/model.h"

#include <algorithm>
#include <memory>

#include "libcontact/laws/list.h"

namespace contact {
namespace {

struct Found {
  std::size_t place = 0, words = 0;
};

template <class List>
std::optional<Found> find(std::string_view name, std::size_t held_elsewhere = 0) {
  std::optional<Found> found;
  each_law<List>([&](auto law, std::size_t i) {
    using Law = decltype(law);
    if (name == Law::name) found = Found{i, state_words<Law> - held_elsewhere};
  });
  return found;
}

// f(Law{}) for the law at a place of a list.
template <class List, class F>
void at(std::size_t place, F&& f) {
  each_law<List>([&](auto law, std::size_t i) {
    if (i == place) f(law);
  });
}

template <class List>
constexpr std::size_t most_words = [] {
  std::size_t most = 0;
  each_law<List>([&](auto law, std::size_t) { most = std::max(most, state_words<decltype(law)>); });
  return most;
}();

static_assert(most_words<NormalLaws> + most_words<TangentialLaws> + most_words<RollingLaws> +
                  most_words<CohesionLaws> <=
              kernels::memory_words);

}  // namespace

std::optional<LawNames> named_law(std::string_view name) {
  for (const NamedLaw& l : named_laws)
    if (l.name == name)
      return LawNames{std::string(l.normal), std::string(l.tangential), std::string(l.rolling),
                      std::string(l.cohesion)};
  return {};
}

std::optional<LawModel> law_model(const LawNames& names) {
  constexpr std::size_t vector_words = 3;  // the tangential force is in the History
  const auto n = find<NormalLaws>(names.normal);
  const auto t = find<TangentialLaws>(names.tangential, vector_words);
  const auto r = find<RollingLaws>(names.rolling);
  const auto c = find<CohesionLaws>(names.cohesion);
  if (!n || !t || !r || !c) return {};
  LawModel m;
  m.normal = n->place;
  m.tangential = t->place;
  m.rolling = r->place;
  m.cohesion = c->place;
  m.memory_tangential = m.memory_normal + n->words;
  m.memory_rolling = m.memory_tangential + t->words;
  m.memory_cohesion = m.memory_rolling + r->words;
  m.words = m.memory_cohesion + c->words;
  m.hertzian = hertzian(names.normal);
  m.rolls = names.rolling != NoRolling::name;
  at<NormalLaws>(m.normal, [&](auto law) {
    m.loss = law.loss;
    m.lingers = law_adheres<decltype(law)>;
    m.damping_factor = law.damping_factor;
  });
  at<CohesionLaws>(m.cohesion, [&](auto law) { m.lingers = m.lingers || state_words<decltype(law)> > 0; });
  return m;
}

bool LawModel::fused() const {
  const auto is = [](std::size_t place, auto list, std::string_view name) {
    bool same = false;
    at<decltype(list)>(place, [&](auto law) { same = name == law.name; });
    return same;
  };
  return (is(normal, NormalLaws{}, Hertz::name) || is(normal, NormalLaws{}, Linear::name)) &&
         is(tangential, TangentialLaws{}, CoulombSpring::name) && is(rolling, RollingLaws{}, NoRolling::name) &&
         is(cohesion, CohesionLaws{}, NoCohesion::name);
}

void LawModel::run(kernels::LawChunk& chunk, kernels::LawWork& work, std::size_t count, double dt,
                   const LawOptions& options, bool patch, const kernels::KernelSet& own) const {
  const kernels::StageSet& set = *own.stages;
  kernels::StageCall call{dt, &options, memory_normal, patch};
  set.normal[normal](chunk, work, count, call);
  call.memory = memory_tangential;
  set.tangential[tangential](chunk, work, count, call);
  call.memory = memory_rolling;
  set.rolling[rolling](chunk, work, count, call);
  call.memory = memory_cohesion;
  set.cohesion[cohesion](chunk, work, count, call);
  set.finish(chunk, work, count, call);
}

double LawModel::range(const PairParameters& pair, const LawOptions& options, double radius_eff) const {
  double widest = 0;
  at<NormalLaws>(normal, [&](auto law) {
    if constexpr (law_adheres<decltype(law)>) widest = law.range(pair, radius_eff);
  });
  at<CohesionLaws>(cohesion, [&](auto law) { widest = std::max(widest, law.range(pair, options, radius_eff)); });
  return widest;
}

Stiffness LawModel::stiffness(const PairParameters& pair, const LawOptions& options, double radius_eff, double overlap,
                              const double* memory) const {
  Stiffness s;
  Kinematics<double> k;
  k.normal = {0, 0, 1};
  k.radius_eff = radius_eff;
  k.mass_eff = 1;
  NormalForce<double> f;
  at<NormalLaws>(normal, [&](auto law) {
    using Law = decltype(law);
    typename Law::template State<double> state{};
    if (memory != nullptr) std::copy_n(memory + memory_normal, state_words<Law>, reinterpret_cast<double*>(&state));
    k.overlap = law_adheres<Law> && memory != nullptr ? overlap : std::max(overlap, 0.0);
    f = law.update(pair, k, options, state);
    s.n = f.stiffness;
    s.t = f.stiffness_t;
    s.damping = law.damping_factor > 0 ? 0 : f.damping;
  });
  at<TangentialLaws>(tangential, [&](auto law) {
    if (std::is_same_v<decltype(law), Frictionless>) s.t = 0;
  });
  if (!rolls || !(overlap > 0)) return s;
  at<RollingLaws>(rolling, [&](auto law) {
    // What a turn so small that no cap is met stores is its spring's; the rest of its moment at a rate is the
    // dashpot's.
    const double turn = 0x1p-30 * (overlap / radius_eff);
    typename decltype(law)::template State<double> rolled{}, twisted{}, resting{};
    k.dt_contact = 1;
    k.relative_spin = {turn, 0, 0};
    s.rolling = 2 * law.update(pair, k, f, options, rolled).energy / (turn * turn);
    k.relative_spin = {0, 0, turn};
    s.twist = 2 * law.update(pair, k, f, options, twisted).energy / (turn * turn);
    k.dt_contact = 0;
    k.relative_spin = {turn, 0, 0};
    if (s.rolling > 0)
      s.rolling_damping = -law.update(pair, k, f, options, resting).moment.x / turn;
    else
      s.rolling_damping = 0.25 * resistance::solid_inertia(k);
  });
  return s;
}

}  // namespace contact
