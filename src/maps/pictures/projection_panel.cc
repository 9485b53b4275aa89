#include "maps/pictures/projection_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/pictures/class_cells.h"
#include "maps/pictures/outlines.h"
#include "maps/svg/legend.h"
#include "maps/svg/marker.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kPadding = 14.0;

// From positions to pixels of the map: both axes have one scale, and y grows downwards.
class Scale {
 public:
  explicit Scale(const ProjectionPanel& panel) {
    for (const Position& position : panel.neurons) add(position);
    for (const Position& position : panel.samples) add(position);
    const double longest = std::max(most_.x - least_.x, most_.y - least_.y);
    // Halved, so that the difference of great numbers is finite.
    const double half = std::max(most_.x / 2 - least_.x / 2, most_.y / 2 - least_.y / 2);
    factor_ = std::isfinite(longest) && longest > 0 ? kMapSide / longest
              : half > 0                            ? kMapSide / 2 / half
                                                    : 0.0;
  }

  double width() const { return factor_ * most_.x - factor_ * least_.x + 2 * kPadding; }
  double height() const { return factor_ * most_.y - factor_ * least_.y + 2 * kPadding; }

  Point at(const Position& position) const {
    return {factor_ * position.x - factor_ * least_.x + kPadding,
            factor_ * most_.y - factor_ * position.y + kPadding};
  }

 private:
  void add(const Position& position) {
    if (is_empty_) least_ = most_ = position;
    is_empty_ = false;
    least_ = {std::min(least_.x, position.x), std::min(least_.y, position.y)};
    most_ = {std::max(most_.x, position.x), std::max(most_.y, position.y)};
  }

  bool is_empty_ = true;
  Position least_{};
  Position most_{};
  double factor_ = 0.0;
};

struct Edges {
  std::vector<Point> inside;   // of a cluster
  std::vector<Point> between;  // clusters
  std::vector<Point> across;   // the border of a torus
};

bool is_across(const Grid& grid, std::size_t a, std::size_t b) {
  if (grid.graph()) return false;
  const auto apart = [](std::size_t i, std::size_t j) { return std::max(i, j) - std::min(i, j); };
  return apart(grid.row_of(a), grid.row_of(b)) > 1 ||
         apart(grid.column_of(a), grid.column_of(b)) > 1;
}

Edges edges_of(const ProjectionPanel& panel, const Scale& scale) {
  Edges edges;
  for (std::size_t a = 0; a < panel.grid.size(); ++a) {
    for (const std::size_t b : panel.grid.neighbours(a)) {
      if (b < a) continue;
      const bool differ = !panel.clusters.empty() && panel.clusters[a] != panel.clusters[b];
      std::vector<Point>& ends = is_across(panel.grid, a, b) ? edges.across
                                 : differ                    ? edges.between
                                                             : edges.inside;
      ends.push_back(scale.at(panel.neurons[a]));
      ends.push_back(scale.at(panel.neurons[b]));
    }
  }
  return edges;
}

// By the lower quartile of the edges, so that circles seldom hide each other; larger if they have
// numbers.
double radius_for(const Edges& edges, bool has_numbers) {
  const double greatest = has_numbers ? 6.0 : 4.0;
  std::vector<double> lengths;
  for (const std::vector<Point>* ends : {&edges.inside, &edges.between}) {
    for (std::size_t i = 0; i < ends->size(); i += 2) {
      lengths.push_back(distance((*ends)[i], (*ends)[i + 1]));
    }
  }
  if (lengths.empty()) return greatest;
  std::sort(lengths.begin(), lengths.end());
  const double quartile = lengths[lengths.size() / 4];
  const double least = has_numbers && lengths.size() < 500 ? kLeastNumberedRadius : 1.5;
  return std::clamp(0.35 * quartile, least, greatest);
}

void draw_edges(SvgWriter& svg, const Edges& edges, Point corner) {
  svg.open_group("edges", corner, {.fill = "none", .stroke = "#333333"});
  if (!edges.across.empty()) {
    svg.segments(edges.across, {.stroke = "#999999", .stroke_width = 0.6, .dashes = "1 3"});
  }
  if (!edges.between.empty()) {
    svg.segments(edges.between, {.stroke = "#777777", .stroke_width = 0.8, .dashes = "4 3"});
  }
  if (!edges.inside.empty()) svg.segments(edges.inside, {.stroke_width = 1.2});
  svg.close_group();
}

void draw_samples(SvgWriter& svg, const ProjectionPanel& panel, const Scale& scale, Point corner) {
  // Few samples can be larger.
  const double radius = std::clamp(60.0 / std::sqrt(real(panel.samples.size()) + 1), 1.5, 3.5);
  svg.open_group("samples", corner, {.stroke = "#222222", .stroke_width = 0.25});
  for (std::size_t i = 0; i < panel.samples.size(); ++i) {
    const ClassMark mark =
        panel.classes.empty() ? ClassMark{{0x99, 0x99, 0x99}} : class_mark(panel.classes[i]);
    draw_marker(svg, scale.at(panel.samples[i]), radius, mark);
  }
  svg.close_group();
}

std::string tooltip_of(const ProjectionPanel& panel, std::size_t neuron) {
  const std::string place = place_of(panel.grid, neuron);
  return panel.clusters.empty() ? place
                                : fmt::format("{}: cluster {}", place, panel.clusters[neuron] + 1);
}

void draw_neurons(SvgWriter& svg, const ProjectionPanel& panel, const Scale& scale, double radius,
                  Point corner) {
  svg.open_group("neurons", corner,
                 {.fill = "#ffffff", .stroke = "#111111", .stroke_width = radius < 3 ? 0.7 : 1.1});
  for (std::size_t i = 0; i < panel.neurons.size(); ++i) {
    svg.circle(scale.at(panel.neurons[i]), radius, {}, tooltip_of(panel, i));
    if (panel.clusters.empty() || radius < kLeastNumberedRadius) continue;
    const std::string number = fmt::format("{}", panel.clusters[i] + 1);
    const double size = std::min(1.5 * radius, 1.7 * radius / text_width(number, 1.0));
    const Point at = scale.at(panel.neurons[i]);
    svg.open_group("", {}, {.stroke = "none"});
    svg.text({at.x, at.y + 0.36 * size}, number, {size, Anchor::kMiddle});
    svg.close_group();
  }
  svg.close_group();
}

std::string note_of(const ProjectionPanel& panel) {
  std::string note = panel.note;
  const auto add = [&](const char* sentence) {
    note += (note.empty() ? "" : " ") + std::string(sentence);
  };
  if (!panel.clusters.empty()) {
    const Edges edges = edges_of(panel, Scale(panel));
    add(radius_for(edges, true) < kLeastNumberedRadius
            ? "Dashed lines connect two clusters."
            : "Numbers of clusters are in the circles; dashed lines connect two clusters.");
  }
  if (panel.grid.topology() == Topology::kTorus) add("Dotted lines join opposite edges.");
  return note;
}

void check(const ProjectionPanel& panel) {
  require(panel.grid.size() > 0, "a panel needs a grid with neurons");
  require(panel.neurons.size() == panel.grid.size(), "a panel needs one position per neuron");
  check_clusters(panel.grid, panel.clusters);
  for (const std::vector<Position>* positions : {&panel.neurons, &panel.samples}) {
    for (const Position& at : *positions) {
      require(std::isfinite(at.x) && std::isfinite(at.y), "positions must be finite");
    }
  }
  require(panel.classes.empty() || panel.classes.size() == panel.samples.size(),
          "a panel needs a class for each sample");
  for (const std::size_t class_number : panel.classes) {
    require(class_number < panel.class_names.size(), "a class has no name");
  }
}

}  // namespace

PanelFrame frame_of(const ProjectionPanel& panel) {
  check(panel);
  const Scale scale(panel);
  PanelFrame frame = make_frame(panel.title, scale.width(), scale.height());
  if (!panel.classes.empty()) {
    frame.foot_height = Legend(panel.class_names, frame.width).height() + 6;
  }
  add_note(frame, note_of(panel), Topology::kPlane);
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const ProjectionPanel& panel) {
  const Scale scale(panel);
  const Edges edges = edges_of(panel, scale);
  const Point corner = frame.map_corner();
  draw_frame(svg, frame);
  svg.open_group("background", corner);
  svg.rectangle({0, 0}, scale.width(), scale.height(),
                {.fill = "#ffffff", .stroke = "#bbbbbb", .stroke_width = 0.8});
  svg.close_group();
  draw_edges(svg, edges, corner);
  draw_samples(svg, panel, scale, corner);
  draw_neurons(svg, panel, scale, radius_for(edges, !panel.clusters.empty()), corner);
  if (!panel.classes.empty()) {
    Legend(panel.class_names, frame.width).draw(svg, {0, frame.foot_top()});
  }
}

}  // namespace somato
