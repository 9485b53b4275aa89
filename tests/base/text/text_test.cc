#include "base/text/text.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

// The boundaries of RFC 3629, section 4.
TEST(Utf8, AcceptsExactlyWhatIsWellFormed) {
  for (const char* good :
       {"", "plain", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
        "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(is_utf8(good)) << good;
  }
  for (const char* bad :
       {"\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
        "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    EXPECT_FALSE(is_utf8(bad)) << bad;
  }
  EXPECT_EQ(first_invalid_utf8("abc\xC3\xA4\xFF"), 5u);
}

TEST(Name, IsShortAndPlain) {
  EXPECT_TRUE(is_name("weights"));
  EXPECT_TRUE(
      is_name("Gr\xC3\xB6\xC3\x9F"
              "e 1"));
  EXPECT_TRUE(is_name(std::string(255, 'a')));
  EXPECT_FALSE(is_name(""));
  EXPECT_FALSE(is_name(std::string(256, 'a')));
  EXPECT_FALSE(is_name("two\nlines"));
  EXPECT_FALSE(is_name("\xFF"));
}

TEST(Text, LosesItsByteOrderMark) {
  EXPECT_EQ(text_of("\xEF\xBB\xBF"
                    "a",
                    "f")
                .value(),
            "a");
  EXPECT_EQ(text_of("a\n", "f").value(), "a\n");
}

TEST(Text, NamesTheLineThatIsNoText) {
  EXPECT_EQ(text_of("a\nb\n\xE4", "f").error().where, "f:3");
  EXPECT_EQ(text_of(std::string_view("a\n\0b", 4), "f").error().where, "f:2");
  EXPECT_EQ(text_of("\xFF\xFE", "f").error().kind, ErrorKind::kData);
}

TEST(Trimmed, LosesBlanks) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
}

TEST(Shown, IsShortAndOnOneLine) {
  EXPECT_EQ(shown("a\nb"), "'a?b'");
  EXPECT_EQ(shown(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
  EXPECT_EQ(shown(std::string(39, 'x') + "\xC3\xA4"), "'" + std::string(39, 'x') + "...'");
}

}  // namespace
}  // namespace somato
