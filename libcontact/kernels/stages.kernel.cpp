#include "libcontact/kernels/stages.h"

#include <array>

#include "libcontact/kernels/extreme_sets.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/laws/list.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

// The words of a state are its members in order, each a Pack: sizeof counts them.
template <class State>
inline constexpr std::size_t words = std::is_empty_v<State> ? 0 : sizeof(State) / sizeof(Pack);

template <class State>
State load_state(const LawWork& w, std::size_t i, std::size_t first, std::size_t skip = 0) {
  State s{};
  Pack* word = reinterpret_cast<Pack*>(&s);
  for (std::size_t j = skip; j < words<State>; ++j) word[j] = load(w.memory[first + j - skip], i);
  return s;
}
template <class State>
void store_state(LawWork& w, std::size_t i, std::size_t first, const State& s, std::size_t skip = 0) {
  const Pack* word = reinterpret_cast<const Pack*>(&s);
  for (std::size_t j = skip; j < words<State>; ++j) store(w.memory[first + j - skip], i, word[j]);
}
template <class State, class Mask>
void wipe(State& s, const Mask& where) {
  Pack* word = reinterpret_cast<Pack*>(&s);
  for (std::size_t j = 0; j < words<State>; ++j) word[j] = select(where, Pack(0), word[j]);
}
// The leading vectors of a state, turned as the contact frame turned.
template <class Law, class State>
void carry(State& s, const LawChunk& c, std::size_t i, const V& normal, const Pack& angle) {
  const V before = load(c.history_normal, i);
  V* vector = reinterpret_cast<V*>(&s);
  for (int j = 0; j < state_vectors<Law>; ++j) vector[j] = carried(vector[j], before, normal, angle);
}

NormalForce<Pack> load(const NormalForce<Lane>& lanes, std::size_t i) {
  NormalForce<Pack> f;
  each_of_normal_force(f, lanes, [i](Pack& x, const Lane& l) { x = kernels::load(l, i); });
  return f;
}

// Lanes that only cohesion holds.
auto apart(const LawWork& w, std::size_t i) {
  return !(load(w.depth, i) > Pack(0)) && load(w.normal.bond, i) == Pack(0);
}

Kinematics<Pack> seen(const LawChunk& c, const LawWork& w, std::size_t i, const StageCall& call) {
  Kinematics<Pack> k = kinematics(c, i, load(w.depth, i), Pack::mask_type(false), Pack(call.dt), true);
  k.dt_contact = load(w.dt_contact, i);
  k.onset = load(w.onset, i);
  k.overlap_before = load(w.overlap_before, i);
  k.relative_spin = load(c.relative_spin, i);
  return k;
}

template <class Law>
KERNEL_IN_LINE void normal_stage(LawChunk& c, LawWork& w, std::size_t count, const StageCall& call) {
  using State = typename Law::template State<Pack>;
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    State s = load_state<State>(w, i, call.memory);
    Pack depth = load(c.overlap, i);
    auto fresh = !(load(c.history_overlap, i) > Pack(0));
    if constexpr (law_adheres<Law>)
      fresh = s.bonded == Pack(0);
    else
      depth = larger(depth, Pack(0));
    const Pack gain = load(w.gain, i);
    Kinematics<Pack> k = kinematics(c, i, depth, fresh, Pack(call.dt), call.options->clip);
    store(w.depth, i, depth);
    store(w.dt_contact, i, k.dt_contact);
    store(w.onset, i, k.onset);
    k.overlap_before = select(fresh, Pack(0), k.overlap_before);
    store(w.overlap_before, i, k.overlap_before);
    k.closing_speed *= gain;
    k.mass_eff /= gain * gain;
    NormalForce<Pack> f = Law::update(load(c.pair, i), k, *call.options, s);
    f.force *= gain;
    f.elastic *= gain;
    f.holding *= gain;
    f.stiffness *= gain * gain;
    f.damping *= gain * gain;
    if constexpr (!law_adheres<Law>) {  // a record may be there for its cohesion alone
      const auto none = !(depth > Pack(0));
      each_of_normal_force(f, f, [&](Pack& x, const Pack&) { x = select(none, Pack(0), x); });
      wipe(s, none);
    }
    each_of_normal_force(w.normal, f, [i](Lane& l, const Pack& x) { store(l, i, x); });
    store_state(w, i, call.memory, s);
  }
}

template <class Law>
KERNEL_IN_LINE void tangential_stage(LawChunk& c, LawWork& w, std::size_t count, const StageCall& call) {
  using State = typename Law::template State<Pack>;
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const Kinematics<Pack> k = seen(c, w, i, call);
    State s = load_state<State>(w, i, call.memory, 3);
    s.force = load(c.history_force, i);
    carry<Law>(s, c, i, k.normal, load(c.turn, i) * k.dt);
    const TangentialForce<Pack> f = Law::update(load(c.pair, i), k, load(w.normal, i), *call.options, s);
    store(w.tangential, i, f.force);
    store(w.tangential_energy, i, f.energy);
    wipe(s, apart(w, i));
    store(c.history_force, i, s.force);
    store_state(w, i, call.memory, s, 3);
  }
}

template <class Law>
KERNEL_IN_LINE void rolling_stage(LawChunk& c, LawWork& w, std::size_t count, const StageCall& call) {
  using State = typename Law::template State<Pack>;
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const Kinematics<Pack> k = seen(c, w, i, call);
    State s = load_state<State>(w, i, call.memory);
    carry<Law>(s, c, i, k.normal, load(c.turn, i) * k.dt);
    const Moment<Pack> m = Law::update(load(c.pair, i), k, load(w.normal, i), *call.options, s);
    store(w.moment, i, m.moment);
    store(w.moment_energy, i, m.energy);
    wipe(s, apart(w, i));
    store_state(w, i, call.memory, s);
  }
}

template <class Law>
KERNEL_IN_LINE void cohesion_stage(LawChunk& c, LawWork& w, std::size_t count, const StageCall& call) {
  using State = typename Law::template State<Pack>;
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    Kinematics<Pack> k = seen(c, w, i, call);
    k.overlap = load(c.overlap, i);  // a gap counts
    State s = load_state<State>(w, i, call.memory);
    const Pull<Pack> pull = Law::update(load(c.pair, i), k, load(w.normal, i), *call.options, s);
    store(w.pull, i, pull.force * load(w.gain, i));
    store(w.pull_energy, i, pull.energy);
    store(w.bond, i, larger(kernels::load(w.normal.bond, i), pull.bond));
    store_state(w, i, call.memory, s);
  }
}

KERNEL_IN_LINE void finish_stage(LawChunk& c, LawWork& w, std::size_t count, const StageCall& call) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V n = load(c.normal, i);
    const NormalForce<Pack> f = load(w.normal, i);
    store(c.force, i, -(n * (f.force - load(w.pull, i)) + load(w.tangential, i)));
    V couple = load(w.moment, i);
    if (call.patch) couple += patch_couple(c, i, n, f, load(c.pair.friction, i), load(w.dt_contact, i));
    store(c.couple, i, couple);
    store(c.history_normal, i, n);
    const Pack overlap = load(c.overlap, i);
    const auto bonded = load(w.bond, i) > Pack(0);
    store(c.history_overlap, i, select(bonded && overlap < Pack(0), overlap, larger(overlap, Pack(0))));
  }
}

template <class List, class F>
constexpr auto table(F&& stage) {
  std::array<Stage, std::tuple_size_v<List>> list{};
  each_law<List>([&](auto law, std::size_t i) { list[i] = stage(law); });
  return list;
}

}  // namespace

const StageSet& stage_set() {
  static constexpr auto normal = table<NormalLaws>([](auto law) { return normal_stage<decltype(law)>; });
  static constexpr auto tangential = table<TangentialLaws>([](auto law) { return tangential_stage<decltype(law)>; });
  static constexpr auto rolling = table<RollingLaws>([](auto law) { return rolling_stage<decltype(law)>; });
  static constexpr auto cohesion = table<CohesionLaws>([](auto law) { return cohesion_stage<decltype(law)>; });
  static constexpr StageSet set{normal, tangential, rolling, cohesion, finish_stage};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
