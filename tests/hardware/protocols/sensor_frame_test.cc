#include "hardware/protocols/sensor_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/archives/checksum.h"
#include "base/support/no_malloc.h"
#include "hardware/support/damaged_sensor_stream.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded_sensor_frame(const SensorFrame& frame) {
  Bytes bytes(sensor_frame_bytes(frame.values.size(), frame.type));
  bytes.resize(encode_sensor_frame(frame, bytes));
  return bytes;
}

void append_number(std::string& text, std::uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) text += static_cast<char>((number >> (8 * i)) & 0xFF);
}

// The slow, obvious way: the body as text, then a block for each zero.
std::string body_by_hand(const SensorFrame& frame) {
  std::string body(1, static_cast<char>(frame.type));
  append_number(body, frame.sequence, 2);
  append_number(body, frame.microseconds, 4);
  for (const float value : frame.values) {
    if (frame.type == SensorValueType::kInt16) {
      append_number(body, static_cast<std::uint32_t>(static_cast<int>(value)), 2);
    } else {
      body.append(reinterpret_cast<const char*>(&value), 4);
    }
  }
  append_number(body, somato::crc32(body), 4);
  return body;
}

std::optional<std::string> unstuffed(const Bytes& bytes) {
  std::string body;
  for (std::size_t i = 1; i + 1 < bytes.size();) {
    const std::size_t code = bytes[i];
    if (code == 0 || i + code > bytes.size() - 1) return {};
    body.append(bytes.begin() + static_cast<int>(i) + 1,
                bytes.begin() + static_cast<int>(i + code));
    i += code;
    if (code < 255 && i + 1 < bytes.size()) body += '\0';
  }
  return body;
}

SensorFrame random_frame(Random& random, std::vector<float>& values) {
  const auto type = random.below(2) ? SensorValueType::kInt16 : SensorValueType::kFloat32;
  for (float& value : values) {
    const double number = random.below(4) ? (random.uniform() - 0.5) * 65534.0 : 0.0;
    value = type == SensorValueType::kInt16 ? static_cast<float>(static_cast<int>(number))
                                            : static_cast<float>(number * 1e-3);
  }
  return {static_cast<std::uint16_t>(random.below(65536)), random.next(), type, values};
}

std::size_t decoded(SensorFrameDecoder& decoder, std::span<const std::uint8_t> bytes) {
  std::size_t frames = 0;
  for (const std::uint8_t byte : bytes) frames += decoder.take(byte) ? 1 : 0;
  return frames;
}

// By hand: type 1, sequence 2, time 0x00010203, values 1 and -1; its CRC-32 by Python's zlib.
TEST(SensorFrame, HasTheDocumentedBytes) {
  const std::array<float, 2> values{1.0F, -1.0F};
  const SensorFrame frame{2, 0x00010203, SensorValueType::kInt16, values};
  const std::string body = body_by_hand(frame);
  EXPECT_EQ(body.substr(0, 11), std::string("\x01\x02\x00\x03\x02\x01\x00\x01\x00\xFF\xFF", 11));
  EXPECT_EQ(encoded_sensor_frame(frame),
            (Bytes{0, 3, 1, 2, 4, 3, 2, 1, 2, 1, 7, 0xFF, 0xFF, 0xE4, 0x0E, 0x2A, 0x7A, 0}));
}

TEST(SensorFrame, AgreesWithTheObviousWay) {
  Random random(1);
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<float> values(1 + random.below(trial % 10 == 0 ? 1024 : 80));
    const SensorFrame frame = random_frame(random, values);
    const Bytes bytes = encoded_sensor_frame(frame);
    ASSERT_EQ(std::count(bytes.begin(), bytes.end(), 0), 2);
    ASSERT_EQ(unstuffed(bytes), body_by_hand(frame));
    SensorFrameDecoder decoder(values.size());
    ASSERT_EQ(decoded(decoder, bytes), 1U);
    ASSERT_EQ(decoder.frame().sequence, frame.sequence);
    ASSERT_EQ(decoder.frame().microseconds, frame.microseconds);
    ASSERT_EQ(decoder.frame().type, frame.type);
    ASSERT_TRUE(std::equal(values.begin(), values.end(), decoder.frame().values.begin()));
  }
}

// Blocks of 254 bytes without zero and their neighbours; 0x41424344 is 12.141422.
TEST(SensorFrame, SplitsLongRunsWithoutZero) {
  for (std::size_t count = 50; count < 400; ++count) {
    const std::vector<float> values(count, 12.141422F);
    const SensorFrame frame{0x0101, 0x01010101, SensorValueType::kFloat32, values};
    const Bytes bytes = encoded_sensor_frame(frame);
    ASSERT_EQ(std::count(bytes.begin(), bytes.end(), 0), 2);
    ASSERT_EQ(unstuffed(bytes), body_by_hand(frame));
    SensorFrameDecoder decoder(count);
    ASSERT_EQ(decoded(decoder, bytes), 1U) << count;
  }
}

TEST(SensorFrame, RoundsToInt16) {
  const std::array<float, 4> values{0.5F, -1.4F, 32767.4F, -32768.0F};
  SensorFrameDecoder decoder(4);
  ASSERT_EQ(decoded(decoder, encoded_sensor_frame({0, 0, SensorValueType::kInt16, values})), 1U);
  const auto read = decoder.frame().values;
  EXPECT_EQ(std::vector<float>(read.begin(), read.end()),
            (std::vector<float>{1.0F, -1.0F, 32767.0F, -32768.0F}));
}

TEST(SensorFrame, RejectsEverySingleChangedByte) {
  std::vector<float> values{1.0F, 0.0F, 3.0F};
  const Bytes bytes = encoded_sensor_frame({7, 9, SensorValueType::kInt16, values});
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    for (unsigned change = 1; change < 256; ++change) {
      Bytes changed = bytes;
      changed[place] ^= static_cast<std::uint8_t>(change);
      changed.push_back(0);
      SensorFrameDecoder decoder(3);
      ASSERT_EQ(decoded(decoder, changed), 0U) << place << " " << change;
      ASSERT_GE(decoder.rejected(), 1U);
    }
  }
}

TEST(SensorFrame, RejectsAnotherNumberOfValues) {
  const std::vector<float> values(5, 1.0F);
  const Bytes bytes = encoded_sensor_frame({0, 0, SensorValueType::kInt16, values});
  SensorFrameDecoder four(4);
  SensorFrameDecoder thousand(1000);
  EXPECT_EQ(decoded(four, bytes), 0U);
  EXPECT_EQ(decoded(thousand, bytes), 0U);
  EXPECT_EQ(four.rejected(), 1U);
}

TEST(SensorFrame, KeepsTheLastFrameWhenAnotherIsRejected) {
  std::vector<float> values{1.0F};
  SensorFrameDecoder decoder(1);
  decoded(decoder, encoded_sensor_frame({0, 0, SensorValueType::kInt16, values}));
  values[0] = 2.0F;
  Bytes bytes = encoded_sensor_frame({1, 1, SensorValueType::kInt16, values});
  bytes[2] ^= 0x40;
  decoded(decoder, bytes);
  EXPECT_EQ(decoder.frame().values[0], 1.0F);
  EXPECT_EQ(decoder.frame().sequence, 0);
}

TEST(SensorFrame, RejectsValuesThatAreNotFinite) {
  std::string body(1, '\x02');
  body += std::string(6, '\x01') + std::string("\x00\x00\x80\x7F", 4);  // Infinity.
  append_number(body, somato::crc32(body), 4);
  Bytes bytes{0, 8};
  bytes.insert(bytes.end(), body.begin(), body.begin() + 7);
  bytes.push_back(1);
  bytes.push_back(static_cast<std::uint8_t>(body.size() - 9 + 1));
  bytes.insert(bytes.end(), body.begin() + 9, body.end());
  bytes.push_back(0);
  ASSERT_EQ(unstuffed(bytes), body);
  SensorFrameDecoder decoder(1);
  EXPECT_EQ(decoded(decoder, bytes), 0U);
  EXPECT_EQ(decoder.rejected(), 1U);
}

TEST(SensorFrame, SkipsZerosBetweenFrames) {
  SensorFrameDecoder decoder(1);
  EXPECT_EQ(decoded(decoder, Bytes(10, 0)), 0U);
  EXPECT_EQ(decoder.rejected(), 0U);
}

TEST(SensorFrame, AcceptsNoDamagedFrameAndLosesNoWholeOne) {
  testing::DamagedSensorStream stream(5);
  Random random(6);
  std::vector<float> values(56);
  for (int i = 0; i < 20'000; ++i) {
    for (float& value : values) value = static_cast<float>(random.below(1024));
    stream.add(encoded_sensor_frame(
                   {static_cast<std::uint16_t>(i), random.next(), SensorValueType::kInt16, values}),
               values);
  }
  SensorFrameDecoder decoder(values.size());
  for (const std::uint8_t byte : stream.bytes()) {
    if (decoder.take(byte)) stream.accept(decoder.frame().values);
  }
  EXPECT_EQ(stream.wrong(), 0U);
  EXPECT_EQ(stream.lost(), 0U);
  EXPECT_GT(stream.accepted(), 17'000U);
}

TEST(SensorFrame, MarksMissingValuesOfFloats) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> values{1.0F, nan, 3.0F};
  SensorFrameDecoder decoder(3);
  ASSERT_EQ(decoded(decoder, encoded_sensor_frame({0, 0, SensorValueType::kFloat32, values})), 1U);
  EXPECT_EQ(decoder.frame().values[0], 1.0F);
  EXPECT_TRUE(std::isnan(decoder.frame().values[1]));
  EXPECT_THROW(encoded_sensor_frame({0, 0, SensorValueType::kInt16, values}), InvalidArgument);
}

TEST(SensorFrame, SaysWhyAFrameWasRejected) {
  const std::vector<float> four{1.0F, 2.0F, 3.0F, 4.0F};
  SensorFrameDecoder decoder(3);
  EXPECT_EQ(decoder.complaint(), "");
  decoded(decoder, encoded_sensor_frame({0, 0, SensorValueType::kInt16, four}));
  EXPECT_EQ(decoder.complaint(), "the last frame had 19 bytes instead of 17 or 23 for 3 values");
  decoded(decoder, encoded_sensor_frame({0, 0, SensorValueType::kFloat32, four}));
  EXPECT_EQ(decoder.complaint(), "the last frame had 27 bytes instead of 17 or 23 for 3 values");
  Bytes wrong =
      encoded_sensor_frame({0x0101, 0x01010101, SensorValueType::kInt16, std::span(four).first(3)});
  wrong[4] ^= 2;
  decoded(decoder, wrong);
  EXPECT_EQ(decoder.complaint(), "the last frame had a wrong checksum");
  decoded(decoder, Bytes{0, 9, 9, 0});
  EXPECT_EQ(decoder.complaint(), "the last frame was cut after 1 bytes");
}

TEST(SensorFrame, RefusesImpossibleFrames) {
  Bytes bytes(5000);
  const float infinite = std::numeric_limits<float>::infinity();
  const auto encode = [&](const std::vector<float>& values, SensorValueType type) {
    encode_sensor_frame({0, 0, type, values}, bytes);
  };
  EXPECT_THROW(encode({}, SensorValueType::kInt16), InvalidArgument);
  EXPECT_THROW(encode(std::vector<float>(1025), SensorValueType::kInt16), InvalidArgument);
  EXPECT_THROW(encode({32768.0F}, SensorValueType::kInt16), InvalidArgument);
  EXPECT_THROW(encode({infinite}, SensorValueType::kFloat32), InvalidArgument);
  bytes.resize(10);
  EXPECT_THROW(encode({1.0F}, SensorValueType::kInt16), InvalidArgument);
  EXPECT_THROW(SensorFrameDecoder(0), InvalidArgument);
  EXPECT_THROW(SensorFrameDecoder(1025), InvalidArgument);
}

TEST(SensorFrame, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  const std::vector<float> values(300, 1.0F);
  Bytes bytes(sensor_frame_bytes(300, SensorValueType::kFloat32));
  SensorFrameDecoder decoder(300);
  const testing::AllocationCounter allocations;
  const std::size_t size = encode_sensor_frame({0, 0, SensorValueType::kFloat32, values}, bytes);
  const std::size_t frames = decoded(decoder, std::span(bytes).first(size));
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(frames, 1U);
}

}  // namespace
}  // namespace somato::wire
