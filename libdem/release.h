// Gives a vector's memory back; `v = {}` would keep it.
#pragma once

#include <vector>

namespace dem {

template <class T>
void release(std::vector<T>& v) {
  std::vector<T>().swap(v);
}

}  // namespace dem
