#include "hardware/protocols/number_line.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/support/damaged_sensor_stream.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

std::string encoded_line(const std::vector<float>& values) {
  std::vector<std::uint8_t> bytes(kMostNumberBytes * values.size());
  bytes.resize(encode_number_line(values, bytes));
  return {bytes.begin(), bytes.end()};
}

std::size_t lines_in(NumberLineDecoder& decoder, std::string_view text) {
  std::size_t lines = 0;
  for (const char c : text) lines += decoder.take(static_cast<std::uint8_t>(c)) ? 1 : 0;
  return lines;
}

std::vector<float> read_line(std::string_view text) {
  NumberLineDecoder decoder(3);
  lines_in(decoder, "\n");
  if (lines_in(decoder, text) == 0) return {};
  return {decoder.values().begin(), decoder.values().end()};
}

TEST(NumberLine, WritesNumbers) {
  EXPECT_EQ(encoded_line({1.0F, -0.5F, 0.1F}), "1,-0.5,0.1\n");
  EXPECT_EQ(encoded_line({1023.0F}), "1023\n");
  EXPECT_EQ(encoded_line({1.0F, std::numeric_limits<float>::quiet_NaN()}), "1,nan\n");
}

TEST(NumberLine, ReadsNumbersAsSketchesPrintThem) {
  const std::vector<float> expected{1.0F, -2.5F, 300.0F};
  EXPECT_EQ(read_line("1,-2.5,300\n"), expected);
  EXPECT_EQ(read_line("1.00,-2.50,300.00\r\n"), expected);
  EXPECT_EQ(read_line(" 1,\t-2.5 , 3e2 \r\n"), expected);
}

TEST(NumberLine, RejectsEverythingElse) {
  for (const std::string_view line :
       {"1,2\n", "1,2,3,4\n", ",1,2\n", "1,,3\n", "1,2,x\n", "1,2,3x\n", "1 2,3,4\n", "1,5;2\n",
        "1e40,2,3\n", "0x1,2,3\n", "--1,2,3\n", "touch: 1,2,3\n", "1,2,-\n", "1e,2,3\n"}) {
    NumberLineDecoder decoder(3);
    EXPECT_EQ(lines_in(decoder, "\n"), 0U);
    EXPECT_EQ(lines_in(decoder, line), 0U) << line;
    EXPECT_EQ(decoder.rejected(), 1U) << line;
  }
  EXPECT_TRUE(read_line("1,2,3" + std::string(300, ' ') + "\n").empty());
}

TEST(NumberLine, EndsWithEveryUsualEnd) {
  for (const std::string end : {"\n", "\r\n", "\r", "\n\r", "\r\r\n"}) {
    NumberLineDecoder decoder(2);
    EXPECT_EQ(lines_in(decoder, end + "1,2" + end + "3,4" + end), 2U);
    EXPECT_EQ(decoder.values()[1], 4.0F);
    EXPECT_EQ(decoder.rejected(), 0U);
  }
}

TEST(NumberLine, QuotesTheLineThatItRejected) {
  NumberLineDecoder decoder(3);
  EXPECT_EQ(decoder.complaint(), "");
  lines_in(decoder, "ets Jun  8");
  EXPECT_EQ(decoder.complaint(), "10 characters arrived without an end of line: 'ets Jun  8'");
  lines_in(decoder, "\r\n");
  EXPECT_EQ(decoder.complaint(), "");
  EXPECT_EQ(decoder.last_line(), "ets Jun  8");
  lines_in(decoder, "5,205,300,7\r\n1,2,3\r\n");
  EXPECT_EQ(decoder.complaint(), "the last line was '5,205,300,7': 4 fields instead of 3");
  EXPECT_EQ(decoder.last_line(), "1,2,3");
  lines_in(decoder, "\x01\xFF\t7\n");
  EXPECT_EQ(decoder.complaint(), "the last line was '\\x01\\xff\\t7': 2 fields instead of 3");
  lines_in(decoder, std::string(300, '1') + "\n");
  EXPECT_EQ(decoder.complaint(),
            "the last line was '" + std::string(80, '1') + "...': more than 256 characters");
}

TEST(NumberLine, PlacesNumbersByName) {
  NumberLineDecoder decoder(2, {{"left", 0}, {"right", 1}});
  EXPECT_EQ(lines_in(decoder, "\nRight:2,Left:1\n"), 1U);
  EXPECT_EQ(decoder.values()[0], 1.0F);
  EXPECT_EQ(decoder.values()[1], 2.0F);
}

TEST(NumberLine, SkipsEmptyLines) {
  NumberLineDecoder decoder(1);
  EXPECT_EQ(lines_in(decoder, "\n\r\n\n5\n\n6\n"), 2U);
  EXPECT_EQ(decoder.rejected(), 0U);
}

TEST(NumberLine, DoesNotTakeTheRestOfALineForALine) {
  NumberLineDecoder decoder(3);
  EXPECT_EQ(lines_in(decoder, "3,4,5\n"), 0U);  // The rest of 123,4,5.
  EXPECT_EQ(lines_in(decoder, "6,7,8\n"), 1U);
}

TEST(NumberLine, KeepsTheLastLineWhenAnotherIsRejected) {
  NumberLineDecoder decoder(2);
  lines_in(decoder, "\n1,2\n3,x\n");
  EXPECT_EQ(decoder.values()[0], 1.0F);
}

// The C library's reading of the same text.
TEST(NumberLine, ReadsBackEveryFloat) {
  Random random(1);
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto value = std::bit_cast<float>(random.next());
    if (!std::isnormal(value)) continue;
    const std::string line = encoded_line({value, 1.0F, value});
    ASSERT_EQ(std::strtof(line.c_str(), nullptr), value) << line;
    ASSERT_EQ(read_line(line), (std::vector<float>{value, 1.0F, value})) << line;
  }
}

// The format has no checksum: of about 1,070 changed bytes, 478 give another number that is
// accepted. Garbage before a line costs the line: 403 of 20,000.
TEST(NumberLine, AcceptsWrongDigitsOnly) {
  testing::DamagedSensorStream stream(3);
  Random random(4);
  std::vector<float> values(16);
  for (int i = 0; i < 20'000; ++i) {
    for (float& value : values) value = static_cast<float>(random.below(1024));
    const std::string line = encoded_line(values);
    stream.add({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, values);
  }
  NumberLineDecoder decoder(values.size());
  for (const std::uint8_t byte : stream.bytes()) {
    if (decoder.take(byte)) stream.accept(decoder.values());
  }
  EXPECT_GT(stream.accepted(), 18'000U);
  EXPECT_LT(stream.wrong(), 500U);
  EXPECT_LT(stream.lost(), 450U);
}

TEST(NumberLine, RefusesImpossibleArguments) {
  std::vector<std::uint8_t> bytes(kMostNumberBytes);
  EXPECT_THROW(encode_number_line({}, bytes), InvalidArgument);
  EXPECT_THROW(encode_number_line(std::vector<float>(2), bytes), InvalidArgument);
  const std::vector<float> infinite{std::numeric_limits<float>::infinity()};
  EXPECT_THROW(encode_number_line(infinite, bytes), InvalidArgument);
  EXPECT_THROW(NumberLineDecoder(0), InvalidArgument);
}

TEST(NumberLine, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  const std::vector<float> values(45, 0.1F);
  std::vector<std::uint8_t> bytes(kMostNumberBytes * values.size());
  NumberLineDecoder decoder(values.size());
  const testing::AllocationCounter allocations;
  int lines = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t size = encode_number_line(values, bytes);
    for (std::size_t j = 0; j < size; ++j) lines += decoder.take(bytes[j]) ? 1 : 0;
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(lines, 2);
}

}  // namespace
}  // namespace somato::wire
