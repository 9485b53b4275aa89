// The tables of kernels of the instruction set in use. A later set includes the earlier ones.

#include "base/kernels/distance_kernels.h"
#include "base/kernels/instruction_set.h"
#include "base/kernels/neuron_activity_kernels.h"
#include "base/kernels/product_kernels.h"
#include "base/kernels/t_mpsom_kernels.h"

namespace somato::kernels {

#define SOMATO_DECLARE_TABLES(set)           \
  namespace set {                            \
  extern const ActivityTable kActivityTable; \
  extern const DistanceTable kDistanceTable; \
  extern const ProductTable kProductTable;   \
  extern const TMpsomTable kTMpsomTable;     \
  }
SOMATO_DECLARE_TABLES(portable)
SOMATO_DECLARE_TABLES(neon)
SOMATO_DECLARE_TABLES(avx2)
SOMATO_DECLARE_TABLES(avx512)
#undef SOMATO_DECLARE_TABLES

#if defined(__x86_64__)
namespace {

template <typename Table>
const Table* table_in_use(const Table* plain, const Table* of_avx2, const Table* of_avx512) {
  if (instruction_set() >= InstructionSet::kAvx512) return of_avx512;
  return instruction_set() == InstructionSet::kAvx2 ? of_avx2 : plain;
}

}  // namespace

#define SOMATO_TABLE_IN_USE(name) *table_in_use(&portable::name, &avx2::name, &avx512::name)
#elif defined(__aarch64__)
#define SOMATO_TABLE_IN_USE(name) \
  (instruction_set() == InstructionSet::kNeon ? neon::name : portable::name)
#else
#define SOMATO_TABLE_IN_USE(name) portable::name
#endif

const ActivityTable& activity_table() {
  return SOMATO_TABLE_IN_USE(kActivityTable);
}

const DistanceTable& distance_table() {
  return SOMATO_TABLE_IN_USE(kDistanceTable);
}

const ProductTable& product_table() {
  return SOMATO_TABLE_IN_USE(kProductTable);
}

const TMpsomTable& t_mpsom_table() {
  return SOMATO_TABLE_IN_USE(kTMpsomTable);
}

#undef SOMATO_TABLE_IN_USE

}  // namespace somato::kernels
