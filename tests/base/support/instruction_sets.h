#pragma once

#include "base/kernels/instruction_set.h"

namespace somato::testing {

/// Calls `check(set)` with each instruction set of this machine in use, then restores the choice.
template <typename Check>
void for_each_instruction_set(const Check& check) {
  const InstructionSet before = instruction_set();
  for (const InstructionSet set : available_instruction_sets()) {
    use_instruction_set(set);
    check(set);
  }
  use_instruction_set(before);
}

}  // namespace somato::testing
