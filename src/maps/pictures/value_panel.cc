#include "maps/pictures/value_panel.h"

#include <algorithm>
#include <cmath>

#include "maps/pictures/outlines.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

void draw_numbers(SvgWriter& svg, const PanelFrame& frame, const ValuePanel& panel,
                  const std::vector<Colour>& fills) {
  constexpr double kLeastSize = 6.0;
  const double room = frame.cells.inner_side() * 0.9;
  svg.open_group("numbers", frame.map_corner());
  for (std::size_t i = 0; i < panel.values.size(); ++i) {
    if (panel.values[i] == 0.0) continue;
    const std::string text = readable_number(panel.values[i]);
    const double size = std::min({room * 0.6, room / text_width(text, 1.0), 13.0});
    if (size < kLeastSize) continue;
    const Point centre = frame.cells.centre(i);
    svg.text({centre.x, centre.y + size * 0.36}, text,
             {size, Anchor::kMiddle, false, to_string(readable_on(fills[i]))});
  }
  svg.close_group();
}

ValueRange limits_of(const ValuePanel& panel) {
  if (!panel.limits) return range_of(panel.values);
  return {panel.limits->least, panel.limits->greatest};
}

}  // namespace

void draw_bar(SvgWriter& svg, const PanelFrame& frame, const ValueRange& range) {
  const double width = std::max(frame.map_width, 160.0);
  draw_colour_bar(svg, {(frame.width - width) / 2, frame.foot_top()}, width, range);
}

PanelFrame frame_of(const ValuePanel& panel) {
  PanelFrame frame = make_frame(panel.title, panel.grid);
  check_values(panel.grid, panel.values);
  check_clusters(panel.grid, panel.clusters);
  require(!panel.limits ||
              (std::isfinite(panel.limits->least) && std::isfinite(panel.limits->greatest) &&
               panel.limits->least <= panel.limits->greatest),
          "a panel's limits must be finite and in ascending order");
  frame.foot_height = kColourBarHeight;
  add_note(frame, panel.note);
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const ValuePanel& panel) {
  const ValueRange range = limits_of(panel);
  std::vector<Colour> fills;
  fills.reserve(panel.values.size());
  for (const double value : panel.values) fills.push_back(sequential_colour(range.place_of(value)));
  draw_frame(svg, frame);
  draw_cells(svg, frame, fills, [&](std::size_t neuron) {
    return place_of(panel.grid, neuron) + ": " + readable_number(panel.values[neuron]);
  });
  draw_outlines(svg, frame.cells, frame.map_corner(), panel.clusters);
  if (panel.write_values) draw_numbers(svg, frame, panel, fills);
  draw_bar(svg, frame, range);
}

}  // namespace somato
