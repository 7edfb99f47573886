// Values of a scene about bodies that come, go and are told apart: regions, fills, rain, outlets, species, events.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "libdem/scene/where.h"
#include "shapes/math/quat.h"

namespace dem {

using shapes::Quatd;
using shapes::Vec3d;

struct RegionSpec {
  std::string name, kind = "box";  // box | cylinder | sphere; in two dimensions box | disc
  Vec3d lower{}, upper{};          // box, m
  Vec3d centre{}, axis{0, 0, 1};   // the others; the axis of a cylinder, any length
  double radius = 0, height = 0;   // m
  Where where;
};

enum class SizeDistribution { uniform, lognormal, table };
enum class ShareBy { number, mass };

struct FillItem {
  std::string shape, material;
  double weight = 1;                    // share of the number
  double scale_min = 1, scale_max = 1;  // uniform: between these; lognormal: cut off there (factor on the shape's size)
  SizeDistribution distribution = SizeDistribution::uniform;
  double median = 1, sigma = 0;                // lognormal: median of the factor, standard deviation of its logarithm
  std::vector<std::array<double, 2>> table{};  // factor, share
  ShareBy share_by = ShareBy::number;
  std::string species{};  // empty: none
};

enum class Arrangement { automatic, random, lattice, cubic, hexagonal, fcc };
enum class Turned { random, given };

inline constexpr std::uint64_t most_bodies = 50000000;  // of one fill: what memory of some ten gigabytes holds

struct FillSpec {                       // bodies in a region, without overlap
  std::string region;                   // or the box from lower to upper
  Vec3d lower{}, upper{};               // m
  std::uint64_t count = 0;              // one of these three; none of them: every site of a regular lattice
  double solid_fraction = 0, mass = 0;  // –, kg
  Arrangement arrangement = Arrangement::automatic;
  double spacing = 0;  // m, of a regular lattice; 0: bounding spheres touch
  Turned turned = Turned::random;
  Quatd orientation{};
  Vec3d velocity{};
  std::vector<FillItem> items;
  Where where;
};

struct RainSpec {  // bodies created at a rate, at random in a region, without overlap
  std::string name, region;
  double rate = 0, mass_rate = 0;                                    // 1/s or kg/s
  double start = 0, stop = std::numeric_limits<double>::infinity();  // s
  std::uint64_t count = 0;                                           // at most; 0: no limit
  double mass = 0;                                                   // kg, at most; 0: no limit
  int tries = 20;  // positions tried per step while something is in the way
  Turned turned = Turned::random;
  Quatd orientation{};
  Vec3d velocity{};
  std::vector<FillItem> items;
  Where where;
};

// Bodies whose centre is behind the plane (normal·(x − point) < 0), or inside the region, are counted and deleted, or
// moved to a region.
struct OutletSpec {
  std::string name;
  std::string region;  // or the plane
  Vec3d point{}, normal{};
  std::string recycle_to;  // region; empty: deleted
  Vec3d velocity{};        // m/s, after recycling
  Where where;
};

// A tag on bodies. With a region, material or shape: the bodies that begin there, or are of it, get the tag.
struct SpeciesSpec {
  std::string name, region, material, shape;
  Where where;
};

// Something that happens once: at a time, or when a condition holds.
struct EventSpec {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::string name;
  double at = 0;                                                    // s; 0 when `when` is given instead
  std::string when;                                                 // condition, see libdem/events/condition.h
  double delay = 0;                                                 // s, from the condition to the actions
  std::string remove_wall, insert_wall, start_motion, stop_motion;  // walls
  std::string start_rain, stop_rain;
  Vec3d gravity{none, none, none};  // m/s²
  double friction = none;           // of the pair of materials a, b
  std::string a, b;
  std::string species, region, material;  // tags the bodies in the region and of the material
  bool stop = false;                      // ends the run
  Where where;
};

}  // namespace dem
