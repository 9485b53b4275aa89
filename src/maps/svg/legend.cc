#include "maps/svg/legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "maps/svg/marker.h"
#include "maps/svg/text_layout.h"

namespace somato {
namespace {

constexpr double kNameSize = 12.0;
constexpr double kLegendLine = 19.0;
constexpr double kMarkerRoom = 20.0;
constexpr double kGap = 12.0;
constexpr double kWidestName = 180.0;
constexpr double kMarkerRadius = 5.0;

double widest(const std::vector<std::string>& names) {
  double width = 0.0;
  for (const std::string& name : names) width = std::max(width, text_width(name, kNameSize));
  return std::min(width, kWidestName);
}

}  // namespace

std::string shown_name(const std::string& name) {
  const bool is_blank = name.find_first_not_of(" \t\r\n") == std::string::npos;
  return is_blank ? "(no name)" : name;
}

Legend::Legend(const std::vector<std::string>& names, double width) : width_(width) {
  for (const std::string& name : names) names_.push_back(shown_name(name));
  shown_ = std::min(names_.size(), kClassMarks);
  const double column = kMarkerRoom + widest(names_) + kGap;
  columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(width / column), 1,
                                     std::max<std::size_t>(shown_, 1));
}

double Legend::height() const {
  const std::size_t lines = (shown_ + columns_ - 1) / columns_ + (shown_ < names_.size() ? 1 : 0);
  return kLegendLine * static_cast<double>(lines);
}

void Legend::draw(SvgWriter& svg, Point corner) const {
  const double column = width_ / static_cast<double>(columns_);
  const std::size_t lines = (shown_ + columns_ - 1) / columns_;
  svg.open_group("legend", corner, {.stroke = "#222222", .stroke_width = 0.75});
  for (std::size_t i = 0; i < shown_; ++i) {
    const std::size_t column_number = i / lines;
    const double left = column * static_cast<double>(column_number);
    const double middle = kLegendLine * (static_cast<double>(i % lines) + 0.5);
    draw_marker(svg, {left + 8, middle}, kMarkerRadius, class_mark(i));
  }
  svg.close_group();
  svg.open_group("names", corner);
  for (std::size_t i = 0; i < shown_; ++i) {
    const std::size_t column_number = i / lines;
    const double left = column * static_cast<double>(column_number);
    const double middle = kLegendLine * (static_cast<double>(i % lines) + 0.5);
    write_line(svg, {left + kMarkerRoom, middle + 4}, names_[i], column - kMarkerRoom - kGap / 2,
               {.size = kNameSize});
  }
  if (shown_ < names_.size()) {
    svg.text({0, height() - 5},
             fmt::format("and {} more, with repeated marks", names_.size() - shown_),
             {.size = kNameSize});
  }
  svg.close_group();
}

}  // namespace somato
