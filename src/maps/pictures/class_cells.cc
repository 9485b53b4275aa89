#include "maps/pictures/class_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"
#include "maps/pictures/panel_frame.h"
#include "maps/svg/legend.h"
#include "maps/svg/marker.h"
#include "maps/svg/text_layout.h"

namespace somato {
namespace {

constexpr double kLeastText = 7.0;
constexpr double kGreatestText = 11.0;
constexpr double kCellLine = 1.12;  // in sizes of the text
constexpr double kWidestTooltipName = 600.0;

// The radius of the marker of a class in its slice: in the greatest circle that the slice has room
// for around `distance` from the middle of the pie.
double marker_radius(double radius, double share, double distance) {
  const double to_side = share < 0.5 ? distance * cosine_of_turns(0.25 - share / 2) : distance;
  return 0.55 * std::min(share < 1 ? to_side : radius, radius - (share < 1 ? distance : 0.0));
}

// In a colour that differs from that of the slice, whose hue is that of the legend.
void draw_slice_marker(SvgWriter& svg, Point centre, double radius, double from, double share,
                       std::size_t class_number) {
  constexpr double kLeastInSlice = 1.4;
  constexpr double kGreatestInSlice = 5.0;
  const double distance = share < 1 ? 0.6 * radius : 0.0;
  const double size = std::min(marker_radius(radius, share, distance), kGreatestInSlice);
  if (size < kLeastInSlice) return;
  const double middle = from + share / 2;
  ClassMark mark = class_mark(class_number);
  mark.colour = readable_on(mark.colour);
  draw_marker(svg,
              {centre.x + distance * cosine_of_turns(middle - 0.25),
               centre.y - distance * cosine_of_turns(middle)},
              size, mark);
}

void draw_pie(SvgWriter& svg, const LabelPanel& panel, Point centre, double radius,
              const std::string& place, const Won& won) {
  const auto all = static_cast<double>(samples_of(won));
  std::size_t before = 0;
  for (const auto& [class_number, samples] : won) {
    const std::string name = tooltip_name(panel, class_number);
    const double from = real(before) / all;
    before += samples;
    svg.sector(centre, radius, from, real(before) / all,
               {.fill = to_string(class_mark(class_number).colour)},
               fmt::format("{} of {} samples are {}, {}", samples, all, name, place));
    draw_slice_marker(svg, centre, radius, from, real(samples) / all, class_number);
  }
}

bool breaks_after(char character) {
  return character == ' ' || character == '_' || character == '-' || character == '/';
}

// Parts of a name between which a line may break.
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char character : name) {
    parts.back() += character;
    if (breaks_after(character)) parts.emplace_back();
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

std::vector<std::string> lines_of(const std::string& name, double width, double size) {
  std::vector<std::string> lines;
  for (const std::string& part : parts_of(name)) {
    if (!lines.empty() && text_width(lines.back() + part, size) <= width) {
      lines.back() += part;
    } else {
      lines.push_back(part);
    }
  }
  return lines;
}

struct FittedText {
  double size = 0.0;
  std::vector<std::string> lines;
};

// The greatest size at which the text fits into a cell, or nothing.
std::optional<FittedText> fitted(const std::string& text, const Cells& cells) {
  const double width = 0.92 * cells.text_area().x;
  const double height = 0.96 * cells.text_area().y;
  constexpr double kStep = 0.5;
  constexpr int kSteps = static_cast<int>((kGreatestText - kLeastText) / kStep);
  for (int step = 0; step <= kSteps; ++step) {
    const double size = kGreatestText - kStep * step;
    const auto lines = lines_of(text, width, size);
    const bool is_narrow = std::all_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return text_width(line, size) <= width;
    });
    if (is_narrow && real(lines.size()) * kCellLine * size <= height)
      return FittedText{size, lines};
  }
  return std::nullopt;
}

}  // namespace

std::size_t samples_of(const Won& won) {
  std::size_t samples = 0;
  for (const auto& [class_number, of_class] : won) samples += of_class;
  return samples;
}

std::string tooltip_name(const LabelPanel& panel, std::size_t class_number) {
  return shortened(shown_name(panel.class_names[class_number]), kWidestTooltipName, 12.0);
}

void draw_pies(SvgWriter& svg, const LabelPanel& panel, const Cells& cells, Point corner,
               const std::vector<Won>& won) {
  std::size_t most = 1;
  for (const Won& of_neuron : won) most = std::max(most, samples_of(of_neuron));
  const double outline = std::clamp(cells.pixels() * 0.02, 0.15, 0.75);
  svg.open_group("pies", corner, {.stroke = "#222222", .stroke_width = outline});
  for (std::size_t i = 0; i < won.size(); ++i) {
    if (won[i].empty()) continue;
    const double share = panel.size_by_hits ? real(samples_of(won[i])) / real(most) : 1.0;
    const double radius = 0.45 * cells.pixels() * std::sqrt(share);
    draw_pie(svg, panel, cells.centre(i), radius, place_of(panel.grid, i), won[i]);
  }
  svg.close_group();
}

bool fit_in_cells(const std::vector<std::string>& names, const Cells& cells) {
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return fitted(name, cells).has_value(); });
}

void draw_texts(SvgWriter& svg, const Cells& cells, Point corner,
                const std::vector<std::optional<std::size_t>>& class_of_neuron,
                const std::vector<std::string>& texts, const std::vector<Colour>& fills) {
  std::map<std::size_t, FittedText> fitted_texts;
  svg.open_group("texts", corner);
  for (std::size_t i = 0; i < class_of_neuron.size(); ++i) {
    if (!class_of_neuron[i]) continue;
    const auto [found, is_new] = fitted_texts.try_emplace(*class_of_neuron[i]);
    FittedText& text = found->second;
    if (is_new) text = fitted(texts[*class_of_neuron[i]], cells).value_or(FittedText{});
    const Point centre = cells.centre(i);
    double base = centre.y + text.size * (0.36 - kCellLine * (real(text.lines.size()) - 1) / 2);
    for (const std::string& line : text.lines) {
      svg.text({centre.x, base}, line,
               {text.size, Anchor::kMiddle, false, to_string(readable_on(fills[i]))});
      base += kCellLine * text.size;
    }
  }
  svg.close_group();
}

}  // namespace somato
