#include "maps/pictures/panel_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "maps/pictures/geometry.h"
#include "maps/svg/text_layout.h"

namespace somato {
namespace {

Grid squares(std::size_t rows, std::size_t columns) {
  return {rows, columns, Lattice::kRectangular, Topology::kPlane};
}

test::Element drawn_frame(const PanelFrame& frame) {
  SvgWriter svg(2000, 2000, "a frame");
  draw_frame(svg, frame);
  return test::read_xml(std::move(svg).finish()).value();
}

test::Element drawn_cells(const Grid& grid) {
  SvgWriter svg(3000, 20000, "cells");
  draw_cells(svg, make_frame("", grid), std::vector<Colour>(grid.size()),
             [](std::size_t neuron) { return "neuron " + std::to_string(neuron); });
  return test::read_xml(std::move(svg).finish()).value();
}

double longest_side(const Cells& cells) {
  return std::max(cells.width(), cells.height());
}

TEST(PanelFrame, MapsOfOrdinarySizeAreAbout480PixelsLong) {
  for (std::size_t side = 10; side <= 96; ++side) {
    for (const Grid& grid : {squares(side, side), squares(side, 3), squares(3, side)}) {
      EXPECT_LE(longest_side(make_frame("", grid).cells), 480.0) << side;
      EXPECT_GT(longest_side(make_frame("", grid).cells), 480.0 - static_cast<double>(side));
    }
  }
}

TEST(PanelFrame, CellsAreNeitherPostersNorInvisible) {
  for (const std::size_t side : {1U, 2U, 9U}) {
    const double pixels = make_frame("", squares(side, 1)).cells.pixels();
    EXPECT_LE(pixels, 50.0);
    EXPECT_GE(pixels, 40.0);
  }
  for (const std::size_t side : {97U, 200U, 1000U}) {
    EXPECT_EQ(make_frame("", squares(1, side)).cells.pixels(), 5.0);
  }
}

TEST(PanelFrame, ANarrowMapHasRoomForATitleAndIsInItsMiddle) {
  const PanelFrame narrow = make_frame("", squares(8, 1));
  EXPECT_GT(narrow.width, text_width("accuracy of 20 maps", 14.0));
  EXPECT_LT(narrow.width, make_frame("", squares(8, 8)).width);
  EXPECT_EQ(narrow.map_corner().x, narrow.width - narrow.cells.width() - narrow.map_corner().x);
  const PanelFrame wide = make_frame("", squares(3, 96));
  EXPECT_EQ(wide.width, wide.cells.width());
  EXPECT_EQ(wide.map_corner().x, 0.0);
}

// Title, map, foot and note from top to bottom, none far from the one before.
TEST(PanelFrame, PartsStandCloseUnderEachOther) {
  PanelFrame frame = make_frame("A title", squares(4, 4));
  frame.foot_height = 33.0;
  add_note(frame, "A note that is longer than the panel is wide, so that it has a second line.");
  ASSERT_EQ(frame.note_lines.size(), 2U);
  const auto texts = test::drawn_in(drawn_frame(frame), "text");
  ASSERT_EQ(texts.size(), 3U);
  const auto close = [](double above, double below) {
    EXPECT_GE(below, above);
    EXPECT_LE(below, above + 20.0);
  };
  close(0.0, texts[0].box.top);
  close(texts[0].box.bottom, frame.map_corner().y);
  close(frame.map_corner().y + frame.cells.height(), frame.foot_top());
  close(frame.foot_top() + frame.foot_height, texts[1].box.top);
  close(texts[1].box.bottom, texts[2].box.top);
  close(texts[2].box.bottom, frame.height());
}

TEST(PanelFrame, TheTitleIsBoldAndLargerThanTheNote) {
  PanelFrame frame = make_frame("A title", squares(4, 4));
  add_note(frame, "A note.");
  const auto texts = test::elements(drawn_frame(frame), "text");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0]["font-weight"], "bold");
  EXPECT_EQ(texts[1]["font-weight"], "");
  EXPECT_GT(test::number_of(texts[0], "font-size"), test::number_of(texts[1], "font-size"));
  EXPECT_LE(test::number_of(texts[0], "font-size"), 16.0);
  EXPECT_GE(test::number_of(texts[1], "font-size"), 10.0);
}

TEST(PanelFrame, LinesOfTheNoteStandUnderEachOtherAtOneDistance) {
  PanelFrame frame = make_frame("", squares(4, 4));
  std::string note;
  for (int i = 0; i < 200; ++i) note += "endless note ";
  add_note(frame, note);
  ASSERT_EQ(frame.note_lines.size(), 6U);
  const auto texts = test::drawn_in(drawn_frame(frame), "text");
  ASSERT_EQ(texts.size(), 7U);
  const double line = texts[2].box.top - texts[1].box.top;
  const double size = test::number_of(texts[1].element, "font-size");
  EXPECT_GE(line, 1.2 * size);
  EXPECT_LE(line, 1.6 * size);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_EQ(texts[i].box.left, 0.0);
    EXPECT_LE(texts[i].box.right, frame.width);
    EXPECT_NEAR(texts[i].box.top, texts[1].box.top + line * static_cast<double>(i - 1), 0.02);
  }
}

TEST(PanelFrame, ATorusIsAddedToTheNote) {
  const Grid torus{3, 3, Lattice::kRectangular, Topology::kTorus};
  PanelFrame frame = make_frame("", torus);
  add_note(frame, "Hits.");
  ASSERT_EQ(frame.note_lines.size(), 1U);
  EXPECT_TRUE(frame.note_lines[0].starts_with("Hits. A torus"));
  add_note(frame, "");
  EXPECT_TRUE(frame.note_lines[0].starts_with("A torus"));
}

TEST(PanelFrame, UpTo2500CellsHaveTooltips) {
  for (const std::size_t cells : {2499U, 2500U, 2501U}) {
    const test::Element first = test::elements(drawn_cells(squares(1, cells)), "polygon").at(0);
    EXPECT_EQ(first.children.size(), cells <= 2500 ? 1U : 0U) << cells;
  }
}

// An outline is stretched with its cells.
TEST(PanelFrame, CellsAreOutlinedNearlyAPixelWide) {
  for (const std::size_t side : {2U, 20U, 90U}) {
    const Grid grid = squares(side, side);
    const test::Element cells = test::groups(drawn_cells(grid), "cells").at(0);
    const double pixels =
        test::number_of(cells, "stroke-width") * make_frame("", grid).cells.unit().x;
    EXPECT_GE(pixels, 0.6) << side;
    EXPECT_LE(pixels, 1.0) << side;
  }
}

}  // namespace
}  // namespace somato
