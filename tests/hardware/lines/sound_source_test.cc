#include "hardware/lines/sound_source.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <vector>

#include "base/support/temporary_folder.h"

namespace somato::wire {
namespace {

std::string little(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

// A WAV file by its specification: RIFF, a format and samples.
std::string wav(std::uint32_t rate, std::uint32_t channels, const std::string& samples) {
  const std::string format = little(1, 2) + little(channels, 2) + little(rate, 4) +
                             little(rate * channels * 2, 4) + little(channels * 2, 2) +
                             little(16, 2);
  const std::string rest = "WAVEfmt " + little(16, 4) + format + "LIST" + little(3, 4) + "odd" +
                           std::string(1, '\0') + "data" +
                           little(static_cast<std::uint32_t>(samples.size()), 4) + samples;
  return "RIFF" + little(static_cast<std::uint32_t>(rest.size()), 4) + rest;
}

std::string received(const SoundSource& source, std::size_t count) {
  const Descriptor& from = source.samples;
  std::string all;
  while (all.size() < count) {
    pollfd polled{from.number(), POLLIN, 0};
    if (poll(&polled, 1, 5000) <= 0) break;
    std::array<char, 64> part{};
    const ssize_t read = ::read(from.number(), part.data(), part.size());
    if (read <= 0) break;
    all.append(part.data(), static_cast<std::size_t>(read));
  }
  return all;
}

TEST(SoundSource, PlaysTheSamplesOfAWavFile) {
  const TemporaryFolder folder;
  const std::string samples = little(1, 2) + little(65535, 2) + little(4660, 2);
  const std::string path = folder.with("a.wav", wav(8192, 1, samples));
  const auto opened = open_sound("wav:" + path, 8192.0);
  ASSERT_TRUE(opened) << to_string(opened.error());
  EXPECT_EQ(received(*opened, samples.size()), samples);
}

TEST(SoundSource, RefusesOtherFiles) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& bytes) {
    const auto opened = open_sound("wav:" + folder.with("a.wav", bytes), 8192.0);
    return opened ? "none" : opened.error().what;
  };
  EXPECT_EQ(error("RIFF"), "it is not a WAV file");
  EXPECT_EQ(error(wav(44100, 1, "abcd")), "the file has 44100 samples per second, not 8192");
  EXPECT_EQ(error(wav(8192, 2, "abcd")), "the file has 2 channels, not one");
  EXPECT_EQ(open_sound("tape:deck", 8192.0).error().what, "this is no source of sound");
  EXPECT_EQ(open_sound("raw:" + folder.path() + "/no", 8192.0).error().kind, ErrorKind::kSystem);
}

TEST(SoundSource, PlaysFilesWhoseSizeTheirWriterDidNotKnow) {
  const TemporaryFolder folder;
  const std::string samples = little(1, 2) + little(65535, 2) + little(4660, 2);
  std::string bytes = wav(8192, 1, samples);
  bytes.replace(bytes.size() - samples.size() - 4, 4, little(0xFFFFFFFF, 4));
  const auto opened = open_sound("wav:" + folder.with("a.wav", bytes), 8192.0);
  ASSERT_TRUE(opened) << to_string(opened.error());
  EXPECT_EQ(received(*opened, samples.size()), samples);
  bytes.replace(bytes.size() - samples.size() - 4, 4, little(1000, 4));
  EXPECT_FALSE(open_sound("wav:" + folder.with("torn.wav", bytes), 8192.0));
}

// The messages of alsa-utils 1.2.8.
TEST(SoundSource, UnderstandsALSAsRecorder) {
  const auto fault = [](std::string_view words) {
    const auto found = fault_in_words(words, "alsa:hw:1,0");
    return found ? found->what : "none";
  };
  EXPECT_EQ(fault(""), "none");
  EXPECT_EQ(
      fault("Recording raw data 'stdin' : Signed 16 bit Little Endian, Rate 16000 Hz, Mono\n"),
      "none");
  EXPECT_EQ(
      fault("Recording raw data 'stdin'\nWarning: rate is not accurate (requested = 16000Hz, "
            "got = 44100Hz)\n         please, try the plug plugin\n"),
      "the sound device has another rate: Warning: rate is not accurate (requested = 16000Hz, "
      "got = 44100Hz)");
  EXPECT_EQ(fault("Recording\noverrun!!! (at least 300.000 ms long)\n"),
            "samples of the microphone were lost: overrun!!! (at least 300.000 ms long)");
  EXPECT_EQ(fault("arecord: main:850: audio open error: Device or resource busy\n"),
            "the sound device is in use: arecord: main:850: audio open error: Device or resource "
            "busy");
  EXPECT_EQ(ended_sound("a\narecord: main:850: audio open error: No such device\n", "alsa:x").what,
            "the recorder has ended: arecord: main:850: audio open error: No such device");
  EXPECT_EQ(ended_sound("", "alsa:x").what, "the sound has ended");
}

TEST(SoundSource, ReadsSamplesWithoutAHeader) {
  const TemporaryFolder folder;
  const auto opened = open_sound("raw:" + folder.with("a.raw", "abcd"), 8192.0);
  ASSERT_TRUE(opened);
  EXPECT_EQ(received(*opened, 4), "abcd");
}

}  // namespace
}  // namespace somato::wire
