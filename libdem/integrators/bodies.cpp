#include "libdem/integrators/bodies.h"

#include <cstring>

#include "libcontact/kernels/chunk.h"

namespace dem {

namespace sse2 {
void advance_bodies(const BodyArrays&, const SumLists&, const BodyStep&, std::size_t, std::size_t, BodyTally&);
}
#if defined(__x86_64__)
namespace avx2 {
void advance_bodies(const BodyArrays&, const SumLists&, const BodyStep&, std::size_t, std::size_t, BodyTally&);
}
namespace avx512 {
void advance_bodies(const BodyArrays&, const SumLists&, const BodyStep&, std::size_t, std::size_t, BodyTally&);
}
#endif

BodyKernel body_kernel(const char* set) {
#if defined(__x86_64__)
  if (std::strcmp(set, "avx512") == 0) return avx512::advance_bodies;
  if (std::strcmp(set, "avx2") == 0) return avx2::advance_bodies;
#endif
  return sse2::advance_bodies;
}

BodyKernel body_kernel() { return body_kernel(contact::kernels::kernels().name); }

}  // namespace dem
