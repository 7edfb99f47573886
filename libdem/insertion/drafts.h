// Which bodies a fill or a rain makes, before any of them has a place: shape, material, species and size.
#pragma once

#include <optional>
#include <vector>

#include "libdem/random.h"
#include "libdem/world.h"

namespace dem {

struct Draft {
  std::uint32_t shape = 0, material = 0, species = 0;
  double scale = 1;
};

// The items of a fill or rain with their size distributions, tables cut into classes of one size each.
class Recipe {
 public:
  Recipe(const World& world, const std::vector<FillItem>& items, const Where& where);

  // `count` bodies: every class gets its share by largest remainder, then the order is shuffled. A function of
  // (seed, stream, count) alone.
  std::vector<Draft> list(std::uint64_t count, std::uint64_t stream) const;
  // One body of an endless row, each class drawn with its probability.
  Draft draw(Random& random) const;

  double volume(const Draft& draft) const;  // m³
  double solid(const Draft& draft) const;   // m³; m² in two dimensions: what a solid fraction counts
  double mass(const Draft& draft) const;    // kg
  double radius(const Draft& draft) const;  // m, of the bounding sphere
  // What the bounding spheres of `count` bodies fill at least, m³ (m²): more than that never fits.
  double least_room(std::uint64_t count) const;
  std::vector<Draft> smallest() const;  // of every class: what the time step must allow for
  double largest_radius() const;        // m, of any body that can be drawn

 private:
  struct Class {
    const FillItem* item;
    Draft body;                           // with its scale where that is fixed
    std::vector<std::uint32_t> variants;  // of its shape, taken in turn
    double share, smallest, largest;
    bool fixed;
  };
  void add_classes(const FillItem& item, const Draft& body, const std::vector<std::uint32_t>& variants);
  double scale_of(const Class& c, Random& random) const;
  const World& world_;
  std::vector<FillItem> items_;
  Where where_;
  std::vector<Class> classes_;
};

// What a recipe weighs: bodies whose sum comes nearest to an amount. Nothing when more are needed than a region of that
// size (m³, m²) holds.
enum class Amount { solid, mass };
std::optional<std::vector<Draft>> list_of_amount(const Recipe& recipe, Amount amount, double target, double region,
                                                 std::uint64_t stream);

}  // namespace dem
