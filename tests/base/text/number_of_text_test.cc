#include "base/text/number_of_text.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace somato {
namespace {

TEST(NumberOfText, IsTheWholeText) {
  EXPECT_EQ(number_of_text<std::size_t>("0"), 0U);
  EXPECT_EQ(number_of_text<std::size_t>("0042"), 42U);
  EXPECT_EQ(number_of_text<std::int64_t>("-7"), -7);
  EXPECT_EQ(number_of_text<double>("1.5e3"), 1500.0);
  EXPECT_EQ(number_of_text<std::uint64_t>("18446744073709551615"), UINT64_MAX);
}

TEST(NumberOfText, IsNothingForOtherTexts) {
  for (const char* text : {"", " 1", "1 ", "+1", "-1", "1.5", "1x", "x", "18446744073709551616"}) {
    EXPECT_FALSE(number_of_text<std::uint64_t>(text)) << text;
  }
  EXPECT_FALSE(number_of_text<double>("1e999"));
  EXPECT_FALSE(number_of_text<int>("3000000000"));
}

}  // namespace
}  // namespace somato
