#include "somato/core/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "somato/core/check.h"

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
  for (const auto& [set, name] : Choices<InstructionSet>::all()) {
    if (std::find(available.begin(), available.end(), set) == available.end()) {
      EXPECT_THROW(use_instruction_set(set), InvalidArgument) << name;
    }
  }
}

}  // namespace
}  // namespace somato
