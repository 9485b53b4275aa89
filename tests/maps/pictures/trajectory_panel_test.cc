#include "maps/pictures/trajectory_panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/pictures/geometry.h"
#include "maps/pictures/panels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::draw;
using test::grid_of;
using test::group;
using test::texts;

TrajectoryPanel over(const Grid& grid, std::vector<std::size_t> winners) {
  return {.title = "Trajectory", .grid = grid, .winners = std::move(winners)};
}

std::string note_of(const TrajectoryPanel& panel) {
  std::string note;
  for (const std::string& line : frame_of(panel).note_lines) note += line + " ";
  return note;
}

TEST(TrajectoryPanel, EachStepHasAnArrowToItsTarget) {
  const TrajectoryPanel panel = over(grid_of(3, 3), {0, 0, 2, 8});
  const test::Element steps = group(draw(panel), "steps");
  const auto arrows = test::elements(steps, "polygon");
  ASSERT_EQ(arrows.size(), 2U);
  const Cells& cells = frame_of(panel).cells;
  const std::size_t targets[] = {2, 8};
  for (std::size_t i = 0; i < 2; ++i) {
    const Point tip = test::corners_of(arrows[i]).at(0);
    EXPECT_LT(distance(tip, cells.centre(targets[i])), cells.pixels() / 2);
  }
}

TEST(TrajectoryPanel, VisitsHaveTheNumberOfTheirFirstSampleAndTheLastThatOfTheLast) {
  TrajectoryPanel panel = over(grid_of(3, 3), {0, 0, 2, 8, 8, 8});
  EXPECT_EQ(texts(group(draw(panel), "numbers")), (std::vector<std::string>{"1", "3", "6"}));
  panel.first_number = 101;
  EXPECT_EQ(texts(group(draw(panel), "numbers")), (std::vector<std::string>{"101", "103", "106"}));
  EXPECT_NE(note_of(panel).find("Samples 101 (black circle) to 106 (black square): 2 steps"),
            std::string::npos);
}

// In grey: black and white, a circle and a square.
TEST(TrajectoryPanel, BeginningAndEndDifferInShape) {
  const test::Element visits = group(draw(over(grid_of(3, 3), {0, 4, 8})), "visits");
  EXPECT_EQ(test::elements(visits, "rect").size(), 1U);
  const auto circles = test::elements(visits, "circle");
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_EQ(circles[0]["fill"], "#ffffff");
  EXPECT_EQ(circles[1]["fill"], "#111111");
}

TEST(TrajectoryPanel, VisitsOfANeuronAreSideBySide) {
  const test::Element visits = group(draw(over(grid_of(1, 2), {0, 1, 0, 1, 0, 1, 0})), "visits");
  const auto drawn = test::drawn_in(visits);
  ASSERT_EQ(drawn.size(), 7U);
  for (std::size_t a = 0; a < drawn.size(); ++a) {
    for (std::size_t b = a + 1; b < drawn.size(); ++b) {
      EXPECT_FALSE(drawn[a].box.overlaps(drawn[b].box)) << a << " " << b;
    }
  }
}

// From the last to the first column: two lines, each to its border, and one arrow.
TEST(TrajectoryPanel, StepsAcrossTheBorderOfATorusLeaveAndEnter) {
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    const TrajectoryPanel panel = over(grid_of(4, 6, lattice, Topology::kTorus), {5, 0});
    const test::Element steps = group(draw(panel), "steps");
    EXPECT_EQ(test::elements(steps, "path").size(), 4U);  // with white rims
    EXPECT_EQ(test::elements(steps, "polygon").size(), 1U);
    const Cells& cells = frame_of(panel).cells;
    for (const test::Element& path : test::elements(steps, "path")) {
      double x[2];
      double y[2];
      ASSERT_EQ(std::sscanf(path["d"].c_str(), "M%lf %lfL%lf %lf", &x[0], &y[0], &x[1], &y[1]), 4);
      EXPECT_LT(std::fabs(x[1] - x[0]), 2 * cells.pixels());
      for (const double end : x) {
        EXPECT_GE(end, -0.01);
        EXPECT_LE(end, cells.width() + 0.01);
      }
    }
  }
}

TEST(TrajectoryPanel, OneNeuronAndManySamplesAreDrawn) {
  EXPECT_NE(note_of(over(grid_of(1, 1), {0, 0, 0})).find("Samples 1 to 3 have the same winner."),
            std::string::npos);
  std::vector<std::size_t> winners;
  for (std::size_t i = 0; i < kMostTrajectorySamples; ++i) winners.push_back(i % 2);
  EXPECT_NO_THROW(draw(over(grid_of(1, 2), winners)));
  EXPECT_NO_THROW(draw(over(grid_of(40, 40), winners)));
  winners.push_back(0);
  EXPECT_THROW(draw(over(grid_of(1, 2), winners)), InvalidArgument);
}

TEST(TrajectoryPanel, ShadesAreGreyAndLightEnoughForLines) {
  TrajectoryPanel panel = over(grid_of(1, 3), {0, 2});
  panel.values = {0.0, 5.0, 10.0};
  for (const test::Element& fill : group(draw(panel), "cells").children) {
    const std::string colour = fill["fill"];
    EXPECT_EQ(colour.substr(1, 2), colour.substr(3, 2));
    EXPECT_EQ(colour.substr(1, 2), colour.substr(5, 2));
    EXPECT_GE(std::stoi(colour.substr(1, 2), nullptr, 16), 0x90);
  }
}

TEST(TrajectoryPanel, WhatCannotBeDrawnIsRefused) {
  EXPECT_THROW(draw(over(grid_of(2, 2), {})), InvalidArgument);
  EXPECT_THROW(draw(over(grid_of(2, 2), {4})), InvalidArgument);
  TrajectoryPanel panel = over(grid_of(2, 2), {0});
  panel.values = {1, 2};
  EXPECT_THROW(draw(panel), InvalidArgument);
  EXPECT_THROW(draw(over({}, {0})), InvalidArgument);
}

}  // namespace
}  // namespace somato
