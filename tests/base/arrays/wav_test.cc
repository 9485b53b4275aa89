#include "base/arrays/wav.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "base/archives/little_endian.h"
#include "somato/core/random.h"

namespace somato {
namespace {

std::string wav_part(const std::string& name, const std::string& content) {
  std::string bytes = name;
  append_little_endian(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += content;
  if (content.size() % 2 != 0) bytes += '\0';
  return bytes;
}

std::string wav_format(std::uint16_t coding, std::uint16_t channels, std::uint16_t bits) {
  constexpr std::uint32_t kRate = 8000;
  std::string content;
  append_little_endian(content, coding);
  append_little_endian(content, channels);
  append_little_endian(content, kRate);
  append_little_endian(content, std::uint32_t{0});
  append_little_endian(content, static_cast<std::uint16_t>(channels * bits / 8));
  append_little_endian(content, bits);
  return content;
}

std::string wav(const std::string& parts) {
  std::string bytes = "RIFF";
  append_little_endian(bytes, static_cast<std::uint32_t>(4 + parts.size()));
  return bytes + "WAVE" + parts;
}

std::string wav(const std::string& head, const std::string& data) {
  return wav(wav_part("fmt ", head) + wav_part("LIST", "odd") + wav_part("data", data));
}

template <typename T>
std::string wav_samples(const std::vector<T>& values) {
  std::string bytes;
  for (const T value : values) append_little_endian(bytes, value);
  return bytes;
}

Matrix<float> read_wav(const std::string& bytes) {
  const auto sound = decode_wav(bytes, "a.wav");
  if (!sound) ADD_FAILURE() << to_string(sound.error());
  return sound ? sound->samples : Matrix<float>();
}

std::string wav_refusal(const std::string& bytes) {
  const auto sound = decode_wav(bytes, "a.wav");
  return sound ? "read" : to_string(sound.error());
}

constexpr std::uint16_t kPcm = 1;
constexpr std::uint16_t kFloat = 3;

// A file with these sizes in its head and its data, whatever it holds.
std::string wav_with_sizes(std::uint32_t riff, std::uint32_t data, const std::string& samples,
                           std::uint16_t bits = 16) {
  std::string bytes = wav(wav_part("fmt ", wav_format(kPcm, 1, bits)) + wav_part("LIST", "odd"));
  std::string size;
  append_little_endian(size, riff);
  bytes.replace(4, 4, size);
  bytes += "data";
  append_little_endian(bytes, data);
  return bytes + samples;
}

TEST(Wav, IntegersAreSharesOfTheirRange) {
  EXPECT_EQ(
      read_wav(wav(wav_format(kPcm, 1, 16), wav_samples<std::int16_t>({-32768, 0, 16384, 1}))),
      Matrix<float>(4, 1, {-1.0F, 0.0F, 0.5F, 1.0F / 32768.0F}));
  EXPECT_EQ(read_wav(wav(wav_format(kPcm, 2, 8), wav_samples<std::uint8_t>({0, 128, 192, 129}))),
            Matrix<float>(2, 2, {-1.0F, 0.0F, 0.5F, 1.0F / 128.0F}));
  EXPECT_EQ(read_wav(wav(wav_format(kPcm, 1, 24), std::string("\0\0\x80\1\0\0\xFF\xFF\xFF", 9))),
            Matrix<float>(3, 1, {-1.0F, 1.0F / 8388608.0F, -1.0F / 8388608.0F}));
  EXPECT_EQ(read_wav(wav(wav_format(kPcm, 1, 32), wav_samples<std::int32_t>({1 << 30, -1}))),
            Matrix<float>(2, 1, {0.5F, -1.0F / 2147483648.0F}));
}

TEST(Wav, FloatingPointNumbersAreKept) {
  EXPECT_EQ(read_wav(wav(wav_format(kFloat, 1, 32), wav_samples<float>({0.1F, -2.0F}))),
            Matrix<float>(2, 1, {0.1F, -2.0F}));
  EXPECT_EQ(read_wav(wav(wav_format(kFloat, 1, 64), wav_samples<double>({0.1}))),
            Matrix<float>(1, 1, 0.1F));
  std::string extensible = wav_format(0xFFFE, 1, 32) + wav_samples<std::uint16_t>({22, 32, 0, 0});
  extensible += wav_samples<std::uint16_t>({kFloat}) + std::string(14, '\0');
  EXPECT_EQ(read_wav(wav(extensible, wav_samples<float>({0.25F}))), Matrix<float>(1, 1, 0.25F));
  EXPECT_EQ(decode_wav(wav(extensible, wav_samples<float>({0.25F})), "")->rate, 8000.0);
}

TEST(Wav, OtherAndDamagedFilesAreRefused) {
  const std::string data = wav_samples<std::int16_t>({1, 2, 3});
  EXPECT_NE(wav_refusal("RIFF").find("not a WAV file"), std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_part("fmt ", wav_format(kPcm, 1, 16)))).find("no samples"),
            std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_format(kPcm, 1, 16), "")).find("no samples"), std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_format(kPcm, 2, 16), data)).find("last sample is cut"),
            std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_format(2, 1, 4), data)).find("the coding 2 with 4 bits"),
            std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_format(kPcm, 0, 16), data)).find("0 channels"), std::string::npos);
  const std::string whole = wav(wav_format(kPcm, 1, 16), data);
  EXPECT_NE(wav_refusal(whole.substr(0, whole.size() - 1)).find("cut within its part 'data'"),
            std::string::npos);
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_NE(wav_refusal(wav(wav_format(kFloat, 1, 32), wav_samples<float>({0, infinite})))
                .find("sample 2"),
            std::string::npos);
  EXPECT_NE(wav_refusal("RF64" + whole.substr(4)).find("RF64"), std::string::npos);
}

TEST(Wav, AnyBytesAreReadOrRefused) {
  Random random(1);
  const std::string whole = wav(wav_format(kPcm, 2, 16), wav_samples<std::int16_t>({1, 2, 3, 4}));
  for (int i = 0; i < 3000; ++i) {
    std::string changed = whole;
    for (int k = 0; k < 3; ++k) {
      changed[random.below(changed.size())] = static_cast<char>(random.below(256));
    }
    if (i % 3 == 0) changed.resize(random.below(changed.size()));
    (void)decode_wav(changed, "a.wav");
  }
}

// As ffmpeg, sox, arecord, libsndfile and GStreamer write to a pipe.
TEST(Wav, SamplesOfUnknownSizeReachToTheEnd) {
  const std::string samples = wav_samples<std::int16_t>({16384, -16384, 0});
  const Matrix<float> expected(3, 1, {0.5F, -0.5F, 0.0F});
  for (const auto& [riff, data] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0xFFFFFFFFU, 0xFFFFFFFFU},
                                                            {0x7FFFF024U, 0x7FFFF000U},
                                                            {0x80000024U, 0x80000000U},
                                                            {0x7FFFFFFFU, 0x7FFFFFDBU},
                                                            {0xFFFFFFFFU, 0xFFFFFFDBU},
                                                            {0, 0},
                                                            {36, 0},
                                                            {0, 0xFFFFFFFFU}}) {
    EXPECT_EQ(read_wav(wav_with_sizes(riff, data, samples)), expected) << riff << " " << data;
  }
  // An odd number of bytes is padded.
  EXPECT_EQ(read_wav(wav_with_sizes(~0U, ~0U, std::string("\0\0\x40\0", 4), 24)),
            Matrix<float>(1, 1, 0.5F));
}

TEST(Wav, ATornFileIsNoFileOfUnknownSize) {
  const std::string samples = wav_samples<std::int16_t>({16384, -16384, 0});
  for (const std::uint32_t size : {7U, 8U, 100U, 1U << 20U, 1U << 30U, 3U << 30U}) {
    EXPECT_NE(wav_refusal(wav_with_sizes(size + 40, size, samples)).find("the file is cut within"),
              std::string::npos)
        << size;
  }
  // In the middle of a sample.
  EXPECT_NE(wav_refusal(wav_with_sizes(~0U, ~0U, samples + "a")).find("its last sample is cut"),
            std::string::npos);
  // No sound at all, and another part behind it.
  EXPECT_NE(wav_refusal(wav_with_sizes(~0U, ~0U, "")).find("it has no samples"), std::string::npos);
  EXPECT_NE(wav_refusal(wav(wav_part("fmt ", wav_format(kPcm, 1, 16)) + wav_part("data", "") +
                            wav_part("LIST", "even")))
                .find("it has no samples"),
            std::string::npos);
}

}  // namespace
}  // namespace somato
