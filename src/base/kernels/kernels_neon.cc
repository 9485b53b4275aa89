// NEON is in every processor of this architecture; empty elsewhere.
#if defined(__aarch64__)
#include <arm_neon.h>
#define SOMATO_KERNELS neon
#define SOMATO_NEON
#include "base/kernels/kernels.h"

#include "base/kernels/batch_kernels_body.h"
#include "base/kernels/distance_kernels_body.h"
#include "base/kernels/kernels_body.h"
#include "base/kernels/neuron_activity_kernels_body.h"
#include "base/kernels/online_kernels_body.h"
#include "base/kernels/product_kernels_body.h"
#include "base/kernels/t_mpsom_kernels_body.h"
#endif
