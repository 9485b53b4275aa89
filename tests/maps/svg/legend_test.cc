#include "maps/svg/legend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "maps/pictures/geometry.h"
#include "maps/svg/colours.h"

namespace somato {
namespace {

constexpr Point kLegendCorner{40.0, 30.0};

struct DrawnLegend {
  double width = 0.0;
  double height = 0.0;
  test::Element root;
  std::vector<test::Drawn> markers;
  std::vector<test::Drawn> names;

  test::Box box() const {
    return {kLegendCorner.x, kLegendCorner.y, kLegendCorner.x + width, kLegendCorner.y + height};
  }
};

DrawnLegend drawn_legend(const std::vector<std::string>& names, double width) {
  SvgWriter svg(2000, 2000, "a legend");
  const Legend legend(names, width);
  legend.draw(svg, kLegendCorner);
  const test::Element root = test::read_xml(std::move(svg).finish()).value();
  const auto of_group = [&](const char* name) {
    test::Element parent;
    parent.children = test::groups(root, name);
    return test::drawn_in(parent);
  };
  return {width, legend.height(), root, of_group("legend"), of_group("names")};
}

std::vector<std::string> class_names(std::size_t count, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(name + std::to_string(i % 10));
  return names;
}

std::size_t columns_of(const DrawnLegend& legend) {
  std::set<double> lefts;
  for (const test::Drawn& name : legend.names) lefts.insert(std::round(name.box.left));
  return lefts.size();
}

// Few and many, short and too long, and more than there are marks.
std::vector<DrawnLegend> legends() {
  std::vector<DrawnLegend> all;
  for (const std::size_t count : {1U, 2U, 5U, 8U, 13U, 64U}) {
    for (const std::string name :
         {"b", "wooden block ", "the smallest of all tinned pineapples "}) {
      for (const double width : {260.0, 480.0}) {
        all.push_back(drawn_legend(class_names(count, name), width));
      }
    }
  }
  all.push_back(drawn_legend(class_names(90, "cube "), 300.0));
  return all;
}

TEST(Legend, AllOfItLiesWithinItsWidthAndHeight) {
  for (const DrawnLegend& legend : legends()) {
    for (const test::Drawn& marker : legend.markers) EXPECT_TRUE(legend.box().holds(marker.box));
    for (const test::Drawn& name : legend.names) EXPECT_TRUE(legend.box().holds(name.box));
    EXPECT_LT(legend.box().bottom - test::box_around(legend.names).bottom, 10.0);
  }
}

TEST(Legend, NothingOfItOverlaps) {
  for (const DrawnLegend& legend : legends()) {
    std::vector<test::Drawn> all = legend.markers;
    all.insert(all.end(), legend.names.begin(), legend.names.end());
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_FALSE(all[a].box.overlaps(all[b].box)) << all[a].element.text;
      }
    }
  }
}

TEST(Legend, EachMarkerStandsInTheMiddleOfItsNamesCapitalsAndCloseBefore) {
  for (const DrawnLegend& legend : legends()) {
    for (std::size_t i = 0; i < legend.markers.size(); ++i) {
      const test::Drawn& name = legend.names[i];
      // Polygons with a point up are centred on their area; the circle gives the centre.
      if (legend.markers[i].element.name == "circle") {
        const double capitals = 0.72 * test::number_of(name.element, "font-size");
        const double base = kLegendCorner.y + test::number_of(name.element, "y");
        EXPECT_NEAR(legend.markers[i].box.centre().y, base - capitals / 2, 0.5);
      }
      const double gap = name.box.left - legend.markers[i].box.right;
      EXPECT_GE(gap, 3.0);
      EXPECT_LE(gap, 10.0);
    }
  }
}

TEST(Legend, MarkersAreThoseOfTheClasses) {
  const DrawnLegend legend = drawn_legend(class_names(20, "cube "), 300.0);
  ASSERT_EQ(legend.markers.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(legend.markers[i].element["fill"], to_string(class_mark(i).colour)) << i;
    EXPECT_EQ(legend.names[i].element.text, "cube " + std::to_string(i % 10));
  }
}

// Line under line at one distance that suits the size of the text, down a column and then from its
// top.
TEST(Legend, NamesStandUnderEachOtherAtOneDistance) {
  const DrawnLegend legend = drawn_legend(class_names(7, "cube "), 230.0);
  ASSERT_EQ(columns_of(legend), 3U);
  const double size = test::number_of(legend.names[0].element, "font-size");
  const double line = legend.names[1].box.top - legend.names[0].box.top;
  EXPECT_GE(line, 1.3 * size);
  EXPECT_LE(line, 1.8 * size);
  EXPECT_NEAR(legend.names[2].box.top - legend.names[1].box.top, line, 0.02);
  EXPECT_NEAR(legend.names[3].box.top, legend.names[0].box.top, 0.02);
  EXPECT_NEAR(legend.names[0].box.left, legend.names[2].box.left, 0.02);
  EXPECT_NEAR(legend.names[6].box.top, legend.names[0].box.top, 0.02);
  EXPECT_NEAR(legend.height, 3 * line, 0.02);
}

TEST(Legend, TextIsReadableAndOfOneSize) {
  for (const DrawnLegend& legend : legends()) {
    for (const test::Drawn& name : legend.names) {
      EXPECT_EQ(name.element["font-size"], legend.names[0].element["font-size"]);
    }
    EXPECT_GE(test::number_of(legend.names[0].element, "font-size"), 10.0);
    EXPECT_LE(test::number_of(legend.names[0].element, "font-size"), 14.0);
  }
}

TEST(Legend, HasAsManyColumnsAsFit) {
  const std::vector<std::string> names = class_names(12, "cube ");
  const double widest = text_width("cube 0", 12.0);
  // Twenty pixels for the marker, and as many at most between columns.
  const double column = 20.0 + widest + 20.0;
  EXPECT_GE(columns_of(drawn_legend(names, 4 * column)), 4U);
  EXPECT_EQ(columns_of(drawn_legend(names, 0.5 * column)), 1U);
  EXPECT_LE(columns_of(drawn_legend(names, 4 * (20.0 + widest))), 3U);
  EXPECT_EQ(columns_of(drawn_legend(class_names(2, "b"), 2000.0)), 2U);
}

TEST(Legend, NamesThatFitTheirColumnAreWhole) {
  for (std::size_t count = 1; count < 20; ++count) {
    for (double width = 130.0; width < 600.0; width += 37.0) {
      for (const test::Drawn& name : drawn_legend(class_names(count, "cube "), width).names) {
        EXPECT_TRUE(name.element.text.starts_with("cube ")) << width;
        EXPECT_TRUE(name.element.children.empty()) << width;
      }
    }
  }
}

// The widest maps have 480 pixels.
TEST(Legend, EndlessNamesLeaveRoomForASecondColumn) {
  const DrawnLegend legend = drawn_legend(class_names(6, std::string(300, 'x')), 480.0);
  EXPECT_EQ(columns_of(legend), 2U);
  for (const test::Drawn& name : legend.names) EXPECT_GT(name.box.right - name.box.left, 120.0);
}

TEST(Legend, WithoutClassesIsNothing) {
  const DrawnLegend legend = drawn_legend({}, 300.0);
  EXPECT_EQ(legend.height, 0.0);
  EXPECT_TRUE(legend.markers.empty());
  EXPECT_TRUE(legend.names.empty());
}

TEST(Legend, SaysHowManyClassesItLeavesOutOnlyWhereItDoes) {
  const DrawnLegend all = drawn_legend(class_names(64, "cube "), 300.0);
  EXPECT_EQ(all.names.size(), 64U);
  const DrawnLegend more = drawn_legend(class_names(65, "cube "), 300.0);
  ASSERT_EQ(more.names.size(), 65U);
  EXPECT_TRUE(more.names[64].element.text.starts_with("and 1 more"));
  EXPECT_NEAR(more.names[64].box.left, kLegendCorner.x, 0.02);
  const double line = more.names[1].box.top - more.names[0].box.top;
  EXPECT_NEAR(more.height - all.height, line, 0.02);
}

TEST(Legend, OutlinesOfMarkersAreThin) {
  const test::Element root = drawn_legend(class_names(3, "cube "), 300.0).root;
  EXPECT_LE(test::number_of(test::groups(root, "legend").at(0), "stroke-width"), 1.0);
}

TEST(Legend, ANameThatIsBlankSaysSo) {
  EXPECT_EQ(shown_name(""), "(no name)");
  EXPECT_EQ(shown_name(" \t"), "(no name)");
  EXPECT_EQ(shown_name(" a "), " a ");
}

}  // namespace
}  // namespace somato
