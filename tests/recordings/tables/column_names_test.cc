#include "recordings/tables/column_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace somato {
namespace {

using Names = std::vector<std::string>;

TEST(FitsColumnPattern, TakesAStarForAnyText) {
  for (const char* name : {"tax_", "tax_1", "tax_a_b", "tax_*"}) {
    EXPECT_TRUE(fits_column_pattern("tax_*", name)) << name;
  }
  for (const char* name : {"", "tax", "Tax_1", " tax_1", "atax_1"}) {
    EXPECT_FALSE(fits_column_pattern("tax_*", name)) << name;
  }
  EXPECT_TRUE(fits_column_pattern("*", ""));
  EXPECT_TRUE(fits_column_pattern("acc_*_mean", "acc_x_mean"));
  EXPECT_FALSE(fits_column_pattern("acc_*_mean", "acc_mean"));
  EXPECT_FALSE(fits_column_pattern("acc_*_mean", "acc_x_mean2"));
  EXPECT_TRUE(fits_column_pattern("x.y", "x.y"));
  EXPECT_FALSE(fits_column_pattern("x.y", "xay"));
}

// Every text of up to `most` of the letters.
std::vector<std::string> texts(const std::string& letters, std::size_t most) {
  std::vector<std::string> all{""};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].size() == most) continue;
    for (const char letter : letters) all.push_back(all[i] + letter);
  }
  return all;
}

// By trying every text for the first star.
bool fits_slowly(const std::string& pattern, const std::string& name) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*') {
    return !name.empty() && name[0] == pattern[0] && fits_slowly(pattern.substr(1), name.substr(1));
  }
  for (std::size_t taken = 0; taken <= name.size(); ++taken) {
    if (fits_slowly(pattern.substr(1), name.substr(taken))) return true;
  }
  return false;
}

TEST(FitsColumnPattern, FitsWhatTryingEveryTextFits) {
  for (const std::string& pattern : texts("ab*", 5)) {
    for (const std::string& name : texts("ab", 5)) {
      ASSERT_EQ(fits_column_pattern(pattern, name), fits_slowly(pattern, name))
          << pattern << " and " << name;
    }
  }
}

TEST(IsColumnPattern, LooksForAStarOrARange) {
  EXPECT_TRUE(is_column_pattern("a*"));
  EXPECT_TRUE(is_column_pattern("thumb..pinky"));
  EXPECT_FALSE(is_column_pattern("thumb"));
  EXPECT_TRUE(is_column_range("a..b"));
  EXPECT_FALSE(is_column_range("a..b*"));
}

// The names of the columns, or the error.
Names in_range(const std::string& range, const Names& header) {
  const auto places =
      columns_in_range(range, header, [&](const std::string& name) -> Result<std::size_t> {
        const auto found = std::find(header.begin(), header.end(), name);
        if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
        return fail(ErrorKind::kData, "there is no column '" + name + "'");
      });
  if (!places) return {places.error().what};
  Names names;
  for (const std::size_t place : *places) names.push_back(header[place]);
  return names;
}

TEST(ColumnsInRange, AreThoseBetweenTheTwoNames) {
  const Names header{"time", "thumb", "index_tip", "ring", "pinky", "label"};
  EXPECT_EQ(in_range("thumb..pinky", header), (Names{"thumb", "index_tip", "ring", "pinky"}));
  EXPECT_EQ(in_range("ring..ring", header), Names{"ring"});
  EXPECT_EQ(in_range("pinky..thumb", header), Names{"'pinky..thumb' is not a range of columns"});
  EXPECT_EQ(in_range("thumb..pinkie", header), Names{"there is no column 'pinkie'"});
  EXPECT_EQ(in_range("thmb..pinky", header), Names{"there is no column 'thmb'"});
}

TEST(ColumnsInRange, TwoDigitsAreARowAndAColumnIfThereAreNoOthers) {
  Names pad;
  for (const char row : {'0', '1', '2'}) {
    for (const char column : {'1', '0'}) pad.push_back(std::string("t") + row + column);
  }
  EXPECT_EQ(in_range("t00..t21", pad), (Names{"t00", "t01", "t10", "t11", "t20", "t21"}));
  EXPECT_EQ(in_range("t10..t21", pad), (Names{"t10", "t11", "t20", "t21"}));
  // A column that is missing among numbers is not taken for the end of a row.
  pad.push_back("t12");
  EXPECT_EQ(in_range("t00..t21", pad), Names{"there is no column 't02'"});
  Names all;
  for (int i = 0; i < 35; ++i)
    all.push_back("t" + std::string(i < 10 ? "0" : "") + std::to_string(i));
  EXPECT_EQ(in_range("t00..t33", all).size(), 34U);
  EXPECT_EQ(in_range("t21..t00", pad), Names{"'t21..t00' is not a range of columns"});
}

TEST(ExpandColumns, CountsRangesUp) {
  EXPECT_EQ(expand_columns({"a", "b1..b3", "c"}), (Names{"a", "b1", "b2", "b3", "c"}));
  EXPECT_EQ(expand_columns({"b8..b11"}), (Names{"b8", "b9", "b10", "b11"}));
  EXPECT_EQ(expand_columns({"b08..b11"}), (Names{"b08", "b09", "b10", "b11"}));
  EXPECT_EQ(expand_columns({"2..4"}), (Names{"2", "3", "4"}));
  EXPECT_EQ(expand_columns({"x1y7..x1y7"}), (Names{"x1y7"}));
  EXPECT_EQ(expand_columns({"a*", "*..*"}), (Names{"a*", "*..*"}));
  EXPECT_EQ(expand_columns({"thumb..pinky", "t00..t33"}), (Names{"thumb..pinky", "t00..t33"}));
  EXPECT_EQ(expand_columns({}), Names{});
}

TEST(ExpandColumns, RefusesWhatIsNoRange) {
  for (const char* range : {"..", "a1..", "..a1", "a2..a1", "a1..a2..a3"}) {
    const auto columns = expand_columns({range});
    ASSERT_FALSE(columns) << range;
    EXPECT_EQ(columns.error().what, "'" + std::string(range) + "' is not a range of columns");
  }
  EXPECT_EQ(expand_columns({"a1..a100000"})->size(), 100000U);
  EXPECT_EQ(expand_columns({"a0..a100000"}).error().what,
            "'a0..a100000' gives more than 100000 columns");
  EXPECT_EQ(expand_columns({"a1..a100000", "b1..b2"}).error().what,
            "'b1..b2' gives more than 100000 columns");
}

}  // namespace
}  // namespace somato
