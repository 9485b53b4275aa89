#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "maps/svg/svg.h"

namespace somato {

/// Width of bold text relative to normal text.
constexpr double kBoldness = 1.1;

/// About how many pixels wide a line of text is; on the wide side, for the reader's font is
/// unknown.
double text_width(std::string_view text, double size);

/// `text`, cut with an ellipsis so that it is at most about `width` pixels wide.
std::string shortened(std::string_view text, double width, double size);

/// `text` in lines at most about `width` pixels wide, broken between words; words too long for a
/// line are cut. At most `most_lines`, the last of them cut; none for an empty text.
std::vector<std::string> wrapped(std::string_view text, double width, double size,
                                 std::size_t most_lines);

/// Writes one line, cut to `width`, with the whole text as tooltip when something was cut. `at` is
/// the left end of the base line.
void write_line(SvgWriter& svg, Point at, std::string_view text, double width,
                const TextStyle& style);

}  // namespace somato
