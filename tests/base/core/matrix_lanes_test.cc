#include "somato/core/matrix.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace somato {
namespace {

TEST(LaneMatrix, KeepsRowsAndFillsTheLastBlockWithZeros) {
  Matrix<float> matrix(17, 3);
  for (std::size_t i = 0; i < matrix.values().size(); ++i) {
    matrix.values()[i] = static_cast<float>(i + 1);
  }
  const LaneMatrix<float> lanes(matrix);
  EXPECT_EQ(lanes.padded_rows(), 32U);
  EXPECT_EQ(lanes.to_matrix(), matrix);
  EXPECT_EQ(lanes(16, 2), 51.0F);
  // Block 1, column 0: row 16 in its first lane, the rest filling.
  const float* block = lanes.data() + 16 * 3;
  EXPECT_EQ(block[0], 49.0F);
  for (int lane = 1; lane < 16; ++lane) EXPECT_EQ(block[lane], 0.0F);
}

TEST(LaneMatrix, PutsTheLanesOfOneColumnSideBySide) {
  LaneMatrix<double> lanes(8, 2);
  for (std::size_t row = 0; row < 8; ++row) lanes(row, 1) = static_cast<double>(row);
  for (std::size_t row = 0; row < 8; ++row) EXPECT_EQ(lanes.data()[8 + row], double(row));
}

TEST(LaneMatrix, StartsOnACacheLine) {
  for (const std::size_t rows : {1U, 5U, 100U, 300000U}) {  // the last on large pages
    const LaneMatrix<float> lanes(rows, 7);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lanes.data()) % 64, 0U);
  }
}

}  // namespace
}  // namespace somato
