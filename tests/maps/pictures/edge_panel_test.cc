#include "maps/pictures/edge_panel.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <memory>
#include <set>

#include "maps/pictures/geometry.h"
#include "maps/pictures/panels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::draw;
using test::grid_of;
using test::group;

// Neuron n has the value n, an edge 100 times the lower plus the higher number.
EdgePanel counted(const Grid& grid) {
  EdgePanel panel{.title = "Edges", .grid = grid};
  for (std::size_t a = 0; a < grid.size(); ++a) {
    panel.values.push_back(static_cast<double>(a));
    for (const std::size_t b : grid.neighbours(a)) {
      if (b > a) panel.edges.push_back({a, b, static_cast<double>(100 * a + b)});
    }
  }
  return panel;
}

// The middle of each cell with a tooltip, by the tooltip.
std::map<std::string, Point> cells_by_tooltip(const test::Element& root) {
  std::map<std::string, Point> cells;
  const test::Element all = group(root, "cells");
  for (const test::Drawn& cell : test::drawn_in(all, "polygon")) {
    if (cell.element.children.empty()) continue;
    cells[cell.element.children[0].text] = cell.box.centre();
  }
  return cells;
}

TEST(EdgePanel, EveryEdgeOfAPlaneIsHalfwayBetweenItsNeurons) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const auto& [rows, columns] :
         {std::pair{4U, 5U}, {5U, 4U}, {1U, 6U}, {6U, 1U}, {2U, 2U}, {1U, 1U}}) {
      const Grid grid = grid_of(rows, columns, lattice);
      const EdgePanel panel = counted(grid);
      const auto cells = cells_by_tooltip(draw(panel));
      EXPECT_EQ(cells.size(), panel.values.size() + panel.edges.size());
      std::vector<Point> neurons;
      for (std::size_t n = 0; n < grid.size(); ++n) {
        neurons.push_back(cells.at(place_of(grid, n) + ": " + std::to_string(n)));
      }
      for (const auto& [a, b, value] : panel.edges) {
        const Point middle = cells.at(place_of(grid, a) + " to " + place_of(grid, b) + ": " +
                                      std::to_string(static_cast<int>(value)));
        EXPECT_NEAR(middle.x, (neurons[a].x + neurons[b].x) / 2, 0.05) << a << " " << b;
        EXPECT_NEAR(middle.y, (neurons[a].y + neurons[b].y) / 2, 0.05) << a << " " << b;
      }
    }
  }
}

// Nothing hides another value, and none is left out, also across the border.
TEST(EdgePanel, EdgesOfATorusHaveTheirOwnCells) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const auto& [rows, columns] : {std::pair{4U, 5U}, {6U, 3U}, {4U, 4U}}) {
      const EdgePanel panel = counted(grid_of(rows, columns, lattice, Topology::kTorus));
      const auto cells = cells_by_tooltip(draw(panel));
      EXPECT_EQ(cells.size(), panel.values.size() + panel.edges.size());
      std::set<std::pair<int, int>> places;
      for (const auto& [tooltip, at] : cells) {
        EXPECT_EQ(tooltip.find("to"), tooltip.rfind("to")) << "two edges in one cell";
        places.emplace(static_cast<int>(10 * at.x), static_cast<int>(10 * at.y));
      }
      EXPECT_EQ(places.size(), cells.size());
    }
  }
}

TEST(EdgePanel, SmallToriAreDrawn) {
  for (const auto& [rows, columns] : {std::pair{1U, 1U}, {1U, 2U}, {2U, 2U}, {2U, 3U}, {3U, 1U}}) {
    EXPECT_NO_THROW(draw(counted(grid_of(rows, columns, Lattice::kRectangular, Topology::kTorus))));
    if (rows % 2 == 1) continue;
    EXPECT_NO_THROW(draw(counted(grid_of(rows, columns, Lattice::kHexagonal, Topology::kTorus))));
  }
}

TEST(EdgePanel, TwoDiagonalsHaveTheirMean) {
  EdgePanel panel = counted(grid_of(2, 2));
  panel.values = {0, 0, 0, 0};
  panel.edges = {{0, 3, 1.0}, {1, 2, 3.0}};
  const test::Element cells = group(draw(panel), "cells");
  const auto fill_of = [&](const std::string& part) {
    for (const test::Element& fill : cells.children) {
      for (const test::Element& cell : fill.children) {
        if (!cell.children.empty() && cell.children[0].text.find(part) != std::string::npos) {
          return fill["fill"];
        }
      }
    }
    return std::string();
  };
  EXPECT_EQ(fill_of(" to "), to_string(sequential_colour(2.0 / 3.0)));
}

TEST(EdgePanel, NeuronsHaveADotThatCanBeSeen) {
  const Grid grid = grid_of(3, 4, Lattice::kHexagonal);
  const auto dots = test::elements(group(draw(counted(grid)), "neurons"), "circle");
  ASSERT_EQ(dots.size(), grid.size());
  EXPECT_EQ(dots.front()["fill"], "#ffffff");  // on the darkest colour
}

// A straight outline between the columns 0 and 1 of a row lies halfway between their neurons.
TEST(EdgePanel, OutlinesLieOnTheEdges) {
  EdgePanel panel = counted(grid_of(1, 2));
  panel.clusters = {0, 1};
  const test::Element root = draw(panel);
  const auto paths = test::elements(group(root, "outlines"), "path");
  ASSERT_EQ(paths.size(), 2U);
  double x = 0;
  double y = 0;
  ASSERT_EQ(std::sscanf(paths[1]["d"].c_str(), "M%lf %lfL", &x, &y), 2);
  const std::string transform = group(root, "outlines")["transform"];
  const Point at = test::Placement().within(transform).of({x, y});
  const auto dots = test::drawn_in(group(root, "neurons"), "circle");
  EXPECT_NEAR(at.x, (dots[0].box.centre().x + dots[1].box.centre().x) / 2, 0.05);
}

TEST(EdgePanel, EdgesOfAGraphAreLines) {
  const auto graph =
      std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 1}, {1, 2}});
  EdgePanel panel{.title = "Graph", .grid = Grid(graph), .values = {1, 2, 3}};
  panel.edges = {{0, 1, 5.0}, {1, 2, 1.0}};
  const auto lines = test::elements(group(draw(panel), "edges"), "path");
  ASSERT_EQ(lines.size(), 4U);  // each with a dark rim
  EXPECT_EQ(lines[1]["stroke"], to_string(sequential_colour(1.0)));
  EXPECT_EQ(lines[3]["stroke"], to_string(sequential_colour(0.0)));
}

TEST(EdgePanel, WhatCannotBeDrawnIsRefused) {
  EdgePanel panel = counted(grid_of(3, 3));
  panel.edges = {{0, 8, 1.0}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.edges = {{0, 2, 1.0}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.edges = {{0, 9, 1.0}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.edges = {{0, 0, 1.0}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.edges = {{0, 1, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.edges = {};
  panel.clusters = {0, 1};
  EXPECT_THROW(draw(panel), InvalidArgument);
  EXPECT_THROW(draw(EdgePanel{}), InvalidArgument);
  EdgePanel hexagonal = counted(grid_of(3, 3, Lattice::kHexagonal));
  hexagonal.edges = {{0, 4, 1.0}};  // adjacent on a rectangular diagonal only
  EXPECT_THROW(draw(hexagonal), InvalidArgument);
}

}  // namespace
}  // namespace somato
