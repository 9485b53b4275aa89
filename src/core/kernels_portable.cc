#define SOMATO_KERNELS portable
#include "core/kernels_body.h"
#include "core/online_kernels_body.h"
