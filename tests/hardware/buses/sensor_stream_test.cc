#include "hardware/buses/sensor_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/devices/device_io.h"
#include "hardware/emulation/sensor_board.h"
#include "hardware/support/emulated_line.h"
#include "hardware/support/every_bus.h"

namespace somato::devices {
namespace {

struct StreamCase {
  FrameFormat format;
  wire::SensorValueType values = wire::SensorValueType::kFloat32;
};

std::unique_ptr<SensorStream> stream_for(FrameFormat format, std::size_t elements) {
  DeviceFile file;
  file.frame_line.emplace();
  file.frame_line->format = format;
  file.frame_line->elements = elements;
  return make_stream(file);
}

std::vector<StreamCase> every_case() {
  std::vector<StreamCase> cases{{FrameFormat::kFrames, wire::SensorValueType::kInt16}};
  for (const FrameFormat format : testing::every_format()) cases.push_back({format});
  return cases;
}

class SensorStreamTest : public ::testing::TestWithParam<StreamCase> {};

TEST_P(SensorStreamTest, StatesThatNothingHasArrived) {
  const auto stream = stream_for(GetParam().format, 3);
  EXPECT_EQ(stream->time(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(stream->device_time(), std::nullopt);
  ASSERT_EQ(stream->values().size(), 3U);
  for (const float value : stream->values()) EXPECT_TRUE(std::isnan(value));
}

TEST_P(SensorStreamTest, FollowsABoard) {
  emulation::SensorBoard board({GetParam().format, 6, 100.0, 25.0F, GetParam().values});
  testing::EmulatedLine line(board);
  const auto stream = stream_for(GetParam().format, 6);
  std::vector<float> values(6);
  for (int frame = 1; frame <= 300; ++frame) {
    for (std::size_t i = 0; i < 6; ++i) values[i] = static_cast<float>(frame * (i % 2 ? 1 : -1));
    board.set_values(values);
    std::vector<std::uint8_t> bytes(300);
    while (line.now() < frame * 0.01 - 1e-9) line.wait(frame * 0.01);
    bytes.resize(line.read(0, bytes).value());
    stream->receive(bytes, line.now());
    if (frame > 1) {
      ASSERT_EQ(std::vector<float>(stream->values().begin(), stream->values().end()), values);
      ASSERT_EQ(stream->time(), line.now());
    }
  }
  // The first one may pass before the decoder knows where a frame begins.
  EXPECT_GE(stream->frames(), GetParam().format == FrameFormat::kFrames ? 300U : 299U);
  EXPECT_LE(stream->frames(), 300U);
  EXPECT_EQ(stream->lost(), 0U);
}

TEST_P(SensorStreamTest, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  emulation::SensorBoard board({GetParam().format, 45, 100.0, 25.0F, GetParam().values});
  std::vector<std::uint8_t> bytes;
  board.advance(1.0, bytes);
  bytes[500] ^= 1;
  const auto stream = stream_for(GetParam().format, 45);
  const testing::AllocationCounter allocations;
  stream->receive(bytes, 1.0);
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_GE(stream->frames(), 90U);
}

INSTANTIATE_TEST_SUITE_P(Formats, SensorStreamTest, ::testing::ValuesIn(every_case()));

}  // namespace
}  // namespace somato::devices
