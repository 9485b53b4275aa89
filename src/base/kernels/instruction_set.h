#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace somato {

/// The vector instructions the kernels may use. Every set gives the same bits; they differ in
/// speed.
enum class InstructionSet {
  kPortable,    ///< The instructions that every processor of the architecture has.
  kNeon,        ///< NEON of 64-bit ARM.
  kAvx2,        ///< AVX2 with fused multiply-add.
  kAvx512,      ///< AVX-512 F and BW.
  kAvx512Vnni,  ///< The same with sums of products of 16-bit integers.
};

/// Every set with its name, slowest first.
const std::array<std::pair<InstructionSet, std::string>, 5>& named_instruction_sets();

std::string name_of(InstructionSet set);

/// The sets that this processor and this build offer, slowest first; never empty.
std::vector<InstructionSet> available_instruction_sets();

/// The set in use: the fastest available one unless chosen otherwise.
InstructionSet instruction_set();

/// Uses `chosen` from now on, in all threads; meant for tests and comparisons, not to be called
/// while something trains. Throws std::invalid_argument when the set is not available.
void use_instruction_set(InstructionSet chosen);

}  // namespace somato
