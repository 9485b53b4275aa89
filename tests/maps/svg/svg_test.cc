#include "maps/svg/svg.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "maps/pictures/xml.h"
#include "somato/core/check.h"

namespace somato {
namespace {

TEST(Svg, NumbersAreShort) {
  EXPECT_EQ(svg_number(1.0), "1");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(1.255001), "1.26");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(1200.0, 0), "1200");
  EXPECT_EQ(svg_number(-2.5, 6), "-2.5");
  EXPECT_THROW(svg_number(std::numeric_limits<double>::infinity()), InvalidArgument);
}

TEST(Svg, EscapesMarkupAndReplacesWhatXmlForbids) {
  EXPECT_EQ(xml_escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(xml_escaped("a\tb\nc"), "a b c");
  EXPECT_EQ(xml_escaped(std::string("\0\x1b\x7f", 3)), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_escaped("\uFFFE\uFFFF"), "\uFFFD\uFFFD");
}

TEST(Svg, KeepsUtf8AndReplacesEachBrokenByte) {
  EXPECT_EQ(xml_escaped("\u00e9\u624b\U0001F916"), "\u00e9\u624b\U0001F916");
  EXPECT_EQ(xml_escaped("a\xff"), "a\uFFFD");
  EXPECT_EQ(xml_escaped("\xe6\x89"), "\uFFFD\uFFFD");                      // cut short
  EXPECT_EQ(xml_escaped("\xc0\xaf"), "\uFFFD\uFFFD");                      // overlong
  EXPECT_EQ(xml_escaped("\xe0\x80\xbc"), "\uFFFD\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(xml_escaped("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");            // a surrogate
  EXPECT_EQ(xml_escaped("\xf4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");  // beyond Unicode
}

TEST(Svg, DrawsTheGivenShapes) {
  SvgWriter svg(30, 20.5, "a <name>");
  svg.open_group("part", {1, 2}, {.stroke = "#000000", .stroke_width = 0.5}, {2, 3});
  svg.polygon({{0, 0}, {1, 0}, {0.5, 1}}, {.fill = "#ffffff"}, "tip & more");
  svg.circle({1, 2}, 3);
  svg.segments({{0, 0}, {1, 1}, {2, 2}, {3, 4}});
  svg.close_group();
  svg.text({5, 6}, "<b>", {.size = 10, .anchor = Anchor::kEnd, .bold = true});
  const auto root = test::read_xml(std::move(svg).finish());
  ASSERT_TRUE(root);
  EXPECT_EQ((*root)["width"], "30");
  EXPECT_EQ((*root)["viewBox"], "0 0 30 20.5");
  EXPECT_EQ(root->children[0].text, "a <name>");
  const auto part = test::groups(*root, "part");
  ASSERT_EQ(part.size(), 1U);
  EXPECT_EQ(part[0]["transform"], "translate(1,2)scale(2,3)");
  EXPECT_EQ(part[0]["stroke-width"], "0.5");
  EXPECT_EQ(part[0].children[0]["points"], "0,0 1,0 0.5,1");
  EXPECT_EQ(part[0].children[0].children[0].text, "tip & more");
  EXPECT_EQ(part[0].children[1]["r"], "3");
  EXPECT_EQ(part[0].children[2]["d"], "M0 0L1 1M2 2L3 4");
  const auto texts = test::elements(*root, "text");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].text, "<b>");
  EXPECT_EQ(texts[0]["text-anchor"], "end");
  EXPECT_EQ(texts[0]["font-weight"], "bold");
}

std::string transform_written(Point offset, Point scale) {
  SvgWriter svg(5, 5, "");
  svg.open_group("one", offset, {}, scale);
  svg.close_group();
  return test::groups(test::read_xml(std::move(svg).finish()).value(), "one").at(0)["transform"];
}

TEST(Svg, GroupsAreMovedAndStretchedOnlyWhereTheyAskForIt) {
  EXPECT_EQ(transform_written({0, 0}, {1, 1}), "");
  EXPECT_EQ(transform_written({0, 3}, {1, 1}), "translate(0,3)");
  EXPECT_EQ(transform_written({1, 0}, {1, 1}), "translate(1,0)");
  EXPECT_EQ(transform_written({0, 0}, {1, 2}), "scale(1,2)");
  EXPECT_EQ(transform_written({0, 0}, {2, 1}), "scale(2,1)");
  EXPECT_EQ(transform_written({0, 0}, {2, 2}), "scale(2,2)");
  EXPECT_EQ(transform_written({0, 0}, {1.234567, 1}), "scale(1.234567,1)");
}

TEST(Svg, RefusesMistakes) {
  EXPECT_THROW(SvgWriter(0, 5, ""), InvalidArgument);
  EXPECT_THROW(SvgWriter(5, std::numeric_limits<double>::quiet_NaN(), ""), InvalidArgument);
  SvgWriter svg(5, 5, "");
  EXPECT_THROW(svg.close_group(), InvalidArgument);
  EXPECT_THROW(svg.segments({{0, 0}}), InvalidArgument);
  svg.open_group("open");
  EXPECT_THROW(std::move(svg).finish(), InvalidArgument);
}

}  // namespace
}  // namespace somato
