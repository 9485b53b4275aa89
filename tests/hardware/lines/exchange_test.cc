#include "hardware/lines/exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "hardware/lines/serial_lines.h"

namespace somato::wire {
namespace {

TEST(Exchange, AsksAgainUntilTheAnswerIsComplete) {
  const auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}}, 100.0);
  Exchange exchange(**lines, 0);
  const std::array<std::uint8_t, 1> request{'?'};
  const auto none =
      exchange.request(request, 0.01, 3, [](std::span<const std::uint8_t>) { return true; });
  ASSERT_TRUE(none);
  EXPECT_FALSE(*none);
  std::array<std::uint8_t, 8> received{};
  EXPECT_EQ(*read_available(terminal->device.number(), received, ""), 3U);
}

TEST(Exchange, GivesEverythingThatArrivesUntilTheAnswerIsComplete) {
  const auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}});
  Exchange exchange(**lines, 0);
  const std::array<std::uint8_t, 3> sent{7, 8, 9};
  EXPECT_EQ(*write_available(terminal->device.number(), sent, ""), 3U);
  std::size_t count = 0;
  const auto complete = exchange.receive(60.0, [&](std::span<const std::uint8_t> bytes) {
    count += bytes.size();
    return count == 3;
  });
  ASSERT_TRUE(complete);
  EXPECT_TRUE(*complete);
  EXPECT_EQ(count, 3U);
}

// A board that echoes each byte 0.15 s later.
class LateLine : public Lines {
 public:
  double now() const override { return now_; }
  Result<std::size_t> read(std::size_t /*line*/, std::span<std::uint8_t> bytes) override {
    if (answers_.empty() || answers_.front().first > now_) return 0;
    bytes[0] = answers_.front().second;
    answers_.pop_front();
    return 1;
  }
  Result<std::size_t> write(std::size_t /*line*/, std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) answers_.emplace_back(now_ + 0.15, byte);
    ++requests;
    return bytes.size();
  }
  void wait(double until) override { now_ = std::min(until, now_ + 0.001); }
  Result<void> reopen(std::size_t /*line*/) override { return {}; }

  std::size_t requests = 0;

 private:
  double now_ = 0.0;
  std::deque<std::pair<double, std::uint8_t>> answers_;
};

TEST(Exchange, TakesALateAnswerForThatOfNoOtherRequest) {
  LateLine line;
  Exchange exchange(line, 0);
  for (const std::uint8_t letter : std::array<std::uint8_t, 3>{1, 2, 3}) {
    std::uint8_t answer = 0;
    const auto complete = exchange.request({&letter, 1}, 0.1, 3, [&](auto bytes) {
      answer = bytes[0];
      return true;
    });
    ASSERT_TRUE(complete && *complete);
    EXPECT_EQ(answer, letter);
  }
}

TEST(Exchange, WaitsAtLeastForItsPatience) {
  LateLine line;
  Exchange exchange(line, 0, 0.2);
  const std::array<std::uint8_t, 1> request{7};
  const auto complete = exchange.request(request, 0.1, 3, [](auto) { return true; });
  EXPECT_TRUE(complete && *complete);
  EXPECT_EQ(line.requests, 1U);
}

}  // namespace
}  // namespace somato::wire
