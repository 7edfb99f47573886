// Chooses the kernel set, once.
#include <cstdlib>
#include <cstring>

#include "libcontact/kernels/chunk.h"

namespace contact::kernels {

namespace sse2 {
const KernelSet& kernel_set();
}
#if defined(__x86_64__)
namespace avx2 {
const KernelSet& kernel_set();
}
namespace avx512 {
const KernelSet& kernel_set();
}
#endif

namespace {

const KernelSet& choose() {
#if defined(__x86_64__)
  const char* wish = std::getenv("DEM_SIMD");
  const auto allowed = [&](const char* name) { return wish == nullptr || std::strcmp(wish, name) == 0; };
  const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  const bool has_avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                          __builtin_cpu_supports("avx512vl") != 0;
  if (has_avx512 && allowed("avx512")) return avx512::kernel_set();
  if (has_avx2 && (allowed("avx2") || allowed("avx512"))) return avx2::kernel_set();
#endif
  return sse2::kernel_set();
}

}  // namespace

const KernelSet& kernels() {
  static const KernelSet& set = choose();
  return set;
}

}  // namespace contact::kernels
