#include "somato/core/matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace somato {
namespace {

TEST(Matrix, KeepsItsValuesRowAfterRow) {
  const Matrix<int> matrix(2, 3, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(matrix.rows(), 2U);
  EXPECT_EQ(matrix.columns(), 3U);
  EXPECT_EQ(matrix(0, 2), 3);
  EXPECT_EQ(matrix(1, 0), 4);
  EXPECT_TRUE(std::ranges::equal(matrix.row(1), std::vector<int>{4, 5, 6}));
}

TEST(Matrix, IsWrittenThroughElementsAndRows) {
  Matrix<int> matrix(2, 2, 7);
  matrix(0, 1) = 1;
  matrix.row(1)[0] = 2;
  EXPECT_EQ(matrix, Matrix<int>(2, 2, {7, 1, 2, 7}));
}

TEST(Matrix, DiffersByShapeAsWellAsByValue) {
  EXPECT_NE(Matrix<int>(2, 3, 0), Matrix<int>(3, 2, 0));
  EXPECT_NE(Matrix<int>(2, 3, 0), Matrix<int>(2, 3, 1));
}

TEST(Matrix, RefusesValuesThatDoNotFill) {
  EXPECT_THROW(Matrix<int>(2, 3, std::vector<int>(5)), InvalidArgument);
  EXPECT_THROW(Matrix<int>(2, 3, std::vector<int>(7)), InvalidArgument);
}

TEST(Matrix, MayBeEmpty) {
  EXPECT_TRUE(Matrix<float>().empty());
  EXPECT_TRUE(Matrix<float>(0, 5).empty());
  EXPECT_EQ((Matrix<float>(0, 5).columns()), 5U);
}

TEST(Matrix, GrowsByRows) {
  Matrix<int> matrix(0, 2);
  matrix.append(Matrix<int>(1, 2, {1, 2}));
  matrix.append(Matrix<int>(2, 2, {3, 4, 5, 6}));
  EXPECT_EQ(matrix, (Matrix<int>(3, 2, {1, 2, 3, 4, 5, 6})));
  EXPECT_THROW(matrix.append(Matrix<int>(1, 3)), InvalidArgument);
}

}  // namespace
}  // namespace somato
