// Rows of four doubles, loaded whole from records and transposed in registers: four records become four lanes and back,
// at a third of the cost of moving the numbers one by one. Inside the kernels only (compiled once per instruction set).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "libcontact/kernels/lattice.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

// Rows are passed by value between functions that are always in line: no call, no convention of calls.
#pragma GCC diagnostic ignored "-Wpsabi"

using Row = double __attribute__((vector_size(32), may_alias));

// Row `row` of record `index`; records are aligned to rows.
[[gnu::always_inline]] inline const Row& row_of(const void* base, std::size_t size, std::uint32_t index,
                                                std::size_t row) {
  return *reinterpret_cast<const Row*>(static_cast<const char*>(base) + index * size + row * sizeof(Row));
}
[[gnu::always_inline]] inline Row& row_of(void* base, std::size_t size, std::uint32_t index, std::size_t row) {
  return *reinterpret_cast<Row*>(static_cast<char*>(base) + index * size + row * sizeof(Row));
}

template <int N>
struct LanesOf;
template <>
struct LanesOf<4> {
  using Lanes = Row;
  using Bits = decltype(Row{} < Row{});  // all of a lane or none
};
template <>
struct LanesOf<8> {
  using Lanes = double __attribute__((vector_size(64), may_alias));
  using Bits = decltype(Lanes{} < Lanes{});
};

// N = 4 or 8 lanes, one per record, with what templates over a scalar ask of a number.
template <int N>
struct Wide {
  using Lanes = typename LanesOf<N>::Lanes;
  using Bits = typename LanesOf<N>::Bits;
  struct Mask {
    Bits bits;
    friend Mask operator&&(const Mask& a, const Mask& b) { return {a.bits & b.bits}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {a.bits | b.bits}; }
    friend Mask operator!(const Mask& a) { return {~a.bits}; }
    friend bool any_of(const Mask& a) {
      auto any = a.bits[0];
      for (int i = 1; i < N; ++i) any |= a.bits[i];
      return any != 0;
    }
  };
  Lanes v;
  Wide() : v{} {}
  Wide(const Lanes& lanes) : v(lanes) {}
  explicit Wide(double x) : v(Lanes{} + x) {}

  friend Wide operator+(const Wide& a, const Wide& b) { return a.v + b.v; }
  friend Wide operator-(const Wide& a, const Wide& b) { return a.v - b.v; }
  friend Wide operator*(const Wide& a, const Wide& b) { return a.v * b.v; }
  friend Wide operator/(const Wide& a, const Wide& b) { return a.v / b.v; }
  friend Wide operator-(const Wide& a) { return -a.v; }
  friend Mask operator<(const Wide& a, const Wide& b) { return {a.v < b.v}; }
  friend Mask operator>(const Wide& a, const Wide& b) { return {a.v > b.v}; }
  friend Mask operator==(const Wide& a, const Wide& b) { return {a.v == b.v}; }
  friend Wide select(const Mask& mask, const Wide& a, const Wide& b) { return Lanes(mask.bits ? a.v : b.v); }
  friend Wide sqrt(const Wide& a) {
    Wide r;
    for (int i = 0; i < N; ++i) r.v[i] = __builtin_sqrt(a.v[i]);
    return r;
  }
};
using Four = Wide<4>;

// Of N records the same row each: four vectors, the first of which has that of record 0 and, of eight, that of record 4
// behind it, and so on; after `turned` the first number of all records, the second, …
template <int N>
struct RowsOf {
  using Lanes = typename LanesOf<N>::Lanes;
  Lanes a, b, c, d;

  [[gnu::always_inline]] static RowsOf load(const void* base, std::size_t size, const std::uint32_t* index,
                                            std::size_t row) {
    const auto at = [&](std::size_t i) -> const Row& { return row_of(base, size, index[i], row); };
    if constexpr (N == 4)
      return {at(0), at(1), at(2), at(3)};
    else
      return {join(at(0), at(4)), join(at(1), at(5)), join(at(2), at(6)), join(at(3), at(7))};
  }
  // Rows of b less those of a, but of the fourth numbers the sum.
  [[gnu::always_inline]] static RowsOf load_apart(const void* base, std::size_t size, const std::uint32_t* a,
                                                  const std::uint32_t* b, std::size_t row) {
    if constexpr (N == 4)
      return {apart(base, size, a[0], b[0], row), apart(base, size, a[1], b[1], row),
              apart(base, size, a[2], b[2], row), apart(base, size, a[3], b[3], row)};
    else
      return {join(apart(base, size, a[0], b[0], row), apart(base, size, a[4], b[4], row)),
              join(apart(base, size, a[1], b[1], row), apart(base, size, a[5], b[5], row)),
              join(apart(base, size, a[2], b[2], row), apart(base, size, a[6], b[6], row)),
              join(apart(base, size, a[3], b[3], row), apart(base, size, a[7], b[7], row))};
  }
  [[gnu::always_inline]] RowsOf turned() const {
    if constexpr (N == 4) {
      const Row p = __builtin_shufflevector(a, b, 0, 4, 2, 6), q = __builtin_shufflevector(a, b, 1, 5, 3, 7);
      const Row r = __builtin_shufflevector(c, d, 0, 4, 2, 6), s = __builtin_shufflevector(c, d, 1, 5, 3, 7);
      return {__builtin_shufflevector(p, r, 0, 1, 4, 5), __builtin_shufflevector(q, s, 0, 1, 4, 5),
              __builtin_shufflevector(p, r, 2, 3, 6, 7), __builtin_shufflevector(q, s, 2, 3, 6, 7)};
    } else {
      const Lanes p = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14),
                  q = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15),
                  r = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14),
                  s = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
      return {__builtin_shufflevector(p, r, 0, 1, 8, 9, 4, 5, 12, 13),
              __builtin_shufflevector(q, s, 0, 1, 8, 9, 4, 5, 12, 13),
              __builtin_shufflevector(p, r, 2, 3, 10, 11, 6, 7, 14, 15),
              __builtin_shufflevector(q, s, 2, 3, 10, 11, 6, 7, 14, 15)};
    }
  }
  // The first `count` of the records.
  [[gnu::always_inline]] void store(void* base, std::size_t size, const std::uint32_t* index, std::size_t row,
                                    std::size_t count) const {
    const Lanes* const from[] = {&a, &b, &c, &d};
    const auto put = [&](std::size_t i) {
      const Lanes& lanes = *from[i % 4];
      Row& to = row_of(base, size, index[i], row);
      to = reinterpret_cast<const Row*>(&lanes)[i / 4];
    };
    if (count >= N)
      for (std::size_t i = 0; i < N; ++i) put(i);
    else
      for (std::size_t i = 0; i < count; ++i) put(i);
  }

 private:
  [[gnu::always_inline]] static Row apart(const void* base, std::size_t size, std::uint32_t a, std::uint32_t b,
                                          std::size_t row) {
    using Bits = std::int64_t __attribute__((vector_size(32), may_alias));
    constexpr std::int64_t sign = std::numeric_limits<std::int64_t>::min();
    return row_of(base, size, b, row) + (Row)((Bits)row_of(base, size, a, row) ^ Bits{sign, sign, sign, 0});
  }
  [[gnu::always_inline]] static Lanes join(const Row& low, const Row& high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
};
using Rows = RowsOf<4>;

// Offsets of pairs to the nearest image, as Lattice::nearest; four or eight lanes.
template <class Lanes>
[[gnu::always_inline]] inline void to_nearest(const Lattice& l, Lanes& x, Lanes& y, Lanes& z) {
  const double big = Lattice::rounder;
  const Lanes nx = (x * l.inverse.x + big) - big, ny = (y * l.inverse.y + big) - big,
              nz = (z * l.inverse.z + big) - big;
  x = x - nx * l.length.x;
  y = y - ny * l.length.y;
  z = z - nz * l.length.z;
}
// Velocities of pairs relative to the flow of the lattice between their centres, as Lattice::flow.
template <class Lanes>
[[gnu::always_inline]] inline void leave_flow(const Lattice& l, const Lanes& x, const Lanes& y, const Lanes& z,
                                              Lanes& vx, Lanes& vy, Lanes& vz) {
  vx = vx - l.rate.x * x;
  vy = vy - l.rate.y * y;
  vz = vz - l.rate.z * z;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
