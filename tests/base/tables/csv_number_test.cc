#include "base/tables/csv_number.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

CsvMeaning meaning_of(const char* field) {
  return read_csv_number<double>(field).meaning;
}

TEST(CsvNumber, ClassifiesAField) {
  for (const char* field : {"1", "-1.5", "+2", "1e5", ".5", "0"}) {
    EXPECT_EQ(meaning_of(field), CsvMeaning::kNumber) << field;
  }
  for (const char* field : {"", "NA", "n/a", "None", "NULL", "?", "-", "nan", "-NaN", "+nan"}) {
    EXPECT_EQ(meaning_of(field), CsvMeaning::kMissing) << field;
  }
  for (const char* field : {"inf", "-Infinity", "+INF"}) {
    EXPECT_EQ(meaning_of(field), CsvMeaning::kInfinite) << field;
  }
  for (const char* field : {"a", "1,5", "1.5x", "+-1", "0x10", "--1"}) {
    EXPECT_EQ(meaning_of(field), CsvMeaning::kText) << field;
  }
}

TEST(CsvNumber, KnowsTheRangeOfItsType) {
  EXPECT_EQ(read_csv_number<float>("1e39").meaning, CsvMeaning::kTooLarge);
  EXPECT_EQ(read_csv_number<double>("1e39").number, 1e39);
  EXPECT_EQ(read_csv_number<double>("1e309").meaning, CsvMeaning::kTooLarge);
  EXPECT_EQ(read_csv_number<float>("1e-60").meaning, CsvMeaning::kNumber);
  EXPECT_EQ(read_csv_number<float>("1e-60").number, 0.0F);
}

}  // namespace
}  // namespace somato
