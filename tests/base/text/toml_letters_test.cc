#include "base/text/toml_letters.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/text/utf8.h"

namespace somato {
namespace {

std::string as_text(char32_t code) {
  std::string text;
  append_character(text, code);
  return text;
}

TEST(TomlLetters, HaveStandInsWhereTomlppIsUndefined) {
  for (const char32_t code :
       std::vector<char32_t>{0xA1, 0xE4, 0x499, 0x2C5E, 0x2FFF, 0x3001, 0x3057, 0xFB26, 0xFEFE}) {
    EXPECT_EQ(with_stand_ins(as_text(code)), as_text(0xC0000 + code)) << std::uint32_t{code};
  }
  for (const char32_t code : std::vector<char32_t>{0x41, 0x7F, 0x85, 0xA0, 0x49A, 0x2C5D, 0x3000,
                                                   0x3058, 0x4E00, 0xFB25, 0xFEFF, 0x1F600}) {
    EXPECT_EQ(with_stand_ins(as_text(code)), as_text(code)) << std::uint32_t{code};
  }
}

TEST(TomlLetters, AreBackAfterwards) {
  std::string all;
  for (char32_t code = 1; code < 0xD800; ++code) append_character(all, code);
  for (char32_t code = 0xE000; code < 0x10000; ++code) append_character(all, code);
  EXPECT_EQ(without_stand_ins(with_stand_ins(all)), all);
  const std::string no_text = "a\xFF\xC3\n\xE0\x83\xA4\xED\xA0\x80";
  EXPECT_EQ(with_stand_ins(no_text), no_text);
  EXPECT_EQ(without_stand_ins(no_text), no_text);
}

TEST(TomlLetters, FindsTextThatCannotHaveStandIns) {
  const std::string::size_type none = std::string::npos;
  EXPECT_EQ(first_stand_in("a = '" + as_text(0xBFFFF) + as_text(0xD0000) + "'"), none);
  EXPECT_EQ(first_stand_in("a = '" + as_text(0xC0000) + "'"), 5u);
  EXPECT_EQ(first_stand_in("a = '" + as_text(0xC0000 - 1) + as_text(0xCFFFF) + "'"), 9u);
  EXPECT_EQ(first_stand_in("a = \"\\U000C00E4\""), 5u);
  EXPECT_EQ(first_stand_in("a = \"\\U000c00E4\" #" + as_text(0xC0000)), 5u);
  EXPECT_EQ(first_stand_in("a = \"\\U000D00E4\\u000C\""), none);
  EXPECT_EQ(first_stand_in("\xF3\xF3"), none);
}

}  // namespace
}  // namespace somato
