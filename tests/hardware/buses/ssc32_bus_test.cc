#include "hardware/buses/ssc32_bus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/boards/ssc32_board.h"
#include "hardware/support/emulated_line.h"
#include "somato/core/check.h"

namespace somato::devices {
namespace {

constexpr double kNoPulse = std::numeric_limits<double>::quiet_NaN();
constexpr double kTick = 0.02;

// Answers every line with the same bytes.
class OtherBoard : public emulation::EmulatedBoard {
 public:
  explicit OtherBoard(std::string answer) : answer_(std::move(answer)) {}

  void receive(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) lines_ += byte == '\r' ? 1 : 0;
  }

  void advance(double /*now*/, std::vector<std::uint8_t>& sent) override {
    for (; lines_ > 0; --lines_) sent.insert(sent.end(), answer_.begin(), answer_.end());
  }

  void restart() override {}

 private:
  std::string answer_;
  int lines_ = 0;
};

std::string start_error(const std::string& answer) {
  OtherBoard board(answer);
  testing::EmulatedLine line(board);
  wire::Exchange exchange(line, 0);
  Ssc32Bus bus({0, 1});
  const Result<void> started = bus.start(exchange);
  return started ? "started" : started.error().what;
}

// A bus with three servos at a board.
class Ssc32BusTest : public ::testing::Test {
 protected:
  void start() {
    const Result<void> started = bus_.start(exchange_);
    ASSERT_TRUE(started) << to_string(started.error());
  }

  std::string tick(const std::vector<double>& positions) {
    const auto bytes = bus_.tick(positions, kTick);
    std::string text(bytes.begin(), bytes.end());
    EXPECT_TRUE(line_.write(0, bytes));
    pass_tick();
    return text;
  }

  void pass_tick() {
    const double until = line_.now() + kTick;
    while (line_.now() < until) {
      line_.wait(until);
      std::vector<std::uint8_t> bytes(64);
      bytes.resize(line_.read(0, bytes).value());
      if (reachable_) bus_.receive(bytes, line_.now());
    }
  }

  void receive(std::string_view text) {
    bus_.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, line_.now());
  }

  void send(std::string_view text) {
    board_.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

  emulation::Ssc32Board board_{{4, 10, 31}};
  testing::EmulatedLine line_{board_};
  wire::Exchange exchange_{line_, 0};
  Ssc32Bus bus_{{4, 10, 31}};
  bool reachable_ = true;
};

TEST_F(Ssc32BusTest, ReportsWhichChannelsHaveNoPulseWhenItStarts) {
  send("#4P1234#31P2000\r#4P15");  // with the beginning of a line that was cut short
  start();
  EXPECT_EQ(bus_.reports()[0].position, 1230.0);
  EXPECT_TRUE(std::isnan(bus_.reports()[1].position));
  EXPECT_EQ(bus_.reports()[2].position, 2000.0);
  EXPECT_EQ(bus_.reports()[1].time, line_.now());
  EXPECT_EQ(board_.driven_position(0), 1234.0);
  EXPECT_EQ(board_.driven_position(1), std::nullopt);
}

TEST_F(Ssc32BusTest, MovesOnlyWhatChanged) {
  start();
  EXPECT_EQ(tick({1500.0, 1000.4, kNoPulse}), "QP10\r#4P1500#10P1000T20\r");
  EXPECT_EQ(tick({1500.4, 1000.6, kNoPulse}), "QP31\r#10P1001T20\r");
  EXPECT_EQ(tick({1499.6, 1001.0, kNoPulse}), "QP4\r");
  EXPECT_EQ(board_.driven_position(0), 1500.0);
  EXPECT_EQ(board_.driven_position(1), 1001.0);
  EXPECT_EQ(board_.driven_position(2), std::nullopt);
}

TEST_F(Ssc32BusTest, NeverSendsWhatTheProtocolDoesNotExpress) {
  start();
  EXPECT_EQ(tick({499.4, 2500.6, 1e300}), "QP10\r");
  EXPECT_EQ(tick({499.6, 2500.4, -1500.0}), "QP31\r#4P500#10P2500T20\r");
}

TEST_F(Ssc32BusTest, ReachesPositionsWithTheTicks) {
  start();
  double position = 1000.0;
  for (int i = 0; i < 50; ++i) tick({position += 10.0, 1500.0, 2000.0});
  pass_tick();
  EXPECT_EQ(board_.driven_position(0), 1500.0);
  EXPECT_EQ(bus_.answers(), 49U);
  EXPECT_EQ(bus_.resynchronizations(), 0U);
  EXPECT_NEAR(bus_.reports()[0].position, 1500.0, 40.0);  // queried up to three ticks before
  EXPECT_EQ(bus_.reports()[2].position, 2000.0);
}

TEST_F(Ssc32BusTest, LetsTheTimeOfReportsGrowOldWhenTheBoardIsDead) {
  start();
  tick({1500.0, 1500.0, 1500.0});
  send("GOBOOT\r");
  tick({1500.0, 1500.0, 1500.0});
  const double alive = bus_.reports()[0].time;
  EXPECT_GT(alive, 0.0);
  for (int i = 0; i < 50; ++i) tick({1500.0, 1500.0, 1500.0});
  for (const ServoReport& report : bus_.reports()) EXPECT_EQ(report.time, alive);
  EXPECT_GT(bus_.resynchronizations(), 3U);
  board_.restart();
  for (int i = 0; i < 20; ++i) tick({1500.0, 1500.0, 1500.0});
  EXPECT_GT(bus_.reports()[0].time, alive + 1.0);
}

TEST_F(Ssc32BusTest, NoticesABoardThatLostItsPulses) {
  start();
  for (int i = 0; i < 6; ++i) tick({1500.0, 1500.0, 1500.0});
  board_.restart();
  for (int i = 0; i < 6; ++i) tick({kNoPulse, kNoPulse, kNoPulse});
  for (const ServoReport& report : bus_.reports()) {
    EXPECT_TRUE(std::isnan(report.position));
    EXPECT_EQ(report.error, Ssc32Bus::kRestarted);
  }
  EXPECT_NE(bus_.explain(Ssc32Bus::kRestarted).advice.find("check the supply"), std::string::npos);
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "QP10\r");  // no servo jumps
}

// Also while all its servos move, and after a time without answers.
TEST_F(Ssc32BusTest, NoticesARestartWithTheFirstAnswer) {
  for (const int ticks_without_board : {0, 1, 3, 9, 30}) {
    start();
    double position = 1000.0;
    for (int i = 0; i < 6; ++i) tick({position += 10.0, position, position});
    reachable_ = ticks_without_board == 0;
    line_.is_connected = reachable_;
    for (int i = 0; i < ticks_without_board; ++i) tick({position += 10.0, position, position});
    board_.restart();
    reachable_ = line_.is_connected = true;
    std::size_t moves = 0;
    for (int i = 0; i < 12; ++i) {
      const std::string sent = tick({position += 10.0, position, position});
      moves += sent.find('#') != std::string::npos ? 1 : 0;
    }
    std::size_t restarted = 0;
    for (const ServoReport& report : bus_.reports()) restarted += report.error;
    EXPECT_GE(restarted, 1U) << ticks_without_board;
    EXPECT_LE(moves, 1U) << ticks_without_board;
  }
}

TEST_F(Ssc32BusTest, MovesNothingBeforeTheLastQuestionIsAnswered) {
  start();
  for (int i = 0; i < 6; ++i) tick({1500.0, 1500.0, 1500.0});
  reachable_ = false;
  EXPECT_EQ(tick({1510.0, 1500.0, 1500.0}), "QP10\r#4P1510T20\r");
  EXPECT_EQ(tick({1520.0, 1500.0, 1500.0}), "");
  EXPECT_EQ(tick({1530.0, 1500.0, 1500.0}), "");
  reachable_ = true;
  receive("\x96");
  EXPECT_EQ(tick({1540.0, 1500.0, 1500.0}), "QP31\r#4P1540T60\r");  // as much slower
}

TEST_F(Ssc32BusTest, ResynchronizesAfterGarbage) {
  start();
  for (int i = 0; i < 4; ++i) tick({1500.0, 1500.0, 1500.0});
  receive("\x07");
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "\x1B\r");
  const ServoReport before = bus_.reports()[2];
  receive("\x64");  // A late answer.
  EXPECT_EQ(bus_.reports()[2].position, before.position);
  EXPECT_EQ(bus_.reports()[2].time, before.time);
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "");
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "");
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "QP31\r") << "the board may be gone";
  EXPECT_EQ(bus_.answers(), 3U);
  EXPECT_EQ(tick({1500.0, 1500.0, 1500.0}), "QP4\r#4P1500#10P1500#31P1500T100\r");
  EXPECT_EQ(bus_.resynchronizations(), 1U);
}

TEST_F(Ssc32BusTest, ResynchronizesAfterAnAnswerThatWasNotAskedFor) {
  start();
  tick({kNoPulse, kNoPulse, kNoPulse});
  receive("\x64");
  EXPECT_EQ(tick({kNoPulse, kNoPulse, kNoPulse}), "\x1B\r");
}

TEST_F(Ssc32BusTest, GivesUpALostAnswer) {
  start();
  reachable_ = false;
  std::string sent;
  for (int i = 0; i < 7; ++i) sent += tick({kNoPulse, kNoPulse, kNoPulse});
  EXPECT_EQ(sent, "QP10\r\x1B\r");
  reachable_ = true;
  for (int i = 0; i < 5; ++i) sent += tick({kNoPulse, kNoPulse, kNoPulse});
  EXPECT_EQ(bus_.answers(), 2U);
}

TEST_F(Ssc32BusTest, SwitchesAllChannelsOffEvenInTheMiddleOfALine) {
  const auto relax = bus_.relax_bytes();
  EXPECT_EQ(std::string(relax.begin(), relax.end()), "\x1B\r#4P0\r#10P0\r#31P0\r");
  start();
  tick({1500.0, 1500.0, 1500.0});
  EXPECT_EQ(bus_.relax_bytes().data(), relax.data());
  send("#4P15");
  board_.receive(relax);
  for (std::size_t servo = 0; servo < 3; ++servo) {
    EXPECT_EQ(board_.driven_position(servo), std::nullopt);
  }
}

TEST_F(Ssc32BusTest, StatesTheLongestTick) {
  // "#4P2500" "#10P2500" "#31P2500" "T65535" CR "QP31" CR and the answer
  EXPECT_EQ(bus_.bytes_per_tick(), 7U + 8U + 8U + 6U + 1U + 4U + 1U + 1U);
}

TEST_F(Ssc32BusTest, AllocatesNothingWhileItRuns) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  start();
  const std::vector<double> positions{1500.0, 1600.0, 1700.0};
  const std::vector<std::uint8_t> bytes{150, 7, 'x'};
  const testing::AllocationCounter allocations;
  for (int i = 0; i < 20; ++i) {
    bus_.tick(positions, kTick);
    bus_.receive(std::span(bytes).first(i % 4 == 0 ? 3 : 1), 1.0);
  }
  EXPECT_EQ(allocations.count(), 0U);
}

TEST(Ssc32Bus, StatesWhyItDoesNotStart) {
  EXPECT_EQ(start_error(""), "nothing answers");
  EXPECT_EQ(start_error("\xF8\xE0\x01"), "the answer is unreadable");
  EXPECT_EQ(start_error("OK\r"), "the device answers 'OK'");
  EXPECT_EQ(start_error("OK"), "the device answers 'OKOK'");
  EXPECT_EQ(start_error("SSC32-V1.0\r"), "the board does not state the pulse of channel 0");
}

TEST(Ssc32Bus, FindsASilencedBoard) {
  emulation::Ssc32Board board({0});
  constexpr std::string_view kBoot = "GOBOOT\r";
  board.receive({reinterpret_cast<const std::uint8_t*>(kBoot.data()), kBoot.size()});
  testing::EmulatedLine line(board);
  wire::Exchange exchange(line, 0);
  const Result<void> started = Ssc32Bus({0}).start(exchange);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::kSystem);
}

TEST(Ssc32Bus, DrivesAllChannelsInLinesThatFitTheBoard) {
  std::vector<int> channels;
  for (int channel = 0; channel < 32; ++channel) channels.push_back(channel);
  emulation::Ssc32Board board(channels);
  testing::EmulatedLine line(board);
  wire::Exchange exchange(line, 0);
  Ssc32Bus bus(channels);
  ASSERT_TRUE(bus.start(exchange));
  const std::vector<double> positions(32, 2345.0);
  ASSERT_TRUE(line.write(0, bus.tick(positions, kTick)));
  for (std::size_t servo = 0; servo < 32; ++servo) {
    EXPECT_EQ(board.driven_position(servo), 2345.0);
  }
  EXPECT_EQ(board.overflows(), 0U);
  EXPECT_EQ(board.register_writes(), 0U);
}

TEST(Ssc32Bus, RejectsImpossibleChannels) {
  EXPECT_THROW(Ssc32Bus({}), InvalidArgument);
  EXPECT_THROW(Ssc32Bus({32}), InvalidArgument);
  EXPECT_THROW(Ssc32Bus({1, 1}), InvalidArgument);
}

}  // namespace
}  // namespace somato::devices
