#include "hardware/buses/anyskin_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace somato::devices {
namespace {

TEST(AnySkinStream, SeparatesFieldsAndTemperatures) {
  AnySkinStream stream(2);
  EXPECT_TRUE(std::isnan(stream.temperatures()[1]));
  const std::array<float, 8> values{24.0F, 1.0F, 2.0F, 3.0F, 25.0F, -4.0F, -5.0F, -6.0F};
  std::vector<std::uint8_t> bytes(wire::anyskin_frame_bytes(2));
  wire::encode_anyskin_frame(values, bytes);
  stream.receive(bytes, 1.0);
  stream.receive(bytes, 2.0);
  EXPECT_EQ(std::vector<float>(stream.values().begin(), stream.values().end()),
            (std::vector<float>{1.0F, 2.0F, 3.0F, -4.0F, -5.0F, -6.0F}));
  EXPECT_EQ(stream.temperatures()[0], 24.0F);
  EXPECT_EQ(stream.temperatures()[1], 25.0F);
  EXPECT_EQ(stream.time(), 2.0);
  EXPECT_EQ(stream.frames(), 1U);
}

}  // namespace
}  // namespace somato::devices
