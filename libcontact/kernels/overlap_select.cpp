#include <cstring>

#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/overlap_sums.h"

namespace contact::kernels {

namespace sse2 {
extern const OverlapKernels overlap_set;
}
#if defined(__x86_64__)
namespace avx2 {
extern const OverlapKernels overlap_set;
}
namespace avx512 {
extern const OverlapKernels overlap_set;
}
#endif

const OverlapKernels& overlap_kernels([[maybe_unused]] const char* set) {
#if defined(__x86_64__)
  if (std::strcmp(set, "avx512") == 0) return avx512::overlap_set;
  if (std::strcmp(set, "avx2") == 0) return avx2::overlap_set;
#endif
  return sse2::overlap_set;
}

const OverlapKernels& overlap_kernels() {
  static const OverlapKernels& set = overlap_kernels(kernels().name);
  return set;
}

}  // namespace contact::kernels
