// The keys of [[shape]] of kinds that stand for many grains made by random numbers.
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::value;

std::vector<Key> grain_keys() {
  return {
      value<&ShapeSpec::statistic>(
          "statistic", "",
          "Sample that the grains follow in W/L, T/W and sphericity: CSV file with columns L, W, T, and sphericity or "
          "volume and area where that counts; ct:all is shipped, 2500 scanned grains of ten powders.")
          .as_file()
          .when("kind", {"generated"})
          .must(),
      value<&ShapeSpec::set>("set", "", "Only the rows of the sample that have this in their column set.")
          .when("kind", {"generated"}),
      value<&ShapeSpec::variants>("variants", "",
                                  "How many grains are made; bodies take them in equal numbers. NAME#1 is the first of "
                                  "them.")
          .from(1)
          .to(10000)
          .when("kind", {"generated", "voronoi"}),
      value<&ShapeSpec::relaxations>("relaxations", "",
                                     "How often the points go to the centres of their cells: more are rounder and more "
                                     "alike.")
          .from(0)
          .to(100)
          .when("kind", {"voronoi"}),
  };
}

}  // namespace dem
