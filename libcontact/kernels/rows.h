// Rows of four doubles, loaded whole from records and transposed in registers: four records become four lanes and back,
// at a third of the cost of moving the numbers one by one. Inside the kernels only (compiled once per instruction set).
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/kernels/lattice.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

using Row = double __attribute__((vector_size(32), may_alias));

// Row `row` of record `index`; records are aligned to rows.
[[gnu::always_inline]] inline const Row& row_of(const void* base, std::size_t size, std::uint32_t index,
                                                std::size_t row) {
  return *reinterpret_cast<const Row*>(static_cast<const char*>(base) + index * size + row * sizeof(Row));
}
[[gnu::always_inline]] inline Row& row_of(void* base, std::size_t size, std::uint32_t index, std::size_t row) {
  return *reinterpret_cast<Row*>(static_cast<char*>(base) + index * size + row * sizeof(Row));
}
struct Rows {  // four rows, one per record; after `turn` four lanes
  Row a, b, c, d;

  [[gnu::always_inline]] static Rows load(const void* base, std::size_t size, const std::uint32_t* index,
                                          std::size_t row) {
    return {row_of(base, size, index[0], row), row_of(base, size, index[1], row), row_of(base, size, index[2], row),
            row_of(base, size, index[3], row)};
  }
  [[gnu::always_inline]] Rows turned() const {
    const Row p = __builtin_shufflevector(a, b, 0, 4, 2, 6), q = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Row r = __builtin_shufflevector(c, d, 0, 4, 2, 6), s = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {__builtin_shufflevector(p, r, 0, 1, 4, 5), __builtin_shufflevector(q, s, 0, 1, 4, 5),
            __builtin_shufflevector(p, r, 2, 3, 6, 7), __builtin_shufflevector(q, s, 2, 3, 6, 7)};
  }
  [[gnu::always_inline]] void store(void* base, std::size_t size, const std::uint32_t* index, std::size_t row,
                                    std::size_t count) const {
    row_of(base, size, index[0], row) = a;
    if (count > 1) row_of(base, size, index[1], row) = b;
    if (count > 2) row_of(base, size, index[2], row) = c;
    if (count > 3) row_of(base, size, index[3], row) = d;
  }
};

// Offsets of four pairs to the nearest image, as Lattice::nearest.
[[gnu::always_inline]] inline void to_nearest(const Lattice& l, Row& x, Row& y, Row& z) {
  const double big = Lattice::rounder;
  const Row nx = (x * l.inverse.x + big) - big, ny = (y * l.inverse.y + big) - big, nz = (z * l.inverse.z + big) - big;
  x = x - nx * l.length.x;
  y = y - ny * l.length.y;
  z = z - nz * l.length.z;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
