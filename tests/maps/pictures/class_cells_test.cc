#include "maps/pictures/class_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "maps/pictures/geometry.h"
#include "maps/pictures/label_panel.h"
#include "maps/pictures/panels.h"
#include "maps/svg/text_layout.h"

namespace somato {
namespace {

using test::draw;
using test::grid_of;
using test::group;
using test::texts;
using test::two_classes;

LabelPanel pies(LabelPanel panel) {
  panel.marks = LabelMarks::kPies;
  return panel;
}

LabelPanel text(LabelPanel panel) {
  panel.marks = LabelMarks::kText;
  return panel;
}

// The share of a sector by its angle, from the numbers of its path.
double share_of(const std::string& path) {
  double cx = 0;
  double cy = 0;
  double x = 0;
  double y = 0;
  double r = 0;
  double r2 = 0;
  int large = 0;
  double to_x = 0;
  double to_y = 0;
  if (std::sscanf(path.c_str(), "M%lf %lfL%lf %lfA%lf %lf 0 %d 1 %lf %lfZ", &cx, &cy, &x, &y, &r,
                  &r2, &large, &to_x, &to_y) != 9) {
    return -1;
  }
  const double from = std::atan2(x - cx, cy - y);
  const double to = std::atan2(to_x - cx, cy - to_y);
  const double turn = 8 * std::atan(1.0);
  return std::fmod((to - from) / turn + 1.0, 1.0);
}

// Three samples of a neuron, two of class 0; two of another, of class 1; one of class 0.
TEST(Pies, HaveTheShareOfEachClass) {
  const test::Element root = draw(pies(two_classes()));
  const test::Element drawn = group(root, "pies");
  const auto slices = test::elements(drawn, "path");
  ASSERT_EQ(slices.size(), 2U);
  EXPECT_NEAR(share_of(slices[0]["d"]), 2.0 / 3.0, 0.01);
  EXPECT_NEAR(share_of(slices[1]["d"]), 1.0 / 3.0, 0.01);
  EXPECT_EQ(slices[0]["fill"], to_string(class_mark(0).colour));
  EXPECT_EQ(slices[1]["fill"], to_string(class_mark(1).colour));
  EXPECT_EQ(slices[0].children.at(0).text, "2 of 3 samples are ball, row 1, column 1");
}

// Without colour, the marker of its class is in each slice that has room for it.
TEST(Pies, CanBeReadInGrey) {
  const test::Element drawn = group(draw(pies(two_classes())), "pies");
  // A circle for the class "ball" in the slice, one pie of that class and its marker, and the
  // squares of the class "block".
  EXPECT_EQ(test::elements(drawn, "polygon").size(), 2U);
  EXPECT_EQ(test::elements(drawn, "circle").size(), 4U);
}

TEST(Pies, StayInTheirCells) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const std::size_t side : {1U, 3U, 40U}) {
      LabelPanel panel = pies(two_classes());
      panel.grid = grid_of(side, side, lattice);
      panel.winners = {0, 0, 0, 0, 0, 0};
      const double pixels = frame_of(panel).cells.pixels();
      for (const test::Drawn& one : test::drawn_in(group(draw(panel), "pies"), "circle")) {
        EXPECT_LE(one.box.right - one.box.left, pixels);
      }
    }
  }
}

TEST(Pies, AreasAreProportionalToHitsIfRequested) {
  LabelPanel panel = pies(two_classes());
  panel.winners = {0, 0, 0, 0, 1, 5};
  panel.classes = {0, 0, 0, 0, 0, 0};
  panel.size_by_hits = true;
  const auto circles = test::elements(group(draw(panel), "pies"), "circle");
  std::vector<double> radii;
  for (const test::Element& circle : circles) radii.push_back(test::number_of(circle, "r"));
  // A pie and its marker for each of three neurons; four samples have twice the radius of one.
  ASSERT_EQ(radii.size(), 6U);
  EXPECT_NEAR(radii[0], 2 * radii[2], 0.02);
  EXPECT_EQ(radii[2], radii[4]);
}

TEST(Pies, ManyClassesAndHostileNamesAreDrawn) {
  LabelPanel panel = pies({.title = "<&>", .grid = grid_of(1, 1)});
  for (std::size_t i = 0; i < 70; ++i) {
    panel.class_names.push_back(i % 3 == 0 ? "" : "<b>&\"'" + std::to_string(i));
    panel.winners.push_back(0);
    panel.classes.push_back(i);
  }
  const auto slices = test::elements(group(draw(panel), "pies"), "path");
  EXPECT_EQ(slices.size(), 70U);
}

TEST(LabelText, IsTheNameOfTheMajority) {
  const auto written = texts(group(draw(text(two_classes())), "texts"));
  EXPECT_EQ(written, (std::vector<std::string>{"ball", "ball", "block"}));
}

TEST(LabelText, NamesThatDoNotFitAreNumbersThatTheLegendExplains) {
  LabelPanel panel = text(two_classes());
  panel.class_names[1] = std::string(60, 'w');
  const test::Element root = draw(panel);
  EXPECT_EQ(texts(group(root, "texts")), (std::vector<std::string>{"1", "1", "2"}));
  EXPECT_EQ(texts(group(root, "names")).at(0), "1  ball");
  EXPECT_TRUE(texts(group(root, "names")).at(1).starts_with("2  www"));
}

TEST(LabelText, StaysInItsCell) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const std::size_t side : {1U, 5U, 10U, 14U, 30U}) {
      LabelPanel panel = text(two_classes());
      panel.grid = grid_of(side, side, lattice);
      panel.winners.assign(6, side * side / 2);
      panel.class_names = {"half_full_bottle of water", "x"};
      const PanelFrame frame = frame_of(panel);
      const Point centre = frame.cells.centre(side * side / 2);
      const Point area = frame.cells.text_area();
      const test::Element group_of_texts = group(draw(panel), "texts");
      for (const test::Element& line : group_of_texts.children) {
        const test::Box box = test::box_of_text(line);
        EXPECT_GE(box.left, centre.x - area.x / 2) << side;
        EXPECT_LE(box.right, centre.x + area.x / 2) << side;
        EXPECT_GE(box.top, centre.y - area.y / 2 - 1) << side;
        EXPECT_LE(box.bottom, centre.y + area.y / 2 + 1) << side;
        EXPECT_GE(test::number_of(line, "font-size"), 7.0);
      }
    }
  }
}

TEST(LabelText, EmptyNamesAreDescribed) {
  LabelPanel panel = text(two_classes());
  panel.grid = grid_of(1, 12);
  panel.class_names = {"", "b"};
  const auto names = texts(group(draw(panel), "names"));
  EXPECT_NE(names.at(0).find("(no name)"), std::string::npos);
}

TEST(ClustersPanel, HasTheNumberOfEachCluster) {
  const LabelPanel panel = clusters_panel(grid_of(2, 2), {0, 0, 1, 2});
  EXPECT_EQ(texts(group(draw(panel), "texts")), (std::vector<std::string>{"1", "1", "2", "3"}));
  EXPECT_EQ(test::elements(group(draw(panel), "outlines"), "path").size(), 2U);
}

}  // namespace
}  // namespace somato
