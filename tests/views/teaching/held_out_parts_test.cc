#include "views/teaching/held_out_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace somato::live {
namespace {

using Numbers = std::vector<std::size_t>;

// Class 1 comes twice as often as the others.
Numbers classes(std::size_t explorations) {
  Numbers class_of;
  for (std::size_t i = 0; i < explorations; ++i) class_of.push_back(Numbers{0, 1, 2, 1}[i % 4]);
  return class_of;
}

TEST(HeldOutParts, HoldEachExplorationOutOnce) {
  const Numbers class_of = classes(22);
  const auto parts = held_out_parts(class_of, 3, 0.05);
  ASSERT_EQ(parts.size(), 3U);
  Numbers held_out;
  for (const HeldOutPart& part : parts) {
    Numbers all = part.training;
    all.insert(all.end(), part.held_out.begin(), part.held_out.end());
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all.size(), 22U);
    EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
    held_out.insert(held_out.end(), part.held_out.begin(), part.held_out.end());
    for (const std::size_t one : {0U, 1U, 2U}) {
      const auto of_class = [&](std::size_t i) { return class_of[i] == one; };
      const auto held = std::ranges::count_if(part.held_out, of_class);
      const auto known = std::ranges::count_if(part.training, of_class);
      EXPECT_LE(std::abs(2 * held - known), 3) << "a third of class " << one;
    }
  }
  std::sort(held_out.begin(), held_out.end());
  EXPECT_EQ(held_out.size(), 22U);
  EXPECT_EQ(std::adjacent_find(held_out.begin(), held_out.end()), held_out.end());
}

TEST(HeldOutParts, NeedEnoughExplorationsOfEachClass) {
  EXPECT_EQ(held_out_parts(classes(19), 3, 0.05).size(), 3U);
  EXPECT_TRUE(held_out_parts(classes(18), 3, 0.05).empty());
  EXPECT_EQ(held_out_parts(classes(9), 3, 0.1).size(), 3U);
  Numbers single = classes(40);
  single.push_back(3);
  EXPECT_TRUE(held_out_parts(single, 3, 0.05).empty());
  EXPECT_EQ(held_out_parts(Numbers{0, 0, 1, 1}, 3, 0.5).size(), 2U) << "no empty part";
}

}  // namespace
}  // namespace somato::live
