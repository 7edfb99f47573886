// The contacts of a step, task by task, and the bodies' part of it.
#include <omp.h>

#include <algorithm>
#include <chrono>

#include "libcontact/methods/polygon_regions.h"
#include "libdem/build.h"
#include "libdem/contact_checks.h"
#include "libdem/forces.h"
#include "libdem/forces_compound.h"
#include "libdem/meetings.h"
#include "libdem/pair_answers.h"
#include "libdem/release.h"
#include "libdem/sleep.h"
#include "libdem/stopwatch.h"
#include "libdem/sweep.h"
#include "libdem/wall_load.h"
#include "libdem/walls.h"

namespace dem {
namespace {

// What the contacts that have ended lost, in the order of their keys.
void book_lost(World& world, const std::vector<Change>& changed) {
  std::vector<Gone>& gone = world.contacts.gone;
  for (const Change& c : changed)
    if (world.contacts.touching[c.record] == 0) gone.push_back({world.contacts.key[c.record], c.lost});
  std::sort(gone.begin(), gone.end(), [](const Gone& x, const Gone& y) { return x.key < y.key; });
  for (const Gone& g : gone)
    for (std::size_t m = 0; m < contact::mechanism_count; ++m) world.balance.lost[m].add(g.lost[m]);
  gone.clear();
}

// Pairs of a task: as many lanes as a chunk has where kernels run across pairs, less where pairs are dear or have many
// records.
std::size_t task_size(const Bin& bin, const PairAnswers& pairs) {
  if (pairs.in_lanes(bin)) return chunk_size;
  if (bin.regions) return chunk_size / contact::max_regions;
  return bin.a == shapes::Kind::ellipsoid || bin.a == shapes::Kind::ellipse ? chunk_size : chunk_size / 2;
}

// What became of the candidates of each bin, and last of the groups.
void book(World& world, const std::vector<Tally>& tally) {
  Counters& n = world.counters;
  for (std::size_t i = 0; i < tally.size(); ++i) {
    Tally t = tally[i];
    if (i + 1 < tally.size()) {
      const Bin& bin = world.contacts.bins[i];
      const std::size_t asleep = bin.records.size() / (bin.regions ? contact::max_regions : 1) - t.candidates;
      t.candidates += asleep;
      // Round pairs are told apart by their spheres in the step that lists the awake, and by their ways after it.
      (bin.round() && world.contacts.way == 0 ? t.by_spheres : t.by_displacement) += asleep;
    }
    if (i + 1 == tally.size()) {
      world.profile.parts += t;
    } else {
      const Bin& bin = world.contacts.bins[i];
      world.profile.pairs[static_cast<std::size_t>(bin.a)][static_cast<std::size_t>(bin.b)] += t;
    }
    n.queries += t.candidates;
    n.contact_steps += t.touching;
    n.not_converged += t.not_converged;
    n.uncertified += t.uncertified;
    n.handed_over += t.handed_over;
  }
}

// What acts on the walls, from the slots of their records.
void sum_walls(World& world) {
  const Contacts& c = world.contacts;
  for (Wall& w : world.walls) w.force = w.torque = {};
  for (const std::uint32_t k : c.wall_records) {
    if (c.touching[k] == 0) continue;
    Wall& w = world.walls[c.index_b[k]];
    w.force -= c.slot[c.slot_of(k)].force;
    w.torque += c.slot[c.slot_of_b(k)].couple;
  }
  sum_resistance(world);
}

// What threads find; put together by collect().
class ContactStep {
 public:
  ContactStep(World& world, int threads, double dt)
      : world_(world), threads_(threads), pairs_(world, dt), compounds_(world, dt), timed_(world.profile.timed) {}

  // What a sweep does not come by: other kinds, and round pairs that have met since the list was made.
  void others() {
    list_tasks();
#pragma omp parallel num_threads(threads_)
    {
      Scratch& s = scratch();
#pragma omp for schedule(dynamic, 1)
      for (std::size_t i = 0; i < tasks_.size(); ++i) answer(tasks_[i], s);
      collect(s);
    }
    Contacts& c = world_.contacts;
    for (const Change& change : changed)
      if (c.seat[change.record] < c.round_seats) relist(c, change.record);
  }

  // The other round pairs, and the bodies.
  void sweep(const BodyPass& bodies) {
    const Sweep& plan = world_.contacts.sweep;
    Bin* bin = plan.chunks > 0 ? &world_.contacts.bins[plan.bin] : nullptr;
#pragma omp parallel num_threads(threads_)
    {
      Scratch& s = scratch();
      BodyTally mine;
      double seconds = 0;
      const auto self = static_cast<std::size_t>(omp_get_thread_num()),
                 count = static_cast<std::size_t>(omp_get_num_threads());
      const ChunkRange range(plan.chunks, self, count);
      if (!bodies.keeps() && world_.contacts.words == 0 && bin != nullptr) s.ring = ring_of(world_, self, count);
      auto next = std::lower_bound(plan.order.begin(), plan.order.end(), range.first,
                                   [&](std::uint32_t block, std::size_t chunk) { return plan.last[block] < chunk; });
      for (std::size_t first = range.first; first < range.last; first += chunks_at_once) {
        const std::size_t last = std::min(first + chunks_at_once, range.last);
        answer({bin, true, first, last}, s);
        const auto begin = Clock::now();
        for (; next != plan.order.end() && plan.last[*next] < last; ++next) {
          if (next + 1 != plan.order.end()) bodies.fetch(next[1]);
          if (range.holds(plan, *next)) bodies.block(*next, mine, s.ring);
        }
        seconds += seconds_since(begin);
      }
#pragma omp barrier
      const auto begin = Clock::now();
#pragma omp for schedule(static)
      for (std::size_t block = 0; block < bodies.blocks(); ++block)
        if (!in_one_range(plan, block, count)) bodies.block(block, mine);
      seconds += seconds_since(begin);
      collect(s);
#pragma omp critical(bodies)
      add(moved, mine);
      if (self == 0) moving = seconds;
    }
  }

  std::vector<Change> changed;
  std::vector<std::uint32_t> through;
  std::vector<Tally> total;
  BodyTally moved;
  double moving = 0;  // s, of the first thread

 private:
  using Clock = std::chrono::steady_clock;
  struct Task {
    Bin* bin;  // null: groups
    bool met;  // chunks of the pairs that have met
    std::size_t first, last;
  };

  // Tasks of about ten microseconds, the dear ones first, so that threads end together.
  void list_tasks() {
    Contacts& c = world_.contacts;
    for (std::size_t first = 0, g = 0, records = 0; g < c.groups.size(); ++g) {
      records += c.groups[g].count;
      if (records < chunk_size && g + 1 < c.groups.size()) continue;
      tasks_.push_back({nullptr, false, first, g + 1});
      first = g + 1;
      records = 0;
    }
    const auto add = [this](Bin& bin, bool met, std::size_t first, std::size_t last, std::size_t size) {
      for (; first < last; first += size) tasks_.push_back({&bin, met, first, std::min(first + size, last)});
    };
    for (Bin& b : c.bins)
      if (b.query != nullptr) add(b, false, 0, b.awake.size(), task_size(b, pairs_));
    for (std::size_t i = 0; i < c.bins.size(); ++i) {
      Bin& b = c.bins[i];
      if (b.smooth) add(b, true, 0, b.met.chunks(), 4);
      if (b.round()) add(b, true, i == c.sweep.bin ? c.sweep.chunks : 0, b.met.chunks(), chunks_at_once);
      if (b.query == nullptr && b.wall) add(b, false, 0, b.records.size(), 8 * chunk_size);
    }
  }

  // This thread's.
  Scratch& scratch() const {
    static thread_local Scratch s;
    std::fill(std::begin(s.pair), std::end(s.pair), none);
    s.pair_everywhere = none;
    s.ring = {};
    s.tally.assign(world_.contacts.bins.size() + 1, {});
    return s;
  }

  void answer(const Task& task, Scratch& s) const {
    const auto start = timed_ ? Clock::now() : Clock::time_point{};
    Tally mine = task.bin == nullptr ? compounds_.answer(task.first, task.last, s)
                                     : pairs_.answer(*task.bin, task.met, task.first, task.last, s);
    if (timed_) mine.seconds = seconds_since(start);
    const Bin* bins = world_.contacts.bins.data();
    s.tally[task.bin == nullptr ? s.tally.size() - 1 : static_cast<std::size_t>(task.bin - bins)] += mine;
  }

  void collect(Scratch& s) {
#pragma omp critical
    {
      for (std::size_t i = 0; i < total.size(); ++i) total[i] += s.tally[i];
      changed.insert(changed.end(), s.changed.begin(), s.changed.end());
      through.insert(through.end(), s.through.begin(), s.through.end());
      const auto empty = [](auto& list) {  // at the first step all contacts come
        constexpr std::size_t usual = 4096;
        if (list.capacity() > usual)
          release(list);
        else
          list.clear();
      };
      empty(s.changed);
      empty(s.through);
    }
  }

  World& world_;
  int threads_;
  PairAnswers pairs_;
  CompoundPass compounds_;
  std::vector<Task> tasks_;
  bool timed_;
};

}  // namespace

BodyTally compute_forces(World& world, int threads, double dt, const BodyStep& then) {
  const auto begin = std::chrono::steady_clock::now();
  wake(world, threads);
  std::vector<Tally> looked = meet(world, threads);
  plan_sweep_again(world);
  ContactStep step(world, threads, dt);
  step.total = std::move(looked);
  ImpactCheck impacts(world);
  step.others();
  if (dt > 0) impacts.judge(step.changed);  // by the present poses
  const std::size_t judged = step.changed.size();
  sum_walls(world);
  if (dt > 0) book_wall_loads(world, dt);
  step.sweep(BodyPass(world, then));
  if (!world.contacts.ledger.empty()) book_lost(world, step.changed);
  if (dt > 0) {
    impacts.judge(std::span(step.changed).subspan(judged));
    check_passages(world, step.through);
    impacts.stop();
  }
  book(world, step.total);
  world.times.query += seconds_since(begin) - step.moving;
  world.times.integrate += step.moving;
  return step.moved;
}

}  // namespace dem
