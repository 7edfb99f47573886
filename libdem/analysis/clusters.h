// Bodies that hang together: components of a graph that grows by one contact at a time, and in a periodic cell whether
// a component joins its own image.
//
// Cost: nearly O(1) per contact (union by size, halved paths). The smallest place in a component names it, so the
// answer does not depend on the order of contacts. Tests: tests/libdem/analysis_forces.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace dem::analysis {

class Clusters {
 public:
  using Shift = std::array<int, 3>;  // in cells
  explicit Clusters(std::size_t count);

  // Joins a and the image of b that stands `shift` cells from b.
  void join(std::uint32_t a, std::uint32_t b, const Shift& shift = {});
  // Marks are or-ed over a component.
  void mark(std::uint32_t i, std::uint32_t marks);
  std::uint32_t marks(std::uint32_t i) { return marks_[find(i)]; }
  // Whether i's component reaches its own image along the axis.
  bool winds(std::uint32_t i, int axis) { return (winding_[find(i)] >> axis & 1u) != 0; }
  std::uint32_t size(std::uint32_t i) { return size_[find(i)]; }
  bool joined(std::uint32_t a, std::uint32_t b) { return find(a) == find(b); }
  // The components of at least `least` bodies in falling order of size, then by their smallest body; of each body its
  // place among them, or none.
  static constexpr std::uint32_t none = 0xffffffffu;
  struct List {
    std::vector<std::uint32_t> sizes, of_body;
  };
  List list(std::uint32_t least);

 private:
  std::uint32_t find(std::uint32_t i);  // root; shift_[i] is then from i to it
  std::vector<std::uint32_t> parent_, size_, marks_, winding_;
  std::vector<Shift> shift_;  // cells from the parent's frame to this body's
  std::vector<std::uint32_t> path_;
};

}  // namespace dem::analysis
