#include "base/numbers/known_values.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace somato {
namespace {

constexpr float kUnknownValue = std::numeric_limits<float>::quiet_NaN();

Samples samples(std::size_t rows, std::vector<float> values) {
  const std::size_t columns = values.size() / rows;
  return Samples(Matrix<float>(rows, columns, std::move(values)));
}

// By hand: 1, 4, 7 and 2, 3; one value is missing in the second row, two in the third.
TEST(KnownValues, AreCountedAndMeasuredByColumn) {
  KnownValues known;
  ASSERT_TRUE(known.take(samples(2, {1, 2, 9, 4, kUnknownValue, 9})));
  ASSERT_TRUE(known.take(samples(1, {kUnknownValue, 3, kUnknownValue})));
  EXPECT_EQ(known.samples(), 3U);
  EXPECT_EQ(known.missing(), 3U);
  EXPECT_EQ(known.incomplete(), 2U);
  EXPECT_EQ(known.means({}).value(), (std::vector<double>{2.5, 2.5, 9}));
  EXPECT_EQ(known.low(), (std::vector<float>{1, 2, 9}));
  EXPECT_EQ(known.high(), (std::vector<float>{4, 3, 9}));
}

TEST(KnownValues, RefuseRowsAndColumnsOfWhichNothingIsKnown) {
  KnownValues known;
  ASSERT_TRUE(known.take(samples(1, {kUnknownValue, 3})));
  EXPECT_EQ(known.take(samples(2, {kUnknownValue, 1, kUnknownValue, kUnknownValue})).error().what,
            "row 3 has no known value");
  KnownValues columns;
  ASSERT_TRUE(columns.take(samples(2, {kUnknownValue, 3, kUnknownValue, 4})));
  EXPECT_EQ(columns.means({}).error().what, "column 1 has no known value");
  EXPECT_EQ(columns.means({"x", "y"}).error().what, "column 1 ('x') has no known value");
}

TEST(KnownValues, TakeRowsAsWellAsParts) {
  KnownValues rows;
  for (const std::vector<float>& row : {std::vector<float>{1, kUnknownValue}, {3, 4}}) {
    ASSERT_TRUE(rows.take(row));
  }
  EXPECT_EQ(rows.means({}).value(), (std::vector<double>{2, 4}));
  EXPECT_EQ(rows.take(std::vector<float>(2, kUnknownValue)).error().what,
            "row 3 has no known value");
}

}  // namespace
}  // namespace somato
