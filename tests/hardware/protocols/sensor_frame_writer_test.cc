// The framing for microcontrollers, examples/arduino/touch_hand/sensor_frame_writer.h.
#include "../../../examples/arduino/touch_hand/sensor_frame_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardware/protocols/sensor_frame.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

template <std::size_t kCount>
std::vector<std::uint8_t> written_frame(SensorFrameWriter<kCount>& writer,
                                        const SensorFrame& frame) {
  writer.begin(frame.sequence, frame.microseconds);
  for (const float value : frame.values) writer.add(static_cast<std::int16_t>(value));
  std::vector<std::uint8_t> bytes;
  writer.send([&](std::uint8_t byte) { bytes.push_back(byte); });
  return bytes;
}

template <std::size_t kCount>
void expect_frames_of_decoder(std::uint64_t seed, std::uint64_t zeros_of_four) {
  Random random(seed);
  SensorFrameWriter<kCount> writer;
  SensorFrameDecoder decoder(kCount);
  std::vector<float> values(kCount);
  for (int trial = 0; trial < 100; ++trial) {
    for (float& value : values) {
      value =
          random.below(4) < zeros_of_four ? 0.0F : static_cast<float>(random.below(65536)) - 32768;
    }
    const SensorFrame frame{static_cast<std::uint16_t>(random.below(65536)), random.next(),
                            SensorValueType::kInt16, values};
    const auto bytes = written_frame(writer, frame);
    std::vector<std::uint8_t> expected(sensor_frame_bytes(kCount, frame.type));
    ASSERT_LE(bytes.size(), expected.size());
    int frames = 0;
    for (const std::uint8_t byte : bytes) frames += decoder.take(byte) ? 1 : 0;
    ASSERT_EQ(frames, 1);
    ASSERT_EQ(decoder.frame().sequence, frame.sequence);
    ASSERT_EQ(decoder.frame().microseconds, frame.microseconds);
    ASSERT_TRUE(std::equal(values.begin(), values.end(), decoder.frame().values.begin()));
    expected.resize(encode_sensor_frame(frame, expected));
    ASSERT_EQ(bytes, expected);
  }
  EXPECT_EQ(decoder.rejected(), 0U);
}

TEST(SensorFrameWriter, WritesTheDocumentedExample) {
  const std::array<float, 2> values{1.0F, -1.0F};
  SensorFrameWriter<2> writer;
  EXPECT_EQ(written_frame(writer, {2, 0x00010203, SensorValueType::kInt16, values}),
            (std::vector<std::uint8_t>{0, 3, 1, 2, 4, 3, 2, 1, 2, 1, 7, 0xFF, 0xFF, 0xE4, 0x0E,
                                       0x2A, 0x7A, 0}));
}

TEST(SensorFrameWriter, WritesWhatTheDecoderReads) {
  for (const std::uint64_t zeros : {0U, 1U, 4U}) {
    expect_frames_of_decoder<1>(1, zeros);
    expect_frames_of_decoder<56>(2, zeros);
    expect_frames_of_decoder<122>(3, zeros);
    expect_frames_of_decoder<400>(4, zeros);
  }
}

TEST(SensorFrameWriter, IgnoresValuesBeyondItsFrame) {
  const std::vector<float> values{1.0F, 2.0F, 3.0F};
  SensorFrameWriter<2> writer;
  SensorFrameDecoder decoder(2);
  int frames = 0;
  for (const std::uint8_t byte : written_frame(writer, {0, 0, SensorValueType::kInt16, values})) {
    frames += decoder.take(byte) ? 1 : 0;
  }
  EXPECT_EQ(frames, 1);
}

}  // namespace
}  // namespace somato::wire
