#include "base/kernels/distance_kernels.h"

#include "base/kernels/instruction_set.h"

namespace somato::kernels {

#define SOMATO_DECLARE_TABLE(set)            \
  namespace set {                            \
  extern const DistanceTable kDistanceTable; \
  }
SOMATO_DECLARE_TABLE(portable)
SOMATO_DECLARE_TABLE(avx2)
SOMATO_DECLARE_TABLE(avx512)
#undef SOMATO_DECLARE_TABLE

// A later set includes the earlier ones.
const DistanceTable& distance_table() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kDistanceTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kDistanceTable;
#endif
  return portable::kDistanceTable;
}

}  // namespace somato::kernels
