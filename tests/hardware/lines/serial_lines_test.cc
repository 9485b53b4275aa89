#include "hardware/lines/serial_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <tuple>
#include <utility>

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
