#include "hardware/protocols/ssc32.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "base/support/no_malloc.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

std::string text_of(const Ssc32Commands& commands) {
  return {commands.bytes().begin(), commands.bytes().end()};
}

std::vector<std::string> lines_of(const Ssc32Commands& commands) {
  std::vector<std::string> lines(1);
  for (const char c : text_of(commands)) {
    lines.back() += c;
    if (c == '\r') lines.emplace_back();
  }
  EXPECT_EQ(lines.back(), "");
  lines.pop_back();
  return lines;
}

std::string error_of(const Result<void>& result) {
  return result ? "accepted" : to_string(result.error());
}

// By hand from the protocol: # channel, P pulse, S speed of the pulse before, T time, CR.
TEST(Ssc32, WritesAGroupMove) {
  Ssc32Commands commands;
  ASSERT_TRUE(commands.move(std::array{Ssc32Move{5, 1600, 750}}, 1000));
  EXPECT_EQ(text_of(commands), "#5P1600S750T1000\r");
  commands.clear();
  ASSERT_TRUE(commands.move(std::array{Ssc32Move{0, 500}, Ssc32Move{31, 2500}}, 0));
  EXPECT_EQ(text_of(commands), "#0P500#31P2500\r");
}

TEST(Ssc32, WritesTheOtherCommands) {
  Ssc32Commands commands;
  ASSERT_TRUE(commands.resynchronize());
  ASSERT_TRUE(commands.query_version());
  ASSERT_TRUE(commands.stop(7));
  ASSERT_TRUE(commands.pulse_off(12));
  ASSERT_TRUE(commands.offset(3, -100));
  ASSERT_TRUE(commands.query_moving());
  ASSERT_TRUE(commands.query_pulse(31));
  ASSERT_TRUE(commands.line("VA VB"));
  EXPECT_EQ(text_of(commands), "\x1B\rVER\rSTOP7\r#12P0\r#3PO-100\rQ\rQP31\rVA VB\r");
}

TEST(Ssc32, WritesNothingForAnEmptyGroup) {
  Ssc32Commands commands;
  ASSERT_TRUE(commands.move({}, 20));
  EXPECT_TRUE(commands.bytes().empty());
}

std::vector<Ssc32Move> random_group(Random& random) {
  std::vector<Ssc32Move> group(random.below(kSsc32Channels + 1));
  std::array<int, kSsc32Channels> channels{};
  std::iota(channels.begin(), channels.end(), 0);
  for (std::size_t i = 0; i < group.size(); ++i) {
    std::swap(channels[i], channels[i + random.below(channels.size() - i)]);
    group[i] = {channels[i], static_cast<int>(500 + random.below(2001)),
                static_cast<int>(random.below(2) * random.below(65536))};
  }
  return group;
}

// The obvious way: one string for each channel.
std::string plain_text(const Ssc32Move& move) {
  std::string text = "#" + std::to_string(move.channel) + "P" + std::to_string(move.pulse);
  if (move.speed > 0) text += "S" + std::to_string(move.speed);
  return text;
}

TEST(Ssc32, SplitsGroupsIntoLinesThatFitTheQueue) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Ssc32Move> group = random_group(random);
    const int time = static_cast<int>(random.below(65536));
    Ssc32Commands commands;
    ASSERT_TRUE(commands.move(group, time));
    const std::string ending = (time > 0 ? "T" + std::to_string(time) : "") + "\r";
    std::string joined;
    for (const std::string& line : lines_of(commands)) {
      ASSERT_LE(line.size(), kSsc32Queue);
      ASSERT_TRUE(line.ends_with(ending));
      joined += line.substr(0, line.size() - ending.size());
    }
    std::string expected;
    for (const Ssc32Move& move : group) expected += plain_text(move);
    ASSERT_EQ(joined, expected);
  }
}

TEST(Ssc32, FillsALineToTheLastByteOfTheQueue) {
  // 15 channels of 8 bytes, T6553 and CR: 126 bytes; with T65535 127; one more channel exceeds it.
  std::vector<Ssc32Move> group;
  for (int channel = 10; channel < 25; ++channel) group.push_back({channel, 1500});
  Ssc32Commands commands;
  ASSERT_TRUE(commands.move(group, 65535));
  EXPECT_EQ(lines_of(commands).size(), 1U);
  EXPECT_EQ(commands.bytes().size(), 127U);
  commands.clear();
  group.front().speed = 0;
  group.push_back({1, 500});  // 6 bytes: 15 * 8 + 6 + 1 = 127 without a time.
  ASSERT_TRUE(commands.move(group, 0));
  EXPECT_EQ(lines_of(commands).size(), 1U);
  group.back() = {10, 1500, 0};
  group.front() = {1, 1500, 0};  // 7 + 15 * 8 + 1 = 128.
  commands.clear();
  ASSERT_TRUE(commands.move(group, 0));
  EXPECT_EQ(lines_of(commands).size(), 1U);
  EXPECT_EQ(commands.bytes().size(), 128U);
  group.front() = {25, 1500, 0};  // 129.
  commands.clear();
  ASSERT_TRUE(commands.move(group, 0));
  EXPECT_EQ(lines_of(commands).size(), 2U);
}

TEST(Ssc32, RefusesNumbersOutsideTheirRanges) {
  Ssc32Commands commands;
  EXPECT_EQ(error_of(commands.move(std::array{Ssc32Move{32, 1500}}, 0)),
            "SSC-32: channel 32 is outside 0 to 31");
  EXPECT_EQ(error_of(commands.move(std::array{Ssc32Move{0, 499}}, 0)),
            "SSC-32: a pulse of 499 us is outside 500 to 2500 us");
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{0, 2501}}, 0));
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{-1, 1500}}, 0));
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{0, 1500, -1}}, 0));
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{0, 1500, 65536}}, 0));
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{0, 1500}}, 65536));
  EXPECT_FALSE(commands.move(std::array{Ssc32Move{0, 1500}}, -1));
  EXPECT_EQ(error_of(commands.offset(0, 101)),
            "SSC-32: an offset of 101 us is outside -100 to 100 us");
  EXPECT_FALSE(commands.offset(0, -101));
  EXPECT_FALSE(commands.offset(32, 0));
  EXPECT_FALSE(commands.stop(-1));
  EXPECT_FALSE(commands.pulse_off(32));
  EXPECT_FALSE(commands.query_pulse(32));
  EXPECT_TRUE(commands.bytes().empty());
}

TEST(Ssc32, RefusesAChannelTwiceInAGroup) {
  Ssc32Commands commands;
  EXPECT_EQ(error_of(commands.move(std::array{Ssc32Move{3, 1500}, Ssc32Move{3, 1600}}, 0)),
            "SSC-32: channel 3 is in the group twice");
}

TEST(Ssc32, RefusesLinesThatWearOrSilenceTheBoard) {
  Ssc32Commands commands;
  for (const std::string_view line :
       {"GOBOOT", "goboot", "GoBoot 1", "XGOBOOT", "R4=1", "r 4 = 1", "#1P1500R4=1", "RDFLT", "EEW",
        "#1P400", "#32P1500", "#1PO150", "#1P", "STOP", "QP99", "#1P1500T70000", "VER\r", "\x1B",
        "#1P1500S-5"}) {
    EXPECT_FALSE(commands.line(line)) << line;
  }
  EXPECT_FALSE(commands.line(std::string(128, ' ')));
  EXPECT_TRUE(commands.bytes().empty());
  EXPECT_EQ(error_of(commands.line("GOBOOT")),
            "SSC-32: GOBOOT silences the board or wears its memory");
}

TEST(Ssc32, AcceptsOtherLines) {
  Ssc32Commands commands;
  for (const std::string_view line :
       {"#1P0", "#1L #2L", "#0:255", "A B C D", "R4", "Q", "ver", "#1P1500S0T0"}) {
    EXPECT_TRUE(commands.line(line)) << line;
  }
  EXPECT_TRUE(commands.line(std::string(127, ' ')));
}

TEST(Ssc32, KeepsWhatIsThereWhenSomethingDoesNotFit) {
  Ssc32Commands commands;
  while (commands.bytes().size() + 30 <= Ssc32Commands::kCapacity) {
    ASSERT_TRUE(commands.query_version());
  }
  const std::size_t before = commands.bytes().size();
  std::vector<Ssc32Move> group;
  for (int channel = 0; channel < 32; ++channel) group.push_back({channel, 1500});
  EXPECT_FALSE(commands.move(group, 20));
  EXPECT_EQ(commands.bytes().size(), before);
  EXPECT_FALSE(commands.line(std::string(100, ' ')));
  EXPECT_EQ(commands.bytes().size(), before);
}

TEST(Ssc32, DecodesAnswers) {
  EXPECT_EQ(ssc32_moving('.'), false);
  EXPECT_EQ(ssc32_moving('+'), true);
  EXPECT_EQ(ssc32_moving(150), std::nullopt);
  EXPECT_EQ(ssc32_pulse(0), 0);
  EXPECT_EQ(ssc32_pulse(50), 500);
  EXPECT_EQ(ssc32_pulse(153), 1530);
  EXPECT_EQ(ssc32_pulse(250), 2500);
  for (const int byte : {1, 49, 251, 255, int{'.'}, int{'+'}}) {
    EXPECT_EQ(ssc32_pulse(static_cast<std::uint8_t>(byte)), std::nullopt) << byte;
  }
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Ssc32, CollectsTheVersion) {
  Ssc32Version version;
  EXPECT_FALSE(version.take(bytes_of("SSC32-V")));
  EXPECT_FALSE(version.complete());
  EXPECT_TRUE(version.take(bytes_of("2.50\rQ")));
  EXPECT_EQ(version.text(), "SSC32-V2.50");
  EXPECT_FALSE(version.unreadable());
}

TEST(Ssc32, NoticesBytesThatNoVersionContains) {
  Ssc32Version version;
  EXPECT_FALSE(version.take(bytes_of("\xF8\x01g")));
  EXPECT_TRUE(version.unreadable());
  EXPECT_EQ(version.text(), "??g");
  for (int i = 0; i < 20; ++i) version.take(bytes_of("0123456789"));
  EXPECT_EQ(version.text().size(), 64U);
}

TEST(Ssc32, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  std::vector<Ssc32Move> group;
  for (int channel = 0; channel < 32; ++channel) group.push_back({channel, 1500, 100});
  Ssc32Commands commands;
  Ssc32Version version;
  const testing::AllocationCounter allocations;
  const bool moved = commands.move(group, 20) && commands.query_pulse(1) && commands.offset(1, 5) &&
                     commands.line("VA VB");
  const bool complete = version.take(bytes_of("SSC32\r"));
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_TRUE(moved && complete);
}

}  // namespace
}  // namespace somato::wire
