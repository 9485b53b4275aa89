#include "hardware/protocols/anyskin_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/support/damaged_sensor_stream.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

using Frame = std::vector<std::uint8_t>;

Frame encoded_anyskin(const std::vector<float>& values) {
  Frame bytes(anyskin_frame_bytes(values.size() / 4));
  EXPECT_EQ(encode_anyskin_frame(values, bytes), bytes.size());
  return bytes;
}

std::vector<std::vector<float>> decoded_anyskin(AnySkinDecoder& decoder,
                                                std::span<const std::uint8_t> bytes) {
  std::vector<std::vector<float>> frames;
  for (const std::uint8_t byte : bytes) {
    if (decoder.take(byte)) frames.emplace_back(decoder.values().begin(), decoder.values().end());
  }
  return frames;
}

std::vector<float> random_reading(Random& random, std::size_t magnetometers) {
  std::vector<float> values;
  for (std::size_t i = 0; i < magnetometers; ++i) {
    values.push_back(static_cast<float>(24.0 + 2.0 * random.uniform()));
    for (int axis = 0; axis < 3; ++axis) {
      values.push_back(static_cast<float>(3000.0 * (random.uniform() - 0.5)));
    }
  }
  return values;
}

Frame joined(std::initializer_list<Frame> frames) {
  Frame bytes;
  for (const Frame& frame : frames) bytes.insert(bytes.end(), frame.begin(), frame.end());
  return bytes;
}

// 24.5 is 0x41C40000, 1 is 0x3F800000, -2.5 is 0xC0200000, 0 is 0.
TEST(AnySkinFrame, HasTheBytesOfTheFormat) {
  EXPECT_EQ(encoded_anyskin({24.5F, 1.0F, -2.5F, 0.0F}),
            (Frame{0, 0, 0xC4, 0x41, 0, 0, 0x80, 0x3F, 0, 0, 0x20, 0xC0, 0, 0, 0, 0, 13, 10}));
}

TEST(AnySkinFrame, ReadsFramesAfterTheFirstEnd) {
  Random random(1);
  std::vector<std::vector<float>> sent;
  Frame bytes;
  for (int i = 0; i < 500; ++i) {
    sent.push_back(random_reading(random, 5));
    const Frame frame = encoded_anyskin(sent.back());
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  AnySkinDecoder decoder(5);
  const auto read = decoded_anyskin(decoder, bytes);
  ASSERT_EQ(read.size(), 499U);
  for (std::size_t i = 0; i < read.size(); ++i) ASSERT_EQ(read[i], sent[i + 1]);
}

// 42.009819 is 0x42280A0D: its lowest bytes are CR LF.
const float kWithEnding = std::bit_cast<float>(0x42280A0DU);

TEST(AnySkinFrame, IsNotMisledByAnEndInTheSamePlaceOfEveryFrame) {
  const std::vector<float> values{24.0F, kWithEnding, 5.0F, 6.0F, 25.0F, 7.0F, 8.0F, 9.0F};
  const Frame frame = encoded_anyskin(values);
  for (std::size_t cut = 0; cut < frame.size(); ++cut) {
    Frame bytes(frame.begin() + static_cast<std::ptrdiff_t>(cut), frame.end());
    for (int i = 0; i < 5; ++i) bytes.insert(bytes.end(), frame.begin(), frame.end());
    AnySkinDecoder decoder(2);
    const auto read = decoded_anyskin(decoder, bytes);
    ASSERT_EQ(read.size(), cut < 33 ? 5U : 4U) << cut;  // A lone LF is no end.
    for (const std::vector<float>& one : read) ASSERT_EQ(one, values);
  }
}

// All bytes 0x41 but CR LF in the second and third: read from there, every value is plausible too.
TEST(AnySkinFrame, AcceptsNoFramesThatOverlap) {
  Frame frame(18, 0x41);
  frame[1] = frame[16] = '\r';
  frame[2] = frame[17] = '\n';
  AnySkinDecoder decoder(1);
  const auto read =
      decoded_anyskin(decoder, joined({{'\r', '\n'}, frame, frame, frame, frame, frame}));
  ASSERT_EQ(read.size(), 5U);
  for (const auto& values : read) EXPECT_EQ(values[0], std::bit_cast<float>(0x410A0D41U));
}

TEST(AnySkinFrame, RejectsImplausibleValues) {
  const std::vector<float> good{24.0F, 1.0F, 2.0F, 3.0F};
  const float infinite = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t place : {0U, 1U, 3U}) {
    for (const float value : {-51'000.0F, 51'000.0F, 1e30F, 1e-30F, infinite, -infinite, nan}) {
      if (place == 0 && value == 1e-30F) continue;
      std::vector<float> bad = good;
      bad[place] = value;
      AnySkinDecoder decoder(1);
      const Frame bytes =
          joined({encoded_anyskin(good), encoded_anyskin(bad), encoded_anyskin(good)});
      EXPECT_EQ(decoded_anyskin(decoder, bytes).size(), 1U) << place << " " << value;
    }
  }
}

// A dead magnetometer is no reading of 0, and one without a number does not cost the others.
TEST(AnySkinFrame, KnowsMagnetometersWithoutAReading) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::vector<float>> dead{{0.0F, 0.0F, 0.0F, 0.0F},
                                             {25.0F, 0.0F, -0.0F, 0.0F},
                                             {25.0F, nan, nan, nan},
                                             {nan, nan, nan, nan}};
  for (const std::vector<float>& one : dead) {
    std::vector<float> values{24.0F, 1.0F, 2.0F, 3.0F};
    values.insert(values.end(), one.begin(), one.end());
    AnySkinDecoder decoder(2);
    const auto read =
        decoded_anyskin(decoder, joined({encoded_anyskin(values), encoded_anyskin(values)}));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0][3], 3.0F);
    for (const std::size_t axis : {5U, 6U, 7U}) EXPECT_TRUE(std::isnan(read[0][axis]));
  }
}

TEST(AnySkinFrame, SaysWhichValueItRejected) {
  const Frame good = encoded_anyskin({24.0F, 1.0F, 2.0F, 3.0F});
  AnySkinDecoder decoder(1);
  EXPECT_EQ(decoder.complaint(), "");
  decoded_anyskin(decoder, joined({{1, 2, 3}, good, good}));
  EXPECT_EQ(decoder.complaint(), "no frame of 18 bytes stood between two CR LF");
  decoded_anyskin(decoder,
                  joined({good, encoded_anyskin({24.0F, 1.0F, 60'000.0F, 3.0F}), good, good}));
  EXPECT_EQ(decoder.complaint(), "in the last frame the field y of magnetometer 1 was 60000");
}

TEST(AnySkinFrame, AcceptsTheLimitsThemselves) {
  const AnySkinLimits limits{10.0F, 30.0F, 0.5F, 100.0F};
  AnySkinDecoder decoder(1, limits);
  const Frame bytes = joined(
      {encoded_anyskin({20.0F, 0.0F, 0.0F, 0.0F}), encoded_anyskin({10.0F, 100.0F, 0.5F, 0.0F}),
       encoded_anyskin({30.0F, -100.0F, -0.5F, -0.0F}), encoded_anyskin({20.0F, 0.4F, 0.0F, 0.0F}),
       encoded_anyskin({9.9F, 1.0F, 1.0F, 1.0F}), encoded_anyskin({20.0F, 101.0F, 1.0F, 1.0F}),
       encoded_anyskin({20.0F, 1.0F, 1.0F, 1.0F})});
  EXPECT_EQ(decoded_anyskin(decoder, bytes).size(), 3U);
  EXPECT_EQ(decoder.rejected(), 4U);  // The first, and three.
}

TEST(AnySkinFrame, LosesOneFrameToADroppedByte) {
  Random random(2);
  Frame bytes = encoded_anyskin(random_reading(random, 5));
  for (int i = 0; i < 10; ++i) {
    Frame frame = encoded_anyskin(random_reading(random, 5));
    if (i == 4) frame.erase(frame.begin() + 30);
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  AnySkinDecoder decoder(5);
  EXPECT_EQ(decoded_anyskin(decoder, bytes).size(), 9U);
  EXPECT_EQ(decoder.rejected(), 2U);  // The first, and the damaged one.
}

// As parsers of this format are written: as many bytes as a frame has; where they do not end in CR
// LF, everything up to the next CR LF is skipped.
std::vector<std::vector<float>> naively_decoded(std::span<const std::uint8_t> bytes,
                                                std::size_t frame) {
  std::vector<std::vector<float>> frames;
  std::size_t begin = 0;
  const auto ends_at = [&](std::size_t end) {
    return bytes[end - 2] == 13 && bytes[end - 1] == 10;
  };
  while (begin + frame <= bytes.size()) {
    std::size_t end = begin + frame;
    if (ends_at(end)) {
      std::vector<float> values((frame - 2) / 4);
      std::memcpy(values.data(), &bytes[begin], frame - 2);
      frames.push_back(values);
    } else {
      while (end < bytes.size() && !ends_at(end)) ++end;
    }
    begin = end;
  }
  return frames;
}

testing::DamagedSensorStream damaged_anyskin() {
  testing::DamagedSensorStream stream(7);
  Random random(8);
  for (int i = 0; i < 20'000; ++i) {
    const std::vector<float> values = random_reading(random, 5);
    stream.add(encoded_anyskin(values), values);
  }
  return stream;
}

// The format has no checksum. In 20,000 frames with about 820 changed bytes, the naive parser
// accepts 718 wrong ones and loses 1,125 whole ones; ours accepts 599, all with a byte changed
// within a value that stays plausible, and loses 410, most of them because garbage stood directly
// before them.
TEST(AnySkinFrame, AcceptsFewerDamagedFramesThanANaiveParser) {
  testing::DamagedSensorStream ours = damaged_anyskin();
  testing::DamagedSensorStream naive = ours;
  AnySkinDecoder decoder(5);
  for (const auto& values : decoded_anyskin(decoder, ours.bytes())) ours.accept(values);
  for (const auto& values : naively_decoded(naive.bytes(), 82)) naive.accept(values);
  EXPECT_GT(naive.wrong(), 700U);
  EXPECT_LT(ours.wrong(), 620U);
  EXPECT_GT(naive.lost(), 1'000U);
  EXPECT_LT(ours.lost(), 450U);
}

TEST(AnySkinFrame, RefusesImpossibleArguments) {
  Frame bytes(17);
  EXPECT_THROW(encode_anyskin_frame(std::vector<float>(3), bytes), InvalidArgument);
  EXPECT_THROW(encode_anyskin_frame({}, bytes), InvalidArgument);
  EXPECT_THROW(encode_anyskin_frame(std::vector<float>(4), bytes), InvalidArgument);
  EXPECT_THROW(AnySkinDecoder(0), InvalidArgument);
}

TEST(AnySkinFrame, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  const std::vector<float> values(20, 20.0F);
  Frame bytes(82);
  AnySkinDecoder decoder(5);
  const testing::AllocationCounter allocations;
  int frames = 0;
  for (int i = 0; i < 10; ++i) {
    encode_anyskin_frame(values, bytes);
    for (const std::uint8_t byte : bytes) frames += decoder.take(byte) ? 1 : 0;
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(frames, 9);
}

}  // namespace
}  // namespace somato::wire
