// Bytes as text for a page (RFC 4648).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dem::report {

std::string base64(std::span<const std::uint8_t> bytes);
// Of plain numbers, in the byte order of this machine (little-endian, as browsers read them).
template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)});
}

}  // namespace dem::report
