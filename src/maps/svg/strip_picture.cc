#include "maps/svg/strip_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/svg/colours.h"
#include "maps/svg/svg.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kStripMargin = 24.0;
constexpr double kNameWidth = 230.0;
constexpr double kStripWidth = 480.0;
constexpr double kStripHeight = 44.0;
constexpr double kMarkHeight = 18.0;
constexpr double kLabelHeight = 16.0;
constexpr double kRowGap = 10.0;
constexpr double kRowHeight = kMarkHeight + kStripHeight + kLabelHeight + kRowGap;
constexpr double kFigureGap = 16.0;
constexpr double kFigureWidth = 110.0;
constexpr double kStripsWidth = kNameWidth + kStripWidth + kFigureGap + kFigureWidth;
constexpr double kSmall = 10.5;
constexpr std::size_t kMostLines = 4;

const char* const kGrey = "#555555";

void check(const Strip& strip) {
  require(!strip.cells.empty(), "a strip needs cells");
  require(strip.edges.empty() || strip.edges.size() == strip.cells.size() + 1,
          "a range has one more edge than it has cells");
  const auto is_share = [](const std::optional<double>& share) {
    return !share || (*share >= 0.0 && *share <= 1.0);
  };
  require(is_share(strip.mark.place), "a mark must lie on its strip");
  for (const StripCell& cell : strip.cells)
    require(is_share(cell.share), "a share must be from 0 to 1");
}

// Lines of text one below the other.
class TextBlock {
 public:
  TextBlock(std::string_view text, double size, bool bold)
      : lines_(wrapped(text, kStripsWidth, size * (bold ? kBoldness : 1.0), kMostLines)),
        style_{.size = size, .bold = bold, .fill = bold ? "#222222" : kGrey} {}

  double height() const { return static_cast<double>(lines_.size()) * style_.size * 1.35; }

  void draw(SvgWriter& svg, double top) const {
    for (const std::string& line : lines_) {
      svg.text({0, top + style_.size}, line, style_);
      top += style_.size * 1.35;
    }
  }

 private:
  std::vector<std::string> lines_;
  TextStyle style_;
};

class StripPanelLayout {
 public:
  explicit StripPanelLayout(const StripPanel& panel)
      : panel_(panel), title_(panel.title, 14.0, true), note_(panel.note, 11.5, false) {}

  double height() const { return strips_top() + kRowHeight * count(); }

  void draw(SvgWriter& svg, double top) const;

 private:
  double count() const { return static_cast<double>(panel_.strips.size()); }
  double strips_top() const { return title_.height() + note_.height() + 8.0; }

  const StripPanel& panel_;
  TextBlock title_;
  TextBlock note_;
};

// A bar on a pale ground, with the share above it, or within where it is high.
void draw_cell(SvgWriter& svg, const StripCell& cell, double left, double width) {
  svg.rectangle({left, 0}, width, kStripHeight, {.fill = "#f0f0f0", .stroke = "#ffffff"},
                cell.tooltip);
  if (!cell.share) return;
  const Colour colour = sequential_colour(*cell.share);
  const double height = kStripHeight * *cell.share;
  svg.rectangle({left + 1, kStripHeight - height}, width - 2, height, {.fill = to_string(colour)},
                cell.tooltip);
  const std::string percent = fmt::format("{:.0f}", 100.0 * *cell.share);
  if (text_width(percent, kSmall) > width) return;
  const bool within = height > kStripHeight / 2;
  const double base = kStripHeight - height + (within ? kSmall + 3 : -4);
  svg.text({left + width / 2, base}, percent,
           {.size = kSmall,
            .anchor = Anchor::kMiddle,
            .fill = within ? to_string(readable_on(colour)) : "#222222"});
}

// As many texts as fit, from the left; the last one is always included.
void draw_edges(SvgWriter& svg, const std::vector<std::string>& edges) {
  const double width = kStripWidth / static_cast<double>(edges.size() - 1);
  const double last = kStripWidth - text_width(edges.back(), kSmall) / 2;
  double free_from = -kStripWidth;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double middle = width * static_cast<double>(i);
    const double half = text_width(edges[i], kSmall) / 2;
    const bool is_last = i + 1 == edges.size();
    if (!is_last && (middle - half < free_from || middle + half + 4 > last)) continue;
    svg.text({middle, kStripHeight + kSmall + 2}, edges[i],
             {.size = kSmall, .anchor = Anchor::kMiddle, .fill = kGrey});
    free_from = middle + half + 4;
  }
}

void draw_labels(SvgWriter& svg, const std::vector<StripCell>& cells, double width) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string& label = cells[i].label;
    svg.text({width * (static_cast<double>(i) + 0.5), kStripHeight + kSmall + 2},
             shortened(label, width - 4, kSmall),
             {.size = kSmall, .anchor = Anchor::kMiddle, .fill = kGrey}, label);
  }
}

// A triangle that points at its place, with its text to the side where there is more room.
void draw_mark(SvgWriter& svg, const StripMark& mark) {
  constexpr double kHalf = 5.0;
  if (mark.text.empty()) return;
  if (!mark.place) {
    write_line(svg, {0, -5}, mark.text, kStripWidth, {.size = kSmall, .fill = kGrey});
    return;
  }
  const double x = kStripWidth * *mark.place;
  svg.polygon({{x - kHalf, -10}, {x + kHalf, -10}, {x, -1}}, {.fill = "#d55e00"}, mark.text);
  const bool to_the_left = *mark.place > 0.5;
  const double room = (to_the_left ? x : kStripWidth - x) - 2 * kHalf;
  svg.text(
      {to_the_left ? x - kHalf - 4 : x + kHalf + 4, -3}, shortened(mark.text, room, kSmall),
      {.size = kSmall, .anchor = to_the_left ? Anchor::kEnd : Anchor::kStart, .fill = "#a04800"});
}

void write_note(SvgWriter& svg, Point at, const std::string& text, double width,
                const TextStyle& style) {
  if (!text.empty()) write_line(svg, at, text, width, style);
}

void draw_strip(SvgWriter& svg, const Strip& strip, double top) {
  const double width = kStripWidth / static_cast<double>(strip.cells.size());
  svg.open_group("strip", {0, top + kMarkHeight});
  write_note(svg, {0, 18}, strip.name, kNameWidth - 12, {.size = 12.5, .bold = true});
  write_note(svg, {0, 34}, strip.note, kNameWidth - 12, {.size = kSmall, .fill = kGrey});
  svg.open_group("cells", {kNameWidth, 0});
  for (std::size_t i = 0; i < strip.cells.size(); ++i) {
    draw_cell(svg, strip.cells[i], width * static_cast<double>(i), width);
  }
  strip.edges.empty() ? draw_labels(svg, strip.cells, width) : draw_edges(svg, strip.edges);
  draw_mark(svg, strip.mark);
  svg.close_group();
  const double right = kNameWidth + kStripWidth + kFigureGap;
  write_note(svg, {right, 20}, strip.figure, kFigureWidth, {.size = 13.0, .bold = true});
  write_note(svg, {right, 36}, strip.figure_note, kFigureWidth, {.size = kSmall, .fill = kGrey});
  svg.close_group();
}

void StripPanelLayout::draw(SvgWriter& svg, double top) const {
  svg.open_group("panel", {kStripMargin, top});
  title_.draw(svg, 0);
  note_.draw(svg, title_.height());
  double row = strips_top();
  for (const Strip& strip : panel_.strips) {
    draw_strip(svg, strip, row);
    row += kRowHeight;
  }
  svg.close_group();
}

}  // namespace

std::string draw_strips(const std::string& title, const std::string& caption,
                        const std::vector<StripPanel>& panels) {
  require(!panels.empty(), "a picture needs panels");
  constexpr double kStripGap = 22.0;
  const TextBlock heading(title, 18.0, true);
  const TextBlock legend(caption, 11.5, false);
  std::vector<StripPanelLayout> layouts;
  double height = kStripMargin + heading.height() + legend.height();
  for (const StripPanel& panel : panels) {
    for (const Strip& strip : panel.strips) check(strip);
    layouts.emplace_back(panel);
    height += kStripGap + layouts.back().height();
  }
  SvgWriter svg(2 * kStripMargin + kStripsWidth, height + kStripMargin, title);
  svg.open_group("heading", {kStripMargin, kStripMargin});
  heading.draw(svg, 0);
  legend.draw(svg, heading.height());
  svg.close_group();
  double top = kStripMargin + heading.height() + legend.height();
  for (const StripPanelLayout& layout : layouts) {
    layout.draw(svg, top + kStripGap);
    top += kStripGap + layout.height();
  }
  return std::move(svg).finish();
}

}  // namespace somato
