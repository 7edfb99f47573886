// Lanes of the chunks of pairs in packs: inside the kernels only (compiled once per instruction set).
#pragma once

#include "libcontact/kernels/pair_chunks.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

inline shapes::Pack load(const EllipsoidChunk::Lane& l, std::size_t i) {
  return shapes::Pack(&l.v[i], std::experimental::vector_aligned);
}
inline void store(EllipsoidChunk::Lane& l, std::size_t i, const shapes::Pack& p) {
  p.copy_to(&l.v[i], std::experimental::vector_aligned);
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
