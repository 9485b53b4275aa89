#include "hardware/protocols/float_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace somato::wire {
namespace {

// 1.0 is 0x3F800000 and -2.5 is 0xC0200000 in IEEE 754.
TEST(FloatBytes, WritesTheLowestByteFirst) {
  std::array<std::uint8_t, 4> bytes{};
  put_float(1.0F, bytes);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 4>{0, 0, 0x80, 0x3F}));
  EXPECT_EQ(float_of(std::array<std::uint8_t, 4>{0, 0, 0x20, 0xC0}), -2.5F);
}

TEST(FloatBytes, WritesNumbersOfAnyWidth) {
  std::array<std::uint8_t, 3> bytes{};
  put_little_endian(0x12345678, bytes);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 3>{0x78, 0x56, 0x34}));
  EXPECT_EQ(little_endian(bytes), 0x345678U);
  EXPECT_EQ(little_endian({}), 0U);
}

}  // namespace
}  // namespace somato::wire
