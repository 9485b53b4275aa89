#include "recording/column_names.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace somato {
namespace {

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

TEST(IsColumnPattern, LooksForAStar) {
  EXPECT_TRUE(is_column_pattern("a*"));
  EXPECT_FALSE(is_column_pattern("a1..a2"));
}

}  // namespace
}  // namespace somato
