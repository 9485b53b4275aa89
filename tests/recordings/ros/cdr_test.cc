#include "recordings/ros/cdr.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace somato {
namespace {

// By hand: the byte, three of padding, the number, the text with its length and zero.
TEST(Cdr, NumbersAreAtMultiplesOfTheirSize) {
  CdrWriter writer;
  writer.number(std::uint8_t{7}).number(std::uint32_t{0x01020304}).text("ab");
  const std::string expected("\0\1\0\0\7\0\0\0\4\3\2\1\3\0\0\0ab\0", 19);
  EXPECT_EQ(writer.bytes(), expected);
}

TEST(Cdr, BothOrdersOfBytesAreRead) {
  const std::string little("\0\1\0\0\7\0\0\0\4\3\2\1\3\0\0\0ab\0", 19);
  const std::string big("\0\0\0\0\7\0\0\0\1\2\3\4\0\0\0\3ab\0", 19);
  for (const std::string& message : {little, big}) {
    ASSERT_TRUE(check_cdr_encapsulation(message));
    CdrReader reader(message);
    EXPECT_EQ(reader.bits(1), 7U);
    EXPECT_EQ(reader.bits(4), 0x01020304U);
    EXPECT_EQ(reader.text(), "ab");
    EXPECT_TRUE(reader.fits());
    EXPECT_EQ(reader.place(), message.size());
  }
}

TEST(Cdr, OtherEncodingsAreRefused) {
  for (const std::string& message : {std::string("\0\2\0\0", 4), std::string("\0\3\0\0", 4),
                                     std::string("\0\7\0\0", 4), std::string("\1\1\0\0", 4)}) {
    EXPECT_FALSE(check_cdr_encapsulation(message));
  }
  EXPECT_FALSE(check_cdr_encapsulation("\0\1"));
  EXPECT_TRUE(check_cdr_encapsulation(std::string("\0\1\0\0", 4)));
}

TEST(Cdr, ALengthThatTheRemainingBytesCannotHoldDoesNotFit) {
  CdrWriter writer;
  writer.number(std::uint32_t{3}).number(std::uint32_t{0}).number(std::uint32_t{0});
  EXPECT_EQ(CdrReader(writer.bytes()).count(2), 3U);
  CdrReader reader(writer.bytes());
  EXPECT_EQ(reader.count(3), 0U);
  EXPECT_FALSE(reader.fits());
  EXPECT_EQ(reader.bits(4), 0U);
}

TEST(Cdr, SkippingStaysWithinTheMessage) {
  const std::array<double, 2> values{1.0, 2.0};
  CdrWriter writer;
  writer.number(std::uint8_t{1}).number(values[0]).number(values[1]);
  CdrReader reader(writer.bytes());
  reader.skip(1, 1);
  reader.skip(8, 2);
  EXPECT_TRUE(reader.fits());
  EXPECT_EQ(reader.place(), writer.bytes().size());
  reader.skip(8, 0);
  EXPECT_TRUE(reader.fits());
  reader.skip(1, 1);
  EXPECT_FALSE(reader.fits());
  CdrReader again(writer.bytes());
  again.skip(8, std::size_t{1} << 61);
  EXPECT_FALSE(again.fits());
}

TEST(Cdr, AnEmptyTextMayHaveNoZero) {
  CdrWriter writer;
  writer.number(std::uint32_t{0}).text("x");
  CdrReader reader(writer.bytes());
  EXPECT_EQ(reader.text(), "");
  EXPECT_EQ(reader.text(), "x");
  EXPECT_TRUE(reader.fits());
}

}  // namespace
}  // namespace somato
