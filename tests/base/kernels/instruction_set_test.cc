#include "base/kernels/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace somato {
namespace {

TEST(InstructionSet, TheFastestAvailableOneIsInUse) {
  EXPECT_EQ(available_instruction_sets().front(), InstructionSet::kPortable);
  EXPECT_EQ(instruction_set(), available_instruction_sets().back());
}

TEST(InstructionSet, IsUsedWhenChosen) {
  use_instruction_set(InstructionSet::kPortable);
  EXPECT_EQ(instruction_set(), InstructionSet::kPortable);
  use_instruction_set(available_instruction_sets().back());
}

TEST(InstructionSet, IsRefusedWhenTheProcessorLacksIt) {
  const auto available = available_instruction_sets();
  for (const auto& [set, name] : named_instruction_sets()) {
    if (std::find(available.begin(), available.end(), set) == available.end()) {
      EXPECT_THROW(use_instruction_set(set), std::invalid_argument) << name;
    }
  }
}

}  // namespace
}  // namespace somato
