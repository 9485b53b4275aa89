#include "bodies/sensors/exact_values.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "somato/core/random.h"

namespace somato::detail {
namespace {

double through_parts(double value) {
  const auto parts = parts_of(value);
  return whole_of(parts[0], parts[1], parts[2]);
}

TEST(ExactValues, ThreeFloatsHoldANumberInDoublePrecision) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double mantissa = random.normal();
    const double value = std::ldexp(mantissa, static_cast<int>(random.below(60)) - 40);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(through_parts(value)),
              std::bit_cast<std::uint64_t>(value));
  }
  for (const double value :
       {0.0, 1.0 / 3.0, 1e9 + 1e-6, -std::nextafter(1.0, 0.0), std::nextafter(16777217.0, 0.0)}) {
    EXPECT_EQ(through_parts(value), value);
  }
}

TEST(ExactValues, TheFirstPartIsTheNumberRounded) {
  EXPECT_EQ(parts_of(0.1)[0], 0.1F);
  EXPECT_EQ(parts_of(2.5), (std::array{2.5F, 0.0F, 0.0F}));
}

TEST(ExactValues, AChannelNamesTheValuesBeforeTheirParts) {
  Channel channel = exact_channel("true_angles", "deg", {"a", "b"});
  EXPECT_EQ(channel.element_names,
            (std::vector<std::string>{"a", "b", "a_rest", "b_rest", "a_rest_2", "b_rest_2"}));
  add_exact(channel, std::array{0.1, -1.0 / 3.0});
  add_exact(channel, std::array{7.0, 1e-9});
  EXPECT_EQ(channel.frames(0, 0), 0.1F);
  EXPECT_EQ(exact_row(channel, 0), (std::vector<double>{0.1, -1.0 / 3.0}));
  EXPECT_EQ(exact_row(channel, 1), (std::vector<double>{7.0, 1e-9}));
  EXPECT_TRUE(is_true_channel(channel));
}

TEST(ExactValues, DamagedChannelsAreRefused) {
  Channel channel = exact_channel("true_angles", "deg", {"a"});
  EXPECT_FALSE(check_truth(channel, 3));
  add_exact(channel, std::array{0.1});
  EXPECT_TRUE(check_truth(channel, 3));
  EXPECT_FALSE(check_truth(channel, 6));
  channel.frames(0, 1) = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(check_truth(channel, 3));
  channel.frames(0, 1) = 0.0F;
  channel.valid = Matrix<std::uint8_t>(1, 3, std::uint8_t{1});
  EXPECT_TRUE(check_truth(channel, 3));
  channel.valid(0, 2) = 0;
  EXPECT_FALSE(check_truth(channel, 3));
}

}  // namespace
}  // namespace somato::detail
