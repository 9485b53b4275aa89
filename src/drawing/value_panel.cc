#include "drawing/value_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kBarHeight = 12.0;
constexpr double kNumberSize = 11.0;
constexpr double kFootHeight = kBarHeight + 24.0;

struct Extent {
  double least = 0.0;
  double greatest = 0.0;

  bool is_constant() const { return least == greatest; }

  /// The position of `value`, from 0 to 1; in the middle if there is only one value.
  double place_of(double value) const {
    if (is_constant()) return 0.5;
    const double length = greatest - least;
    if (std::isfinite(length)) return (value - least) / length;
    return (value / 2 - least / 2) / (greatest / 2 - least / 2);
  }
};

Extent extent_of(const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, *greatest};
}

std::string number(double value) {
  const bool is_short_whole = std::fabs(value) < 1e7 && value == std::floor(value);
  return is_short_whole ? svg_number(value, 0) : fmt::format("{:.4g}", value);
}

void draw_numbers(SvgWriter& svg, const PanelFrame& frame, const ValuePanel& panel,
                  const std::vector<Colour>& fills) {
  constexpr double kLeastSize = 6.0;
  const double room = frame.cells.inner_side() * 0.9;
  svg.open_group("numbers", frame.map_corner());
  for (std::size_t i = 0; i < panel.values.size(); ++i) {
    if (panel.values[i] == 0.0) continue;
    const std::string text = number(panel.values[i]);
    const double size = std::min({room * 0.6, room / text_width(text, 1.0), 13.0});
    if (size < kLeastSize) continue;
    const Point centre = frame.cells.centre(i);
    svg.text({centre.x, centre.y + size * 0.36}, text,
             {size, Anchor::kMiddle, false, to_string(readable_on(fills[i]))});
  }
  svg.close_group();
}

// Each step reaches below the next, so that no gap opens between them.
void draw_gradient(SvgWriter& svg, Point corner, double width) {
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const double left = width * i / kSteps;
    const double right = width * std::min(i + 2, kSteps) / kSteps;
    svg.rectangle({corner.x + left, corner.y}, right - left, kBarHeight,
                  {.fill = to_string(sequential_colour((i + 0.5) / kSteps))});
  }
}

void draw_bar(SvgWriter& svg, const PanelFrame& frame, const Extent& range) {
  const double width = std::max(frame.cells.width(), 160.0);
  const Point corner{(frame.width - width) / 2, frame.foot_top()};
  const double base_line = corner.y + kBarHeight + kNumberSize + 2;
  svg.open_group("bar");
  if (range.is_constant()) {
    svg.rectangle(corner, width, kBarHeight, {.fill = to_string(sequential_colour(0.5))});
    svg.text({corner.x, base_line}, "all values are " + number(range.least), {kNumberSize});
  } else {
    draw_gradient(svg, corner, width);
    svg.text({corner.x, base_line}, number(range.least), {kNumberSize});
    svg.text({corner.x + width, base_line}, number(range.greatest), {kNumberSize, Anchor::kEnd});
  }
  svg.close_group();
}

}  // namespace

PanelFrame frame_of(const ValuePanel& panel) {
  PanelFrame frame = make_frame(panel.title, panel.grid);
  require(panel.values.size() == panel.grid.size(), "a panel needs one value per neuron");
  const auto is_finite = [](double value) { return std::isfinite(value); };
  require(std::all_of(panel.values.begin(), panel.values.end(), is_finite),
          "a panel's values must be finite");
  frame.foot_height = kFootHeight;
  add_note(frame, panel.note);
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const ValuePanel& panel) {
  const Extent range = extent_of(panel.values);
  std::vector<Colour> fills;
  fills.reserve(panel.values.size());
  for (const double value : panel.values) fills.push_back(sequential_colour(range.place_of(value)));
  draw_frame(svg, frame);
  draw_cells(svg, frame, fills, [&](std::size_t neuron) {
    return place_of(panel.grid, neuron) + ": " + number(panel.values[neuron]);
  });
  if (panel.write_values) draw_numbers(svg, frame, panel, fills);
  draw_bar(svg, frame, range);
}

}  // namespace somato
