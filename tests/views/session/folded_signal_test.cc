#include "views/session/folded_signal.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato::live {
namespace {

using Floats = std::vector<float>;
using Sizes = std::vector<std::size_t>;

TEST(FoldedSignal, LeavesASmallOneAsItIs) {
  const Floats values{1, 2, 3, 4};
  const FoldedSignal folded = fold_signal(SignalView::dense(values), {2, 2}, 4);
  EXPECT_EQ(folded.values, values);
  EXPECT_EQ(folded.shape, (Sizes{2, 2}));
  EXPECT_FALSE(folded.folded);
}

TEST(FoldedSignal, SumsOverLeadingAxes) {
  const Floats values{1, 2, 3, 10, 20, 30};
  const FoldedSignal folded = fold_signal(SignalView::dense(values), {2, 3}, 5);
  EXPECT_EQ(folded.values, (Floats{11, 22, 33}));
  EXPECT_EQ(folded.shape, (Sizes{3}));
  EXPECT_TRUE(folded.folded);
}

TEST(FoldedSignal, SumsOverNoMoreAxesThanItMust) {
  const Floats values(24, 1.0F);
  const FoldedSignal folded = fold_signal(SignalView::dense(values), {2, 3, 4}, 12);
  EXPECT_EQ(folded.shape, (Sizes{3, 4}));
  EXPECT_EQ(folded.values, Floats(12, 2.0F));
}

TEST(FoldedSignal, SumsNeighboursOfALongAxis) {
  const Floats values{1, 2, 3, 4, 5};
  const FoldedSignal folded = fold_signal(SignalView::dense(values), {5}, 3);
  EXPECT_EQ(folded.values, (Floats{3, 7, 5}));
  EXPECT_EQ(folded.shape, (Sizes{3}));
}

TEST(FoldedSignal, TakesSparseOnesAlike) {
  const Signal sparse = Signal::sparse({2, 3}, {1, 4, 5}, {2, 20, 30});
  EXPECT_EQ(fold_signal(sparse.view(), {2, 3}, 3).values, (Floats{0, 22, 30}));
  EXPECT_EQ(fold_signal(sparse.view(), {2, 3}, 6).values, sparse.to_dense());
}

TEST(FoldedSignal, NeverHasMoreNumbersThanItMay) {
  for (std::size_t size = 1; size < 60; ++size) {
    for (std::size_t most = 1; most < 20; ++most) {
      const Floats values(size, 1.0F);
      const FoldedSignal folded = fold_signal(SignalView::dense(values), {size}, most);
      EXPECT_LE(folded.values.size(), most);
      float sum = 0.0F;
      for (const float value : folded.values) sum += value;
      EXPECT_EQ(sum, static_cast<float>(size));
    }
  }
}

TEST(FoldedSignal, CannotBeNothing) {
  EXPECT_THROW(fold_signal(SignalView::dense(Floats{1}), {1}, 0), InvalidArgument);
}

}  // namespace
}  // namespace somato::live
