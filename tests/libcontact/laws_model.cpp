// What holds for every law of the lists, run as scenes run them: in stages over chunks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "libcontact/laws/ledger.h"
#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"
#include "libcontact/laws/model.h"
#include "tests/libcontact/law_lanes.h"
#include "tests/libcontact/law_material.h"

namespace contact {
namespace {

using kernels::chunk_size;
using kernels::Draw;
using kernels::get;
using kernels::Lane3;
using kernels::LawChunk;
using kernels::LawWork;
using kernels::put;
using shapes::Vec3d;

Material viscous_stone() {
  Material m = stone();
  m.viscous_time = 1e-5;
  return m;
}

// Every law of every family with partners that suit it.
std::vector<LawNames> combinations() {
  std::vector<LawNames> list;
  const auto partner_of = [](std::string_view tangential) {
    for (const Partners& p : partners)
      if (p.law == tangential) return std::string(p.normal.substr(0, p.normal.find(',')));
    return std::string("hertz");
  };
  each_law<NormalLaws>([&](auto law, std::size_t) { list.push_back({law.name, "coulomb_spring"}); });
  each_law<TangentialLaws>([&](auto law, std::size_t) { list.push_back({partner_of(law.name), law.name}); });
  each_law<RollingLaws>([&](auto law, std::size_t) { list.push_back({"hertz", "coulomb_spring", law.name}); });
  each_law<CohesionLaws>([&](auto law, std::size_t) { list.push_back({"hertz", "coulomb_spring", "none", law.name}); });
  return list;
}
std::string title(const LawNames& n) { return n.normal + ", " + n.tangential + ", " + n.rolling + ", " + n.cohesion; }

// A chunk of contacts that come, press, slide, roll, part and come again, each on a path of its own.
class Crowd {
 public:
  Crowd(const LawNames& names, unsigned seed) : model_(*law_model(names)), draw_(seed) {
    const PairParameters pair = mix(viscous_stone(), viscous_stone());
    for (std::size_t i = 0; i < chunk_size; ++i) {
      each_parameter(chunk_->pair, pair, [i](kernels::Lane& lane, double v) { lane[i] = v; });
      chunk_->radius_eff[i] = 1e-3 * draw_.in(0.5, 2);
      chunk_->mass_eff[i] = 1e-5 * draw_.in(0.5, 2);
      put(chunk_->normal, i, draw_.unit());
      work_->gain[i] = 1;
      mean_.push_back(draw_.in(-5e-6, 2e-5));
      phase_.push_back(draw_.in(0, 6));
      spread(i);
    }
  }
  void step(double dt, bool patch, bool fused = false, const kernels::KernelSet* set = nullptr) {
    time_ += dt;
    for (std::size_t i = 0; i < chunk_size; ++i) {
      const double at = 2e3 * time_ + phase_[i], overlap = mean_[i] + 2e-5 * std::sin(at);
      const Vec3d n = normalized(get(chunk_->normal, i) + draw_.unit() * 1e-3);
      const Vec3d sideways = draw_.unit() * 0.02;
      const bool first = chunk_->history_overlap[i] == 0 && chunk_->history_normal.x[i] == 0;
      chunk_->overlap[i] = overlap;
      put(chunk_->normal, i, n);
      if (first) put(chunk_->history_normal, i, n);
      put(chunk_->velocity, i, n * (4e-2 * std::cos(at)) + sideways - n * dot(sideways, n));
      put(chunk_->relative_spin, i, draw_.unit() * 5.0);
      chunk_->turn[i] = draw_.in(-1, 1);
    }
    const kernels::KernelSet& own = set != nullptr ? *set : kernels::kernels();
    if (fused)
      (model_.hertzian ? patch ? own.hertz_mindlin_patch : own.hertz_mindlin
                       : (patch ? own.spring_dashpot_patch : own.spring_dashpot))(*chunk_, chunk_size, dt, wet());
    else
      model_.run(*chunk_, *work_, chunk_size, dt, wet(), patch, own);
    for (std::size_t i = 0; i < chunk_size; ++i) {
      if (chunk_->history_overlap[i] > 0 || (!fused && work_->bond[i] > 0)) continue;
      put(chunk_->history_force, i, {});  // as a loop forgets
      put(chunk_->history_normal, i, {});
      chunk_->history_overlap[i] = chunk_->history_twist[i] = 0;
      for (auto& word : work_->memory) word[i] = 0;
    }
  }
  const LawModel& model() const { return model_; }
  const LawChunk& chunk() const { return *chunk_; }
  const LawWork& work() const { return *work_; }

 private:
  void spread(std::size_t i) {
    chunk_->spread_xx[i] = draw_.in(0, 1e-8);
    chunk_->spread_yy[i] = draw_.in(0, 1e-8);
    chunk_->spread_zz[i] = draw_.in(0, 1e-8);
  }
  LawModel model_;
  Draw draw_;
  std::unique_ptr<LawChunk> chunk_ = std::make_unique<LawChunk>();
  std::unique_ptr<LawWork> work_ = std::make_unique<LawWork>();
  std::vector<double> mean_, phase_;
  double time_ = 0;
};

bool same(const Lane3& a, const Lane3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_where_touching(const LawChunk& c, const Lane3& a, const Lane3& b) {
  bool same = true;
  for (std::size_t i = 0; i < chunk_size; ++i) same = same && (!(c.overlap[i] > 0) || get(a, i) == get(b, i));
  return same;
}

TEST(LawModel, StagesGiveTheBitsOfTheFusedKernels) {
  for (const char* normal : {"hertz", "linear"})
    for (const bool patch : {false, true}) {
      Crowd stages({normal, "coulomb_spring"}, 1), fused({normal, "coulomb_spring"}, 1);
      ASSERT_TRUE(stages.model().fused());
      for (int s = 0; s < 3000; ++s) {
        stages.step(1e-6, patch);
        fused.step(1e-6, patch, true);
        const LawChunk &one = stages.chunk(), &other = fused.chunk();
        ASSERT_TRUE(same_where_touching(one, one.force, other.force)) << normal << " step " << s;
        ASSERT_TRUE(same_where_touching(one, one.history_force, other.history_force)) << normal << " step " << s;
        ASSERT_TRUE(!patch || same_where_touching(one, one.couple, other.couple)) << normal << " step " << s;
      }
    }
}

class EveryLaw : public testing::TestWithParam<LawNames> {};

TEST_P(EveryLaw, GivesTheSameBitsInEveryKernelSet) {
  const auto sets = kernels::kernel_sets();
  std::vector<std::unique_ptr<Crowd>> crowds;
  for (std::size_t k = 0; k < sets.size(); ++k) crowds.push_back(std::make_unique<Crowd>(GetParam(), 2));
  int touched = 0;
  for (int s = 0; s < 1500; ++s)
    for (std::size_t k = 0; k < sets.size(); ++k) {
      crowds[k]->step(4e-6, false, false, sets[k]);
      ASSERT_TRUE(same(crowds[0]->chunk().force, crowds[k]->chunk().force)) << sets[k]->name << " step " << s;
      ASSERT_TRUE(same(crowds[0]->chunk().couple, crowds[k]->chunk().couple)) << sets[k]->name << " step " << s;
      ASSERT_EQ(std::memcmp(crowds[0]->work().memory, crowds[k]->work().memory, sizeof(LawWork::memory)), 0);
      for (std::size_t i = 0; i < chunk_size; ++i) touched += crowds[k]->chunk().overlap[i] > 0 ? 1 : 0;
    }
  EXPECT_GT(touched, 1500);
}

TEST_P(EveryLaw, StaysFiniteAndWithinTheConeAndFreeWhereApart) {
  Crowd crowd(GetParam(), 3);
  const LawModel& model = crowd.model();
  const PairParameters pair = mix(viscous_stone(), viscous_stone());
  for (int s = 0; s < 4000; ++s) {
    crowd.step(4e-6, false);
    const LawWork& w = crowd.work();
    const LawChunk& c = crowd.chunk();
    for (std::size_t i = 0; i < chunk_size; ++i) {
      const Vec3d f = get(c.force, i), n = get(c.normal, i), m = get(c.couple, i);
      ASSERT_TRUE(is_finite(f) && is_finite(m)) << "step " << s << ", lane " << i;
      const Vec3d ft = f - n * dot(f, n);
      // A contact that peels holds more than it would sliding, until it has peeled.
      if (GetParam().tangential != ThorntonPeeling::name) {
        ASSERT_LE(norm(ft), stone().friction * w.normal.holding[i] * (1 + 1e-12) + 1e-12 * norm(f));
      }
      ASSERT_GE(w.normal.holding[i], 0);
      ASSERT_TRUE(w.bond[i] == 0 || w.bond[i] == 1);
      const double range = model.range(pair, wet(), c.radius_eff[i]);
      if (c.overlap[i] < -range * (1 + 1e-9)) {
        ASSERT_EQ(norm(f), 0) << "overlap " << c.overlap[i] << " range " << range;
        ASSERT_EQ(w.bond[i], 0);
        ASSERT_EQ(norm(m), 0);
      }
      ASSERT_TRUE(model.lingers || w.bond[i] == 0);
    }
  }
}

// A pair that moves as one rigid body keeps its forces in its own frame.
TEST_P(EveryLaw, RigidRotationOfThePairTurnsTheForceWithIt) {
  const LawModel model = *law_model(GetParam());
  auto chunk = std::make_unique<LawChunk>();
  auto work = std::make_unique<LawWork>();
  const PairParameters pair = mix(viscous_stone(), viscous_stone());
  each_parameter(chunk->pair, pair, [](kernels::Lane& lane, double v) { lane[0] = v; });
  chunk->radius_eff[0] = 1e-3;
  chunk->mass_eff[0] = 1e-5;
  work->gain[0] = 1;
  const double dt = 1e-6;
  Vec3d n{0, 0, 1};
  put(chunk->history_normal, 0, n);
  const auto run = [&](const Vec3d& velocity, double turn) {
    chunk->overlap[0] = 1e-5;
    put(chunk->normal, 0, n);
    put(chunk->velocity, 0, velocity);
    chunk->turn[0] = turn;
    model.run(*chunk, *work, 1, dt, wet(), false);
    return get(chunk->force, 0);
  };
  for (int s = 0; s < 20; ++s) run({0.02, 0.01, 0}, 0);
  const Vec3d before = run({0, 0, 0}, 0);
  // About an oblique axis by one full turn.
  const Vec3d axis = normalized(Vec3d{0.3, -0.5, 0.8});
  const int steps = 400;
  const double angle = 2 * M_PI / steps;
  Vec3d after{};
  for (int s = 0; s < steps; ++s) {
    const Vec3d half = n * std::cos(0.5 * angle) + cross(axis, n) * std::sin(0.5 * angle) +
                       axis * (dot(axis, n) * (1 - std::cos(0.5 * angle)));
    n = n * std::cos(angle) + cross(axis, n) * std::sin(angle) + axis * (dot(axis, n) * (1 - std::cos(angle)));
    after = run({0, 0, 0}, dot(axis, half) * angle / dt);
  }
  EXPECT_NEAR(norm(after) / norm(before), 1, 1e-9);
  EXPECT_NEAR(norm(after - before) / norm(before), 0, 2e-5);
}

INSTANTIATE_TEST_SUITE_P(List, EveryLaw, testing::ValuesIn(combinations()), [](const auto& p) {
  std::string name = p.param.normal + "_" + p.param.tangential + "_" + p.param.rolling + "_" + p.param.cohesion;
  return name + "_" + std::to_string(p.index);
});

TEST(LawModel, EveryNamedCombinationIsMadeOfLawsOfTheLists) {
  for (const NamedLaw& l : named_laws) {
    const auto names = named_law(l.name);
    ASSERT_TRUE(names);
    const auto model = law_model(*names);
    ASSERT_TRUE(model) << title(*names);
    EXPECT_EQ(model->hertzian, hertzian(l.normal)) << l.name;
  }
  EXPECT_FALSE(law_model({"hertz", "nonsense"}));
  EXPECT_FALSE(named_law("nonsense"));
}

}  // namespace
}  // namespace contact
