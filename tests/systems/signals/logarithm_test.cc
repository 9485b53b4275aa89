#include "systems/signals/logarithm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/random.h"

namespace somato {
namespace {

TEST(SignedLogarithm, AgreesWithTheMathematicsLibrary) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double x = 2000.0 * random.uniform() - 1000.0;
    const double unit = 0.01 + 3.0 * random.uniform();
    const double exact = std::log1p(std::fabs(x) / unit);
    EXPECT_NEAR(signed_logarithm(x, unit), x < 0.0 ? -exact : exact, 1e-14) << x << " " << unit;
  }
}

TEST(SignedLogarithm, HasValuesThatWereDerivedByHand) {
  EXPECT_EQ(signed_logarithm(0.0, 0.3), 0.0);
  EXPECT_NEAR(signed_logarithm(3.0, 1.0), std::log(4.0), 1e-15);
  EXPECT_NEAR(signed_logarithm(-3.5, 0.5), -std::log(8.0), 1e-15);
  EXPECT_NEAR(signed_logarithm(1e-6, 1.0), 1e-6, 1e-12);
}

TEST(SignedLogarithm, IsInverted) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double x = 500.0 * random.uniform() - 250.0;
    EXPECT_NEAR(inverse_signed_logarithm(signed_logarithm(x, 0.3), 0.3), x, 1e-11);
  }
  EXPECT_EQ(inverse_signed_logarithm(0.0, 0.3), 0.0);
}

}  // namespace
}  // namespace somato
