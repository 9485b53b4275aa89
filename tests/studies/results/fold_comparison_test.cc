#include "studies/results/fold_comparison.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato {
namespace {

FoldComparison compared(std::size_t only_blocks, std::size_t only_interleaved) {
  FoldComparison comparison{"blocks", "interleaved", 10};
  comparison.samples = 100;
  comparison.right = 50 + only_blocks;
  comparison.other_right = 50 + only_interleaved;
  comparison.only_right = only_blocks;
  comparison.only_other_right = only_interleaved;
  return comparison;
}

// The same as a study in interleaved folds states it.
FoldComparison reversed(FoldComparison one) {
  std::swap(one.choice, one.other);
  std::swap(one.right, one.other_right);
  std::swap(one.only_right, one.only_other_right);
  return one;
}

TEST(FoldComparison, CountsSamplesOfBothChoices) {
  FoldComparison comparison{"interleaved", "blocks", 2};
  count_right({"a", "a", "b", "b", "b"}, {"a", "a", "b", "a", "a"}, {"a", "b", "a", "b", "a"},
              comparison);
  EXPECT_EQ(comparison.samples, 5U);
  EXPECT_EQ(comparison.right, 3U);
  EXPECT_EQ(comparison.other_right, 2U);
  EXPECT_EQ(comparison.only_right, 2U);
  EXPECT_EQ(comparison.only_other_right, 1U);
  EXPECT_DOUBLE_EQ(*accuracy_by("interleaved", comparison), 0.6);
  EXPECT_DOUBLE_EQ(*accuracy_by("blocks", comparison), 0.4);
  EXPECT_THROW(count_right({"a"}, {}, {"a"}, comparison), InvalidArgument);
}

// 2 sqrt(16) is 8.
TEST(FoldComparison, NeighboursLeakByMoreThanTwoStandardErrors) {
  EXPECT_FALSE(neighbours_leak(compared(4, 12)));
  EXPECT_TRUE(neighbours_leak(compared(3, 13)));
  EXPECT_FALSE(neighbours_leak(compared(13, 3))) << "the accuracy rises";
  EXPECT_FALSE(neighbours_leak(compared(0, 0)));
  EXPECT_TRUE(neighbours_leak(reversed(compared(3, 13))));
  EXPECT_FALSE(neighbours_leak(reversed(compared(13, 3))));
}

TEST(FoldComparison, IsTheSameSentenceFromBothSides) {
  EXPECT_EQ(sentence_of(compared(1, 24)),
            "The accuracy falls from 0.740 to 0.510 when neighbouring explorations are kept "
            "together (interleaved folds and blocks, first seed).");
  EXPECT_EQ(sentence_of(reversed(compared(1, 24))), sentence_of(compared(1, 24)));
  EXPECT_EQ(sentence_of(reversed(compared(4, 5))), sentence_of(compared(4, 5)));
  EXPECT_NE(sentence_of(compared(4, 5)).find("no clear difference"), std::string::npos);
}

TEST(FoldComparison, OfSingleExplorationsSaysThatNothingWasMeasured) {
  const FoldComparison comparison{"blocks", "interleaved", 1};
  EXPECT_FALSE(accuracy_by("blocks", comparison));
  EXPECT_FALSE(neighbours_leak(comparison));
  EXPECT_NE(sentence_of(comparison).find("not measured"), std::string::npos);
}

TEST(FoldComparison, OfSeveralRecordingsIsTheirSum) {
  FoldComparison sum = compared(1, 24);
  add(compared(4, 5), sum);
  EXPECT_EQ(sum.samples, 200U);
  EXPECT_EQ(sum.only_right, 5U);
  EXPECT_EQ(sum.only_other_right, 29U);
  EXPECT_DOUBLE_EQ(*accuracy_by("blocks", sum), 105.0 / 200.0);
}

}  // namespace
}  // namespace somato
