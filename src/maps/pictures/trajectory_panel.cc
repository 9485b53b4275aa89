#include "maps/pictures/trajectory_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/pictures/class_cells.h"
#include "maps/pictures/outlines.h"
#include "maps/svg/colour_bar.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr Colour kLightest{0xfa, 0xfa, 0xfa};

// Consecutive samples with one winner: the first and the last of them, and the place.
struct Visit {
  std::size_t neuron = 0;
  std::size_t first = 0;
  std::size_t last = 0;
  Point at{};
  double radius = 0.0;
};

std::vector<Visit> visits_of(const std::vector<std::size_t>& winners) {
  std::vector<Visit> visits;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (visits.empty() || visits.back().neuron != winners[i]) visits.push_back({winners[i], i, i});
    visits.back().last = i;
  }
  return visits;
}

void place(std::vector<Visit>& visits, const Cells& cells) {
  constexpr double kGreatestVisit = 9.0;
  constexpr double kLeastVisit = 1.5;
  std::vector<std::size_t> counts(cells.grid().size(), 0);
  for (const Visit& visit : visits) ++counts[visit.neuron];
  std::vector<std::size_t> placed(counts.size(), 0);
  for (Visit& visit : visits) {
    const MarkerSquare square(counts[visit.neuron], 0.96 * cells.inner_side());
    const double room = 0.42 * square.spacing();
    visit.radius = std::clamp(room, kLeastVisit, kGreatestVisit);
    visit.at = cells.centre(visit.neuron);
    if (room < kLeastVisit) continue;
    const Point offset = square.offset(placed[visit.neuron]++);
    visit.at = {visit.at.x + offset.x, visit.at.y + offset.y};
  }
}

// A straight line between two visits, with an arrow at its end or without.
struct Line {
  Point from;
  Point to;
  bool has_arrow = true;
};

// The move of a coordinate by a period that brings it nearest.
double nearest_move(double difference, double period) {
  return period > 0 ? -period * std::round(difference / period) : 0.0;
}

Point period_of(const Cells& cells) {
  const Grid& grid = cells.grid();
  if (grid.topology() == Topology::kPlane) return {};
  const double row = cells.unit().y * (grid.lattice() == Lattice::kRectangular ? 2.0 : 3.0);
  return {cells.pixels() * real(grid.columns()), row * real(grid.rows())};
}

// From circle to circle; across the border of a torus, in two parts.
std::vector<Line> lines_between(const Visit& a, const Visit& b, const Cells& cells) {
  const Point period = period_of(cells);
  const Point move{nearest_move(b.at.x - a.at.x, period.x),
                   nearest_move(b.at.y - a.at.y, period.y)};
  const Point target{b.at.x + move.x, b.at.y + move.y};
  const double length = distance(a.at, target);
  if (length <= a.radius + b.radius) return {};
  const Point unit{(target.x - a.at.x) / length, (target.y - a.at.y) / length};
  Line line{{a.at.x + a.radius * unit.x, a.at.y + a.radius * unit.y},
            {target.x - (b.radius + 1) * unit.x, target.y - (b.radius + 1) * unit.y}};
  if (move.x == 0.0 && move.y == 0.0) return {line};
  Line moved{{line.from.x - move.x, line.from.y - move.y},
             {line.to.x - move.x, line.to.y - move.y}};
  line.has_arrow = false;
  std::vector<Line> lines;
  const Point size{cells.width(), cells.height()};
  if (cut_line(line.from, line.to, size)) lines.push_back(line);
  if (cut_line(moved.from, moved.to, size)) lines.push_back(moved);
  return lines;
}

std::vector<Point> arrow_of(const Line& line, double size) {
  const double length = distance(line.from, line.to);
  const double head = std::min(size, length);
  if (head < 0.5) return {};
  const Point unit{(line.to.x - line.from.x) / length, (line.to.y - line.from.y) / length};
  const Point foot{line.to.x - head * unit.x, line.to.y - head * unit.y};
  const double half = 0.45 * head;
  return {line.to,
          {foot.x - half * unit.y, foot.y + half * unit.x},
          {foot.x + half * unit.y, foot.y - half * unit.x}};
}

void draw_steps(SvgWriter& svg, const std::vector<Visit>& visits, const Cells& cells,
                Point corner) {
  const double width = std::clamp(cells.pixels() * 0.05, 0.8, 1.8);
  const double head = std::clamp(cells.pixels() * 0.22, 3.5, 8.0);
  svg.open_group("steps", corner, {.fill = "#111111"});
  for (std::size_t i = 1; i < visits.size(); ++i) {
    for (const Line& line : lines_between(visits[i - 1], visits[i], cells)) {
      svg.segments({line.from, line.to}, {.stroke = "#ffffff", .stroke_width = 2.4 * width});
      svg.segments({line.from, line.to}, {.stroke = "#111111", .stroke_width = width});
      const std::vector<Point> arrow = line.has_arrow ? arrow_of(line, head) : std::vector<Point>();
      if (!arrow.empty()) svg.polygon(arrow, {.stroke = "#ffffff", .stroke_width = 0.5});
    }
  }
  svg.close_group();
}

std::string samples_of(const TrajectoryPanel& panel, const Visit& visit) {
  const std::size_t first = panel.first_number + visit.first;
  const std::size_t last = panel.first_number + visit.last;
  const std::string place = place_of(panel.grid, visit.neuron);
  return first == last ? fmt::format("sample {}, {}", first, place)
                       : fmt::format("samples {} to {}, {}", first, last, place);
}

void draw_number(SvgWriter& svg, const Visit& visit, std::size_t number, const char* colour) {
  const std::string text = fmt::format("{}", number);
  const double size =
      std::min({1.25 * visit.radius, 1.75 * visit.radius / text_width(text, 1.0), 9.5});
  if (visit.radius < kLeastNumberedRadius || size < 5.0) return;
  svg.text({visit.at.x, visit.at.y + 0.36 * size}, text, {size, Anchor::kMiddle, true, colour});
}

// The first visit is black, the last one a black square, which has the number of the last sample.
void draw_visits(SvgWriter& svg, const TrajectoryPanel& panel, const std::vector<Visit>& visits,
                 Point corner) {
  svg.open_group("visits", corner, {.stroke = "#111111", .stroke_width = 1.0});
  for (std::size_t i = visits.size(); i-- > 0;) {
    const Visit& visit = visits[i];
    const std::string tooltip = samples_of(panel, visit);
    if (i + 1 == visits.size()) {
      svg.rectangle({visit.at.x - visit.radius, visit.at.y - visit.radius}, 2 * visit.radius,
                    2 * visit.radius, {.fill = "#111111"}, tooltip);
    } else {
      svg.circle(visit.at, visit.radius, {.fill = i == 0 ? "#111111" : "#ffffff"}, tooltip);
    }
  }
  svg.close_group();
  svg.open_group("numbers", corner);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == visits.size();
    const std::size_t sample = i + 1 == visits.size() ? visits[i].last : visits[i].first;
    draw_number(svg, visits[i], panel.first_number + sample, is_end ? "#ffffff" : "#111111");
  }
  svg.close_group();
}

std::vector<Colour> greys_of(const TrajectoryPanel& panel) {
  constexpr double kDarkest = 100.0;  // below the lightest
  std::vector<Colour> greys(panel.grid.size(), kLightest);
  if (panel.values.empty()) return greys;
  const ValueRange range = range_of(panel.values);
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const double share = range.is_constant() ? 0.0 : range.place_of(panel.values[i]);
    const auto level = static_cast<std::uint8_t>(std::lround(kLightest.red - kDarkest * share));
    greys[i] = {level, level, level};
  }
  return greys;
}

std::string note_of(const TrajectoryPanel& panel) {
  std::vector<std::size_t> neurons = panel.winners;
  std::sort(neurons.begin(), neurons.end());
  const auto distinct = std::unique(neurons.begin(), neurons.end()) - neurons.begin();
  const std::size_t last = panel.first_number + panel.winners.size() - 1;
  const std::size_t steps = visits_of(panel.winners).size() - 1;
  const std::string before = panel.note.empty() ? "" : panel.note + " ";
  const std::string grey =
      panel.values.empty() ? "" : " Grey: U-matrix, darker for greater distances.";
  if (steps == 0) {
    return fmt::format("{}Samples {} to {} have the same winner.{}", before, panel.first_number,
                       last, grey);
  }
  return fmt::format(
      "{}Samples {} (black circle) to {} (black square): {} step{} between {} neuron{}. Circles "
      "have "
      "the number of the sample that arrives.{}",
      before, panel.first_number, last, steps, steps == 1 ? "" : "s", distinct,
      distinct == 1 ? "" : "s", grey);
}

void check(const TrajectoryPanel& panel) {
  if (!panel.values.empty()) check_values(panel.grid, panel.values);
  check_clusters(panel.grid, panel.clusters);
  require(!panel.winners.empty() && panel.winners.size() <= kMostTrajectorySamples,
          "a trajectory needs 1 to 1000 samples");
  for (const std::size_t winner : panel.winners) {
    require(winner < panel.grid.size(), "a winner is not on the map");
  }
}

}  // namespace

PanelFrame frame_of(const TrajectoryPanel& panel) {
  PanelFrame frame = make_frame(panel.title, panel.grid);
  check(panel);
  add_note(frame, note_of(panel));
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const TrajectoryPanel& panel) {
  std::vector<Visit> visits = visits_of(panel.winners);
  place(visits, frame.cells);
  draw_frame(svg, frame);
  draw_cells(svg, frame, greys_of(panel),
             [&](std::size_t neuron) { return place_of(panel.grid, neuron); });
  draw_borders(svg, frame.cells, frame.map_corner(), {}, "#ffffff");
  draw_outlines(svg, frame.cells, frame.map_corner(), panel.clusters);
  draw_steps(svg, visits, frame.cells, frame.map_corner());
  draw_visits(svg, panel, visits, frame.map_corner());
}

}  // namespace somato
