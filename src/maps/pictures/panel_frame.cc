#include "maps/pictures/panel_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kTitleSize = 14.0;
constexpr double kTitleHeight = 26.0;
constexpr double kNoteSize = 11.0;
constexpr double kNoteLine = 15.0;
constexpr std::size_t kMostNoteLines = 6;
constexpr double kLeastWidth = 260.0;
constexpr std::size_t kMostTooltips = 2500;

std::string with_topology(const std::string& note, Topology topology) {
  if (topology == Topology::kPlane) return note;
  return (note.empty() ? "" : note + " ") + "A torus: opposite edges join.";
}

// The neurons of each colour, in the order of colours: a fill is written once.
std::map<std::string, std::vector<std::size_t>> neurons_by_fill(const std::vector<Colour>& fills) {
  std::map<std::string, std::vector<std::size_t>> neurons;
  for (std::size_t i = 0; i < fills.size(); ++i) neurons[to_string(fills[i])].push_back(i);
  return neurons;
}

void draw_connections(SvgWriter& svg, const PanelFrame& frame) {
  const std::vector<Point> ends = frame.cells.connections();
  if (ends.empty()) return;
  svg.open_group("connections", frame.map_corner(), {}, frame.cells.unit());
  svg.segments(ends, {.fill = "none", .stroke = "#666666", .stroke_width = 0.06});
  svg.close_group();
}

}  // namespace

Point PanelFrame::map_corner() const {
  return {(width - map_width) / 2, kTitleHeight};
}

double PanelFrame::foot_top() const {
  return kTitleHeight + map_height + 12;
}

double PanelFrame::height() const {
  return foot_top() + foot_height + kNoteLine * static_cast<double>(note_lines.size());
}

double cell_pixels(const Grid& grid) {
  require(grid.size() > 0, "a panel needs a grid with neurons");
  const std::size_t longest_side =
      grid.graph() ? std::max(grid.graph()->extent().row, grid.graph()->extent().column)
                   : std::max(grid.rows(), grid.columns());
  const auto longest = static_cast<double>(longest_side);
  return std::clamp(std::floor(kMapSide / longest), 5.0, 48.0);
}

PanelFrame make_frame(const std::string& title, const Grid& grid) {
  return make_frame(title, grid, cell_pixels(grid));
}

PanelFrame make_frame(const std::string& title, const Grid& grid, double pixels) {
  const Cells cells(grid, pixels);
  return {title, cells, cells.width(), cells.height(), std::max(cells.width(), kLeastWidth),
          0.0,   {}};
}

PanelFrame make_frame(const std::string& title, double width, double height) {
  return {title, Cells(Grid(), 1.0), width, height, std::max(width, kLeastWidth), 0.0, {}};
}

void check_values(const Grid& grid, const std::vector<double>& values) {
  require(values.size() == grid.size(), "a panel needs one value per neuron");
  require(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
          "a panel's values must be finite");
}

void add_note(PanelFrame& frame, const std::string& note) {
  add_note(frame, note, frame.cells.grid().topology());
}

void add_note(PanelFrame& frame, const std::string& note, Topology topology) {
  frame.note_lines = wrapped(with_topology(note, topology), frame.width, kNoteSize, kMostNoteLines);
}

void draw_frame(SvgWriter& svg, const PanelFrame& frame) {
  write_line(svg, {0, kTitleSize}, frame.title, frame.width, {.size = kTitleSize, .bold = true});
  double base_line = frame.foot_top() + frame.foot_height + kNoteSize;
  for (const std::string& line : frame.note_lines) {
    svg.text({0, base_line}, line, {.size = kNoteSize, .fill = "#444444"});
    base_line += kNoteLine;
  }
}

void draw_cells(SvgWriter& svg, const PanelFrame& frame, const std::vector<Colour>& fills,
                const std::function<std::string(std::size_t)>& tooltip) {
  // Cells of one colour are outlined in it, nearly a pixel wide, or the white between them shines
  // through where a viewer smooths edges.
  const Point unit = frame.cells.unit();
  const bool has_tooltips = fills.size() <= kMostTooltips;
  svg.open_group("cells", frame.map_corner(), {.stroke_width = 0.8 / unit.x}, unit);
  for (const auto& [fill, neurons] : neurons_by_fill(fills)) {
    svg.open_group("", {}, {.fill = fill, .stroke = fill});
    for (const std::size_t neuron : neurons) {
      svg.polygon(frame.cells.corners(neuron), {}, has_tooltips ? tooltip(neuron) : std::string());
    }
    svg.close_group();
  }
  svg.close_group();
  draw_connections(svg, frame);
}

std::string place_of(const Grid& grid, std::size_t neuron) {
  if (grid.graph()) return fmt::format("neuron {}", neuron + 1);
  return fmt::format("row {}, column {}", grid.row_of(neuron) + 1, grid.column_of(neuron) + 1);
}

}  // namespace somato
