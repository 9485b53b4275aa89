#include "base/kernels/instruction_set.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "base/kernels/batch_kernels.h"
#include "base/kernels/kernels.h"
#include "base/kernels/online_kernels.h"

namespace somato {
namespace kernels {

#define SOMATO_DECLARE_TABLES(set)         \
  namespace set {                          \
  extern const Table<float> kFloatTable;   \
  extern const Table<double> kDoubleTable; \
  extern const BatchTable kBatchTable;     \
  extern const OnlineTable kOnlineTable;   \
  }
SOMATO_DECLARE_TABLES(portable)
SOMATO_DECLARE_TABLES(neon)
SOMATO_DECLARE_TABLES(avx2)
SOMATO_DECLARE_TABLES(avx512)
#undef SOMATO_DECLARE_TABLES
namespace avx512_vnni {
extern const BatchTable kBatchTable;
}

}  // namespace kernels

namespace {

std::atomic<InstructionSet>& chosen_set() {
  static std::atomic<InstructionSet> set = available_instruction_sets().back();
  return set;
}

}  // namespace

const std::array<std::pair<InstructionSet, std::string>, 5>& named_instruction_sets() {
  static const std::array<std::pair<InstructionSet, std::string>, 5> sets{
      {{InstructionSet::kPortable, "portable"},
       {InstructionSet::kNeon, "neon"},
       {InstructionSet::kAvx2, "avx2"},
       {InstructionSet::kAvx512, "avx512"},
       {InstructionSet::kAvx512Vnni, "avx512_vnni"}}};
  return sets;
}

std::string name_of(InstructionSet set) {
  for (const auto& [each, name] : named_instruction_sets()) {
    if (each == set) return name;
  }
  return {};
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> sets{InstructionSet::kPortable};
#if defined(__aarch64__)
  sets.push_back(InstructionSet::kNeon);
#elif defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    sets.push_back(InstructionSet::kAvx2);
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")) {
    sets.push_back(InstructionSet::kAvx512);
    if (__builtin_cpu_supports("avx512vnni")) sets.push_back(InstructionSet::kAvx512Vnni);
  }
#endif
  return sets;
}

InstructionSet instruction_set() {
  return chosen_set();
}

void use_instruction_set(InstructionSet chosen) {
  const auto available = available_instruction_sets();
  if (std::find(available.begin(), available.end(), chosen) == available.end()) {
    throw std::invalid_argument("this processor does not have the instruction set '" +
                                name_of(chosen) + "'");
  }
  chosen_set() = chosen;
}

namespace kernels {

template <>
const Table<float>& table<float>() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kFloatTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kFloatTable;
#elif defined(__aarch64__)
  if (instruction_set() == InstructionSet::kNeon) return neon::kFloatTable;
#endif
  return portable::kFloatTable;
}

template <>
const Table<double>& table<double>() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kDoubleTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kDoubleTable;
#elif defined(__aarch64__)
  if (instruction_set() == InstructionSet::kNeon) return neon::kDoubleTable;
#endif
  return portable::kDoubleTable;
}

const BatchTable& batch_table() {
#if defined(__x86_64__)
  if (instruction_set() == InstructionSet::kAvx512Vnni) return avx512_vnni::kBatchTable;
  if (instruction_set() == InstructionSet::kAvx512) return avx512::kBatchTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kBatchTable;
#elif defined(__aarch64__)
  if (instruction_set() == InstructionSet::kNeon) return neon::kBatchTable;
#endif
  return portable::kBatchTable;
}

const OnlineTable& online_table() {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx512) return avx512::kOnlineTable;
  if (instruction_set() == InstructionSet::kAvx2) return avx2::kOnlineTable;
#elif defined(__aarch64__)
  if (instruction_set() == InstructionSet::kNeon) return neon::kOnlineTable;
#endif
  return portable::kOnlineTable;
}

}  // namespace kernels
}  // namespace somato
