#include "maps/pictures/label_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "maps/grid/areas.h"
#include "maps/pictures/cells.h"
#include "maps/pictures/class_cells.h"
#include "maps/pictures/outlines.h"
#include "maps/svg/legend.h"
#include "maps/svg/marker.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"
#include "somato/maps/labels.h"

namespace somato {
namespace {

constexpr double kLeastRadius = 1.8;
constexpr double kGreatestRadius = 7.0;

std::vector<Won> won_by_neuron(const LabelPanel& panel) {
  std::vector<Won> won(panel.grid.size());
  for (std::size_t i = 0; i < panel.winners.size(); ++i) {
    ++won[panel.winners[i]][panel.classes[i]];
  }
  return won;
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
  const std::size_t samples = samples_of(won);
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
  return panel.show_areas && !panel.winners.empty() && panel.marks != LabelMarks::kPies;
}

std::vector<std::optional<std::size_t>> majorities(const LabelPanel& panel) {
  const NeuronLabels labels =
      NeuronLabels::by_majority(panel.winners, panel.classes, panel.grid.size());
  std::vector<std::optional<std::size_t>> classes(panel.grid.size());
  for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = labels[i];
  return classes;
}

bool has_numbers(const LabelPanel& panel, const Cells& cells) {
  if (panel.marks != LabelMarks::kText) return false;
  std::vector<std::string> names;
  names.reserve(panel.class_names.size());
  for (const std::string& name : panel.class_names) names.push_back(shown_name(name));
  return !fit_in_cells(names, cells);
}

// Cells with texts are larger if the names fit into larger ones.
double pixels_of(const LabelPanel& panel) {
  constexpr int kMostTenths = 16;
  const double usual = cell_pixels(panel.grid);
  for (int tenths = 10; tenths <= kMostTenths; ++tenths) {
    const double pixels = tenths * usual / 10.0;
    if (!has_numbers(panel, Cells(panel.grid, pixels))) return pixels;
  }
  return usual;
}

// The texts of the classes in cells: their names or their numbers, counted from 1.
std::vector<std::string> texts_of(const LabelPanel& panel, const Cells& cells) {
  const bool numbers = has_numbers(panel, cells);
  std::vector<std::string> texts;
  texts.reserve(panel.class_names.size());
  for (std::size_t i = 0; i < panel.class_names.size(); ++i) {
    texts.push_back(numbers ? fmt::format("{}", i + 1) : shown_name(panel.class_names[i]));
  }
  return texts;
}

// Won cells in a stronger, the others in a lighter tint of their area's colour.
std::vector<Colour> fills_of(const LabelPanel& panel, const std::vector<std::size_t>& area) {
  constexpr Colour kNothing{0xf4, 0xf4, 0xf4};
  constexpr double kWon = 0.5;
  constexpr double kArea = 0.18;
  std::vector<Colour> fills(panel.grid.size(), kNothing);
  if (panel.marks == LabelMarks::kPies) return fills;
  const auto labels = majorities(panel);
  for (std::size_t i = 0; i < fills.size(); ++i) {
    if (labels[i]) {
      fills[i] = tint(class_mark(*labels[i]).colour, kWon);
    } else if (!area.empty()) {
      fills[i] = tint(class_mark(area[i]).colour, kArea);
    }
  }
  return fills;
}

Legend legend_of(const LabelPanel& panel, const PanelFrame& frame) {
  if (!has_numbers(panel, frame.cells)) return {panel.class_names, frame.width};
  std::vector<std::string> names;
  names.reserve(panel.class_names.size());
  for (std::size_t i = 0; i < panel.class_names.size(); ++i) {
    names.push_back(fmt::format("{}  {}", i + 1, shown_name(panel.class_names[i])));
  }
  return {names, frame.width};
}

void check(const LabelPanel& panel) {
  require(panel.winners.size() == panel.classes.size(), "a panel needs a class for each winner");
  for (const std::size_t winner : panel.winners) {
    require(winner < panel.grid.size(), "a winner is not on the map");
  }
  for (const std::size_t class_number : panel.classes) {
    require(class_number < panel.class_names.size(), "a class has no name");
  }
  check_clusters(panel.grid, panel.clusters);
}

// The meaning of the marks.
std::string explanation_of(const LabelPanel& panel, const Cells& cells) {
  const std::vector<Won> won = won_by_neuron(panel);
  if (panel.marks == LabelMarks::kText) return "";
  if (panel.marks == LabelMarks::kPies) {
    return panel.size_by_hits ? "The area of a pie is proportional to its number of samples." : "";
  }
  const bool all_fit =
      std::all_of(won.begin(), won.end(), [&](const Won& at) { return fit_one_by_one(at, cells); });
  return all_fit ? ""
                 : "If samples lie too close, one marker represents all of a class, with their "
                   "number.";
}

std::string note_of(const LabelPanel& panel, const Cells& cells) {
  const std::string explanation = explanation_of(panel, cells);
  return panel.note + (panel.note.empty() || explanation.empty() ? "" : " ") + explanation;
}

void draw_marks(SvgWriter& svg, const LabelPanel& panel, const PanelFrame& frame,
                const std::vector<Won>& won, const std::vector<Colour>& fills) {
  const Point corner = frame.map_corner();
  switch (panel.marks) {
    case LabelMarks::kSamples:
      return draw_samples(svg, panel, frame.cells, corner, won);
    case LabelMarks::kPies:
      return draw_pies(svg, panel, frame.cells, corner, won);
    case LabelMarks::kText:
      return draw_texts(svg, frame.cells, corner, majorities(panel), texts_of(panel, frame.cells),
                        fills);
  }
}

}  // namespace

LabelPanel clusters_panel(const Grid& grid, const std::vector<std::size_t>& clusters) {
  LabelPanel panel{.title = "Clusters",
                   .grid = grid,
                   .classes = clusters,
                   .marks = LabelMarks::kText,
                   .clusters = clusters};
  panel.winners.resize(grid.size());
  std::iota(panel.winners.begin(), panel.winners.end(), std::size_t{0});
  const std::size_t count =
      clusters.empty() ? 0 : *std::max_element(clusters.begin(), clusters.end()) + 1;
  for (std::size_t i = 0; i < count; ++i) panel.class_names.push_back(fmt::format("{}", i + 1));
  return panel;
}

PanelFrame frame_of(const LabelPanel& panel) {
  check(panel);
  PanelFrame frame = make_frame(panel.title, panel.grid, pixels_of(panel));
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
  const std::vector<Colour> fills = fills_of(panel, area);
  draw_frame(svg, frame);
  draw_cells(svg, frame, fills,
             [&](std::size_t neuron) { return tooltip_of(panel, neuron, won[neuron]); });
  draw_borders(svg, frame.cells, corner, panel.clusters.empty() ? area : std::vector<std::size_t>(),
               panel.marks == LabelMarks::kPies ? "#bbbbbb" : "#ffffff");
  draw_outlines(svg, frame.cells, corner, panel.clusters);
  draw_marks(svg, panel, frame, won, fills);
  legend_of(panel, frame).draw(svg, {0, frame.foot_top()});
}

}  // namespace somato
