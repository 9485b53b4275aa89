#include "base/kernels/product_kernels.h"

#include "base/kernels/instruction_set.h"

namespace somato::kernels {

#define SOMATO_DECLARE_TABLE(set)          \
  namespace set {                          \
  extern const ProductTable kProductTable; \
  }
SOMATO_DECLARE_TABLE(portable)
SOMATO_DECLARE_TABLE(avx2)
SOMATO_DECLARE_TABLE(avx512)
#undef SOMATO_DECLARE_TABLE

// A later set includes the earlier ones.
const ProductTable& product_table() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kProductTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kProductTable;
#endif
  return portable::kProductTable;
}

}  // namespace somato::kernels
