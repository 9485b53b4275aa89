#include "base/tables/column_precision.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/numbers/number_source.h"
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

// With steps s apart near a number whose floats are g apart, rounding changes g / sqrt(12) in the
// mean: columns of n numbers 1 apart have the deviation n / sqrt(12), so that g / n is the share.
TEST(ColumnPrecision, NotesColumnsBetweenATwentiethAndAThousandth) {
  const auto notes = [](double first, double step, int count) {
    ColumnPrecision precision;
    for (int i = 0; i < count; ++i) {
      const double number = first + step * i;
      precision.take(0, number, static_cast<float>(number));
    }
    EXPECT_TRUE(precision.check({"a"}, ""));
    return precision.notes({"a"});
  };
  EXPECT_EQ(notes(1e6, 0.01, 200).size(), 1U);   // 0.0625 of 2
  EXPECT_EQ(notes(1e6, 0.01, 3000).size(), 1U);  // 0.0625 of 30
  EXPECT_TRUE(notes(1e6, 0.01, 12000).empty());  // 0.0625 of 120
  EXPECT_TRUE(notes(1e6, 0.0625, 50).empty());   // numbers that all have a float
  EXPECT_TRUE(notes(0.0, 0.01, 200).empty());
  EXPECT_NE(notes(1e6, 0.01, 200).front().find("column 1 ('a') is rounded"), std::string::npos);
  EXPECT_NE(notes(1e6, 0.01, 200).front().find("0.0625 apart"), std::string::npos);
}

// A hand at rest: 32-bit numbers near 90 are 7.6e-6 apart.
TEST(ColumnPrecision, MattersOnlyBesideADeviationThatIsKnown) {
  for (const double known : {0.0, 10.0}) {
    ColumnPrecision precision({{0.0, known}});
    for (const double number : {90.000001, 90.000002, 90.000004}) {
      precision.take(0, number, static_cast<float>(number));
    }
    EXPECT_EQ(precision.check({}, "").has_value(), known > 0.0);
  }
  ColumnPrecision one({{0.0, 1.0}});
  one.take(0, 1e8 + 3, static_cast<float>(1e8 + 3));  // 32-bit numbers there are 8 apart
  EXPECT_FALSE(one.check({}, ""));
}

TEST(ColumnPrecision, CountsZerosAsNumbers) {
  ColumnPrecision one_by_one;
  ColumnPrecision together;
  for (const double number : {3.0, 5.0, 10.0}) {
    one_by_one.take(0, number, static_cast<float>(number));
    together.take(0, number, static_cast<float>(number));
  }
  for (int i = 0; i < 4; ++i) one_by_one.take(0, 0.0, 0.0F);
  together.take_zeros(0, 4);
  together.take_zeros(0, 0);
  EXPECT_DOUBLE_EQ(together.deviations()[0], one_by_one.deviations()[0]);
}

TEST(ColumnPrecision, ContinuesWithItsStatistics) {
  ColumnPrecision all;
  ColumnPrecision first;
  for (int i = 0; i < 10; ++i) {
    const double number = 1700000000.0 + i;
    all.take(0, number, static_cast<float>(number));
    if (i < 4) first.take(0, number, static_cast<float>(number));
  }
  ColumnPrecision next = ColumnPrecision::with(first.statistics());
  for (int i = 4; i < 10; ++i) {
    const double number = 1700000000.0 + i;
    next.take(0, number, static_cast<float>(number));
  }
  EXPECT_EQ(next.statistics(), all.statistics());
  EXPECT_FALSE(next.check({}, ""));
}

// Seconds since 1970, in text with fractions that are multiples of 1/8.
TEST(ColumnPrecision, IsKeptOfNumbersWithoutTheirOffset) {
  std::string text = "t,v\n";
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < 20; ++i) {
    text += fmt::format("{:.3f},{}\n", 1700000000 + 0.125 * i, i);
    numbers.push_back(1700000000 + i);
  }
  CsvOptions options;
  options.columns.scales = {{1700000000.0, 0.0}, {0.0, 0.0}};
  const auto table = parse_csv(text, "ts.csv", options);
  ASSERT_TRUE(table) << to_string(table.error());
  options.columns.scales.pop_back();
  const auto source = numbers_in(encode_npy(numbers), "ts.npy", options);
  ASSERT_TRUE(source);
  const auto part = (*source)->next_part();
  ASSERT_TRUE(part) << to_string(part.error());
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(table->values(i, 0), 0.125F * static_cast<float>(i));
    EXPECT_EQ(table->values(i, 1), static_cast<float>(i));
    EXPECT_EQ((*part)->samples[i].values[0], static_cast<float>(i));
  }
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
