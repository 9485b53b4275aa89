#include "somato/core/check.h"

#include <gtest/gtest.h>

#include <string>

namespace somato {
namespace {

TEST(Require, ThrowsItsMessageUnlessTheConditionHolds) {
  EXPECT_NO_THROW(require(true, "never seen"));
  try {
    require(false, std::string("rows must be ") + "at least 1");
    FAIL() << "nothing was thrown";
  } catch (const InvalidArgument& mistake) {
    EXPECT_STREQ(mistake.what(), "rows must be at least 1");
  }
}

TEST(Require, IsCaughtAsTheStandardException) {
  EXPECT_THROW(require(false, "a mistake"), std::invalid_argument);
}

TEST(AssertDeathTest, EndsTheProgramWithConditionAndPlace) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const int winner = 7;
  SOMATO_ASSERT(winner == 7);
  EXPECT_DEATH(SOMATO_ASSERT(winner < 5), "'winner < 5' does not hold at .*check_test\\.cc:[0-9]+");
}

}  // namespace
}  // namespace somato
