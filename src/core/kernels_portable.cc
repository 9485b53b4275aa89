#define SOMATO_KERNELS portable
#include "core/kernels_body.h"
