#include "views/report/packed_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/support/json_schema.h"
#include "views/support/unpacked_json.h"

namespace somato {
namespace {

using detail::packed_numbers;
using detail::packed_rows;
using detail::PackedBits;
using testing::unpacked;

TEST(PackedJson, WritesIntegersInBase64WithTheLowerByteFirst) {
  // 0, half and the whole of 254 steps, and a missing one: bytes 0, 127, 254, 255.
  const std::vector<double> numbers = {-1.0, 0.0, 1.0, std::nan("")};
  EXPECT_EQ(packed_numbers(numbers, PackedBits::k8)["packed"], "AH/+/w==");
  // 0, 32767 = 0x7FFF, 65534 = 0xFFFE, 65535: bytes 00 00 FF 7F FE FF FF FF.
  EXPECT_EQ(packed_numbers(numbers, PackedBits::k16)["packed"], "AAD/f/7///8=");
  EXPECT_EQ(packed_numbers({}, PackedBits::k8)["packed"], "");
}

TEST(PackedJson, KeepsNumbersToHalfAStep) {
  for (const std::size_t count : {1U, 2U, 3U, 100U}) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(1.0 / 3.0 * static_cast<double>(i * i));
    const double range = numbers.back();
    for (const auto& [bits, steps] :
         {std::pair{PackedBits::k8, 254.0}, {PackedBits::k16, 65534.0}}) {
      const auto json = packed_rows(numbers, count, bits);
      EXPECT_TRUE(testing::fits_schema(json, "report.json#/$defs/PackedRows"));
      const auto read = unpacked(json);
      ASSERT_EQ(read.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(read[i], numbers[i], range * (0.51 / steps + 1e-6)) << i;
      }
    }
  }
}

TEST(PackedJson, NumbersThatAreNotFiniteAreMissing) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers = {infinity, 2.0, -infinity, std::nan(""), 2.0};
  const auto read = unpacked(packed_numbers(numbers, PackedBits::k16));
  for (const std::size_t missing : {0U, 2U, 3U}) EXPECT_TRUE(std::isnan(read[missing]));
  EXPECT_EQ(read[1], 2.0);
  EXPECT_EQ(read[4], 2.0);
  const std::vector<double> none = {infinity};
  EXPECT_TRUE(std::isnan(unpacked(packed_numbers(none, PackedBits::k8))[0]));
}

}  // namespace
}  // namespace somato
