#include "maps/svg/text_layout.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "maps/pictures/geometry.h"

namespace somato {
namespace {

// The widths of characters in Helvetica, in thousandths of the font size (Adobe's metrics).
const std::map<std::string, int> kHelvetica{
    {"a", 556}, {"b", 556}, {"c", 500}, {"e", 556}, {"f", 278}, {"i", 222}, {"j", 222},
    {"k", 500}, {"l", 222}, {"m", 833}, {"n", 556}, {"o", 556}, {"r", 333}, {"s", 500},
    {"t", 278}, {"w", 722}, {"z", 500}, {"0", 556}, {"9", 556}, {" ", 278}, {".", 278},
    {"A", 667}, {"B", 667}, {"H", 722}, {"I", 278}, {"M", 833}, {"W", 944}, {"Z", 611}};

std::string many(const std::string& word, std::size_t count) {
  std::string text = word;
  for (std::size_t i = 1; i < count; ++i) text += " " + word;
  return text;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " ") + line;
  return text;
}

TEST(TextLayout, CharactersAreAboutAsWideAsInHelvetica) {
  for (const auto& [character, width] : kHelvetica) {
    const double found = 1000 * text_width(character, 1.0);
    EXPECT_GE(found, 0.94 * width) << character;
    EXPECT_LE(found, 1.85 * width) << character;
  }
}

TEST(TextLayout, AllOrdinaryCapitalsAreEquallyWide) {
  for (const char* capital : {"B", "N", "Z"}) {
    EXPECT_EQ(text_width(capital, 1.0), text_width("A", 1.0)) << capital;
  }
  EXPECT_GT(text_width("A", 1.0), text_width("a", 1.0));
}

// They fill a square of the font size.
TEST(TextLayout, CharactersOfEastAsiaAndPicturesAreSquare) {
  for (const char* character : {"\u1100", "\u624b", "\U0001F916"}) {
    EXPECT_GE(text_width(character, 1.0), 1.0) << character;
    EXPECT_LE(text_width(character, 1.0), 1.3) << character;
  }
  EXPECT_LT(text_width("\u10ff", 1.0), 1.0);  // a Georgian letter, the last before them
  EXPECT_LT(text_width("\u2026", 1.0), 1.0);  // the ellipsis
}

TEST(TextLayout, AWidthGrowsWithTextAndSize) {
  EXPECT_EQ(text_width("", 12.0), 0.0);
  EXPECT_DOUBLE_EQ(text_width("hand", 24.0), 2 * text_width("hand", 12.0));
  EXPECT_DOUBLE_EQ(text_width("handhand", 12.0), 2 * text_width("hand", 12.0));
}

TEST(TextLayout, WhatJustFitsIsNotShortened) {
  const std::string text = "texture";
  EXPECT_EQ(shortened(text, text_width(text, 1.0), 1.0), text);
  EXPECT_EQ(shortened(text, 0.999 * text_width(text, 1.0), 1.0), "textu\u2026");
}

TEST(TextLayout, AShortenedTextFitsAndOneMoreCharacterWouldNot) {
  const std::string text = "elementary";
  for (double width = text_width("\u2026", 10.0); width < text_width(text, 10.0); width += 3.3) {
    const std::string found = shortened(text, width, 10.0);
    ASSERT_TRUE(found.ends_with("\u2026")) << width;
    EXPECT_LE(text_width(found, 10.0), width + 1e-9) << found;
    const std::size_t kept = found.size() - std::string("\u2026").size();
    EXPECT_EQ(found.substr(0, kept), text.substr(0, kept));
    EXPECT_GT(text_width(text.substr(0, kept + 1) + "\u2026", 10.0), width - 1e-9) << found;
  }
}

TEST(TextLayout, LinesAreAsLongAsFitAndLoseNothing) {
  for (const std::string word : {"i", "map", "texture", "W"}) {
    const std::string text = many(word, 30);
    const auto lines = wrapped(text, 100.0, 10.0, 30);
    EXPECT_EQ(joined(lines), text);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      EXPECT_LE(text_width(lines[i], 10.0), 100.0);
      EXPECT_GT(text_width(lines[i] + " " + word, 10.0), 100.0) << lines[i];
    }
  }
}

// The narrowest characters are the most that lines can take.
TEST(TextLayout, LinesFullOfNarrowCharactersLoseNothing) {
  const std::string text = many("iiii", 15);  // five words with their spaces fill a line
  EXPECT_EQ(wrapped(text, 100.0, 10.0, 3), std::vector<std::string>(3, many("iiii", 5)));
  EXPECT_EQ(wrapped(many("iiii", 16), 100.0, 10.0, 3).back(), many("iiii", 4) + " iii\u2026");
}

TEST(TextLayout, AtMostSoManyLinesTheLastOfThemCut) {
  const auto lines = wrapped(many("texture", 1000), 100.0, 10.0, 4);
  ASSERT_EQ(lines.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lines[i].ends_with("\u2026"), i == 3) << lines[i];
    EXPECT_LE(text_width(lines[i], 10.0), 100.0) << lines[i];
  }
}

TEST(TextLayout, SpacesAreBetweenWordsOnly) {
  EXPECT_EQ(wrapped("  a   hand \n closes ", 500.0, 10.0, 2),
            (std::vector<std::string>{"a hand closes"}));
  EXPECT_TRUE(wrapped("", 500.0, 10.0, 2).empty());
  EXPECT_TRUE(wrapped("   ", 500.0, 10.0, 2).empty());
  EXPECT_EQ(wrapped(std::string(100, 'W'), 50.0, 10.0, 2).size(), 1U);
}

test::Element written(const std::string& text, double width, bool bold) {
  SvgWriter svg(600, 400, "one line");
  write_line(svg, {3, 20}, text, width, {.size = 10.0, .bold = bold});
  return test::elements(test::read_xml(std::move(svg).finish()).value(), "text").at(0);
}

TEST(TextLayout, ALineThatIsCutSaysAllInItsTooltip) {
  const double width = text_width("a hand", 10.0) + 0.01;
  EXPECT_EQ(written("a hand", width, false).text, "a hand");
  EXPECT_TRUE(written("a hand", width, false).children.empty());
  const test::Element cut = written("a hand closes", width, false);
  EXPECT_TRUE(cut.text.ends_with("\u2026"));
  EXPECT_EQ(cut.children.at(0).text, "a hand closes");
}

// A tenth wider, so that it is cut where the plain text is not.
TEST(TextLayout, BoldTextNeedsMoreRoom) {
  const double width = 1.05 * text_width("a hand", 10.0);
  EXPECT_EQ(written("a hand", width, false).text, "a hand");
  EXPECT_NE(written("a hand", width, true).text, "a hand");
  EXPECT_EQ(written("a hand", 1.11 * text_width("a hand", 10.0), true).text, "a hand");
}

}  // namespace
}  // namespace somato
