#include "maps/svg/strip_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "maps/pictures/panels.h"
#include "maps/svg/colours.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::Element;
using test::elements;
using test::group;
using test::texts;

Strip strip() {
  return {.name = "rate",
          .note = "module.map.rate",
          .cells = {{"low", 0.0, {}}, {"middle", 0.5, {}}, {"high", 1.0, {}}, {"none", {}, {}}},
          .figure = "0.42"};
}

Element drawn(const Strip& one) {
  const auto root = test::read_xml(draw_strips("T < U", "A caption", {{"Claim", "Note", {one}}}));
  if (!root) throw std::runtime_error("not well formed");
  return *root;
}

TEST(StripPicture, BarsAreAsHighAsTheirSharesInTheirColours) {
  const Element cells = group(drawn(strip()), "cells");
  const auto bars = elements(cells, "rect");
  ASSERT_EQ(bars.size(), 7U);  // four grounds, and a bar where something is known
  EXPECT_EQ(bars[1]["height"], "0");
  EXPECT_EQ(bars[3]["height"], "22");
  EXPECT_EQ(bars[3]["y"], "22");
  EXPECT_EQ(bars[3]["fill"], to_string(sequential_colour(0.5)));
  EXPECT_EQ(bars[5]["height"], "44");
  EXPECT_EQ(bars[5]["fill"], to_string(sequential_colour(1.0)));
  EXPECT_EQ(texts(cells),
            (std::vector<std::string>{"0", "50", "100", "low", "middle", "high", "none"}));
}

TEST(StripPicture, HasItsTextsEscaped) {
  const Element root = drawn(strip());
  EXPECT_EQ(texts(root)[0], "T < U");
  const auto panel = texts(group(root, "panel"));
  EXPECT_EQ(panel[0], "Claim");
  EXPECT_EQ(panel[1], "Note");
  EXPECT_EQ(panel[2], "rate");
  EXPECT_EQ(panel.back(), "0.42");
}

TEST(StripPicture, AMarkStandsAtItsPlaceWithItsTextWhereThereIsRoom) {
  Strip one = strip();
  one.mark = {0.25, "here"};
  const Element left = drawn(one);
  EXPECT_EQ(elements(left, "polygon")[0]["points"], "115,-10 125,-10 120,-1");
  one.mark = {1.0, "there"};
  const Element right = drawn(one);
  EXPECT_EQ(elements(right, "polygon")[0]["points"], "475,-10 485,-10 480,-1");
  for (const Element& text : elements(right, "text")) {
    if (text.text == "there") {
      EXPECT_EQ(text["text-anchor"], "end");
    }
  }
  one.mark = {{}, "nowhere"};
  EXPECT_TRUE(elements(drawn(one), "polygon").empty());
}

TEST(StripPicture, EdgesThatWouldOverlapAreLeftOutButForTheEnds) {
  Strip one = strip();
  one.edges = {"0", "1", "2", "3", "4"};
  EXPECT_EQ(texts(group(drawn(one), "cells")),
            (std::vector<std::string>{"0", "50", "100", "0", "1", "2", "3", "4"}));
  const std::string wide(40, '8');
  one.edges = {wide, wide, wide, wide, "end"};
  const auto written = texts(group(drawn(one), "cells"));
  EXPECT_EQ(std::count(written.begin(), written.end(), wide), 1);  // of 252 px, in cells of 120
  EXPECT_EQ(written.back(), "end");
}

TEST(StripPicture, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(draw_strips("T", "", {}), InvalidArgument);
  EXPECT_THROW(drawn({.name = "no cells"}), InvalidArgument);
  Strip one = strip();
  one.cells[0].share = 1.5;
  EXPECT_THROW(drawn(one), InvalidArgument);
  one = strip();
  one.edges = {"0", "1"};
  EXPECT_THROW(drawn(one), InvalidArgument);
  one = strip();
  one.mark.place = -0.1;
  EXPECT_THROW(drawn(one), InvalidArgument);
}

}  // namespace
}  // namespace somato
