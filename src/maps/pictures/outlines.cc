#include "maps/pictures/outlines.h"

#include <algorithm>

#include "somato/core/check.h"

namespace somato {

void check_clusters(const Grid& grid, const std::vector<std::size_t>& clusters) {
  require(clusters.empty() || clusters.size() == grid.size(),
          "a panel needs the cluster of each neuron, or none");
}

std::vector<Point> in_pixels(const Cells& cells, std::vector<Point> points) {
  for (Point& point : points) point = {point.x * cells.unit().x, point.y * cells.unit().y};
  return points;
}

bool cut_line(Point& from, Point& to, Point size) {
  double begin = 0.0;
  double end = 1.0;
  const Point step{to.x - from.x, to.y - from.y};
  const auto limit = [&](double direction, double distance) {
    if (direction == 0.0) return distance >= 0.0;
    const double at = distance / direction;
    if (direction < 0.0) begin = std::max(begin, at);
    if (direction > 0.0) end = std::min(end, at);
    return begin < end;
  };
  if (!limit(-step.x, from.x) || !limit(step.x, size.x - from.x) || !limit(-step.y, from.y) ||
      !limit(step.y, size.y - from.y)) {
    return false;
  }
  to = {from.x + end * step.x, from.y + end * step.y};
  from = {from.x + begin * step.x, from.y + begin * step.y};
  return true;
}

void draw_outlines(SvgWriter& svg, const Cells& cells, Point corner,
                   const std::vector<std::size_t>& clusters) {
  if (clusters.empty()) return;
  draw_outlines(svg, cells.pixels(), corner,
                in_pixels(cells, cells.borders(clusters).between_areas));
}

void draw_outlines(SvgWriter& svg, double pixels, Point corner, const std::vector<Point>& ends) {
  const double width = std::clamp(pixels * 0.09, 1.2, 2.8);
  svg.open_group("outlines", corner, {.fill = "none"});
  if (!ends.empty()) {
    svg.segments(ends, {.stroke = "#ffffff", .stroke_width = 2.2 * width});
    svg.segments(ends, {.stroke = "#111111", .stroke_width = width});
  }
  svg.close_group();
}

void draw_borders(SvgWriter& svg, const Cells& cells, Point corner,
                  const std::vector<std::size_t>& area, const std::string& line_colour) {
  const std::vector<std::size_t> one_area(cells.grid().size(), 0);
  const Cells::Borders borders = cells.borders(area.empty() ? one_area : area);
  constexpr double kLeastCellWithLines = 8.0;
  if (cells.pixels() >= kLeastCellWithLines) {
    svg.open_group("lines", corner, {.fill = "none", .stroke = line_colour, .stroke_width = 0.6});
    svg.segments(in_pixels(cells, borders.within_areas));
    svg.close_group();
  }
  const double width = std::clamp(cells.pixels() * 0.06, 0.6, 1.6);
  svg.open_group("borders", corner, {.fill = "none", .stroke = "#333333", .stroke_width = width});
  svg.segments(in_pixels(cells, borders.around_map));
  svg.segments(in_pixels(cells, borders.between_areas));
  svg.close_group();
}

}  // namespace somato
