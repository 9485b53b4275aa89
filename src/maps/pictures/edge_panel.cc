#include "maps/pictures/edge_panel.h"

#include <algorithm>
#include <cmath>

#include "maps/pictures/expanded_grid.h"
#include "maps/pictures/outlines.h"
#include "maps/pictures/value_panel.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr Colour kNoCell{0xff, 0xff, 0xff};

ValueRange limits_of(const EdgePanel& panel) {
  std::vector<double> all = panel.values;
  for (const EdgeValue& edge : panel.edges) all.push_back(edge.value);
  return range_of(all);
}

void draw_dots(SvgWriter& svg, const PanelFrame& frame, const std::vector<std::size_t>& cells,
               const std::vector<Colour>& fills) {
  svg.open_group("neurons", frame.map_corner());
  for (const std::size_t cell : cells) {
    svg.circle(frame.cells.centre(cell), frame.cells.pixels() * 0.16,
               {.fill = to_string(readable_on(fills[cell]))});
  }
  svg.close_group();
}

// The outlines of the neurons' cells at twice the size, which lie in the cells of the edges, within
// the picture.
void draw_coarse_outlines(SvgWriter& svg, const PanelFrame& frame, const EdgePanel& panel,
                          std::size_t first_cell) {
  if (panel.clusters.empty()) return;
  const Cells coarse(panel.grid, 2 * frame.cells.pixels());
  const Point fine_centre = frame.cells.centre(first_cell);
  const Point coarse_centre = coarse.centre(0);
  const Point move{fine_centre.x - coarse_centre.x, fine_centre.y - coarse_centre.y};
  std::vector<Point> ends = in_pixels(coarse, coarse.borders(panel.clusters).between_areas);
  std::vector<Point> within;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    Point from{ends[i].x + move.x, ends[i].y + move.y};
    Point to{ends[i + 1].x + move.x, ends[i + 1].y + move.y};
    if (!cut_line(from, to, {frame.cells.width(), frame.cells.height()})) continue;
    within.insert(within.end(), {from, to});
  }
  draw_outlines(svg, coarse.pixels(), frame.map_corner(), within);
}

void draw_expanded(SvgWriter& svg, const PanelFrame& frame, const EdgePanel& panel,
                   const ValueRange& range) {
  const ExpandedGrid expanded(panel.grid);
  const ExpandedValues all = expanded_values(expanded, panel);
  std::vector<Colour> fills(all.values.size(), kNoCell);
  for (std::size_t i = 0; i < fills.size(); ++i) {
    if (all.values[i]) fills[i] = sequential_colour(range.place_of(*all.values[i]));
  }
  draw_cells(svg, frame, fills, [&](std::size_t cell) { return all.descriptions[cell]; });
  draw_coarse_outlines(svg, frame, panel, expanded.cell_of(0));
  std::vector<std::size_t> neurons;
  neurons.reserve(panel.grid.size());
  for (std::size_t i = 0; i < panel.grid.size(); ++i) neurons.push_back(expanded.cell_of(i));
  draw_dots(svg, frame, neurons, fills);
}

void draw_graph(SvgWriter& svg, const PanelFrame& frame, const EdgePanel& panel,
                const ValueRange& range) {
  std::vector<Colour> fills;
  fills.reserve(panel.values.size());
  for (const double value : panel.values) fills.push_back(sequential_colour(range.place_of(value)));
  draw_cells(svg, frame, fills, [&](std::size_t neuron) {
    return place_of(panel.grid, neuron) + ": " + readable_number(panel.values[neuron]);
  });
  const double width = std::clamp(frame.cells.pixels() * 0.16, 1.5, 5.0);
  svg.open_group("edges", frame.map_corner(), {.fill = "none"});
  for (const auto& [first, second, value] : panel.edges) {
    const std::vector<Point> ends{frame.cells.centre(first), frame.cells.centre(second)};
    svg.segments(ends, {.stroke = "#222222", .stroke_width = width + 1.5});
    svg.segments(ends, {.stroke = to_string(sequential_colour(range.place_of(value))),
                        .stroke_width = width});
  }
  svg.close_group();
  draw_outlines(svg, frame.cells, frame.map_corner(), panel.clusters);
}

void check(const EdgePanel& panel) {
  require(panel.grid.size() > 0, "a panel needs a grid with neurons");
  check_values(panel.grid, panel.values);
  check_clusters(panel.grid, panel.clusters);
  for (const auto& [first, second, value] : panel.edges) {
    require(first < panel.grid.size() && second < panel.grid.size(),
            "an edge connects two neurons of the map");
    require(std::isfinite(value), "a panel's values must be finite");
    if (!panel.grid.graph()) ExpandedGrid(panel.grid).cell_between(first, second);
  }
}

}  // namespace

PanelFrame frame_of(const EdgePanel& panel) {
  check(panel);
  PanelFrame frame =
      make_frame(panel.title, panel.grid.graph() ? panel.grid : ExpandedGrid(panel.grid).fine());
  frame.foot_height = kColourBarHeight;
  add_note(frame, panel.note, panel.grid.topology());
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const EdgePanel& panel) {
  const ValueRange range = limits_of(panel);
  draw_frame(svg, frame);
  panel.grid.graph() ? draw_graph(svg, frame, panel, range)
                     : draw_expanded(svg, frame, panel, range);
  draw_bar(svg, frame, range);
}

}  // namespace somato
