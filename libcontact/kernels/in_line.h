// KERNEL_IN_LINE: of a kernel, which is one loop with everything in line. Under the address sanitizer that takes
// minutes to compile.
#pragma once

#ifdef __SANITIZE_ADDRESS__
#define KERNEL_IN_LINE
#else
#define KERNEL_IN_LINE __attribute__((flatten))
#endif
