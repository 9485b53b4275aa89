#include "somato/drawing/map_picture.h"

#include <algorithm>
#include <utility>

#include "maps/pictures/dendrogram_panel.h"
#include "maps/pictures/edge_panel.h"
#include "maps/pictures/label_panel.h"
#include "maps/pictures/panel_frame.h"
#include "maps/pictures/projection_panel.h"
#include "maps/pictures/trajectory_panel.h"
#include "maps/pictures/value_panel.h"
#include "maps/svg/svg.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kMargin = 20.0;
constexpr double kPanelGap = 28.0;
constexpr double kPictureTitleSize = 18.0;
constexpr double kTitleLine = 24.0;
constexpr std::size_t kMostTitleLines = 3;
constexpr double kCaptionSize = 12.0;
constexpr double kCaptionLine = 17.0;
constexpr std::size_t kMostCaptionLines = 8;

// Panels row after row; each column is as wide as its widest panel, each row as high as its
// highest.
struct Layout {
  std::vector<PanelFrame> frames;
  std::vector<std::string> title_lines;
  std::vector<std::string> caption_lines;
  std::vector<double> column_widths;
  std::vector<double> row_heights;

  double width() const { return sum_with_gaps(column_widths) + 2 * kMargin; }
  double caption_top() const {
    return kMargin + kTitleLine * static_cast<double>(title_lines.size());
  }
  double panels_top() const {
    return caption_top() + kCaptionLine * static_cast<double>(caption_lines.size()) + 6;
  }
  double height() const { return panels_top() + sum_with_gaps(row_heights) + kMargin; }

  Point corner(std::size_t panel) const {
    const std::size_t row = panel / column_widths.size();
    const std::size_t column = panel % column_widths.size();
    return {kMargin + start(column_widths, column), panels_top() + start(row_heights, row)};
  }

  static double start(const std::vector<double>& lengths, std::size_t index) {
    double sum = 0.0;
    for (std::size_t i = 0; i < index; ++i) sum += lengths[i] + kPanelGap;
    return sum;
  }
  static double sum_with_gaps(const std::vector<double>& lengths) {
    return start(lengths, lengths.size()) - kPanelGap;
  }
};

std::size_t columns_for(std::size_t panels) {
  if (panels <= 3) return panels;
  return panels == 4 ? 2 : panels <= 9 ? 3 : 4;
}

Layout lay_out(const std::string& title, const std::string& caption,
               const std::vector<Panel>& panels) {
  Layout layout;
  const std::size_t columns = columns_for(panels.size());
  layout.column_widths.assign(columns, 0.0);
  layout.row_heights.assign((panels.size() + columns - 1) / columns, 0.0);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const PanelFrame frame =
        std::visit([](const auto& panel) { return frame_of(panel); }, panels[i]);
    double& width = layout.column_widths[i % columns];
    double& height = layout.row_heights[i / columns];
    width = std::max(width, frame.width);
    height = std::max(height, frame.height());
    layout.frames.push_back(frame);
  }
  const double width = layout.width() - 2 * kMargin;
  layout.title_lines = wrapped(title, width, kBoldness * kPictureTitleSize, kMostTitleLines);
  layout.caption_lines = wrapped(caption, width, kCaptionSize, kMostCaptionLines);
  return layout;
}

void write_lines(SvgWriter& svg, double top, double line_height,
                 const std::vector<std::string>& lines, const TextStyle& style) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double base_line = top + line_height * static_cast<double>(i) + style.size;
    svg.text({kMargin, base_line}, lines[i], style);
  }
}

}  // namespace

ValuePanel hits_panel(const Grid& grid, const std::vector<std::size_t>& hits) {
  return {.title = "Hits",
          .grid = grid,
          .values = std::vector<double>(hits.begin(), hits.end()),
          .write_values = true,
          .note = "Number of samples won by each neuron."};
}

std::string draw_picture(const std::string& title, const std::string& caption,
                         const std::vector<Panel>& panels) {
  require(!panels.empty(), "a picture needs at least one panel");
  const Layout layout = lay_out(title, caption, panels);
  SvgWriter svg(layout.width(), layout.height(), title);
  write_lines(svg, kMargin, kTitleLine, layout.title_lines,
              {.size = kPictureTitleSize, .bold = true});
  write_lines(svg, layout.caption_top(), kCaptionLine, layout.caption_lines,
              {.size = kCaptionSize, .fill = "#444444"});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    svg.open_group("panel", layout.corner(i));
    std::visit([&](const auto& panel) { draw_panel(svg, layout.frames[i], panel); }, panels[i]);
    svg.close_group();
  }
  return std::move(svg).finish();
}

}  // namespace somato
