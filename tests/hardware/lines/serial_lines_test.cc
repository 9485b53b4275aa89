#include "hardware/lines/serial_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>

#include "base/support/temporary_folder.h"

namespace somato::wire {
namespace {

TEST(SerialLines, WaitsForBytesOrForTheTime) {
  const auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}});
  ASSERT_TRUE(lines) << to_string(lines.error());
  const double before = (*lines)->now();
  (*lines)->wait(before + 0.01);
  EXPECT_GE((*lines)->now(), before + 0.01);
  const std::array<std::uint8_t, 3> sent{1, 2, 3};
  std::ignore = write_available(terminal->device.number(), sent, "");
  (*lines)->wait((*lines)->now() + 60.0);
  std::array<std::uint8_t, 8> read{};
  EXPECT_EQ(*(*lines)->read(0, read), 3U);
  EXPECT_EQ(read[2], 3);
}

TEST(SerialLines, NoticesAHangUpWhileWaitingAndOpensAgain) {
  auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}});
  ASSERT_TRUE(lines);
  {
    const Descriptor gone = std::move(terminal->device);
  }
  (*lines)->wait((*lines)->now() + 60.0);
  std::array<std::uint8_t, 8> read{};
  const auto failed = (*lines)->read(0, read);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().what, "the line has hung up");
  EXPECT_EQ(failed.error().where, terminal->port);
  const auto again = (*lines)->reopen(0);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, ErrorKind::kSystem);
}

// A recorder in the place of ALSA's, which says `words` and then sends samples for ever.
class SerialLinesSound : public ::testing::Test {
 protected:
  void have_recorder_say(const std::string& words, const std::string& then) {
    const std::string path =
        folder_.with("arecord", "#!/bin/sh\necho \"$LC_ALL $*\" > " + folder_.file("arguments") +
                                    "\necho '" + words + "' >&2\n" + then + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path() + ":" + path_).c_str(), 1);
  }
  ~SerialLinesSound() override { setenv("PATH", path_.c_str(), 1); }

  // The error with which reading fails, sooner or later.
  static Error failure(wire::Lines& lines) {
    std::array<std::uint8_t, 512> read{};
    for (;;) {
      const auto count = lines.read(0, read);
      if (!count) return count.error();
      lines.wait(lines.now() + 0.01);
    }
  }

  static constexpr const char* kForEver = "while :; do printf 0000000000000000; done";
  TemporaryFolder folder_;
  std::string path_ = getenv("PATH");
};

TEST_F(SerialLinesSound, FailsWhenTheRecorderLosesSamples) {
  have_recorder_say("overrun!!! (at least 300.000 ms long)", kForEver);
  const auto lines = SerialLines::open({{"alsa:hw:1,0", 0, 16000.0}});
  ASSERT_TRUE(lines) << to_string(lines.error());
  const Error lost = failure(**lines);
  EXPECT_EQ(lost.kind, ErrorKind::kSystem);
  EXPECT_EQ(lost.what,
            "samples of the microphone were lost: overrun!!! (at least 300.000 ms long)");
  EXPECT_EQ(lost.where, "alsa:hw:1,0");
  EXPECT_EQ(somato::bytes_of(folder_.file("arguments")),
            "C -D hw:1,0 -t raw -f S16_LE -c 1 -r 16000\n");
  // Opened again, it is another recorder.
  have_recorder_say("Recording raw data", "printf abcd; sleep 100");
  ASSERT_TRUE((*lines)->reopen(0));
  std::array<std::uint8_t, 8> read{};
  std::size_t count = 0;
  while (count == 0) {
    (*lines)->wait((*lines)->now() + 60.0);
    const auto arrived = (*lines)->read(0, read);
    ASSERT_TRUE(arrived) << to_string(arrived.error());
    count = *arrived;
  }
  EXPECT_EQ(read[0], 'a');
}

TEST_F(SerialLinesSound, SaysThatTheDeviceIsInUse) {
  have_recorder_say("arecord: main:850: audio open error: Device or resource busy", "exit 1");
  const auto lines = SerialLines::open({{"alsa:hw:1,0", 0, 16000.0}});
  ASSERT_TRUE(lines) << to_string(lines.error());
  const Error busy = failure(**lines);
  EXPECT_EQ(busy.what,
            "the sound device is in use: arecord: main:850: audio open error: Device or resource "
            "busy");
  EXPECT_EQ(busy.advice, "end the program that uses it; 'fuser -v /dev/snd/*' names it");
}

// A stopped hand holds at the pace of its period although its sensors have hung up.
TEST(SerialLines, WaitsBesideALineThatHasHungUp) {
  const auto servos = open_pseudo_terminal();
  auto sensors = open_pseudo_terminal();
  const auto lines = SerialLines::open({{servos->port, 115200}, {sensors->port, 115200}});
  ASSERT_TRUE(lines) << to_string(lines.error());
  {
    const Descriptor gone = std::move(sensors->device);
  }
  (*lines)->wait((*lines)->now() + 60.0);
  std::array<std::uint8_t, 8> read{};
  ASSERT_FALSE((*lines)->read(1, read));
  const double before = (*lines)->now();
  (*lines)->wait(before + 0.02);
  EXPECT_GE((*lines)->now(), before + 0.02);
}

TEST(SerialLines, ScalesTheClockOfAnEmulator) {
  const auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}}, 1000.0);
  const double before = (*lines)->now();
  (*lines)->wait(before + 5.0);  // 5 ms
  EXPECT_GE((*lines)->now(), before + 5.0);
}

}  // namespace
}  // namespace somato::wire
