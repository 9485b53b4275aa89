#include "maps/svg/colour_bar.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "maps/pictures/panels.h"

namespace somato {
namespace {

using test::texts;

test::Element drawn(const ValueRange& range, const std::string& unit) {
  SvgWriter svg(200, 40, "bar");
  draw_colour_bar(svg, {10, 0}, 160, range, unit);
  return test::read_xml(std::move(svg).finish()).value();
}

TEST(ValueRange, PlacesValuesBetweenItsLimits) {
  const ValueRange range = range_of({4, -1, 9});
  EXPECT_EQ(range.least, -1);
  EXPECT_EQ(range.greatest, 9);
  EXPECT_DOUBLE_EQ(range.place_of(4), 0.5);
  EXPECT_DOUBLE_EQ(range_of({3, 3}).place_of(3), 0.5);
  const double huge = std::numeric_limits<double>::max();
  EXPECT_DOUBLE_EQ(range_of({-huge, huge}).place_of(huge), 1.0);
}

TEST(ReadableNumber, HasFourDigitsUnlessItIsWhole) {
  EXPECT_EQ(readable_number(123456), "123456");
  EXPECT_EQ(readable_number(1.23456), "1.235");
  EXPECT_EQ(readable_number(0.0), "0");
}

TEST(ColourBar, HasItsLimitsAndUnit) {
  EXPECT_EQ(texts(drawn({0, 2.5}, "N")), (std::vector<std::string>{"0", "2.5 N"}));
  EXPECT_EQ(texts(drawn({0, 2.5}, "")), (std::vector<std::string>{"0", "2.5"}));
  EXPECT_EQ(texts(drawn({7, 7}, "N")), (std::vector<std::string>{"all values are 7 N"}));
}

}  // namespace
}  // namespace somato
