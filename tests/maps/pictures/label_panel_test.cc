#include "maps/pictures/label_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "maps/pictures/geometry.h"

namespace somato {
namespace {

Grid map_of(std::size_t rows, std::size_t columns, Lattice lattice = Lattice::kRectangular) {
  return {rows, columns, lattice, Topology::kPlane};
}

// `samples` samples of `classes` classes in turn, all won by `winner`.
LabelPanel won_by(std::size_t winner, const Grid& grid, std::size_t samples, std::size_t classes) {
  LabelPanel panel{.title = "Samples", .grid = grid};
  for (std::size_t i = 0; i < classes; ++i) panel.class_names.push_back("c" + std::to_string(i));
  panel.winners.assign(samples, winner);
  for (std::size_t i = 0; i < samples; ++i) panel.classes.push_back(i % classes);
  return panel;
}

struct DrawnPanel {
  PanelFrame frame;
  test::Element root;

  test::Element part(const std::string& name) const {
    test::Element parent;
    parent.children = test::groups(root, name);
    return parent;
  }
  std::vector<test::Drawn> markers() const { return test::drawn_in(part("samples")); }
  // Digits stand on their base line.
  std::vector<test::Drawn> counts() const {
    std::vector<test::Drawn> counts = test::drawn_in(part("counts"));
    for (test::Drawn& count : counts) {
      count.box.bottom = frame.map_corner().y + test::number_of(count.element, "y");
    }
    return counts;
  }

  // The upright square in the middle of a cell.
  test::Box middle_of(std::size_t neuron) const {
    const Point centre = frame.cells.centre(neuron);
    const double half = frame.cells.inner_side() / 2;
    const Point corner = frame.map_corner();
    return {corner.x + centre.x - half, corner.y + centre.y - half, corner.x + centre.x + half,
            corner.y + centre.y + half};
  }
};

DrawnPanel drawn_panel(const LabelPanel& panel) {
  SvgWriter svg(2000, 2000, "a panel");
  const PanelFrame frame = frame_of(panel);
  draw_panel(svg, frame, panel);
  return {frame, test::read_xml(std::move(svg).finish()).value()};
}

double stroke_of(const DrawnPanel& drawn, const std::string& name) {
  return test::number_of(test::groups(drawn.root, name).at(0), "stroke-width");
}

// The middle of the square around all markers, which are circles of one class.
Point middle_of_markers(const std::vector<test::Drawn>& markers) {
  return test::box_around(markers).centre();
}

Point mean_centre(const std::vector<test::Drawn>& markers) {
  Point mean{0.0, 0.0};
  for (const test::Drawn& marker : markers) {
    mean.x += marker.box.centre().x / static_cast<double>(markers.size());
    mean.y += marker.box.centre().y / static_cast<double>(markers.size());
  }
  return mean;
}

TEST(LabelPanel, MarkersAreCentredOnTheirCellAndWithinIt) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    const std::size_t most = lattice == Lattice::kHexagonal ? 36 : 64;
    for (std::size_t samples = 1; samples <= most; ++samples) {
      const DrawnPanel drawn = drawn_panel(won_by(4, map_of(3, 3, lattice), samples, 1));
      const auto markers = drawn.markers();
      ASSERT_EQ(markers.size(), samples);
      const test::Box cell = drawn.middle_of(4);
      EXPECT_NEAR(middle_of_markers(markers).y, cell.centre().y, 0.02) << samples;
      EXPECT_NEAR(mean_centre(markers).x, cell.centre().x, 0.02) << samples;
      for (const test::Drawn& marker : markers) EXPECT_TRUE(cell.holds(marker.box)) << samples;
    }
  }
}

TEST(LabelPanel, ASquareNumberOfMarkersStandsInASquare) {
  for (const std::size_t side : {2U, 3U, 7U}) {
    const auto markers = drawn_panel(won_by(0, map_of(2, 2), side * side, 1)).markers();
    const test::Box box = test::box_around(markers);
    EXPECT_NEAR(box.right - box.left, box.bottom - box.top, 0.03) << side;
    EXPECT_NEAR(markers[0].box.top, markers[side - 1].box.top, 0.02);
    EXPECT_GT(markers[side].box.top, markers[0].box.bottom);
  }
}

// Large enough to be seen, and at most twice as large as those of the legend.
TEST(LabelPanel, MarkersAreOfAUsefulSize) {
  for (const std::size_t samples : {1U, 4U, 30U, 64U}) {
    const DrawnPanel drawn = drawn_panel(won_by(0, map_of(2, 2), samples, 1));
    const auto markers = drawn.markers();
    ASSERT_EQ(markers.size(), samples);
    const double legend = test::number_of(test::drawn_in(drawn.part("legend"))[0].element, "r");
    EXPECT_GE(test::number_of(markers[0].element, "r"), 1.5);
    EXPECT_LE(test::number_of(markers[0].element, "r"), 2 * legend);
    if (samples == 1) {
      EXPECT_GE(test::number_of(markers[0].element, "r"), legend);
    }
  }
}

TEST(LabelPanel, ALoneSampleHasItsMarkerInTheSmallestCellToo) {
  const DrawnPanel drawn = drawn_panel(won_by(0, map_of(1, 100), 1, 1));
  ASSERT_EQ(drawn.markers().size(), 1U);
  EXPECT_TRUE(drawn.middle_of(0).holds(drawn.markers()[0].box));
  EXPECT_TRUE(drawn.counts().empty());
}

TEST(LabelPanel, NumbersStandUnderTheirMarkersWithinTheCell) {
  for (const std::size_t classes : {1U, 2U, 4U}) {
    const DrawnPanel drawn = drawn_panel(won_by(3, map_of(2, 2), 400 * classes, classes));
    const auto markers = drawn.markers();
    const auto counts = drawn.counts();
    ASSERT_EQ(markers.size(), classes);
    ASSERT_EQ(counts.size(), classes);
    for (std::size_t i = 0; i < classes; ++i) {
      EXPECT_EQ(counts[i].element.text, "400");
      EXPECT_EQ(counts[i].element["font-weight"], "bold");
      EXPECT_NEAR(counts[i].box.centre().x, markers[i].box.centre().x, 0.02);
      EXPECT_GE(counts[i].box.top, markers[i].box.bottom - 1.0);
      EXPECT_TRUE(drawn.middle_of(3).holds(markers[i].box));
      EXPECT_TRUE(drawn.middle_of(3).holds(counts[i].box));
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(counts[i].box.overlaps(counts[k].box));
        EXPECT_FALSE(markers[i].box.overlaps(counts[k].box));
      }
    }
  }
}

TEST(LabelPanel, NumbersAreReadableOrLeftOut) {
  for (std::size_t classes = 1; classes <= 20; ++classes) {
    for (const std::size_t each : {90U, 900U, 9000U}) {
      const DrawnPanel drawn = drawn_panel(won_by(0, map_of(2, 2), each * classes, classes));
      for (const test::Drawn& count : drawn.counts()) {
        EXPECT_GE(test::number_of(count.element, "font-size"), 7.0);
        EXPECT_LE(test::number_of(count.element, "font-size"), 12.0);
      }
      if (classes == 20) {
        EXPECT_TRUE(drawn.counts().empty());
      }
    }
  }
}

TEST(LabelPanel, TooltipsSayHowManySamplesOfWhichClassWhere) {
  const auto markers = drawn_panel(won_by(3, map_of(2, 2), 4, 2)).markers();
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[0].element.children.at(0).text, "1 x c0, row 2, column 2");
  EXPECT_EQ(markers[3].element.children.at(0).text, "1 x c1, row 2, column 2");
  const auto of_many = drawn_panel(won_by(3, map_of(2, 2), 800, 2)).markers();
  EXPECT_EQ(of_many.at(1).element.children.at(0).text, "400 x c1, row 2, column 2");
}

TEST(LabelPanel, TooltipsOfCellsListTheirClasses) {
  const DrawnPanel drawn = drawn_panel(won_by(1, map_of(1, 2), 5, 2));
  std::vector<std::string> tooltips;
  for (const test::Element& cell : test::elements(drawn.part("cells"), "polygon")) {
    tooltips.push_back(cell.children.at(0).text);
  }
  std::sort(tooltips.begin(), tooltips.end());
  EXPECT_EQ(tooltips,
            (std::vector<std::string>{"row 1, column 1", "row 1, column 2: 3 x c0, 2 x c1"}));
}

// Not a page of it, and not a word.
TEST(LabelPanel, EndlessNamesInTooltipsAreCut) {
  LabelPanel panel = won_by(0, map_of(1, 1), 1, 1);
  panel.class_names[0] = std::string(5000, 'n');
  const std::string tooltip = drawn_panel(panel).markers().at(0).element.children.at(0).text;
  EXPECT_GT(tooltip.size(), 50U);
  EXPECT_LT(tooltip.size(), 150U);
}

TEST(LabelPanel, OutlinesAreThinBesideWhatTheyOutline) {
  for (const std::size_t side : {2U, 20U, 50U, 96U}) {
    const DrawnPanel drawn = drawn_panel(won_by(0, map_of(side, side), 1, 1));
    const double pixels = drawn.frame.cells.pixels();
    EXPECT_LE(stroke_of(drawn, "samples"), 0.035 * pixels) << side;
    EXPECT_LE(stroke_of(drawn, "samples"), 1.0) << side;
    EXPECT_LE(stroke_of(drawn, "borders"), 0.13 * pixels) << side;
    EXPECT_LE(stroke_of(drawn, "borders"), 2.0) << side;
  }
}

TEST(LabelPanel, LinesBetweenCellsAreThinnerThanBordersAndLeftOutWhereCellsAreSmall) {
  const DrawnPanel large = drawn_panel(won_by(0, map_of(2, 2), 1, 1));
  EXPECT_LT(stroke_of(large, "lines"), stroke_of(large, "borders"));
  EXPECT_EQ(test::groups(drawn_panel(won_by(0, map_of(30, 30), 1, 1)).root, "lines").size(), 1U);
  EXPECT_TRUE(test::groups(drawn_panel(won_by(0, map_of(96, 96), 1, 1)).root, "lines").empty());
}

// Square cells of 48 pixels, in rows.
TEST(LabelPanel, BordersGoAroundTheMapAndBetweenAreas) {
  LabelPanel panel = won_by(0, map_of(1, 2), 2, 2);
  panel.winners = {0, 1};
  const auto paths = test::elements(drawn_panel(panel).part("borders"), "path");
  ASSERT_EQ(paths.size(), 2U);
  const std::string around = paths[0]["d"];
  EXPECT_EQ(std::count(around.begin(), around.end(), 'M'), 6);
  EXPECT_NE(around.find("M0 0L0 48"), std::string::npos);
  EXPECT_NE(around.find("M96 0L96 48"), std::string::npos);
  EXPECT_EQ(around.find("M48 0L48 48"), std::string::npos);
}

TEST(LabelPanel, TheNoteStandsCloseUnderTheLegend) {
  LabelPanel panel = won_by(0, map_of(3, 3), 4, 3);
  panel.note = "A note.";
  const DrawnPanel drawn = drawn_panel(panel);
  const double legend = test::box_around(test::drawn_in(drawn.part("names"))).bottom;
  const auto texts = test::drawn_in(drawn.root, "text");
  const auto note = std::find_if(texts.begin(), texts.end(), [](const test::Drawn& text) {
    return text.element.text == "A note.";
  });
  ASSERT_NE(note, texts.end());
  EXPECT_GE(note->box.top, legend + 4.0);
  EXPECT_LE(note->box.top, legend + 20.0);
}

TEST(LabelPanel, WhatOneMarkerStandsForIsSaidAfterTheNote) {
  LabelPanel panel = won_by(0, map_of(2, 2), 400, 2);
  EXPECT_TRUE(frame_of(panel).note_lines.at(0).starts_with("If samples"));
  panel.note = "A note.";
  EXPECT_TRUE(frame_of(panel).note_lines.at(0).starts_with("A note. If samples"));
}

}  // namespace
}  // namespace somato
