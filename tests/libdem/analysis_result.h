// What a quantity gave, by name.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "libdem/analysis/result.h"

namespace dem::analysis {

inline double scalar(const Result& r, const std::string& name) {
  for (const Scalar& s : r.scalars)
    if (s.name == name) return s.value;
  ADD_FAILURE() << "no scalar " << name;
  return -1;
}

}  // namespace dem::analysis
