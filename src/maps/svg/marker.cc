#include "maps/svg/marker.h"

#include <span>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

// Outlines around (0, 0), in radii.
constexpr Point kSquareMarker[] = {{-0.89, -0.89}, {0.89, -0.89}, {0.89, 0.89}, {-0.89, 0.89}};
constexpr Point kTriangle[] = {{0, -1.3}, {1.2, 0.8}, {-1.2, 0.8}};
constexpr Point kTriangleDown[] = {{0, 1.3}, {-1.2, -0.8}, {1.2, -0.8}};
constexpr Point kDiamond[] = {{0, -1.3}, {1.2, 0}, {0, 1.3}, {-1.2, 0}};
constexpr Point kPlus[] = {{-0.42, -1.2}, {0.42, -1.2}, {0.42, -0.42}, {1.2, -0.42},
                           {1.2, 0.42},   {0.42, 0.42}, {0.42, 1.2},   {-0.42, 1.2},
                           {-0.42, 0.42}, {-1.2, 0.42}, {-1.2, -0.42}, {-0.42, -0.42}};
constexpr Point kCross[] = {{0, -0.59},    {0.55, -1.14}, {1.14, -0.55},  {0.59, 0},
                            {1.14, 0.55},  {0.55, 1.14},  {0, 0.59},      {-0.55, 1.14},
                            {-1.14, 0.55}, {-0.59, 0},    {-1.14, -0.55}, {-0.55, -1.14}};
constexpr Point kStar[] = {{0, -1.4}, {0.33, -0.45}, {1.33, -0.43}, {0.53, 0.17},   {0.82, 1.13},
                           {0, 0.56}, {-0.82, 1.13}, {-0.53, 0.17}, {-1.33, -0.43}, {-0.33, -0.45}};

std::span<const Point> outline_of(MarkerShape shape) {
  switch (shape) {
    case MarkerShape::kCircle:
      return {};
    case MarkerShape::kSquare:
      return kSquareMarker;
    case MarkerShape::kTriangle:
      return kTriangle;
    case MarkerShape::kDiamond:
      return kDiamond;
    case MarkerShape::kTriangleDown:
      return kTriangleDown;
    case MarkerShape::kPlus:
      return kPlus;
    case MarkerShape::kCross:
      return kCross;
    case MarkerShape::kStar:
      return kStar;
  }
  SOMATO_ASSERT(false);
}

}  // namespace

void draw_marker(SvgWriter& svg, Point centre, double radius, const ClassMark& mark,
                 std::string_view tooltip) {
  const Paint paint{.fill = to_string(mark.colour)};
  if (mark.shape == MarkerShape::kCircle) return svg.circle(centre, radius, paint, tooltip);
  std::vector<Point> corners;
  for (const Point& corner : outline_of(mark.shape)) {
    corners.push_back({centre.x + radius * corner.x, centre.y + radius * corner.y});
  }
  svg.polygon(corners, paint, tooltip);
}

}  // namespace somato
