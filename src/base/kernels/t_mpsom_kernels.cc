#include "base/kernels/t_mpsom_kernels.h"

#include "base/kernels/instruction_set.h"

namespace somato::kernels {

namespace portable {
extern const TMpsomTable kTMpsomTable;
}
namespace avx2 {
extern const TMpsomTable kTMpsomTable;
}
namespace avx512 {
extern const TMpsomTable kTMpsomTable;
}

const TMpsomTable& t_mpsom_table() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kTMpsomTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kTMpsomTable;
#endif
  return portable::kTMpsomTable;
}

}  // namespace somato::kernels
