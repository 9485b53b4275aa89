#include "maps/svg/marker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "maps/pictures/geometry.h"

namespace somato {
namespace {

constexpr double kRadius = 100.0;
constexpr Point kCentre{300.0, 200.0};

constexpr MarkerShape kWithCorners[] = {
    MarkerShape::kSquare, MarkerShape::kTriangle, MarkerShape::kDiamond, MarkerShape::kTriangleDown,
    MarkerShape::kPlus,   MarkerShape::kCross,    MarkerShape::kStar};

test::Element drawn_marker(MarkerShape shape) {
  SvgWriter svg(600, 400, "one marker");
  draw_marker(svg, kCentre, kRadius, {{1, 2, 3}, shape}, "a tip");
  return test::read_xml(std::move(svg).finish()).value().children.back();
}

// In hundredths of the radius, from the centre; whole numbers, which can be compared.
std::vector<std::pair<int, int>> outline(MarkerShape shape) {
  std::vector<std::pair<int, int>> corners;
  for (const Point& corner : test::corners_of(drawn_marker(shape))) {
    corners.emplace_back(static_cast<int>(std::lround(corner.x - kCentre.x)),
                         static_cast<int>(std::lround(corner.y - kCentre.y)));
  }
  return corners;
}

std::set<std::pair<int, int>> mapped(MarkerShape shape, int xx, int xy, int yx, int yy) {
  std::set<std::pair<int, int>> corners;
  for (const auto& [x, y] : outline(shape)) corners.emplace(xx * x + xy * y, yx * x + yy * y);
  return corners;
}

std::set<std::pair<int, int>> corner_set(MarkerShape shape) {
  return mapped(shape, 1, 0, 0, 1);
}

// The area of a polygon, by the formula of Gauss.
double area_in_radii(MarkerShape shape) {
  const auto corners = outline(shape);
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [x, y] = corners[i];
    const auto& [next_x, next_y] = corners[(i + 1) % corners.size()];
    twice += static_cast<double>(x * next_y - next_x * y);
  }
  return std::fabs(twice) / 2 / (kRadius * kRadius);
}

TEST(Marker, ACircleIsOne) {
  const test::Element circle = drawn_marker(MarkerShape::kCircle);
  EXPECT_EQ(circle.name, "circle");
  EXPECT_EQ(test::number_of(circle, "cx"), kCentre.x);
  EXPECT_EQ(test::number_of(circle, "cy"), kCentre.y);
  EXPECT_EQ(test::number_of(circle, "r"), kRadius);
  EXPECT_EQ(circle["fill"], "#010203");
  EXPECT_EQ(circle.children.at(0).text, "a tip");
}

TEST(Marker, EveryShapeIsTheSameLeftAndRightOfItsCentre) {
  for (const MarkerShape shape : kWithCorners) {
    EXPECT_EQ(mapped(shape, -1, 0, 0, 1), corner_set(shape)) << static_cast<int>(shape);
  }
}

TEST(Marker, ShapesWithoutAnUpAreTheSameUpsideDown) {
  for (const MarkerShape shape :
       {MarkerShape::kSquare, MarkerShape::kDiamond, MarkerShape::kPlus, MarkerShape::kCross}) {
    EXPECT_EQ(mapped(shape, 1, 0, 0, -1), corner_set(shape)) << static_cast<int>(shape);
  }
  EXPECT_EQ(mapped(MarkerShape::kTriangle, 1, 0, 0, -1), corner_set(MarkerShape::kTriangleDown));
}

TEST(Marker, SquarePlusAndCrossAreTheSameOnTheirSide) {
  for (const MarkerShape shape : {MarkerShape::kSquare, MarkerShape::kPlus, MarkerShape::kCross}) {
    EXPECT_EQ(mapped(shape, 0, -1, 1, 0), corner_set(shape)) << static_cast<int>(shape);
  }
}

// A cross is a plus on its corner: bars whose sides are parallel to the diagonals.
TEST(Marker, EdgesOfPlusAndCrossMeetAtRightAngles) {
  for (const MarkerShape shape : {MarkerShape::kPlus, MarkerShape::kCross}) {
    const auto corners = outline(shape);
    ASSERT_EQ(corners.size(), 12U);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [ax, ay] = corners[i];
      const auto& [bx, by] = corners[(i + 1) % 12];
      const auto& [cx, cy] = corners[(i + 2) % 12];
      const double length = std::hypot(bx - ax, by - ay) * std::hypot(cx - bx, cy - by);
      EXPECT_NEAR(((bx - ax) * (cx - bx) + (by - ay) * (cy - by)) / length, 0.0, 0.01) << i;
    }
  }
}

TEST(Marker, AStarHasFivePointsAroundItsCentre) {
  const auto corners = outline(MarkerShape::kStar);
  ASSERT_EQ(corners.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / 5 - 0.5);
    const auto& [x, y] = corners[i];
    const double distance = std::hypot(x, y);
    EXPECT_NEAR(distance, i % 2 == 0 ? 140.0 : 56.0, 1.5) << i;
    EXPECT_NEAR(x, distance * std::cos(angle), 1.0) << i;
    EXPECT_NEAR(y, distance * std::sin(angle), 1.0) << i;
  }
}

TEST(Marker, ShapesCoverAboutTheAreaOfTheCircleAndReachNotFar) {
  for (const MarkerShape shape : kWithCorners) {
    EXPECT_NEAR(area_in_radii(shape) / std::numbers::pi, 0.95, 0.25) << static_cast<int>(shape);
    for (const auto& [x, y] : outline(shape)) EXPECT_LE(std::hypot(x, y), 145.0);
  }
}

}  // namespace
}  // namespace somato
