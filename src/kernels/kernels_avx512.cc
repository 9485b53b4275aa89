// Compiled with the options of its instruction set (src/CMakeLists.txt); empty elsewhere.
#if defined(__x86_64__)
#define SOMATO_KERNELS avx512
#include "kernels/batch_kernels_body.h"
#include "kernels/kernels_body.h"
#include "kernels/online_kernels_body.h"
#include "kernels/product_kernels_body.h"
#include "kernels/t_mpsom_kernels_body.h"
#endif
