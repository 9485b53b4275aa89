#include "hardware/boards/ssc32_board.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/check.h"

namespace somato::emulation {
namespace {

// A board with the channels 0 to 3, to which text is sent at given times.
class Ssc32BoardTest : public ::testing::Test {
 protected:
  void send(std::string_view text) {
    board_.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

  // The board's bytes until `milliseconds`.
  std::string until(double milliseconds) {
    std::vector<std::uint8_t> sent;
    board_.advance(milliseconds / 1e3, sent);
    return {sent.begin(), sent.end()};
  }

  std::string answer_to(std::string_view text) {
    send(text);
    now_ += 1e-6;
    return until(now_);
  }

  std::optional<double> at(double milliseconds, std::size_t servo) {
    now_ = milliseconds;
    EXPECT_EQ(until(milliseconds), "");
    return board_.driven_position(servo);
  }

  Ssc32Board board_{{0, 1, 2, 3}, "SSC32-V2.01XE"};
  double now_ = 0.0;
};

TEST_F(Ssc32BoardTest, JumpsAtTheFirstMoveAndMovesInStepsAfterwards) {
  EXPECT_EQ(board_.driven_position(0), std::nullopt);
  send("#0P1000T500\r");
  EXPECT_EQ(board_.driven_position(0), 1000.0);
  send("#0P2000T100\r");  // 10 us a millisecond, in steps of 20 ms
  EXPECT_EQ(at(19, 0), 1000.0);
  EXPECT_EQ(at(20, 0), 1200.0);
  EXPECT_EQ(at(39.9, 0), 1200.0);
  EXPECT_EQ(at(80, 0), 1800.0);
  EXPECT_EQ(at(100, 0), 2000.0);
  EXPECT_EQ(at(500, 0), 2000.0);
}

TEST_F(Ssc32BoardTest, EndsAGroupTogether) {
  send("#0P1000#1P1000\r");
  // Channel 0 needs 1000 us / (2000 us/s) = 500 ms, channel 1 only 100 us / (1000 us/s) = 100 ms.
  send("#0P2000S2000#1P1100S1000T200\r");
  EXPECT_EQ(at(240, 0), 1480.0);
  EXPECT_EQ(board_.driven_position(1), 1048.0);
  EXPECT_EQ(at(480, 0), 1960.0);
  EXPECT_EQ(answer_to("Q\r"), "+");
  EXPECT_EQ(at(500, 0), 2000.0);
  EXPECT_EQ(board_.driven_position(1), 1100.0);
  EXPECT_EQ(answer_to("Q\r"), ".");
}

TEST_F(Ssc32BoardTest, UsesTheTimeWhereItIsLonger) {
  send("#0P1000\r#0P1100S1000T400\r");
  EXPECT_EQ(at(200, 0), 1050.0);
}

TEST_F(Ssc32BoardTest, MovesAtTheNextStepWithoutTimeAndSpeed) {
  send("#0P1000\r#0P2000\r");
  EXPECT_EQ(at(19, 0), 1000.0);
  EXPECT_EQ(at(20, 0), 2000.0);
}

TEST_F(Ssc32BoardTest, ReportsTheLastGroupOnly) {
  send("#0P1000#1P1000\r#0P2000T1000\r#1P1000\r");
  EXPECT_EQ(at(40, 1), 1000.0);
  EXPECT_EQ(answer_to("q\r"), ".");
  EXPECT_EQ(at(1000, 0), 2000.0);
}

TEST_F(Ssc32BoardTest, ReportsTheCommandedPulse) {
  board_.set_measured(0, 777.0, 5.0);
  EXPECT_EQ(answer_to("QP0\r"), std::string(1, '\0'));
  send("#0P1519\r#0PO100\r");
  EXPECT_EQ(board_.driven_position(0), 1619.0);
  EXPECT_EQ(answer_to("QP 0\r"), "\x97");  // 151
  EXPECT_EQ(answer_to("QP0 QP1\r"), std::string("\x97\0", 2));
}

TEST_F(Ssc32BoardTest, SwitchesPulsesOff) {
  send("#0P1500#1P1500#2P1500\r#0P0\r#1L\r");
  EXPECT_EQ(board_.driven_position(0), std::nullopt);
  EXPECT_EQ(board_.driven_position(1), std::nullopt);
  EXPECT_EQ(board_.driven_position(2), 1500.0);
  send("#0P2000T1000\r");
  EXPECT_EQ(board_.driven_position(0), 2000.0);
}

TEST_F(Ssc32BoardTest, StopsAChannel) {
  send("#0P1000#1P1000\r#0P2000#1P2000T100\r");
  at(40, 0);
  send("STOP 0\r");
  EXPECT_EQ(at(100, 0), 1400.0);
  EXPECT_EQ(board_.driven_position(1), 2000.0);
}

TEST_F(Ssc32BoardTest, AnswersInputsAndVersion) {
  board_.set_analog(1, 128);
  board_.set_digital(2, true);
  EXPECT_EQ(answer_to("VA VB\r"), std::string("\0\x80", 2));
  EXPECT_EQ(answer_to("A B C D\r"), "0010");
  EXPECT_EQ(answer_to("ver\r"), "SSC32-V2.01XE\r");
  send("#1:170\r");
  EXPECT_EQ(board_.outputs(1), 170);
}

TEST_F(Ssc32BoardTest, DropsWhatItDoesNotUnderstandWithoutASign) {
  EXPECT_EQ(answer_to("HELLO\rVAVB\r#0P1500 X\r"), "");
  EXPECT_EQ(board_.driven_position(0), std::nullopt);
}

TEST_F(Ssc32BoardTest, CancelsALineAtEscape) {
  EXPECT_EQ(answer_to("#0P15\x1BVER\r"), "SSC32-V2.01XE\r");
  send("#0P15");
  send("00\r");
  EXPECT_EQ(board_.driven_position(0), 1500.0);
}

TEST_F(Ssc32BoardTest, DropsALineThatOverflowsTheQueue) {
  send("#0P1500" + std::string(120, ' ') + "\r");  // 128 bytes
  EXPECT_EQ(board_.driven_position(0), 1500.0);
  EXPECT_EQ(board_.overflows(), 0U);
  send("#0P1600" + std::string(121, ' ') + "\r");
  EXPECT_EQ(board_.overflows(), 1U);
  EXPECT_EQ(at(20, 0), 1500.0);
}

TEST_F(Ssc32BoardTest, FallsSilentAtGoboot) {
  send("#0P1500\rgoboot\r");
  EXPECT_EQ(answer_to("VER\rQ\r"), "");
  EXPECT_TRUE(board_.silenced());
  EXPECT_EQ(board_.driven_position(0), std::nullopt);
  board_.restart();
  EXPECT_EQ(answer_to("Q\r"), ".");
}

TEST_F(Ssc32BoardTest, CountsRegisterWrites) {
  send("R4=1\rR4\r");
  board_.restart();
  EXPECT_EQ(board_.register_writes(), 1U);
}

TEST_F(Ssc32BoardTest, LosesItsPulsesWhenItRestarts) {
  send("#0P1500\r#0PO50\r#1P15");
  board_.restart();
  EXPECT_EQ(board_.driven_position(0), std::nullopt);
  send("#0P1500\r");
  EXPECT_EQ(board_.driven_position(0), 1500.0);
}

TEST(Ssc32Board, RejectsImpossibleChannels) {
  EXPECT_THROW(Ssc32Board({32}), InvalidArgument);
  EXPECT_THROW(Ssc32Board({-1}), InvalidArgument);
  EXPECT_THROW(Ssc32Board({1, 2, 1}), InvalidArgument);
}

}  // namespace
}  // namespace somato::emulation
