#include "hardware/buses/sensor_frame_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace somato::devices {
namespace {

class SensorFrameStreamTest : public ::testing::Test {
 protected:
  void send(std::uint16_t sequence, std::uint32_t microseconds) {
    const std::array<float, 1> values{static_cast<float>(sequence % 100)};
    std::vector<std::uint8_t> bytes(wire::sensor_frame_bytes(1, wire::SensorValueType::kInt16));
    bytes.resize(wire::encode_sensor_frame(
        {sequence, microseconds, wire::SensorValueType::kInt16, values}, bytes));
    if (damaged_) bytes[3] ^= 0x40;
    stream_.receive(bytes, 1.0);
  }

  SensorFrameStream stream_{1};
  bool damaged_ = false;
};

TEST_F(SensorFrameStreamTest, CountsWhatIsMissing) {
  send(10, 0);
  send(11, 100);
  EXPECT_EQ(stream_.lost(), 0U);
  send(15, 500);
  EXPECT_EQ(stream_.lost(), 3U);
  damaged_ = true;
  send(16, 600);
  EXPECT_EQ(stream_.rejected(), 1U);
  EXPECT_EQ(stream_.lost(), 3U);
  damaged_ = false;
  send(17, 700);
  EXPECT_EQ(stream_.lost(), 4U);
  EXPECT_EQ(stream_.frames(), 4U);
  EXPECT_EQ(stream_.restarts(), 0U);
}

TEST_F(SensorFrameStreamTest, FollowsTheSequenceOverItsEnd) {
  send(65534, 0);
  send(65535, 1);
  send(0, 2);
  send(2, 3);
  EXPECT_EQ(stream_.lost(), 1U);
}

TEST_F(SensorFrameStreamTest, UnwrapsTheClock) {
  send(0, 4'294'967'290U);
  EXPECT_DOUBLE_EQ(stream_.device_time().value(), 4294.967290);
  send(1, 4);  // 10 us later
  EXPECT_DOUBLE_EQ(stream_.device_time().value(), 4294.967300);
  send(2, 2'000'000'000U);
  send(3, 4'000'000'000U);
  send(4, 1'000'000'000U);
  EXPECT_DOUBLE_EQ(stream_.device_time().value(), 9589.934592);  // 2 * 2^32 + 10^9 us
  EXPECT_EQ(stream_.restarts(), 0U);
}

TEST_F(SensorFrameStreamTest, NoticesARestart) {
  send(30'000, 5'000'000);
  send(0, 10'000);  // by its clock, although the number could be one of 35,535 further on
  EXPECT_EQ(stream_.restarts(), 1U);
  EXPECT_EQ(stream_.lost(), 0U);
  EXPECT_DOUBLE_EQ(stream_.device_time().value(), 0.01);
  send(100, 20'000);
  send(0, 30'000);  // by its number
  EXPECT_EQ(stream_.restarts(), 2U);
  EXPECT_EQ(stream_.lost(), 99U);
}

}  // namespace
}  // namespace somato::devices
