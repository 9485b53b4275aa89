// Compiled with the options of its instruction set (src/CMakeLists.txt); empty elsewhere.
#if defined(__x86_64__)
#define SOMATO_KERNELS avx512
#include "core/kernels_body.h"
#include "core/product_kernels_body.h"
#endif
