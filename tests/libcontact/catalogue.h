// The catalogue of methods as a parameter of tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "libcontact/methods/other_libraries.h"

namespace catalogue {

using contact::MethodInfo;

// Without facets of meshes, which answer for a part of a surface.
inline std::vector<MethodInfo> of_whole_bodies() {
  std::vector<MethodInfo> list(contact::methods_begin(), contact::methods_end());
  std::erase_if(list, [](const MethodInfo& m) { return m.b == shapes::Kind::mesh; });
  return list;
}

// Without those of other libraries, whose own errors tell nothing of checks and references.
inline std::vector<MethodInfo> of_own_methods() {
  std::vector<MethodInfo> list = of_whole_bodies();
  std::erase_if(list, [](const MethodInfo& m) { return m.cost_rank >= contact::first_rank_of_other_libraries; });
  return list;
}

inline std::string entry_name(const testing::TestParamInfo<MethodInfo>& info) {
  return std::string(info.param.name) + "_" + name_of(info.param.a) + "_" + name_of(info.param.b);
}

}  // namespace catalogue
