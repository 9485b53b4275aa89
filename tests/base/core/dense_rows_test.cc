#include "base/core/dense_rows.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(DenseRows, AreTheValuesOfDenseAndSparseSamples) {
  const Matrix<float> expected(2, 3, {0, 2, 0, 4, 1, 6});
  EXPECT_EQ(dense_rows(Samples(expected)), expected);
  const Samples sparse =
      Samples::from_signals({Signal::sparse({3}, {1}, {2}), Signal::sparse({3}, {0, 2}, {4, 6})});
  EXPECT_EQ(dense_rows(sparse), Matrix<float>(2, 3, {0, 2, 0, 4, 0, 6}));
  EXPECT_EQ(dense_rows(Samples()).rows(), 0U);
}

}  // namespace
}  // namespace somato
