#include "hardware/lines/line_clock.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "hardware/lines/serial_lines.h"

namespace somato::wire {
namespace {

// The emulator's side: answers so many requests with the times that `answer` gives, and ends in
// join().
class Emulator {
 public:
  Emulator() : port_(LineClockPort::open().value()) {}
  Emulator(const Emulator&) = delete;
  Emulator(Emulator&&) = delete;
  Emulator& operator=(const Emulator&) = delete;
  Emulator& operator=(Emulator&&) = delete;
  ~Emulator() { join(); }

  std::string port() const { return name_; }

  // In another thread.
  template <typename Answer>
  void answer(std::size_t requests, Answer answer) {
    thread_ = std::thread([this, requests, answer] {
      for (std::size_t done = 0; done < requests;) {
        const auto until = port_->requested();
        if (!until) continue;
        port_->answer(answer(*until));
        ++done;
      }
    });
  }

  void join() {
    if (thread_.joinable()) thread_.join();
    port_.reset();
  }

 private:
  std::optional<LineClockPort> port_;
  std::string name_ = port_->port();
  std::thread thread_;
};

TEST(LineClockThread, HasTheTimeOfTheEmulator) {
  Emulator emulator;
  emulator.answer(3, [](double until) { return until < 10.0 ? 10.0 : 0.5 * (10.0 + until); });
  auto clock = LineClock::open(emulator.port());
  ASSERT_TRUE(clock) << to_string(clock.error());
  EXPECT_EQ(clock->now(), 10.0);  // It did not begin with this host.
  EXPECT_TRUE(clock->wait(12.0));
  EXPECT_EQ(clock->now(), 11.0);  // Bytes arrived before.
  EXPECT_TRUE(clock->wait(10.3));
  EXPECT_EQ(clock->now(), 11.0);  // It never goes back.
}

TEST(LineClockThread, PassesTimeWithoutAnEmulatorThatHasEnded) {
  Emulator emulator;
  emulator.answer(1, [](double until) { return until; });
  auto clock = LineClock::open(emulator.port());
  ASSERT_TRUE(clock) << to_string(clock.error());
  emulator.join();
  const auto waited = clock->wait(3.0);
  ASSERT_FALSE(waited);
  EXPECT_EQ(waited.error().where, emulator.port());
  EXPECT_EQ(clock->now(), 3.0);
}

// The emulator may still answer a host that was killed.
TEST(LineClockThread, IgnoresAnAnswerToAnotherHost) {
  auto port = LineClockPort::open();
  ASSERT_TRUE(port);
  EXPECT_FALSE(port->requested());
  std::optional<LineClock> clock;
  std::thread host([&] {
    auto opened = LineClock::open(port->port());
    if (opened) clock = *std::move(opened);
  });
  while (!port->requested()) std::this_thread::yield();
  const std::string late = "7 9\n";
  const std::vector<std::uint8_t> bytes(late.begin(), late.end());
  std::ignore = write_available(port->descriptor(), bytes, port->port());
  port->answer(5.0);
  host.join();
  ASSERT_TRUE(clock);
  EXPECT_EQ(clock->now(), 5.0);
}

TEST(LineClockThread, IsThatOfLinesWhoseBytesArriveBeforeTheAnswer) {
  const auto terminal = open_pseudo_terminal();
  Emulator emulator;
  emulator.answer(100, [&](double until) {
    const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(until)};
    if (until > 0.0) std::ignore = write_available(terminal->device.number(), byte, "");
    return until;
  });
  const auto lines = SerialLines::open({{terminal->port, 115200}}, 5.0, emulator.port());
  ASSERT_TRUE(lines) << to_string(lines.error());
  EXPECT_EQ((*lines)->clock(), 1.0);
  std::array<std::uint8_t, 8> read{};
  for (std::uint8_t second = 1; second < 100; ++second) {
    (*lines)->wait(second);
    EXPECT_EQ((*lines)->now(), second);
    ASSERT_EQ(*(*lines)->read(0, read), 1U);
    EXPECT_EQ(read[0], second);
  }
  emulator.join();
  (*lines)->wait(200.0);
  EXPECT_FALSE((*lines)->read(0, read));  // Its emulator has ended, and so have they.
  EXPECT_EQ((*lines)->now(), 200.0);
}

}  // namespace
}  // namespace somato::wire
