#include "maps/svg/colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

// Lightness L* of CIELAB (CIE 1976), from the relative luminance.
double lightness(const Colour& colour) {
  return 116 * std::cbrt(luminance(colour)) - 16;
}

TEST(Colours, AreWrittenAsHexadecimal) {
  EXPECT_EQ(to_string(Colour{0, 10, 255}), "#000aff");
}

TEST(Colours, LuminanceOfPrimariesIsThatOfTheStandard) {
  EXPECT_NEAR(luminance({255, 255, 255}), 1.0, 1e-12);
  EXPECT_EQ(luminance({0, 0, 0}), 0.0);
  EXPECT_NEAR(luminance({255, 0, 0}), 0.2126, 1e-12);
  EXPECT_NEAR(luminance({0, 255, 0}), 0.7152, 1e-12);
  EXPECT_NEAR(luminance({119, 119, 119}), 0.1845, 1e-3);  // the middle grey of L* 50
}

TEST(Colours, SequenceGrowsLighterInEvenSteps) {
  for (int i = 0; i < 200; ++i) {
    EXPECT_LE(luminance(sequential_colour(i / 200.0)),
              luminance(sequential_colour((i + 1) / 200.0)))
        << i;
  }
  for (int i = 0; i < 10; ++i) {
    const double step =
        lightness(sequential_colour((i + 1) / 10.0)) - lightness(sequential_colour(i / 10.0));
    EXPECT_NEAR(step, 8.1, 0.8) << i;
  }
}

TEST(Colours, SequenceEndsWhereItsRangeEnds) {
  EXPECT_EQ(sequential_colour(-3.0), sequential_colour(0.0));
  EXPECT_EQ(sequential_colour(7.0), sequential_colour(1.0));
  EXPECT_EQ(sequential_colour(1.0), (Colour{0xff, 0xef, 0x8c}));
  EXPECT_THROW(sequential_colour(std::numeric_limits<double>::quiet_NaN()), InvalidArgument);
}

TEST(Colours, TextIsReadableOnEveryBackground) {
  for (int i = 0; i <= 100; ++i) {
    const Colour background = sequential_colour(i / 100.0);
    const double a = luminance(background) + 0.05;
    const double b = luminance(readable_on(background)) + 0.05;
    EXPECT_GE(std::max(a, b) / std::min(a, b), 4.5) << i;  // WCAG 2, level AA
  }
}

TEST(Colours, TintGoesFromWhiteToTheColour) {
  const Colour colour{100, 0, 200};
  EXPECT_EQ(tint(colour, 0.0), (Colour{255, 255, 255}));
  EXPECT_EQ(tint(colour, 1.0), colour);
  EXPECT_EQ(tint(colour, 0.2), (Colour{224, 204, 244}));
  EXPECT_THROW(tint(colour, 1.5), InvalidArgument);
}

TEST(Colours, MarksDifferInColourAndInShape) {
  std::set<std::string> colours;
  std::set<MarkerShape> shapes;
  std::set<std::pair<std::string, MarkerShape>> marks;
  for (std::size_t i = 0; i < kClassMarks; ++i) {
    const ClassMark mark = class_mark(i);
    marks.emplace(to_string(mark.colour), mark.shape);
    if (i >= 8) continue;
    colours.insert(to_string(mark.colour));
    shapes.insert(mark.shape);
  }
  EXPECT_EQ(colours.size(), 8U);
  EXPECT_EQ(shapes.size(), 8U);
  EXPECT_EQ(marks.size(), 64U);
  EXPECT_EQ(class_mark(kClassMarks), class_mark(0));
}

}  // namespace
}  // namespace somato
