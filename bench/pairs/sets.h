// The pairs that are timed: bodies of a family, placed at a chosen gap, and the pose that follows.
//
// size = mean of the two circumradii; touch: overlap 1e-3 size, apart: gap 0.05 size, deep: overlap 0.2 size. Spheres,
// ellipsoids and their sections are placed about a common normal drawn uniformly; other pairs along a random line of
// centres. In the pose that follows b has moved by 1e-3 size and turned by 1e-3 rad, both in random directions.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"

namespace pairs {

using contact::Body;
using shapes::Mat3d;
using shapes::Vec3d;

struct Pair {
  std::uint32_t a, b;  // of the set's bodies
  Vec3d offset;
  double size;
  std::uint32_t next_b;  // in the pose that follows
  Vec3d next_offset;
};

struct Set {
  std::string family, config;      // "ellipsoid_1_1_2", "touch"
  std::string member_a, member_b;  // families of the bodies' own pairs; equal unless the pair is mixed
  std::vector<Body> bodies;
  std::vector<shapes::Quatd> orientation;  // of the bodies: their rotations before rounding
  std::vector<Pair> list;
  shapes::Kind a, b;
  std::string name() const { return family + "/" + config; }
};

// Where the second body is put: its gap over the size of the pair.
struct Config {
  const char* name;
  double part;
};

// Pairs of bodies of two families ("ellipsoid_1_1_2", "poly50", "grain_fine", …).
std::unique_ptr<Set> make_set(const std::string& family_a, const std::string& family_b, const Config& config,
                              std::size_t count);
// `filter`: a part of the name; empty: all.
std::vector<std::unique_ptr<Set>> all_sets(const std::string& filter, std::size_t count);

}  // namespace pairs
