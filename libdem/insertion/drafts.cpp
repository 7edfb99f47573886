#include "libdem/insertion/drafts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libdem/build.h"
#include "libdem/insertion/region.h"
#include "shapes/math/exponential.h"

namespace dem {
namespace {

// Normal variate by the polar method (Marsaglia & Bray, SIAM Review 6 (1964) 260).
double normal(Random& random) {
  double u, s;
  do {
    u = random.uniform(-1, 1);
    const double v = random.uniform(-1, 1);
    s = u * u + v * v;
  } while (s >= 1 || s == 0);
  return u * std::sqrt(-2 * shapes::logarithm(s) / s);
}

}  // namespace

Recipe::Recipe(const World& world, const std::vector<FillItem>& items, const Where& where)
    : world_(world), items_(items), where_(where) {
  for (const FillItem& item : items_) {
    const std::vector<std::uint32_t> variants = shape_indices(world, item.shape, where);
    add_classes(
        item, {variants[0], material_index(world, item.material, where), species_index(world, item.species, where), 1},
        variants);
  }
}

void Recipe::add_classes(const FillItem& item, const Draft& body, const std::vector<std::uint32_t>& variants) {
  if (item.distribution != SizeDistribution::table) {
    const bool fixed = item.scale_min == item.scale_max;
    classes_.push_back({&item, body, variants, item.weight, item.scale_min, item.scale_max, fixed});
    classes_.back().body.scale = item.scale_min;
    return;
  }
  // A share of the mass is a share of the number times the size's volume.
  std::vector<double> number;
  double sum = 0;
  for (const auto& [size, share] : item.table) {
    number.push_back(item.share_by == ShareBy::mass ? share / volume({body.shape, 0, 0, size}) : share);
    sum += number.back();
  }
  for (std::size_t k = 0; k < item.table.size(); ++k) {
    const double size = item.table[k][0];
    classes_.push_back({&item, body, variants, item.weight * (number[k] / sum), size, size, true});
    classes_.back().body.scale = size;
  }
}

double Recipe::scale_of(const Class& c, Random& random) const {
  if (c.fixed && c.item->distribution == SizeDistribution::table) return c.body.scale;
  const FillItem& item = *c.item;
  if (item.distribution == SizeDistribution::uniform)
    return item.scale_min + (item.scale_max - item.scale_min) * random.uniform();
  constexpr int tries = 100000;
  for (int i = 0; i < tries; ++i) {
    const double scale = item.median * shapes::exponential(item.sigma * normal(random));
    if (scale >= item.scale_min && scale <= item.scale_max) return scale;
  }
  input_error(where_, "the lognormal distribution has next to nothing between the scales " +
                          std::to_string(item.scale_min) + " and " + std::to_string(item.scale_max));
}

std::vector<Draft> Recipe::list(std::uint64_t count, std::uint64_t stream) const {
  double weights = 0;
  for (const Class& c : classes_) weights += c.share;
  std::vector<std::pair<double, std::size_t>> rest;
  std::vector<std::uint64_t> number(classes_.size());
  std::uint64_t given = 0;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    const double exact = static_cast<double>(count) * (classes_[i].share / weights);
    number[i] = static_cast<std::uint64_t>(exact);
    given += number[i];
    rest.emplace_back(static_cast<double>(number[i]) - exact, i);
  }
  std::sort(rest.begin(), rest.end());
  for (std::size_t k = 0; given < count; ++k, ++given) ++number[rest[k % rest.size()].second];
  std::vector<Draft> list;
  for (std::size_t i = 0; i < classes_.size(); ++i)
    for (std::uint64_t k = 0; k < number[i]; ++k) {
      Random random(world_.scene.run.seed, 2 * stream, list.size());
      list.push_back(classes_[i].body);
      list.back().shape = classes_[i].variants[k % classes_[i].variants.size()];
      list.back().scale = scale_of(classes_[i], random);
    }
  for (std::size_t i = list.size(); i > 1; --i) {
    Random random(world_.scene.run.seed, 2 * stream + 1, i);
    std::swap(list[i - 1], list[random.bits() % i]);
  }
  return list;
}

Draft Recipe::draw(Random& random) const {
  double weights = 0;
  for (const Class& c : classes_) weights += c.share;
  double u = weights * random.uniform();
  std::size_t i = 0;
  while (i + 1 < classes_.size() && u >= classes_[i].share) u -= classes_[i++].share;
  Draft draft = classes_[i].body;
  draft.scale = scale_of(classes_[i], random);
  if (const auto& variants = classes_[i].variants; variants.size() > 1)
    draft.shape = variants[random.bits() % variants.size()];
  return draft;
}

double Recipe::volume(const Draft& d) const {
  const ShapeEntry& s = world_.shapes[d.shape];
  return s.volume * (s.mass_power == 3 ? d.scale * d.scale * d.scale : d.scale * d.scale);
}
double Recipe::solid(const Draft& d) const {
  const Scene& scene = world_.scene;
  if (scene.dimension == 3) return volume(d);
  const double radius = world_.shapes[d.shape].circumradius * d.scale;
  return scene.disc_model == DiscModel::prism ? volume(d) / scene.thickness : std::numbers::pi * radius * radius;
}
double Recipe::mass(const Draft& d) const { return world_.materials[d.material].density * volume(d); }
double Recipe::radius(const Draft& d) const { return world_.shapes[d.shape].circumradius * d.scale; }

double Recipe::least_room(std::uint64_t count) const {
  double weights = 0, room = 0;
  for (const Class& c : classes_) weights += c.share;
  for (const Class& c : classes_) {
    double r = std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : c.variants) r = std::min(r, world_.shapes[v].circumradius * c.smallest);
    const double one = dimension_of(world_) == 2 ? std::numbers::pi * r * r : 4 * std::numbers::pi / 3 * r * r * r;
    room += std::floor(static_cast<double>(count) * (c.share / weights)) * one;
  }
  return room;
}

std::vector<Draft> Recipe::smallest() const {
  std::vector<Draft> list;
  for (const Class& c : classes_)
    for (const std::uint32_t v : c.variants) {
      list.push_back(c.body);
      list.back().shape = v;
      list.back().scale = c.smallest;
    }
  return list;
}

double Recipe::largest_radius() const {
  double largest = 0;
  for (const Class& c : classes_)
    for (const std::uint32_t v : c.variants) largest = std::max(largest, world_.shapes[v].circumradius * c.largest);
  return largest;
}

std::optional<std::vector<Draft>> list_of_amount(const Recipe& recipe, Amount amount, double target, double region,
                                                 std::uint64_t stream) {
  const auto total = [&](std::uint64_t count) {
    double sum = 0;
    for (const Draft& d : recipe.list(count, stream)) sum += amount == Amount::solid ? recipe.solid(d) : recipe.mass(d);
    return sum;
  };
  std::uint64_t low = 0, high = 1;
  while (total(high) < target) {
    if (high >= most_bodies || recipe.least_room(high) > region) return {};
    low = high;
    high = std::min(2 * high, most_bodies);
  }
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (total(middle) < target ? low : high) = middle;
  }
  const double below = low > 0 ? total(low) : 0, above = total(high);
  return recipe.list(target - below < above - target ? low : high, stream);
}

}  // namespace dem
