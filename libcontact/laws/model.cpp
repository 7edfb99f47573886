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
  m.rolls = names.rolling != NoRolling::name;
  at<NormalLaws>(m.normal, [&](auto law) {
    m.loss = law.loss;
    m.lingers = law_adheres<decltype(law)>;
    m.damping_factor = law.damping_factor;
    m.hertzian = std::string_view(law.parameters).starts_with("young");
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

Stiffness LawModel::stiffness(const PairParameters& pair, const LawOptions& options, double radius_eff,
                              double overlap) const {
  Stiffness s;
  at<NormalLaws>(normal, [&](auto law) {
    typename decltype(law)::template State<double> state{};
    Kinematics<double> k;
    k.overlap = std::max(overlap, 0.0);
    k.radius_eff = radius_eff;
    k.mass_eff = 1;
    const NormalForce<double> f = law.update(pair, k, options, state);
    s = {f.stiffness, f.stiffness_t};
  });
  return s;
}

}  // namespace contact
