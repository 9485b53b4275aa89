#include "maps/pictures/projection_panel.h"

#include <gtest/gtest.h>

#include <limits>

#include "maps/pictures/geometry.h"
#include "maps/pictures/panels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::draw;
using test::grid_of;
using test::group;
using test::texts;

// The grid as it is, twice as wide as a row is apart from the next one.
ProjectionPanel stretched(const Grid& grid) {
  ProjectionPanel panel{.title = "Projection", .grid = grid};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Position at = grid.position(i);
    panel.neurons.push_back({2 * at.x, -at.y});
  }
  return panel;
}

std::vector<Point> centres(const test::Element& root, const std::string& name) {
  std::vector<Point> points;
  const test::Element drawn = group(root, name);
  for (const test::Drawn& one : test::drawn_in(drawn)) points.push_back(one.box.centre());
  return points;
}

std::size_t lines_in(const test::Element& path) {
  const std::string d = path["d"];
  return static_cast<std::size_t>(std::count(d.begin(), d.end(), 'M'));
}

TEST(ProjectionPanel, AxesHaveOneScaleAndYGrowsUpwards) {
  ProjectionPanel panel = stretched(grid_of(2, 3));
  panel.neurons[0].y = 5.0;
  const auto at = centres(draw(panel), "neurons");
  ASSERT_EQ(at.size(), 6U);
  EXPECT_LT(at[0].y, at[1].y);
  const double unit = (at[2].x - at[1].x) / 2;
  EXPECT_NEAR(at[4].y - at[1].y, unit, 0.05);
  EXPECT_NEAR(at[1].y - at[0].y, 5 * unit, 0.05);
}

TEST(ProjectionPanel, NeighboursAreConnected) {
  ProjectionPanel panel = stretched(grid_of(3, 4));
  auto paths = test::elements(group(draw(panel), "edges"), "path");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(lines_in(paths[0]), 3U * 3U + 2U * 4U);
  panel.clusters.assign(12, 0);
  panel.clusters[0] = 1;
  paths = test::elements(group(draw(panel), "edges"), "path");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(lines_in(paths[0]), 2U);
  EXPECT_FALSE(paths[0]["stroke-dasharray"].empty());
  EXPECT_EQ(texts(group(draw(panel), "neurons")).at(0), "2");
}

TEST(ProjectionPanel, LinesAcrossTheBorderOfATorusAreDotted) {
  ProjectionPanel panel = stretched(grid_of(4, 4, Lattice::kHexagonal, Topology::kTorus));
  const auto paths = test::elements(group(draw(panel), "edges"), "path");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(lines_in(paths[0]) + lines_in(paths[1]), 3U * 16U);
  EXPECT_FALSE(paths[0]["stroke-dasharray"].empty());
  EXPECT_TRUE(paths[1]["stroke-dasharray"].empty());
}

TEST(ProjectionPanel, SamplesHaveTheMarkersOfTheirClasses) {
  ProjectionPanel panel = stretched(grid_of(2, 2));
  panel.samples = {{0, 0}, {10, 1}};
  panel.classes = {0, 1};
  panel.class_names = {"<a>", ""};
  const test::Element root = draw(panel);
  EXPECT_EQ(group(root, "samples").children.at(0).name, "circle");
  EXPECT_EQ(group(root, "samples").children.at(1).name, "polygon");
  EXPECT_EQ(texts(group(root, "names")), (std::vector<std::string>{"<a>", "(no name)"}));
  panel.classes.clear();
  panel.class_names.clear();
  EXPECT_EQ(group(draw(panel), "samples").children.size(), 2U);
  EXPECT_TRUE(test::groups(draw(panel), "names").empty());
}

TEST(ProjectionPanel, EverythingIsWithinThePicture) {
  for (const double size : {1e-30, 1.0, 1e30, 1.5e308}) {
    ProjectionPanel panel{.title = "p", .grid = grid_of(1, 3)};
    panel.neurons = {{-size, 0}, {size, size / 2}, {0, 0}};
    panel.samples = {{0, -size / 3}};
    const test::Element root = draw(panel);
    const test::Box picture = test::own_box(root.children.at(1));
    for (const char* name : {"neurons", "samples"}) {
      for (const Point& at : centres(root, name)) {
        EXPECT_TRUE(picture.holds({at.x, at.y, at.x, at.y})) << size;
      }
    }
  }
}

TEST(ProjectionPanel, OneNeuronAndEqualNeuronsAreDrawn) {
  EXPECT_EQ(centres(draw(stretched(grid_of(1, 1))), "neurons").size(), 1U);
  ProjectionPanel panel{.title = "p", .grid = grid_of(2, 2), .neurons = {{}, {}, {}, {}}};
  EXPECT_EQ(centres(draw(panel), "neurons").size(), 4U);
}

TEST(ProjectionPanel, WhatCannotBeDrawnIsRefused) {
  ProjectionPanel panel = stretched(grid_of(2, 2));
  panel.neurons.pop_back();
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel = stretched(grid_of(2, 2));
  panel.samples = {{std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.samples = {{0, 0}};
  panel.classes = {0};
  EXPECT_THROW(draw(panel), InvalidArgument);
  panel.class_names = {"a"};
  panel.classes = {0, 0};
  EXPECT_THROW(draw(panel), InvalidArgument);
  EXPECT_THROW(draw(ProjectionPanel{}), InvalidArgument);
}

}  // namespace
}  // namespace somato
