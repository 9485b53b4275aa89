// Compiled with the options of its instruction set (src/CMakeLists.txt); empty elsewhere.
#if defined(__x86_64__)
#define SOMATO_KERNELS avx2
#include "base/kernels/kernels.h"

#include "base/kernels/batch_kernels_body.h"
#include "base/kernels/distance_kernels_body.h"
#include "base/kernels/kernels_body.h"
#include "base/kernels/neuron_activity_kernels_body.h"
#include "base/kernels/online_kernels_body.h"
#include "base/kernels/product_kernels_body.h"
#include "base/kernels/t_mpsom_kernels_body.h"
#endif
