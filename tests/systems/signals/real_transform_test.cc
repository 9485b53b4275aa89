#include "systems/signals/real_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "systems/support/plain_transform.h"

namespace somato {
namespace {

std::vector<double> noise(Random& random, std::size_t length) {
  std::vector<double> values(length);
  for (double& value : values) value = random.normal();
  return values;
}

std::vector<double> squares_of(const std::vector<double>& values) {
  RealTransform transform(values.size());
  std::vector<double> squares(transform.bins());
  transform.squares(values, squares);
  return squares;
}

// Among the lengths are all up to 70, so primes, odd ones, and powers of 2, 3, 4, 5 and 7.
TEST(RealTransform, AgreesWithThePlainSum) {
  Random random(1);
  for (std::size_t length = 1; length <= 70; ++length) {
    const std::vector<double> values = noise(random, length);
    const std::vector<double> expected = testing::plain_squares(values);
    const std::vector<double> squares = squares_of(values);
    ASSERT_EQ(squares.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(squares[k], expected[k], 1e-11) << "length " << length << ", bin " << k;
    }
  }
}

TEST(RealTransform, AgreesWithThePlainSumForLongOnes) {
  Random random(2);
  for (const std::size_t length : {127U, 360U, 512U, 1001U, 1024U, 1018U}) {
    const std::vector<double> values = noise(random, length);
    const std::vector<double> expected = testing::plain_squares(values);
    const std::vector<double> squares = squares_of(values);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(squares[k], expected[k], 1e-8) << "length " << length << ", bin " << k;
    }
  }
}

TEST(RealTransform, GivesThe2049BinsOfThePaper) {
  EXPECT_EQ(RealTransform(4096).bins(), 2049U);
  EXPECT_EQ(RealTransform(5).bins(), 3U);
  EXPECT_EQ(RealTransform(1).bins(), 1U);
}

// Parseval: the sum of squares is the same on both sides, but for the length. A bin between the
// ends stands for two frequencies.
TEST(RealTransform, KeepsTheEnergy) {
  Random random(3);
  for (const std::size_t length : {4096U, 4095U, 1000U, 77U}) {
    const std::vector<double> values = noise(random, length);
    const std::vector<double> squares = squares_of(values);
    double energy = 0.0;
    for (const double value : values) energy += value * value;
    double found = 0.0;
    for (std::size_t k = 0; k < squares.size(); ++k) {
      const bool single = k == 0 || 2 * k == length;
      found += (single ? 1.0 : 2.0) * squares[k];
    }
    EXPECT_NEAR(found / static_cast<double>(length), energy, 1e-9 * energy);
  }
}

TEST(RealTransform, MayBeUsedAgainAndCopied) {
  Random random(4);
  RealTransform transform(77);
  const RealTransform copy = transform;
  std::vector<double> squares(transform.bins());
  transform.squares(noise(random, 77), squares);
  const std::vector<double> values = noise(random, 77);
  transform.squares(values, squares);
  EXPECT_EQ(squares, squares_of(values));
  RealTransform second = copy;
  second.squares(values, squares);
  EXPECT_EQ(squares, squares_of(values));
}

TEST(RealTransform, RefusesSizesThatDoNotFit) {
  EXPECT_THROW(RealTransform(0), InvalidArgument);
  RealTransform transform(8);
  std::vector<double> values(8);
  std::vector<double> squares(5);
  EXPECT_NO_THROW(transform.squares(values, squares));
  EXPECT_THROW(transform.squares(squares, squares), InvalidArgument);
  EXPECT_THROW(transform.squares(values, values), InvalidArgument);
}

}  // namespace
}  // namespace somato
