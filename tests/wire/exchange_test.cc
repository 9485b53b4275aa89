#include "wire/exchange.h"

#include <gtest/gtest.h>

#include <array>

#include "wire/serial_lines.h"

namespace somato::wire {
namespace {

TEST(Exchange, AsksAgainUntilTheAnswerIsComplete) {
  const auto terminal = open_pseudo_terminal();
  const auto lines = SerialLines::open({{terminal->port, 115200}}, 100.0);
  Exchange exchange(**lines, 0);
  const std::array<std::uint8_t, 1> request{'?'};
  const auto none =
      exchange.request(request, 0.1, 3, [](std::span<const std::uint8_t>) { return true; });
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

}  // namespace
}  // namespace somato::wire
