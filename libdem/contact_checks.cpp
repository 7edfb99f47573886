#include "libdem/contact_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "libdem/build.h"
#include "libdem/forces.h"
#include "libdem/time_step.h"
#include "libdem/walls.h"

namespace dem {
namespace {

std::string parties(const World& world, std::uint32_t k) {
  const Contacts& c = world.contacts;
  const std::uint32_t b = c.index_b[k];
  return "body " + std::to_string(world.particles.id[c.index_a[k]]) + " and " +
         (c.key[k].b >= wall_base ? "wall \"" + world.walls[b].name + "\""
                                  : "body " + std::to_string(world.particles.id[b]));
}

// The contact, of those judged, whose stability limit by itself lies farthest below the step.
class TightestContact {
 public:
  explicit TightestContact(const World& world) : world_(world), limit_(world.time_step.dt) {}

  void judge(std::uint32_t k, double overlap) {
    const std::vector<Key>& key = world_.contacts.key;
    const double limit = contact_limit(world_, k, overlap);
    if (!(limit < limit_ || (found_ && limit == limit_ && key[k] < key[record_]))) return;
    limit_ = limit;
    record_ = k;
    found_ = true;
  }
  void judge(std::span<const Change> changed) {
    const Contacts& c = world_.contacts;
    for (const Change& x : changed)
      judge(x.record, c.touching[x.record] != 0 ? c.history_of(x.record).overlap : x.overlap);
  }
  // Throws when there is one.
  void stop() const {
    if (found_)
      throw RunError(
          fmt::format("step {}: run.dt = {:.4g} s has passed the stability limit of the contact of {}, {:.4g} s",
                      world_.step, world_.time_step.dt, parties(world_, record_), limit_));
  }

 private:
  const World& world_;
  double limit_;
  std::uint32_t record_ = 0;
  bool found_ = false;
};

}  // namespace

void check_passages(const World& world, const std::vector<std::uint32_t>& through) {
  if (through.empty()) return;
  const Contacts& c = world.contacts;
  const std::uint32_t k = *std::min_element(through.begin(), through.end(),
                                            [&](std::uint32_t x, std::uint32_t y) { return c.key[x] < c.key[y]; });
  throw RunError(fmt::format(
      "step {}: {} pass through each other, their overlap is {:.3g} m: they are too soft for their speed or their load",
      world.step, parties(world, k), c.history_of(k).overlap));
}

struct ImpactCheck::Tightest : TightestContact {
  using TightestContact::TightestContact;
};
ImpactCheck::ImpactCheck(const World& world) : tightest_(std::make_unique<Tightest>(world)) {}
ImpactCheck::~ImpactCheck() = default;

void ImpactCheck::judge(std::span<const Change> changed) { tightest_->judge(changed); }
void ImpactCheck::stop() const { tightest_->stop(); }

void check_contacts(const World& world) {
  const Contacts& c = world.contacts;
  TightestContact tightest(world);
  for (std::uint32_t k = 0; k < c.count(); ++k)
    if (c.touching[k] != 0) tightest.judge(k, c.history_of(k).overlap);
  tightest.stop();
}

}  // namespace dem
