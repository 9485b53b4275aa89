#pragma once

#include <string_view>

#include "maps/svg/colours.h"
#include "maps/svg/svg.h"

namespace somato {

/// Draws the marker of a class. All shapes cover about the area of a circle of `radius`; none
/// reaches further than 1.45 times that.
void draw_marker(SvgWriter& svg, Point centre, double radius, const ClassMark& mark,
                 std::string_view tooltip = {});

}  // namespace somato
