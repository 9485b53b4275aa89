#define SOMATO_KERNELS portable
#include "core/batch_kernels_body.h"
#include "core/kernels_body.h"
#include "core/online_kernels_body.h"
#include "core/product_kernels_body.h"
#include "core/t_mpsom_kernels_body.h"
