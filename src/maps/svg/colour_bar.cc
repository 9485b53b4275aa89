#include "maps/svg/colour_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/svg/colours.h"

namespace somato {
namespace {

constexpr double kBarHeight = 12.0;
constexpr double kNumberSize = 11.0;

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

}  // namespace

double ValueRange::place_of(double value) const {
  if (is_constant()) return 0.5;
  const double length = greatest - least;
  if (std::isfinite(length)) return (value - least) / length;
  return (value / 2 - least / 2) / (greatest / 2 - least / 2);
}

ValueRange range_of(const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, *greatest};
}

std::string readable_number(double value) {
  const bool is_short_whole = std::fabs(value) < 1e7 && value == std::floor(value);
  return is_short_whole ? svg_number(value, 0) : fmt::format("{:.4g}", value);
}

void draw_colour_bar(SvgWriter& svg, Point corner, double width, const ValueRange& range,
                     const std::string& unit) {
  const double base_line = corner.y + kBarHeight + kNumberSize + 2;
  const std::string after = unit.empty() ? "" : " " + unit;
  svg.open_group("bar");
  if (range.is_constant()) {
    svg.rectangle(corner, width, kBarHeight, {.fill = to_string(sequential_colour(0.5))});
    svg.text({corner.x, base_line}, "all values are " + readable_number(range.least) + after,
             {kNumberSize});
  } else {
    draw_gradient(svg, corner, width);
    svg.text({corner.x, base_line}, readable_number(range.least), {kNumberSize});
    svg.text({corner.x + width, base_line}, readable_number(range.greatest) + after,
             {kNumberSize, Anchor::kEnd});
  }
  svg.close_group();
}

}  // namespace somato
