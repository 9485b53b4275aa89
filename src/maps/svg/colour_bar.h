#pragma once

#include <string>
#include <vector>

#include "maps/svg/svg.h"

namespace somato {

/// The range of the values that colours show.
struct ValueRange {
  double least = 0.0;
  double greatest = 0.0;

  bool is_constant() const { return least == greatest; }

  /// The position of `value`, from 0 to 1; in the middle if there is only one value.
  double place_of(double value) const;
};

/// The range of some values, of which there is at least one.
ValueRange range_of(const std::vector<double>& values);

/// A value with about four digits.
std::string readable_number(double value);

constexpr double kColourBarHeight = 36.0;

/// Draws a bar with the colours of a range and its limits, the greater one with its unit.
void draw_colour_bar(SvgWriter& svg, Point corner, double width, const ValueRange& range,
                     const std::string& unit = {});

}  // namespace somato
