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

struct Sets {
  const KernelSet* list[3] = {&sse2::kernel_set()};
  std::size_t count = 1;
  Sets() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") != 0) list[count++] = &avx2::kernel_set();
    if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
        __builtin_cpu_supports("avx512vl") != 0)
      list[count++] = &avx512::kernel_set();
#endif
  }
};

// The widest set up to the one asked for; an unknown wish asks for the narrowest.
const KernelSet& choose() {
  const auto sets = kernel_sets();
  const char* wish = std::getenv("DEM_SIMD");
  if (wish == nullptr) return *sets.back();
  const char* const order[] = {"sse2", "avx2", "avx512"};
  std::size_t last = 0;
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (std::strcmp(wish, order[j]) == 0 && i <= j) last = i;
  return *sets[last];
}

}  // namespace

std::span<const KernelSet* const> kernel_sets() {
  static const Sets sets;
  return {sets.list, sets.count};
}

const KernelSet& kernels() {
  static const KernelSet& set = choose();
  return set;
}

const PairKernels& pair_kernels() { return kernels().pairs; }

const SearchKernels& search_kernels() {
  static const SearchKernels& search = kernels().search;
  return search;
}

}  // namespace contact::kernels
