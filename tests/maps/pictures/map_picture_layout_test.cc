// Where the parts of a picture lie: laws that hold for every picture.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "maps/pictures/geometry.h"
#include "maps/pictures/panels.h"
#include "maps/pictures/xml.h"
#include "maps/svg/colours.h"
#include "maps/svg/text_layout.h"
#include "somato/drawing/map_picture.h"

namespace somato {
namespace {

using test::counting_panel;
using test::draw;
using test::Element;
using test::grid_of;
using test::group;
using test::two_classes;

// The panels have all kinds and sizes, with texts that fill all lines.
std::vector<Panel> various_panels() {
  const Grid torus = grid_of(8, 9, Lattice::kHexagonal, Topology::kTorus);
  LabelPanel crowded = two_classes();
  crowded.title = std::string(200, 'W');
  for (int i = 0; i < 90; ++i) crowded.class_names.push_back("class " + std::to_string(i));
  for (std::size_t i = 0; i < 500; ++i) {
    crowded.winners.push_back(i % 3);
    crowded.classes.push_back(i % 7);
  }
  LabelPanel small = two_classes();
  small.note = "A note about two classes that is so long that it needs two lines at least.";
  return {counting_panel(torus),          crowded, hits_panel(grid_of(2, 3), {1, 20, 300, 0, 7, 9}),
          counting_panel(grid_of(1, 96)), small,   counting_panel(grid_of(1, 1))};
}

Element draw_with_texts(const std::string& title, const std::string& caption,
                        const std::vector<Panel>& panels) {
  return test::read_xml(draw_picture(title, caption, panels)).value();
}

std::string sentence(std::size_t words) {
  std::string text = "Every";
  for (std::size_t i = 1; i < words; ++i) text += " word";
  return text;
}

// The texts of the picture itself, from top to bottom: those outside of all groups.
std::vector<test::Drawn> own_texts(const Element& root) {
  Element bare = root;
  std::erase_if(bare.children, [](const Element& child) { return child.name == "g"; });
  return test::drawn_in(bare, "text");
}

// Cells reach half a pixel further by their outlines.
TEST(MapPictureLayout, AllOfItLiesWithinThePicture) {
  for (const std::size_t count : {1U, 2U, 6U}) {
    auto panels = various_panels();
    panels.resize(count);
    const Element root = draw_with_texts(sentence(60), sentence(500), panels);
    const test::Box picture{0, 0, std::stod(root["width"]), std::stod(root["height"])};
    for (const test::Drawn& drawn : test::drawn_in(root)) {
      EXPECT_TRUE(picture.holds(drawn.box)) << drawn.element.name << drawn.element.text;
    }
  }
}

TEST(MapPictureLayout, NoTextCoversAnother) {
  const Element root = draw_with_texts(sentence(60), sentence(500), various_panels());
  auto texts = test::drawn_in(root, "text");
  // Numbers of samples are digits, which do not reach below their base line.
  std::erase_if(texts, [](const test::Drawn& text) {
    return text.element["font-weight"] == "bold" && text.element["text-anchor"] == "middle";
  });
  for (std::size_t a = 0; a < texts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_FALSE(texts[a].box.overlaps(texts[b].box))
          << texts[a].element.text << " and " << texts[b].element.text;
    }
  }
}

TEST(MapPictureLayout, PanelsStandApartAndNoFurtherThanTheyAreFromTheEdges) {
  const std::vector<Panel> panels(6, counting_panel(grid_of(10, 10)));
  const Element root = draw_with_texts("", "", panels);
  std::vector<test::Box> boxes;
  for (const Element& panel : test::groups(root, "panel")) {
    Element parent;
    parent.children = {panel};
    boxes.push_back(test::box_around(test::drawn_in(parent)));
  }
  ASSERT_EQ(boxes.size(), 6U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GE(boxes[i].left - boxes[i - 1].right, 20.0);
    EXPECT_LE(boxes[i].left - boxes[i - 1].right, 40.0);
  }
  EXPECT_GE(boxes[3].top - boxes[0].bottom, 20.0);
  EXPECT_LE(boxes[3].top - boxes[0].bottom, 60.0);
  EXPECT_GE(boxes[0].left, 10.0);
  EXPECT_LE(boxes[0].left, 30.0);
  EXPECT_NEAR(std::stod(root["width"]) - boxes[2].right, boxes[0].left, 0.02);
  EXPECT_GE(std::stod(root["height"]) - boxes[5].bottom, 10.0);
  EXPECT_LE(std::stod(root["height"]) - boxes[5].bottom, 50.0);
}

TEST(MapPictureLayout, PanelsStandInUpToFourColumns) {
  const std::map<std::size_t, std::size_t> columns{{1, 1}, {2, 2}, {3, 3},  {4, 2},
                                                   {5, 3}, {9, 3}, {10, 4}, {17, 4}};
  for (const auto& [count, expected] : columns) {
    const std::vector<Panel> panels(count, counting_panel(grid_of(1, 1)));
    std::set<double> lefts;
    std::set<double> tops;
    for (const Element& panel : test::groups(draw_with_texts("", "", panels), "panel")) {
      const test::Placement placement = test::Placement().within(panel["transform"]);
      lefts.insert(placement.offset.x);
      tops.insert(placement.offset.y);
    }
    EXPECT_EQ(lefts.size(), expected) << count;
    EXPECT_EQ(tops.size(), (count + expected - 1) / expected) << count;
  }
}

TEST(MapPictureLayout, TitleIsBoldAndLargestAndTheCaptionUnderIt) {
  const Element root = draw_with_texts("Title", "Caption", {two_classes()});
  const auto texts = own_texts(root);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0].element["font-weight"], "bold");
  EXPECT_EQ(texts[1].element["font-weight"], "");
  for (const test::Drawn& other : test::drawn_in(root, "text")) {
    if (other.element.text == "Title") continue;
    EXPECT_LT(test::number_of(other.element, "font-size"),
              test::number_of(texts[0].element, "font-size"));
  }
  EXPECT_LE(test::number_of(texts[0].element, "font-size"), 24.0);
  EXPECT_EQ(texts[0].box.left, texts[1].box.left);
  EXPECT_EQ(texts[0].box.left,
            test::Placement().within(group(root, "panel")["transform"]).offset.x);
}

TEST(MapPictureLayout, LinesOfTitleAndCaptionStandUnderEachOtherAtTheirDistances) {
  const auto texts = own_texts(draw_with_texts(sentence(200), sentence(500), {two_classes()}));
  ASSERT_EQ(texts.size(), 3U + 8U);
  for (const auto& [first, last] : {std::pair(0U, 2U), std::pair(3U, 10U)}) {
    const double size = test::number_of(texts[first].element, "font-size");
    const double line = texts[first + 1].box.top - texts[first].box.top;
    EXPECT_GE(line, 1.2 * size);
    EXPECT_LE(line, 1.6 * size);
    for (std::size_t i = first + 1; i <= last; ++i) {
      EXPECT_EQ(texts[i].box.left, texts[first].box.left);
      EXPECT_NEAR(texts[i].box.top - texts[i - 1].box.top, line, 0.02);
    }
  }
}

TEST(MapPictureLayout, PanelsFollowCloseUnderWhatIsWrittenAboveThem) {
  for (const std::string& caption : {std::string(), sentence(2), sentence(60)}) {
    const Element root = draw_with_texts("Title", caption, {two_classes()});
    const test::Box above = test::box_around(own_texts(root));
    const double panel = test::Placement().within(group(root, "panel")["transform"]).offset.y;
    EXPECT_GE(panel, above.bottom);
    EXPECT_LE(panel, above.bottom + 20.0);
    EXPECT_GE(above.top, 10.0);
    EXPECT_LE(above.top, 30.0);
  }
}

// As wide as the panels between the margins; a title that is cut one word earlier would leave room.
TEST(MapPictureLayout, LinesOfTheTitleUseTheWholeWidth) {
  const Element root = draw_with_texts(sentence(200), sentence(500), {two_classes()});
  const auto texts = own_texts(root);
  const double left = texts[0].box.left;
  const double width = std::stod(root["width"]) - 2 * left;
  const double size = test::number_of(texts[1].element, "font-size");
  const double word = kBoldness * text_width("word ", size);
  EXPECT_LE(test::width_of_text(texts[1].element), width);
  EXPECT_GT(test::width_of_text(texts[1].element), width - word);
}

TEST(MapPictureLayout, NumbersStandInTheMiddleOfTheirCells) {
  const Grid grid = grid_of(2, 2, Lattice::kHexagonal);
  const Element root = draw(hits_panel(grid, {3, 17, 4000, 1234567}));
  Element numbers;
  numbers.children = {group(root, "numbers")};
  Element cells;
  cells.children = {group(root, "cells")};
  std::map<std::string, test::Drawn> cell_of;
  for (const test::Drawn& cell : test::drawn_in(cells)) {
    const std::string tooltip = cell.element.children.at(0).text;
    cell_of[tooltip.substr(tooltip.find(": ") + 2)] = cell;
  }
  const auto drawn = test::drawn_in(numbers);
  ASSERT_EQ(drawn.size(), 4U);
  for (const test::Drawn& number : drawn) {
    const test::Box cell = cell_of.at(number.element.text).box;
    const double size = test::number_of(number.element, "font-size");
    EXPECT_TRUE(cell.holds(number.box)) << number.element.text;
    EXPECT_NEAR(number.box.centre().x, cell.centre().x, 0.02);
    // Digits are about 0.72 of the font size high.
    EXPECT_NEAR(number.box.top + 0.75 * size - 0.36 * size, cell.centre().y, 0.5);
    EXPECT_GE(size, 6.0);
    EXPECT_LE(size, 14.0);
  }
}

TEST(MapPictureLayout, TheBarIsWithoutGapsFromOneNumberToTheOther) {
  const Element root = draw(counting_panel(grid_of(2, 2)));
  Element bar;
  bar.children = {group(root, "bar")};
  const auto steps = test::drawn_in(bar, "rect");
  const auto numbers = test::drawn_in(bar, "text");
  ASSERT_GE(steps.size(), 50U);
  const test::Box all = test::box_around(steps);
  EXPECT_GE(all.bottom - all.top, 8.0);
  EXPECT_LE(all.bottom - all.top, 20.0);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_LE(steps[i].box.left, steps[i - 1].box.right);
    EXPECT_GT(steps[i].box.left, steps[i - 1].box.left);
    EXPECT_EQ(steps[i].box.top, all.top);
  }
  EXPECT_EQ(steps.front().element["fill"], to_string(sequential_colour(0.5 / 64)));
  EXPECT_EQ(steps.back().element["fill"], to_string(sequential_colour(1 - 0.5 / 64)));
  ASSERT_EQ(numbers.size(), 2U);
  EXPECT_NEAR(numbers[0].box.left, all.left, 0.02);
  EXPECT_NEAR(numbers[1].box.right, all.right, 0.02);
  for (const test::Drawn& number : numbers) {
    EXPECT_GE(number.box.top, all.bottom);
    EXPECT_LE(number.box.top, all.bottom + 12.0);
  }
}

}  // namespace
}  // namespace somato
