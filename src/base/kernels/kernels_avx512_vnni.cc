// Compiled with the options of its instruction set (src/CMakeLists.txt); empty elsewhere. The other
// kernels have nothing to gain: they are those of AVX-512.
#if defined(__x86_64__)
#define SOMATO_KERNELS avx512_vnni
#include "base/kernels/batch_kernels.h"

#include "base/kernels/batch_kernels_body.h"
#endif
