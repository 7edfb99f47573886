// Nanoseconds per contact: each law alone, as a scalar template and as its stage of the kernels (with the loads and
// stores of a chunk); whole combinations in every instruction set; what is not asked for costs nothing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"
#include "libcontact/kernels/stages.h"
#include "shapes/math/random.h"

namespace laws {
namespace {

using namespace contact;
using kernels::chunk_size;
using kernels::LawChunk;
using kernels::LawWork;

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Median of repetitions, ns per contact; f runs a chunk.
template <class F>
double ns_per_contact(F&& f) {
  std::vector<double> samples;
  for (int i = 0; i < 50; ++i) f();
  for (int s = 0; s < 15; ++s) {
    int runs = 0;
    const double begin = now();
    double spent = 0;
    do {
      for (int i = 0; i < 50; ++i) f();
      runs += 50;
      spent = now() - begin;
    } while (spent < 1e-3);
    samples.push_back(1e9 * spent / (runs * static_cast<double>(chunk_size)));
  }
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

struct Crowd {
  std::unique_ptr<LawChunk> chunk = std::make_unique<LawChunk>();
  std::unique_ptr<LawWork> work = std::make_unique<LawWork>();
  LawOptions options = wet();
  double dt = 1e-7;

  explicit Crowd(const LawModel& model) {
    const PairParameters pair = mix(stone(), stone());
    shapes::Random random(5, 0, 0);
    for (std::size_t i = 0; i < chunk_size; ++i) {
      each_parameter(chunk->pair, pair, [i](kernels::Lane& lane, double v) { lane[i] = v; });
      chunk->radius_eff[i] = 1e-3;
      chunk->mass_eff[i] = 1e-5;
      chunk->normal.z[i] = 1;
      chunk->overlap[i] = 1e-5 * random.uniform(0.3, 1);
      work->gain[i] = 1;
      slip[i] = random.uniform(0.5, 1);
    }
    // Led into the middle of a contact.
    for (int s = 0; s < 40; ++s) {
      turn();
      model.run(*chunk, *work, chunk_size, dt, options, false);
    }
  }
  // To and fro, so that nothing runs away or idles.
  void turn() {
    ++step;
    const double sign = step % 8 < 4 ? 1 : -1;
    for (std::size_t i = 0; i < chunk_size; ++i) {
      chunk->velocity.x[i] = 0.02 * sign * slip[i];
      chunk->velocity.z[i] = 0.01 * sign;
      chunk->relative_spin.y[i] = sign;
      chunk->overlap[i] += 0.01 * sign * dt;
    }
  }
  double slip[chunk_size];
  int step = 0;
};

// One law of a family over 32 doubles, without the chunk around it.
template <class Law, class Update>
double scalar_cost(Update&& update) {
  const PairParameters pair = mix(stone(), stone());
  PairOf<double> p = pair;
  const LawOptions options = wet();
  typename Law::template State<double> state[chunk_size] = {};
  int step = 0;
  double sum = 0;
  const double cost = ns_per_contact([&] {
    ++step;
    const double sign = step % 8 < 4 ? 1 : -1;
    for (std::size_t i = 0; i < chunk_size; ++i) {
      Kinematics<double> k;
      k.overlap = 1e-5 * (0.5 + 0.01 * static_cast<double>(i)) + sign * 1e-9;
      k.overlap_before = k.overlap - sign * 1e-9;
      k.normal = {0, 0, 1};
      k.closing_speed = 0.01 * sign;
      k.slip = {0.02 * sign, 0, 0};
      k.relative_spin = {0, sign, 0};
      k.radius_eff = 1e-3;
      k.mass_eff = 1e-5;
      k.dt = k.dt_contact = 1e-7;
      sum += update(p, k, options, state[i]);
    }
  });
  volatile double keep = sum;
  (void)keep;
  return cost;
}

NormalForce<double> some_normal_force() {
  NormalForce<double> f;
  f.force = f.elastic = f.holding = 0.1;
  f.stiffness = 2e4;
  f.stiffness_t = 1.5e4;
  f.contact_radius = 1e-4;
  f.shrink = 1;
  f.bond = 1;
  return f;
}

void families(Report& r) {
  r.heading("one law: scalar template | its stage (best set), ns per contact");
  const kernels::StageSet& set = *kernels::kernels().stages;
  const auto stage = [&](kernels::Stage s, const LawNames& n, std::size_t memory) {
    const LawModel model = law_model(n).value();
    Crowd crowd(model);
    kernels::StageCall call{crowd.dt, &crowd.options, memory, false};
    return ns_per_contact([&] {
      crowd.turn();
      s(*crowd.chunk, *crowd.work, chunk_size, call);
    });
  };
  std::vector<std::vector<double>> rows;
  const auto tell = [&](const std::string& item, double scalar, double packed) {
    r.note(item, fmt::format("{:8.1f} | {:6.1f}", scalar, packed));
    rows.push_back({scalar, packed});
  };
  each_law<NormalLaws>([&](auto law, std::size_t i) {
    using Law = decltype(law);
    tell(std::string("normal ") + law.name,
         scalar_cost<Law>([](auto& p, auto& k, auto& o, auto& s) { return Law::update(p, k, o, s).force; }),
         stage(set.normal[i], {law.name, "coulomb_spring"}, 0));
  });
  const NormalForce<double> f = some_normal_force();
  each_law<TangentialLaws>([&](auto law, std::size_t i) {
    using Law = decltype(law);
    std::string normal = "hertz";
    for (const Partners& q : partners)
      if (q.law == law.name) normal = q.normal.substr(0, q.normal.find(','));
    const LawNames n{normal, law.name};
    tell(std::string("tangential ") + law.name,
         scalar_cost<Law>([&](auto& p, auto& k, auto& o, auto& s) { return Law::update(p, k, f, o, s).force.x; }),
         stage(set.tangential[i], n, law_model(n)->memory_tangential));
  });
  each_law<RollingLaws>([&](auto law, std::size_t i) {
    using Law = decltype(law);
    const LawNames n{"hertz", "coulomb_spring", law.name};
    tell(std::string("rolling ") + law.name,
         scalar_cost<Law>([&](auto& p, auto& k, auto& o, auto& s) { return Law::update(p, k, f, o, s).moment.y; }),
         stage(set.rolling[i], n, law_model(n)->memory_rolling));
  });
  each_law<CohesionLaws>([&](auto law, std::size_t i) {
    using Law = decltype(law);
    const LawNames n{"hertz", "coulomb_spring", "none", law.name};
    tell(std::string("cohesion ") + law.name,
         scalar_cost<Law>([&](auto& p, auto& k, auto& o, auto& s) { return Law::update(p, k, f, o, s).force; }),
         stage(set.cohesion[i], n, law_model(n)->memory_cohesion));
  });
  r.csv("cost", "scalar_ns,packed_ns", rows);
}

}  // namespace

void cost(Report& r) {
  families(r);
  std::string names;
  for (const kernels::KernelSet* s : kernels::kernel_sets()) names += fmt::format("{:>8}", s->name);
  r.heading("whole combinations in stages, ns per contact in" + names + "; words of memory per record");
  for (const NamedLaw& l : named_laws) {
    const LawModel model = law_model(names_of(std::string(l.name))).value();
    std::string text;
    for (const kernels::KernelSet* s : kernels::kernel_sets()) {
      Crowd crowd(model);
      text += fmt::format("{:8.1f}", ns_per_contact([&] {
                            crowd.turn();
                            model.run(*crowd.chunk, *crowd.work, chunk_size, crowd.dt, crowd.options, false, *s);
                          }));
    }
    r.note(fmt::format("{} ({})", l.name, model.words), text);
  }
  r.heading("what is not asked for: one fused kernel, no memory beside the History");
  double fused = 0, staged = 0;
  {
    const LawModel model = law_model(names_of("hertz_mindlin")).value();
    Crowd crowd(model);
    fused = ns_per_contact([&] {
      crowd.turn();
      kernels::kernels().hertz_mindlin(*crowd.chunk, chunk_size, crowd.dt, crowd.options);
    });
    staged = ns_per_contact([&] {
      crowd.turn();
      model.run(*crowd.chunk, *crowd.work, chunk_size, crowd.dt, crowd.options, false);
    });
    r.is_true("hertz_mindlin runs fused", model.fused(), "yes", model.fused() ? "yes" : "no");
    r.near("hertz_mindlin: words of memory", 0, static_cast<double>(model.words), 0);
  }
  r.note("hertz_mindlin fused (ns)", fused);
  r.at_most("hertz_mindlin fused over staged", 1, fused / staged);
  const LawModel all = law_model({"hertz", "coulomb_spring", "spring", "liquid_bridge"}).value();
  Crowd crowd(all);
  const double full = ns_per_contact([&] {
    crowd.turn();
    all.run(*crowd.chunk, *crowd.work, chunk_size, crowd.dt, crowd.options, false);
  });
  r.note("with rolling springs and liquid bridges, staged (ns)", full);
}

}  // namespace laws
