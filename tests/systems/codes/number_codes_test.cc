#include "somato/codes/number_codes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr auto kBinary = NumberCodeKind::kBinary;
constexpr auto kGray = NumberCodeKind::kGray;
constexpr auto kThermometer = NumberCodeKind::kThermometer;

NumberCode code_of(NumberCodeKind kind, std::size_t bits, double low, double high,
                   OutsideRange outside = OutsideRange::kRefuse) {
  return NumberCode({kind, low, high, bits, outside});
}

std::vector<float> elements_of(const NumberCode& code, float value) {
  return code.encode(value).value().to_dense();
}

int differences(const std::vector<float>& a, const std::vector<float>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return count;
}

using Elements = std::vector<float>;

TEST(NumberCode, WritesBinaryDigitsMostSignificantFirst) {
  const NumberCode code = code_of(kBinary, 3, 0.0, 8.0);
  EXPECT_EQ(elements_of(code, 0.0F), (Elements{0, 0, 0}));
  EXPECT_EQ(elements_of(code, 1.5F), (Elements{0, 0, 1}));
  EXPECT_EQ(elements_of(code, 6.0F), (Elements{1, 1, 0}));
  EXPECT_EQ(elements_of(code, 8.0F), (Elements{1, 1, 1}));
}

TEST(NumberCode, WritesTheReflectedGrayCode) {
  const NumberCode code = code_of(kGray, 3, 0.0, 8.0);
  const std::vector<Elements> expected{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0},
                                       {1, 1, 0}, {1, 1, 1}, {1, 0, 1}, {1, 0, 0}};
  for (std::size_t level = 0; level < 8; ++level) {
    EXPECT_EQ(elements_of(code, static_cast<float>(level)), expected[level]) << level;
  }
}

TEST(NumberCode, FillsAThermometerFromTheFirstElement) {
  const NumberCode code = code_of(kThermometer, 3, 0.0, 8.0);  // four levels of 2
  EXPECT_EQ(elements_of(code, 1.9F), (Elements{0, 0, 0}));
  EXPECT_EQ(elements_of(code, 2.0F), (Elements{1, 0, 0}));
  EXPECT_EQ(elements_of(code, 5.0F), (Elements{1, 1, 0}));
  EXPECT_EQ(elements_of(code, 8.0F), (Elements{1, 1, 1}));
}

TEST(NumberCode, HasAsManyLevelsAsItsKindAllows) {
  EXPECT_EQ(code_of(kBinary, 18, 0.0, 1.0).levels(), 262144U);
  EXPECT_EQ(code_of(kGray, 24, 0.0, 1.0).levels(), 16777216U);
  EXPECT_EQ(code_of(kThermometer, 18, 0.0, 1.0).levels(), 19U);
}

// Levels of width 1, so that a level's middle is half above its number.
TEST(NumberCode, DecodesToItsLevel) {
  const NumberCode code = code_of(kBinary, 10, 0.0, 1024.0);
  for (std::uint32_t level = 0; level < 1024; ++level) {
    const Elements digits = elements_of(code, static_cast<float>(level) + 0.5F);
    std::uint32_t decoded = 0;
    for (const float digit : digits) decoded = 2 * decoded + static_cast<std::uint32_t>(digit);
    EXPECT_EQ(decoded, level);
  }
}

TEST(NumberCode, GivesNeighboursOneGrayBitOfDifference) {
  const NumberCode code = code_of(kGray, 10, 0.0, 1024.0);
  for (int level = 0; level < 1023; ++level) {
    const auto value = static_cast<float>(level);
    EXPECT_EQ(differences(elements_of(code, value), elements_of(code, value + 1.0F)), 1) << level;
  }
}

TEST(NumberCode, GivesAThermometerAsManyDifferencesAsLevelsBetween) {
  const NumberCode code = code_of(kThermometer, 20, 0.0, 21.0);
  for (int a = 0; a <= 20; ++a) {
    for (int b = 0; b <= 20; ++b) {
      EXPECT_EQ(differences(elements_of(code, static_cast<float>(a)),
                            elements_of(code, static_cast<float>(b))),
                std::abs(a - b));
    }
  }
}

TEST(NumberCode, PutsValuesWhereAOneHotCodeDoes) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double low = 10.0 * random.normal();
    const double high = low + 5.0 * random.uniform() + 0.01;
    const std::size_t bits = 1 + random.below(10);
    const NumberCode digits = code_of(kGray, bits, low, high, OutsideRange::kClamp);
    const NumberCode thermometer = code_of(kThermometer, bits, low, high, OutsideRange::kClamp);
    const OneHot bins({low, high, digits.levels(), OutsideRange::kClamp});
    const OneHot few({low, high, thermometer.levels(), OutsideRange::kClamp});
    const double spread = 1.4 * random.uniform() - 0.2;
    const auto value = static_cast<float>(low + spread * (high - low));
    EXPECT_EQ(digits.level(value).value(), bins.bin(value).value());
    EXPECT_EQ(thermometer.level(value).value(), few.bin(value).value());
  }
}

// 0.1 and 0.7 have no exact binary form.
TEST(NumberCode, TakesDecimalEdgesAsTheyAreWritten) {
  const NumberCode tenths = code_of(kThermometer, 9, 0.0, 1.0);
  const float edges[] = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F, 0.9F};
  for (std::uint32_t level = 1; level < 10; ++level) {
    EXPECT_EQ(tenths.level(edges[level]), level);
    EXPECT_EQ(tenths.level(std::nextafter(edges[level], 0.0F)), level - 1);
  }
  EXPECT_EQ(code_of(kBinary, 4, 0.0, 0.1).level(0.1F), 15U);  // a float 0.1 is above 0.1
  EXPECT_EQ(code_of(kBinary, 4, 0.7, 1.0).level(0.7F), 0U);   // a float 0.7 is below 0.7
}

// Between 2^23 and 2^24 single precision holds every whole number and no other.
TEST(NumberCode, DistinguishesValuesInSinglePrecision) {
  const NumberCode code = code_of(kBinary, 24, 0.0, 16777216.0);
  for (const std::uint32_t level : {0U, 1U, 8388607U, 8388608U, 16777214U, 16777215U}) {
    EXPECT_EQ(code.level(static_cast<float>(level)), level);
  }
  EXPECT_EQ(code.level(16777216.0F), 16777215U);
}

// The range holds a single number between its ends, so only three of 2^24 levels can occur.
TEST(NumberCode, StaysMonotoneWhereSinglePrecisionIsCoarserThanALevel) {
  const NumberCode code = code_of(kBinary, 24, 16777212.0, 16777214.0);
  EXPECT_LT(code.level(16777212.0F).value(), code.level(16777213.0F).value());
  EXPECT_LT(code.level(16777213.0F).value(), code.level(16777214.0F).value());
  EXPECT_EQ(code.level(16777214.0F), 16777215U);
}

TEST(NumberCode, RefusesAValueOutsideWithItsRange) {
  const NumberCode code = code_of(kGray, 4, -5.0, 90.0);
  const auto above = code.encode(91.5F);
  ASSERT_FALSE(above);
  EXPECT_EQ(above.error().kind, ErrorKind::kData);
  EXPECT_EQ(above.error().what, "the value 91.5 is outside the range -5 to 90 of its gray code");
  EXPECT_FALSE(code.level(-5.01F));
  EXPECT_FALSE(code.level(-std::numeric_limits<float>::infinity()));
}

TEST(NumberCode, ClampsOnRequestButRefusesNaN) {
  const NumberCode code = code_of(kBinary, 4, 0.0, 1.0, OutsideRange::kClamp);
  EXPECT_EQ(code.level(-0.1F), 0U);
  EXPECT_EQ(code.level(std::numeric_limits<float>::infinity()), 15U);
  const auto level = code.level(std::nanf(""));
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().what, "the value to be encoded is not a number");
}

TEST(NumberCode, RefusesParametersThatDoNotFit) {
  EXPECT_THROW(code_of(kBinary, 0, 0.0, 1.0), InvalidArgument);
  EXPECT_THROW(code_of(kBinary, 25, 0.0, 1.0), InvalidArgument);
  EXPECT_NO_THROW(code_of(kThermometer, 25, 0.0, 1.0));
  EXPECT_THROW(code_of(kThermometer, (std::size_t{1} << 20) + 1, 0.0, 1.0), InvalidArgument);
  EXPECT_THROW(code_of(kBinary, 4, 1.0, 1.0), InvalidArgument);
  EXPECT_THROW(code_of(kBinary, 4, 0.0, 1e39), InvalidArgument);
  EXPECT_THROW(code_of(kBinary, 4, std::nan(""), 1.0), InvalidArgument);
  const Result<void> valid = NumberCodeParameters{kGray, 0.0, 1.0, 25}.validate();
  ASSERT_FALSE(valid);
  EXPECT_EQ(valid.error().what, "a gray code has 1 to 24 bits, not 25");
}

TEST(NumberCodeParameters, AreReadByTheirNames) {
  const Table table{"",
                    {{"code", "", Value{std::string("thermometer")}},
                     {"low", "", Value{-1.5}},
                     {"high", "", Value{2.5}},
                     {"bits", "", Value{std::int64_t{7}}},
                     {"outside", "", Value{std::string("clamp")}}}};
  const auto parameters = read_parameters<NumberCodeParameters>(table);
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->code, kThermometer);
  EXPECT_EQ(parameters->low, -1.5);
  EXPECT_EQ(parameters->high, 2.5);
  EXPECT_EQ(parameters->bits, 7U);
  EXPECT_EQ(parameters->outside, OutsideRange::kClamp);
  EXPECT_EQ(NumberCodeParameters{}.bits, 18U);
}

}  // namespace
}  // namespace somato
