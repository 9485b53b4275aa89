#include "base/text/utf8.h"

#include <gtest/gtest.h>

#include <vector>

namespace somato {
namespace {

struct Encoded {
  char32_t code;
  std::string bytes;
};

// The boundaries of RFC 3629, section 3.
const std::vector<Encoded> kEncoded = {
    {0x41, "A"},
    {0x7F, "\x7F"},
    {0x80, "\xC2\x80"},
    {0xE4, "\xC3\xA4"},
    {0x7FF, "\xDF\xBF"},
    {0x800, "\xE0\xA0\x80"},
    {0xFFFF, "\xEF\xBF\xBF"},
    {0x10000, "\xF0\x90\x80\x80"},
    {0x10FFFF, "\xF4\x8F\xBF\xBF"},
};

TEST(Utf8Character, IsReadAndWritten) {
  for (const Encoded& one : kEncoded) {
    const Utf8Character first = first_character(one.bytes + "\xC3\xA4");
    EXPECT_EQ(first.code, one.code);
    EXPECT_EQ(first.bytes, one.bytes.size());
    std::string written = "x";
    append_character(written, one.code);
    EXPECT_EQ(written, "x" + one.bytes);
  }
}

TEST(Utf8Character, HasNoLengthWhereThereIsNone) {
  for (const char* bad : {"\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x83\xA4", "\xED\xA0\x80",
                          "\xF4\x90\x80\x80"}) {
    EXPECT_EQ(first_character(bad).bytes, 0u) << bad;
  }
}

}  // namespace
}  // namespace somato
