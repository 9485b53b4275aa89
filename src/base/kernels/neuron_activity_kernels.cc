#include "base/kernels/neuron_activity_kernels.h"

#include "base/kernels/instruction_set.h"

namespace somato::kernels {

namespace portable {
extern const ActivityTable kActivityTable;
}
namespace avx2 {
extern const ActivityTable kActivityTable;
}
namespace avx512 {
extern const ActivityTable kActivityTable;
}

const ActivityTable& activity_table() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kActivityTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kActivityTable;
#endif
  return portable::kActivityTable;
}

}  // namespace somato::kernels
