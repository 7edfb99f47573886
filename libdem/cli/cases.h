// Pair queries from a case file: JSON {"cases": [...]}, each with two shapes, two poses and, where known, the answer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"

namespace dem::cli {

struct Expected {
  std::string state;  // separated, touching, overlapping
  double gap = 0, abs_tol = 0;
  std::vector<shapes::Vec3d> normals;  // every direction that counts as right; empty: not checked
  double normal_tol = 0;               // rad
};

struct Case {
  std::string id;
  int dim = 3;
  contact::Body a, b;
  std::shared_ptr<const void> geometry_a, geometry_b;  // what the bodies point to
  shapes::Vec3d origin{};                              // of A, world
  shapes::Vec3d offset{};                              // origin of B − origin of A
  double size = 0;                                     // |offset| + both circumradii, m
  std::optional<Expected> expected;
};

// Throws InputError with the file, the case and the key.
std::vector<Case> read_cases(const std::string& path);

}  // namespace dem::cli
