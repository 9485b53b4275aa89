#include "base/tables/column_precision.h"

#include <gtest/gtest.h>

#include "somato/files/csv.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

// The error for a column of `count` numbers that begin at `first`, `step` apart, as they stand in
// the file.
std::string precision_error(double first, double step, int count) {
  ColumnPrecision precision;
  for (int i = 0; i < count; ++i) {
    const double number = first + step * i;
    precision.take(1, number, static_cast<float>(number));
  }
  const auto kept = precision.check({"a", "t"}, "a.csv");
  return kept ? "" : to_string(kept.error());
}

TEST(ColumnPrecision, OfTimesSince1970IsLost) {
  const std::string error = precision_error(1700000000, 1, 100);
  EXPECT_NE(error.find("a.csv: column 2 ('t') loses precision"), std::string::npos) << error;
  EXPECT_NE(error.find("128 apart"), std::string::npos) << error;
  EXPECT_NE(error.find("standard deviation is 28.8"), std::string::npos) << error;
  EXPECT_NE(error.find("subtract an offset"), std::string::npos) << error;
  EXPECT_NE(precision_error(1e16, 2, 3), "");
}

TEST(ColumnPrecision, IsKeptWhereRoundingIsSmallBesideTheColumn) {
  EXPECT_EQ(precision_error(0, 1, 100), "");
  EXPECT_EQ(precision_error(16777000, 1, 200), "");  // whole numbers that all have a float
  EXPECT_EQ(precision_error(1700000000, 1, 10000), "");
  EXPECT_EQ(precision_error(0.1, 1e-6, 100), "");
  EXPECT_EQ(precision_error(1700000000.5, 0, 100), "");  // nothing differs that could be lost
}

// With steps of 128 and a deviation s, rounding changes by 128 / sqrt(12) in the mean: s = 739 is
// the border, and n numbers 1 apart have the deviation n / sqrt(12).
TEST(ColumnPrecision, IsLostBelowTwentyTimesWhatRoundingChanges) {
  EXPECT_NE(precision_error(1700000000, 1, 2300), "");
  EXPECT_EQ(precision_error(1700000000, 1, 2800), "");
}

TEST(ColumnPrecision, IsLookedAtInTextAndInNpy) {
  std::string text = "t,v\n";
  std::vector<std::int64_t> whole;
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(1700000000 + i) + "," + std::to_string(i % 7) + "\n";
    whole.push_back(1700000000 + i);
  }
  const auto table = parse_csv(text, "ts.csv", {});
  ASSERT_FALSE(table);
  EXPECT_NE(table.error().what.find("column 1 ('t') loses precision"), std::string::npos);
  const auto matrix = decode_npy(encode_npy(whole), "ts.npy");
  ASSERT_FALSE(matrix);
  EXPECT_NE(matrix.error().what.find("loses precision"), std::string::npos);
}

}  // namespace
}  // namespace somato
