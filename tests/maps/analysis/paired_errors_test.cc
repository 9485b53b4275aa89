#include "maps/analysis/paired_errors.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

using Errors = std::vector<double>;

// The differences 0, 1, 2, 3 have the mean 1.5 and the standard error sqrt(5 / 3 / 4) = 0.645.
TEST(PairedErrors, AMeanAboveOneStandardErrorIsClear) {
  EXPECT_TRUE(is_clearly_better(Errors{5, 5, 5, 5}, Errors{5, 6, 7, 8}));
  EXPECT_FALSE(is_clearly_better(Errors{5, 6, 7, 8}, Errors{5, 5, 5, 5}));
}

// The differences -3, -1, 2, 4 have the mean 0.5 and the standard error 1.55.
TEST(PairedErrors, AMeanBelowIsNot) {
  EXPECT_FALSE(is_clearly_better(Errors{3, 1, 0, 0}, Errors{0, 0, 2, 4}));
}

TEST(PairedErrors, EqualErrorsAreNotBetter) {
  EXPECT_FALSE(is_clearly_better(Errors{1, 2}, Errors{1, 2}));
  EXPECT_FALSE(is_clearly_better(Errors{1}, Errors{1}));
}

TEST(PairedErrors, EqualDifferencesHaveNoError) {
  EXPECT_TRUE(is_clearly_better(Errors{1, 2}, Errors{1.5, 2.5}));
  EXPECT_TRUE(is_clearly_better(Errors{1}, Errors{2}));
}

TEST(PairedErrors, NeedPairs) {
  EXPECT_THROW(is_clearly_better(Errors{1}, Errors{1, 2}), InvalidArgument);
  EXPECT_THROW(is_clearly_better(Errors{}, Errors{}), InvalidArgument);
}

}  // namespace
}  // namespace somato
