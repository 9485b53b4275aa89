#include "base/core/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/random.h"

namespace somato {
namespace {

// Distance from the exact value (the mathematics library's long double) in units in the last place.
double error_in_ulps(double value, long double exact) {
  const double rounded = static_cast<double>(exact);
  const double ulp = std::nextafter(std::fabs(rounded), HUGE_VAL) - std::fabs(rounded);
  return static_cast<double>(std::fabs(static_cast<long double>(value) - exact) /
                             static_cast<long double>(ulp));
}

TEST(Exponential, IsWithinTwoUlpsOfTheLongDoubleValue) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double x = -708.0 + 1417.0 * random.uniform();
    EXPECT_LT(error_in_ulps(exponential(x), std::exp(static_cast<long double>(x))), 2.0) << x;
  }
}

TEST(Exponential, HasItsLimits) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-1e9), 0.0);
  EXPECT_EQ(exponential(1e9), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
}

TEST(NaturalLog, IsWithinTwoUlpsOfTheLongDoubleValue) {
  Random random(2);
  for (int i = 0; i < 100000; ++i) {
    const int exponent = static_cast<int>(random.below(2000)) - 1000;
    const double wide = std::ldexp(0.5 + random.uniform(), exponent);
    EXPECT_LT(error_in_ulps(natural_log(wide), std::log(static_cast<long double>(wide))), 2.0)
        << wide;
    const double near_one = 0.5 + random.uniform();
    EXPECT_LT(error_in_ulps(natural_log(near_one), std::log(static_cast<long double>(near_one))),
              2.0)
        << near_one;
  }
}

TEST(NaturalLog, HasItsLimits) {
  EXPECT_EQ(natural_log(1.0), 0.0);
  EXPECT_EQ(natural_log(0.0), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(natural_log(-1.0)));
  EXPECT_LT(error_in_ulps(natural_log(4e-320), std::log(static_cast<long double>(4e-320))), 2.0);
}

TEST(Power, AgreesWithRepeatedMultiplication) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double base = 2.0 * random.uniform();
    double product = 1.0;
    for (int k = 0; k < 10; ++k) product *= base;
    EXPECT_NEAR(power(base, 10.0), product, 1e-12 * product);
  }
  EXPECT_EQ(power(0.0, 10.0), 0.0);
  EXPECT_EQ(power(0.0, 0.0), 1.0);
}

TEST(CosineOfTurns, IsWithinItsErrorOfTheLongDoubleValue) {
  const long double two_pi = 2.0L * std::acos(-1.0L);
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const double turns = 8.0 * random.uniform() - 4.0;
    const long double exact = std::cos(two_pi * static_cast<long double>(turns));
    EXPECT_LT(std::fabs(static_cast<long double>(cosine_of_turns(turns)) - exact), 0x1p-52L)
        << turns;
  }
}

TEST(CosineOfTurns, IsExactAtEveryQuarter) {
  for (int turn = -3; turn <= 3; ++turn) {
    EXPECT_EQ(cosine_of_turns(turn), 1.0);
    EXPECT_EQ(cosine_of_turns(turn + 0.25), 0.0);
    EXPECT_EQ(cosine_of_turns(turn + 0.5), -1.0);
    EXPECT_EQ(cosine_of_turns(turn + 0.75), 0.0);
  }
  EXPECT_EQ(cosine_of_turns(1e300), 1.0);
}

TEST(CosineOfTurns, HasNoValueAtInfinity) {
  EXPECT_TRUE(std::isnan(cosine_of_turns(std::nan(""))));
  EXPECT_TRUE(std::isnan(cosine_of_turns(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace somato
