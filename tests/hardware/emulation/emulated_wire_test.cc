#include "hardware/emulation/emulated_wire.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hardware/emulation/emulated_lines.h"

namespace somato::emulation {
namespace {

// Sends back what it receives.
class Mirror : public EmulatedBoard {
 public:
  void receive(std::span<const std::uint8_t> bytes) override {
    received.insert(received.end(), bytes.begin(), bytes.end());
    answer_.insert(answer_.end(), bytes.begin(), bytes.end());
  }
  void advance(double /*now*/, std::vector<std::uint8_t>& sent) override {
    sent.insert(sent.end(), answer_.begin(), answer_.end());
    answer_.clear();
  }
  void restart() override {}

  std::vector<std::uint8_t> received;

 private:
  std::vector<std::uint8_t> answer_;
};

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string arrived(EmulatedWire& wire) {
  std::array<std::uint8_t, 64> bytes{};
  const std::size_t count = wire.receive(bytes);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST(EmulatedWire, TakesTenBitsForAByte) {
  Mirror board;
  EmulatedWire wire(board, 1000.0);  // a byte takes 10 ms
  wire.send(bytes_of("abc"), 0.0);
  wire.advance(0.009);
  EXPECT_TRUE(board.received.empty());
  wire.advance(0.021);
  EXPECT_EQ(board.received, bytes_of("ab"));
  wire.advance(0.0305);
  EXPECT_EQ(board.received, bytes_of("abc"));
  EXPECT_FALSE(wire.has_arrived());
  wire.advance(0.0405);  // "ab" left the board at 21 ms
  EXPECT_EQ(arrived(wire), "a");
}

TEST(EmulatedWire, AcceptsNoMoreThanItsBufferHolds) {
  Mirror board;
  EmulatedWire wire(board, 1000.0);
  const std::vector<std::uint8_t> much(5000);
  EXPECT_EQ(wire.send(much, 0.0), 4096U);
  EXPECT_EQ(wire.send(much, 0.0), 0U);
  wire.advance(0.1005);  // ten bytes later
  EXPECT_EQ(wire.send(much, 0.1005), 10U);
}

TEST(EmulatedWire, HasFaults) {
  Mirror board;
  EmulatedWire wire(board, 0.0);
  wire.faults.garbage = bytes_of("?!");
  wire.faults.echo = true;
  wire.send(bytes_of("x"), 0.0);
  wire.advance(0.001);
  EXPECT_EQ(arrived(wire), "x?!x");
  wire.faults.silent = true;
  wire.faults.echo = false;
  wire.send(bytes_of("y"), 0.001);
  wire.advance(0.002);
  EXPECT_FALSE(wire.has_arrived());
  EXPECT_EQ(board.received, bytes_of("xy"));
  wire.faults.deaf = true;
  wire.send(bytes_of("z"), 0.002);
  wire.advance(0.003);
  EXPECT_EQ(board.received, bytes_of("xy"));
}

TEST(EmulatedWire, InvertsOneBitOfTheDeclaredShareOfBytes) {
  Mirror board;
  EmulatedWire wire(board, 0.0, 7);
  wire.faults.flipped = 0.1;
  for (int i = 0; i < 100; ++i) {
    wire.send(std::vector<std::uint8_t>(100, 0), i);
    wire.advance(i + 0.5);
  }
  std::size_t flipped = 0;
  for (const std::uint8_t byte : board.received) {
    flipped += byte != 0 ? 1 : 0;
    EXPECT_EQ(byte & (byte - 1), 0);  // at most one bit
  }
  EXPECT_NEAR(static_cast<double>(flipped), 1000.0, 120.0);  // four standard deviations
}

TEST(EmulatedLines, LetTimePassOnlyWhileTheHostWaits) {
  Mirror board;
  EmulatedWire wire(board, 0.0);
  std::vector<double> times;
  EmulatedLines lines({&wire}, [&](double now) { times.push_back(now); });
  EXPECT_EQ(lines.now(), 0.0);
  lines.wait(0.0025);
  EXPECT_EQ(times, (std::vector<double>{0.001, 0.002, 0.0025}));
  EXPECT_EQ(*lines.write(0, bytes_of("a")), 1U);
  lines.wait(1.0);  // until the answer
  EXPECT_DOUBLE_EQ(lines.now(), 0.0035);
  std::array<std::uint8_t, 4> read{};
  EXPECT_EQ(*lines.read(0, read), 1U);
  wire.faults.hung_up = true;
  EXPECT_EQ(lines.read(0, read).error().what, "the line has hung up");
  EXPECT_EQ(lines.write(0, read).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato::emulation
