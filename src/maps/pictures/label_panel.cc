#include "maps/pictures/label_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "maps/grid/areas.h"
#include "maps/pictures/cells.h"
#include "maps/svg/legend.h"
#include "maps/svg/marker.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"
#include "somato/maps/labels.h"

namespace somato {
namespace {

constexpr double kLeastRadius = 1.8;
constexpr double kGreatestRadius = 7.0;
constexpr double kWidestTooltipName = 600.0;

// The number of samples of each class that a neuron wins, by class number.
using Won = std::map<std::size_t, std::size_t>;

std::vector<Won> won_by_neuron(const LabelPanel& panel) {
  std::vector<Won> won(panel.grid.size());
  for (std::size_t i = 0; i < panel.winners.size(); ++i) {
    ++won[panel.winners[i]][panel.classes[i]];
  }
  return won;
}

std::string tooltip_name(const LabelPanel& panel, std::size_t class_number) {
  return shortened(shown_name(panel.class_names[class_number]), kWidestTooltipName, 12.0);
}

std::string tooltip_of(const LabelPanel& panel, std::size_t neuron, const Won& won) {
  std::string text = place_of(panel.grid, neuron);
  const char* separator = ": ";
  for (const auto& [class_number, samples] : won) {
    text += fmt::format("{}{} x {}", separator, samples, tooltip_name(panel, class_number));
    separator = ", ";
  }
  return text;
}

// Places for markers in an upright square, row after row.
class MarkerSquare {
 public:
  MarkerSquare(std::size_t markers, double side) : markers_(markers) {
    while (columns_ * columns_ < markers) ++columns_;
    spacing_ = side / real(columns_);
  }

  double spacing() const { return spacing_; }

  /// The offset of a marker from the middle of the square; short rows are centred.
  Point offset(std::size_t marker) const {
    const std::size_t row = marker / columns_;
    const std::size_t rows = (markers_ + columns_ - 1) / columns_;
    const std::size_t in_row = std::min(columns_, markers_ - row * columns_);
    return {spacing_ * (real(marker % columns_) - 0.5 * (real(in_row) - 1)),
            spacing_ * (real(row) - 0.5 * (real(rows) - 1))};
  }

 private:
  std::size_t markers_;
  std::size_t columns_ = 1;
  double spacing_ = 0.0;
};

// A marker that represents `samples` samples of one class.
struct Marker {
  std::size_t class_number = 0;
  std::size_t samples = 1;
};

double marker_side(const Cells& cells) {
  return 0.96 * cells.inner_side();
}

double radius_for(double spacing) {
  return std::min(0.36 * spacing, kGreatestRadius);
}

// Whether the samples of a neuron have room for a marker each.
bool fit_one_by_one(const Won& won, const Cells& cells) {
  std::size_t samples = 0;
  for (const auto& [class_number, of_class] : won) samples += of_class;
  return samples <= 1 ||
         radius_for(MarkerSquare(samples, marker_side(cells)).spacing()) >= kLeastRadius;
}

std::vector<Marker> markers_for(const Won& won, bool one_by_one) {
  std::vector<Marker> markers;
  for (const auto& [class_number, samples] : won) {
    if (one_by_one) {
      markers.insert(markers.end(), samples, Marker{class_number});
    } else {
      markers.push_back({class_number, samples});
    }
  }
  return markers;
}

// The size of the number below a marker; 0 where there is no room for it.
double count_size(double spacing, std::size_t samples) {
  constexpr double kLeastSize = 7.0;
  const double narrowest = 0.95 * spacing / text_width(fmt::format("{}", samples), 1.0);
  const double size = std::min({0.45 * spacing, narrowest, 11.0});
  return size < kLeastSize ? 0.0 : size;
}

void draw_won(SvgWriter& svg, const LabelPanel& panel, const Cells& cells, std::size_t neuron,
              const Won& won) {
  const bool one_by_one = fit_one_by_one(won, cells);
  const std::vector<Marker> markers = markers_for(won, one_by_one);
  const MarkerSquare square(markers.size(), marker_side(cells));
  const double spacing = square.spacing();
  const Point centre = cells.centre(neuron);
  const std::string place = place_of(panel.grid, neuron);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const auto [class_number, samples] = markers[i];
    const Point at{centre.x + square.offset(i).x, centre.y + square.offset(i).y};
    const std::string tooltip =
        fmt::format("{} x {}, {}", samples, tooltip_name(panel, class_number), place);
    const bool has_count = !one_by_one && count_size(spacing, samples) > 0;
    const Point raised{at.x, at.y - 0.22 * spacing};
    draw_marker(svg, has_count ? raised : at, radius_for(has_count ? 0.6 * spacing : spacing),
                class_mark(class_number), tooltip);
  }
}

void draw_counts(SvgWriter& svg, const Cells& cells, std::size_t neuron, const Won& won) {
  if (fit_one_by_one(won, cells)) return;
  const MarkerSquare square(won.size(), marker_side(cells));
  const Point centre = cells.centre(neuron);
  std::size_t marker = 0;
  for (const auto& [class_number, samples] : won) {
    const Point offset = square.offset(marker++);
    const double size = count_size(square.spacing(), samples);
    if (size == 0) continue;
    svg.text({centre.x + offset.x, centre.y + offset.y + 0.46 * square.spacing()},
             fmt::format("{}", samples), {size, Anchor::kMiddle, true});
  }
}

void draw_samples(SvgWriter& svg, const LabelPanel& panel, const Cells& cells, Point corner,
                  const std::vector<Won>& won) {
  const double outline = std::clamp(cells.pixels() * 0.03, 0.15, 0.75);
  svg.open_group("samples", corner, {.stroke = "#222222", .stroke_width = outline});
  for (std::size_t i = 0; i < won.size(); ++i) draw_won(svg, panel, cells, i, won[i]);
  svg.close_group();
  svg.open_group("counts", corner);
  for (std::size_t i = 0; i < won.size(); ++i) draw_counts(svg, cells, i, won[i]);
  svg.close_group();
}

bool has_areas(const LabelPanel& panel) {
  return panel.show_areas && !panel.winners.empty();
}

// Won cells in a stronger, the others in a lighter tint of their area's colour.
std::vector<Colour> fills_of(const LabelPanel& panel, const std::vector<std::size_t>& area) {
  constexpr Colour kNothing{0xf4, 0xf4, 0xf4};
  constexpr double kWon = 0.5;
  constexpr double kArea = 0.18;
  const NeuronLabels labels =
      NeuronLabels::by_majority(panel.winners, panel.classes, panel.grid.size());
  std::vector<Colour> fills(panel.grid.size(), kNothing);
  for (std::size_t i = 0; i < fills.size(); ++i) {
    if (labels[i]) {
      fills[i] = tint(class_mark(*labels[i]).colour, kWon);
    } else if (!area.empty()) {
      fills[i] = tint(class_mark(area[i]).colour, kArea);
    }
  }
  return fills;
}

void draw_borders(SvgWriter& svg, const Cells& cells, Point corner,
                  const std::vector<std::size_t>& area) {
  const std::vector<std::size_t> one_area(cells.grid().size(), 0);
  const Cells::Borders borders = cells.borders(area.empty() ? one_area : area);
  // Scaled here and not by the group, whose scale would draw slanting lines thinner.
  const auto in_pixels = [&](std::vector<Point> ends) {
    for (Point& end : ends) end = {end.x * cells.unit().x, end.y * cells.unit().y};
    return ends;
  };
  constexpr double kLeastCellWithLines = 8.0;
  if (cells.pixels() >= kLeastCellWithLines) {
    svg.open_group("lines", corner, {.fill = "none", .stroke = "#ffffff", .stroke_width = 0.6});
    svg.segments(in_pixels(borders.within_areas));
    svg.close_group();
  }
  const double width = std::clamp(cells.pixels() * 0.06, 0.6, 1.6);
  svg.open_group("borders", corner, {.fill = "none", .stroke = "#333333", .stroke_width = width});
  svg.segments(in_pixels(borders.around_map));
  svg.segments(in_pixels(borders.between_areas));
  svg.close_group();
}

Legend legend_of(const LabelPanel& panel, const PanelFrame& frame) {
  return {panel.class_names, frame.width};
}

void check(const LabelPanel& panel) {
  require(panel.winners.size() == panel.classes.size(), "a panel needs a class for each winner");
  for (const std::size_t winner : panel.winners) {
    require(winner < panel.grid.size(), "a winner is not on the map");
  }
  for (const std::size_t class_number : panel.classes) {
    require(class_number < panel.class_names.size(), "a class has no name");
  }
}

std::string note_of(const LabelPanel& panel, const Cells& cells) {
  const std::vector<Won> won = won_by_neuron(panel);
  const bool all_fit =
      std::all_of(won.begin(), won.end(), [&](const Won& at) { return fit_one_by_one(at, cells); });
  if (all_fit) return panel.note;
  return (panel.note.empty() ? "" : panel.note + " ") +
         "If samples lie too close, one marker represents all of a class, with their number.";
}

}  // namespace

PanelFrame frame_of(const LabelPanel& panel) {
  check(panel);
  PanelFrame frame = make_frame(panel.title, panel.grid);
  frame.foot_height = legend_of(panel, frame).height() + 6;
  add_note(frame, note_of(panel, frame.cells));
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const LabelPanel& panel) {
  const std::vector<Won> won = won_by_neuron(panel);
  const Point corner = frame.map_corner();
  const std::vector<std::size_t> area =
      has_areas(panel) ? WinnerAreas(panel.grid, panel.winners).classes_of_neurons(panel.classes)
                       : std::vector<std::size_t>();
  draw_frame(svg, frame);
  draw_cells(svg, frame, fills_of(panel, area),
             [&](std::size_t neuron) { return tooltip_of(panel, neuron, won[neuron]); });
  draw_borders(svg, frame.cells, corner, area);
  draw_samples(svg, panel, frame.cells, corner, won);
  legend_of(panel, frame).draw(svg, {0, frame.foot_top()});
}

}  // namespace somato
