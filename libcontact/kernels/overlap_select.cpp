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

namespace {

const OverlapKernels& choose() {
#if defined(__x86_64__)
  if (std::strcmp(kernels().name, "avx512") == 0) return avx512::overlap_set;
  if (std::strcmp(kernels().name, "avx2") == 0) return avx2::overlap_set;
#endif
  return sse2::overlap_set;
}

}  // namespace

const OverlapKernels& overlap_kernels() {
  static const OverlapKernels& set = choose();
  return set;
}

}  // namespace contact::kernels
