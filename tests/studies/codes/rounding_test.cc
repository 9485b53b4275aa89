#include "studies/codes/rounding.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato {
namespace {

TEST(Rounding, KeepsFourDigitsTowardsZero) {
  EXPECT_EQ(rounded(1.23456), 1.234);
  EXPECT_EQ(rounded(-1.23456), -1.234);
  EXPECT_EQ(rounded(4.99999), 4.999);
  EXPECT_EQ(rounded(123456.0), 123400.0);
  EXPECT_EQ(rounded(0.00098765), 0.0009876);
  EXPECT_EQ(rounded(5.0), 5.0);
  EXPECT_EQ(rounded(0.0), 0.0);
  EXPECT_EQ(rounded(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
}

TEST(Rounding, WritesAFloatWithTheFewestDigits) {
  EXPECT_EQ(plain(0.1F), 0.1);
  EXPECT_EQ(plain(-75.0F), -75.0);
  EXPECT_EQ(static_cast<float>(plain(std::numeric_limits<float>::min())),
            std::numeric_limits<float>::min());
}

}  // namespace
}  // namespace somato
