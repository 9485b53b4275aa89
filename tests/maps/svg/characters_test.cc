#include "maps/svg/characters.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace somato {
namespace {

// The first and the last character of each number of bytes (RFC 3629, section 3).
const std::pair<char32_t, std::string> kEnds[] = {{0x7F, "\x7f"},
                                                  {0x80, "\xc2\x80"},
                                                  {0x7FF, "\xdf\xbf"},
                                                  {0x800, "\xe0\xa0\x80"},
                                                  {0xFFFF, "\xef\xbf\xbf"},
                                                  {0x10000, "\xf0\x90\x80\x80"},
                                                  {0x10FFFF, "\xf4\x8f\xbf\xbf"}};

TEST(Characters, AreWrittenWithAsFewBytesAsTheyNeed) {
  for (const auto& [character, bytes] : kEnds) {
    EXPECT_EQ(utf8_of(std::u32string(1, character)), bytes) << static_cast<unsigned>(character);
  }
}

TEST(Characters, ThoseThatMayBeShownAreReadAsTheyWere) {
  for (const auto& [character, bytes] : kEnds) {
    const bool is_shown = character != 0x7F && character != 0x80 && character != 0xFFFF;
    EXPECT_EQ(characters_of(bytes), std::u32string(1, is_shown ? character : kReplacement))
        << static_cast<unsigned>(character);
  }
}

TEST(Characters, ControlsEndWherePrintedOnesBegin) {
  EXPECT_EQ(characters_of("\x1f \x7e"), (std::u32string{kReplacement, U' ', U'~'}));
  EXPECT_EQ(characters_of("\u009f\u00a0"), (std::u32string{kReplacement, 0xA0}));
  EXPECT_EQ(characters_of("a\r\n\tb"), U"a   b");
}

}  // namespace
}  // namespace somato
