#define SOMATO_KERNELS portable
#include "core/kernels_body.h"
#include "core/product_kernels_body.h"
