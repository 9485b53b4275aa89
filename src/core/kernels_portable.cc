#define SOMATO_KERNELS portable
#include "core/kernels_body.h"
#include "core/t_mpsom_kernels_body.h"
