#define SOMATO_KERNELS portable
#include "kernels/batch_kernels_body.h"
#include "kernels/kernels_body.h"
#include "kernels/online_kernels_body.h"
#include "kernels/product_kernels_body.h"
#include "kernels/t_mpsom_kernels_body.h"
