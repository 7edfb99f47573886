// Rules of periodic scenes: a box of some length, and walls, outlets and fills that are the same for every image; a box
// that deforms is periodic along every axis of its scene.
#include <fmt/format.h>

#include <cmath>

#include "libdem/insertion/region.h"
#include "libdem/scene/rules.h"

namespace dem {

namespace {

class PeriodicRules : RuleContext {
 public:
  explicit PeriodicRules(const RuleContext& context) : RuleContext(context), box_(scene.periodic) {}

  void check() const {
    for (int k = 0; k < 3; ++k)
      if (box_.along(k) && !(box_.lower[k] < box_.upper[k]))
        return wrong("periodic", 0, "upper", fmt::format("allowed periodic.upper > periodic.lower in {}", "xyz"[k]));
    if (box_.axes == "none") return;
    const std::string zero = fmt::format("allowed: 0 along periodic.axes = \"{}\"", box_.axes);
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
      const WallSpec& w = scene.walls[i];
      const bool endless = w.kind == "plane" || w.kind == "line";
      if (!endless)
        wrong("wall", i, "kind", "with periodic.axes only planes (lines in 2-D) are allowed: a mesh has no images");
      if (endless && crosses(w.normal)) wrong("wall", i, "normal", zero);
      if (w.motion == WallMotion::rotation || w.motion == WallMotion::table)
        wrong("wall", i, "motion", "allowed with periodic.axes: fixed, translation, oscillation, servo");
    }
    for (std::size_t i = 0; i < scene.outlets.size(); ++i)
      if (scene.outlets[i].region.empty() && crosses(scene.outlets[i].normal)) wrong("outlet", i, "normal", zero);
    for (std::size_t i = 0; i < scene.fills.size(); ++i) fill(i);
    for (std::size_t i = 0; i < scene.rains.size(); ++i) within_box("rain", i, "region", scene.rains[i].region);
    for (std::size_t i = 0; i < scene.outlets.size(); ++i)
      within_box("outlet", i, "recycle_to", scene.outlets[i].recycle_to);
    if (!box_.deform.empty()) deform();
  }

 private:
  bool crosses(const Vec3d& normal) const {
    for (int k = 0; k < 3; ++k)
      if (box_.along(k) && normal[k] != 0) return true;
    return false;
  }

  void fill(std::size_t i) const {
    const FillSpec& f = scene.fills[i];
    if (!f.region.empty()) return within_box("fill", i, "region", f.region);
    for (int k = 0; k < 3; ++k) {
      if (!box_.along(k)) continue;
      for (const bool low : {true, false})
        if (low ? f.lower[k] < box_.lower[k] : f.upper[k] > box_.upper[k])
          wrong("fill", i, low ? "lower" : "upper",
                fmt::format("allowed within the periodic box, {} = {} to {}", "xyz"[k], box_.lower[k], box_.upper[k]));
    }
  }

  // Bodies must come into a region without meeting their own images.
  void within_box(const char* table, std::size_t i, const char* key, const std::string& name) const {
    for (const RegionSpec& spec : scene.regions) {
      if (spec.name != name) continue;
      const Region region(spec, scene.dimension);
      for (int k = 0; k < 3; ++k)
        if (box_.along(k) && (region.lower()[k] < box_.lower[k] || region.upper()[k] > box_.upper[k]))
          wrong(table, i, key,
                fmt::format("allowed within the periodic box, {} = {} to {}", "xyz"[k], box_.lower[k], box_.upper[k]));
    }
  }

  // Of the i-th entry of periodic.deform.
  void wrong_deform(std::size_t i, const char* key, const std::string& problem) const {
    const Node* list = node("periodic", 0, "deform");
    const Node* entry = list != nullptr && i < list->items.size() ? &list->items[i] : nullptr;
    const Node* value = entry != nullptr ? entry->get(key) : nullptr;
    const Node* at = value != nullptr ? value : entry;
    errors.add(at != nullptr ? at->position : Position{1, 1},
               value != nullptr ? fmt::format("periodic.deform.{} = {}: {}", key, to_toml(*value), problem)
                                : fmt::format("periodic.deform.{}: {}", key, problem));
  }

  void deform() const {
    const char* const every = scene.dimension == 2 ? "xy" : "xyz";
    if (box_.axes != every)
      wrong("periodic", 0, "axes", fmt::format("a box that deforms is periodic along every axis: \"{}\"", every));
    if (scene.dimension == 2 && scene.disc_model == DiscModel::sphere)
      wrong("world", 0, "disc_model",
            "allowed with periodic.deform: \"prism\", for a layer of spheres has no thickness");
    if (!(scene.gravity == Vec3d{}))
      wrong("world", 0, "gravity", "allowed with periodic.deform: [0, 0, 0], for nothing would hold the bodies");
    for (std::size_t i = 0; i < scene.events.size(); ++i)
      if (const Vec3d& g = scene.events[i].gravity; !std::isnan(g.x) && !(g == Vec3d{}))
        wrong("event", i, "gravity", "allowed with periodic.deform: [0, 0, 0], for nothing would hold the bodies");
    const char* const kept = "a box that deforms keeps its bodies: not with periodic.deform";
    for (std::size_t i = 0; i < scene.rains.size(); ++i) wrong("rain", i, nullptr, kept);
    for (std::size_t i = 0; i < scene.outlets.size(); ++i) wrong("outlet", i, nullptr, kept);
    for (std::size_t i = 0; i < box_.deform.size(); ++i) {
      if (i > 0 && !(box_.deform[i].start > box_.deform[i - 1].start))
        wrong_deform(i, "start", fmt::format("does not follow {}: allowed are rising times", box_.deform[i - 1].start));
      if (box_.deform[i].stress_axes != "none") servo(i);
      if (scene.dimension == 2) planar(i);
    }
  }

  void planar(std::size_t i) const {
    const DeformSpec& d = box_.deform[i];
    if (d.strain_rates.z != 0) wrong_deform(i, "strain_rates", "entry 3 must be 0 in a 2-D scene");
    if (d.follows(2)) wrong_deform(i, "stress_axes", "a 2-D scene allows none, x, y, xy");
  }

  void servo(std::size_t i) const {
    const DeformSpec& d = box_.deform[i];
    double common = 0;
    for (int k = 0; k < 3; ++k) {
      const double target = d.target_stress[k];
      if (!d.follows(k)) {
        if (target != 0)
          wrong_deform(i, "target_stress", fmt::format("allowed in {}: 0, or make it one of stress_axes", "xyz"[k]));
        continue;
      }
      if (d.strain_rates[k] != 0)
        wrong_deform(i, "strain_rates", fmt::format("allowed in {}: 0, it is one of stress_axes", "xyz"[k]));
      if (!(target > 0))
        return wrong_deform(i, "target_stress",
                            fmt::format("allowed in {}: > 0, bodies bear compression only", "xyz"[k]));
      if (d.isotropic && common != 0 && target != common)
        return wrong_deform(i, "target_stress", "allowed with isotropic: the same along all stress_axes");
      common = target;
    }
  }

  const PeriodicSpec& box_;
};

}  // namespace

void check_periodic_rules(const RuleContext& context) { PeriodicRules(context).check(); }

}  // namespace dem
