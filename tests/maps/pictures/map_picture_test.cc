#include "somato/drawing/map_picture.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "maps/pictures/panels.h"
#include "maps/pictures/xml.h"
#include "maps/svg/colours.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::counting_panel;
using test::draw;
using test::Element;
using test::grid_of;
using test::group;
using test::texts;
using test::two_classes;
using Corner = std::pair<int, int>;

// Whether a text holds `part`, also when it is broken into lines.
bool has_text(const Element& root, const std::string& part) {
  std::string all;
  for (const std::string& text : texts(root)) all += text + " ";
  return all.find(part) != std::string::npos;
}

// The corners of the cell whose tooltip starts with its place; cells have whole-numbered corners.
std::map<std::string, std::vector<Corner>> cells_by_place(const Element& root) {
  std::map<std::string, std::vector<Corner>> cells;
  for (const Element& cell : test::elements(group(root, "cells"), "polygon")) {
    std::istringstream points(cell["points"]);
    std::vector<Corner> corners;
    int x = 0;
    int y = 0;
    char comma = 0;
    while (points >> x >> comma >> y) corners.emplace_back(x, y);
    const std::string& tooltip = cell.children.at(0).text;
    cells[tooltip.substr(0, tooltip.find(':'))] = corners;
  }
  return cells;
}

std::string place(const Grid& grid, std::size_t neuron) {
  return "row " + std::to_string(grid.row_of(neuron) + 1) + ", column " +
         std::to_string(grid.column_of(neuron) + 1);
}

std::size_t shared(const std::vector<Corner>& a, const std::vector<Corner>& b) {
  const std::set<Corner> of_a(a.begin(), a.end());
  std::size_t count = 0;
  for (const Corner& corner : b) count += of_a.count(corner);
  return count;
}

// Everything that marks a sample: the shapes of the group, titles left out.
std::size_t markers(const Element& root) {
  return group(root, "samples").children.size();
}

TEST(MapPicture, NeighbouringCellsShareAnEdgeAndOthersNone) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    const Grid grid = grid_of(4, 5, lattice);
    const auto cells = cells_by_place(draw(counting_panel(grid)));
    ASSERT_EQ(cells.size(), grid.size());
    for (std::size_t a = 0; a < grid.size(); ++a) {
      const auto& corners = cells.at(place(grid, a));
      EXPECT_EQ(corners.size(), lattice == Lattice::kRectangular ? 4U : 6U);
      for (std::size_t b = a + 1; b < grid.size(); ++b) {
        const std::size_t common = shared(corners, cells.at(place(grid, b)));
        if (grid.adjacent(a, b)) {
          EXPECT_EQ(common, 2U) << a << " " << b;
        } else {
          EXPECT_LE(common, lattice == Lattice::kRectangular ? 1U : 0U) << a << " " << b;
        }
      }
    }
  }
}

TEST(MapPicture, HexagonsAreRegular) {
  const Element root = draw(counting_panel(grid_of(2, 2, Lattice::kHexagonal)));
  double x = 0;
  double y = 0;
  const std::string transform = group(root, "cells")["transform"];
  ASSERT_EQ(std::sscanf(transform.c_str() + transform.find("scale"), "scale(%lf,%lf)", &x, &y), 2);
  // From the centre of the first cell, (1, 2): all corners as far as the top one.
  const auto corners = cells_by_place(root).at("row 1, column 1");
  ASSERT_EQ(corners.size(), 6U);
  for (const auto& [column, row] : corners) {
    const double right = (column - 1) * x;
    const double down = (row - 2) * y;
    EXPECT_NEAR(right * right + down * down, 4 * y * y, 1e-3);
  }
}

TEST(MapPicture, EveryNeuronHasItsValue) {
  const Grid grid = grid_of(2, 3);
  ValuePanel panel{.title = "v", .grid = grid, .values = {0.5, -1, 2, 0.25, 1e-9, 12345678}};
  std::set<std::string> tooltips;
  for (const Element& cell : test::elements(group(draw(panel), "cells"), "polygon")) {
    tooltips.insert(cell.children.at(0).text);
  }
  EXPECT_EQ(tooltips,
            (std::set<std::string>{"row 1, column 1: 0.5", "row 1, column 2: -1",
                                   "row 1, column 3: 2", "row 2, column 1: 0.25",
                                   "row 2, column 2: 1e-09", "row 2, column 3: 1.235e+07"}));
}

TEST(MapPicture, LimitsAreThoseOfTheColoursAndOfTheBar) {
  ValuePanel panel = counting_panel(grid_of(1, 3));
  panel.limits = ColourLimits{-2, 2};
  const Element root = draw(panel);
  EXPECT_TRUE(has_text(root, "-2"));
  const auto fills = group(root, "cells").children;
  std::set<std::string> colours;
  for (const Element& fill : fills) colours.insert(fill["fill"]);
  EXPECT_TRUE(colours.contains(to_string(sequential_colour(0.5))));
  EXPECT_TRUE(colours.contains(to_string(sequential_colour(1.0))));
  panel.limits = ColourLimits{2, -2};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.limits = ColourLimits{0, std::numeric_limits<double>::infinity()};
  EXPECT_THROW(draw(panel), InvalidArgument);
}

TEST(MapPicture, ClustersAreOutlinedOnEveryKindOfPanel) {
  ValuePanel values = counting_panel(grid_of(1, 3));
  values.clusters = {0, 1, 1};
  LabelPanel labels = two_classes();
  labels.clusters.assign(12, 0);
  labels.clusters[3] = 1;
  for (const auto& [panel, lines] : {std::pair<Panel, int>{values, 1}, {labels, 2}}) {
    const auto paths = test::elements(group(draw(panel), "outlines"), "path");
    ASSERT_EQ(paths.size(), 2U);  // a white rim and the line
    EXPECT_EQ(paths[0]["stroke"], "#ffffff");
    const std::string d = paths[1]["d"];
    EXPECT_EQ(std::count(d.begin(), d.end(), 'M'), lines);
  }
  values.clusters = {0, 0, 0};
  EXPECT_TRUE(test::elements(group(draw(values), "outlines"), "path").empty());
  values.clusters = {0, 1};
  EXPECT_THROW(draw(values), InvalidArgument);
}

TEST(MapPicture, LeastIsDarkAndGreatestIsLight) {
  const Element root = draw(counting_panel(grid_of(1, 3)));
  std::map<std::string, std::string> fills;
  for (const Element& fill : group(root, "cells").children) {
    fills[fill.children.at(0).children.at(0).text] = fill["fill"];
  }
  EXPECT_EQ(fills.at("row 1, column 1: 0"), "#0f1c54");
  EXPECT_EQ(fills.at("row 1, column 3: 2"), "#ffef8c");
  EXPECT_EQ(texts(group(root, "bar")), (std::vector<std::string>{"0", "2"}));
}

TEST(MapPicture, ConstantAndExtremeValuesAreDrawn) {
  ValuePanel panel{.title = "v", .grid = grid_of(1, 2), .values = {3.25, 3.25}};
  EXPECT_TRUE(has_text(draw(panel), "all values are 3.25"));
  panel.values = {-1.7e308, 1.7e308};
  EXPECT_EQ(group(draw(panel), "cells").children.size(), 2U);
  panel.values = {0, std::numeric_limits<double>::denorm_min()};
  EXPECT_EQ(group(draw(panel), "cells").children.size(), 2U);
}

TEST(MapPicture, HitsAreWrittenWhereThereIsRoom) {
  const Element root = draw(hits_panel(grid_of(2, 2), {3, 0, 17, 1}));
  EXPECT_EQ(texts(group(root, "numbers")), (std::vector<std::string>{"3", "17", "1"}));
  const Grid large = grid_of(100, 100);
  const Element dense = draw(hits_panel(large, std::vector<std::size_t>(large.size(), 2)));
  EXPECT_TRUE(texts(group(dense, "numbers")).empty());
}

TEST(MapPicture, EverySampleHasAMarker) {
  const Element root = draw(two_classes());
  EXPECT_EQ(markers(root), 6U);
  EXPECT_EQ(test::elements(group(root, "cells"), "polygon").size(), 12U);
  EXPECT_EQ(test::elements(group(root, "samples"), "circle").size(), 3U);   // ball
  EXPECT_EQ(test::elements(group(root, "samples"), "polygon").size(), 3U);  // block, a square
  EXPECT_EQ(texts(group(root, "names")), (std::vector<std::string>{"ball", "block"}));
}

TEST(MapPicture, MarkersOfOneNeuronStandApart) {
  LabelPanel panel{.grid = grid_of(3, 3, Lattice::kHexagonal), .class_names = {"a"}};
  panel.winners.assign(9, 4);
  panel.classes.assign(9, 0);
  const auto circles = test::elements(group(draw(panel), "samples"), "circle");
  ASSERT_EQ(circles.size(), 9U);
  for (std::size_t a = 0; a < circles.size(); ++a) {
    for (std::size_t b = a + 1; b < circles.size(); ++b) {
      const double x = std::stod(circles[a]["cx"]) - std::stod(circles[b]["cx"]);
      const double y = std::stod(circles[a]["cy"]) - std::stod(circles[b]["cy"]);
      const double r = std::stod(circles[a]["r"]);
      EXPECT_GT(x * x + y * y, 4 * r * r);
    }
  }
}

TEST(MapPicture, SamplesWithoutRoomAreCountedByClass) {
  LabelPanel panel{.grid = grid_of(2, 2), .class_names = {"a", "b"}};
  panel.winners.assign(1234, 3);
  panel.classes.assign(1234, 0);
  panel.classes[7] = 1;
  const Element root = draw(panel);
  EXPECT_EQ(markers(root), 2U);
  EXPECT_EQ(texts(group(root, "counts")), (std::vector<std::string>{"1233", "1"}));
  EXPECT_TRUE(has_text(root, "one marker represents all"));
}

TEST(MapPicture, BordersSeparateAreas) {
  LabelPanel panel{.grid = grid_of(1, 2), .class_names = {"a", "b"}};
  panel.winners = {0, 1};
  panel.classes = {0, 1};
  // Cells of 48 pixels: the frame has 6 edges, and one border lies between the cells.
  const auto borders = group(draw(panel), "borders").children;
  EXPECT_EQ(borders.at(1)["d"], "M48 0L48 48");
  panel.classes = {1, 1};
  EXPECT_EQ(group(draw(panel), "borders").children.at(1)["d"], "");
  panel.classes = {0, 1};
  panel.show_areas = false;
  EXPECT_EQ(group(draw(panel), "borders").children.at(1)["d"], "");
}

TEST(MapPicture, WonCellsAreStrongerThanTheirArea) {
  LabelPanel panel{.grid = grid_of(1, 2), .class_names = {"a"}, .winners = {0}, .classes = {0}};
  const auto fills_of = [](const Element& root) {
    std::set<std::string> fills;
    for (const Element& fill : group(root, "cells").children) fills.insert(fill["fill"]);
    return fills;
  };
  // Half and 18 hundredths of #0072b2 (0, 114, 178) in white.
  EXPECT_EQ(fills_of(draw(panel)), (std::set<std::string>{"#80b9d9", "#d1e6f1"}));
  panel.show_areas = false;
  EXPECT_EQ(fills_of(draw(panel)), (std::set<std::string>{"#80b9d9", "#f4f4f4"}));
}

TEST(MapPicture, HostileNamesStayText) {
  const std::string endless(300, 'W');
  LabelPanel panel = two_classes();
  panel.class_names = {"<script>alert(1)</script>", "\"]]>&'", "\U0001F916", endless, "",
                       std::string("\x01\xff\0", 3)};
  const std::string svg = draw_picture("<title>", "&caption;", {panel});
  const auto root = test::read_xml(svg);
  ASSERT_TRUE(root);
  EXPECT_TRUE(test::elements(*root, "script").empty());
  const Element names = group(*root, "names");
  ASSERT_EQ(names.children.size(), 6U);
  EXPECT_EQ(names.children[0].text, "<script>alert(1)</script>");
  EXPECT_EQ(names.children[1].text, "\"]]>&'");
  EXPECT_EQ(names.children[2].text, "\U0001F916");
  EXPECT_LT(names.children[3].text.size(), 60U);
  EXPECT_EQ(names.children[3].children.at(0).text, endless);
  EXPECT_EQ(names.children[4].text, "(no name)");
  EXPECT_EQ(names.children[5].text, "\uFFFD\uFFFD\uFFFD");
}

TEST(MapPicture, LegendOfManyClassesSaysWhatItLeavesOut) {
  LabelPanel panel{.grid = grid_of(5, 5)};
  for (int i = 0; i < 100; ++i) panel.class_names.push_back("class " + std::to_string(i));
  const Element root = draw(panel);
  EXPECT_EQ(group(root, "legend").children.size(), 64U);
  EXPECT_TRUE(has_text(root, "and 36 more"));
}

TEST(MapPicture, TorusSaysThatEdgesJoin) {
  const Grid torus = grid_of(2, 2, Lattice::kHexagonal, Topology::kTorus);
  EXPECT_TRUE(has_text(draw(counting_panel(torus)), "opposite edges join"));
  EXPECT_FALSE(has_text(draw(counting_panel(grid_of(2, 2))), "opposite edges join"));
}

TEST(MapPicture, PanelsDoNotOverlapAndLieWithinThePicture) {
  const std::vector<Panel> panels{counting_panel(grid_of(3, 30)), two_classes(),
                                  counting_panel(grid_of(30, 3)), counting_panel(grid_of(1, 1)),
                                  two_classes()};
  const auto root = test::read_xml(draw_picture("Five", "", panels));
  ASSERT_TRUE(root);
  std::set<std::string> places;
  for (const Element& panel : test::groups(*root, "panel")) {
    places.insert(panel["transform"]);
    double x = 0;
    double y = 0;
    ASSERT_EQ(std::sscanf(panel["transform"].c_str(), "translate(%lf,%lf)", &x, &y), 2);
    EXPECT_LT(x + 260, std::stod((*root)["width"]));
    EXPECT_LT(y + 60, std::stod((*root)["height"]));
  }
  EXPECT_EQ(places.size(), 5U);
}

TEST(MapPicture, LargeMapsAreNotTooLarge) {
  const std::string svg =
      draw_picture("Large", "", {counting_panel(grid_of(200, 200, Lattice::kHexagonal))});
  EXPECT_LT(svg.size(), 3'300'000U);
  const auto root = test::read_xml(svg);
  ASSERT_TRUE(root);
  EXPECT_EQ(test::elements(group(*root, "cells"), "polygon").size(), 40000U);
}

TEST(MapPicture, SameInputGivesTheSameBytesAndNothingComesFromElsewhere) {
  const std::vector<Panel> panels{two_classes(), counting_panel(grid_of(4, 4))};
  const std::string svg = draw_picture("Twice", "", panels);
  EXPECT_EQ(svg, draw_picture("Twice", "", panels));
  EXPECT_EQ(svg.find("href"), std::string::npos);
  EXPECT_EQ(svg.find("url("), std::string::npos);
}

TEST(MapPicture, RefusesWhatCannotBeDrawn) {
  const auto refuses = [](const Panel& panel) {
    EXPECT_THROW(draw_picture("", "", {panel}), InvalidArgument);
  };
  EXPECT_THROW(draw_picture("", "", {}), InvalidArgument);
  refuses(ValuePanel{});
  refuses(ValuePanel{.grid = grid_of(2, 2), .values = {1, 2, 3}});
  refuses(ValuePanel{.grid = grid_of(1, 1), .values = {std::numeric_limits<double>::infinity()}});
  refuses(ValuePanel{.grid = grid_of(1, 1), .values = {std::numeric_limits<double>::quiet_NaN()}});
  LabelPanel panel = two_classes();
  panel.winners.back() = 12;
  refuses(panel);
  panel = two_classes();
  panel.classes.back() = 2;
  refuses(panel);
  panel = two_classes();
  panel.classes.pop_back();
  refuses(panel);
}

// Neurons in a triangle, two of them above or beside each other: 2 x 2 cells.
TEST(MapPicture, DrawsTheEdgesOfAGraph) {
  const Grid grid(std::make_shared<const NeuronGraph>(
      3, std::vector<NeuronGraph::Edge>{{0, 1}, {0, 2}, {1, 2}}));
  const std::string picture = draw_picture("Graph", "", {hits_panel(grid, {4, 0, 1})});
  EXPECT_NE(picture.find("class=\"connections\""), std::string::npos);
  EXPECT_NE(picture.find("neuron 3: 1"), std::string::npos);
  const Grid row(1, 3, Lattice::kRectangular, Topology::kPlane);
  const std::string without = draw_picture("Row", "", {hits_panel(row, {4, 0, 1})});
  EXPECT_EQ(without.find("connections"), std::string::npos);
}

}  // namespace
}  // namespace somato
