#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace somato {

/// A colour in sRGB.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Colour&) const = default;
};

/// In SVG notation: `#rrggbb`.
std::string to_string(const Colour& colour);

/// The colour of a value in [0, 1] (values outside are taken as the nearer end): from dark blue for
/// 0 over green to pale yellow for 1. Lightness grows in even steps, so that it reads the same
/// printed in grey, and the hues can be distinguished with red-green blindness.
Colour sequential_colour(double value);

/// The relative luminance of a colour, 0 for black to 1 for white (WCAG 2, from IEC 61966-2-1).
double luminance(const Colour& colour);

/// Black or white, whichever has the higher contrast to `background`.
Colour readable_on(const Colour& background);

/// A colour mixed with white: `strength` 1 is the colour, 0 white.
Colour tint(const Colour& colour, double strength);

/// The shape of a class's marker.
enum class MarkerShape {
  kCircle,
  kSquare,
  kTriangle,
  kDiamond,
  kTriangleDown,
  kPlus,
  kCross,
  kStar,
};

/// The mark of a class.
struct ClassMark {
  Colour colour;
  MarkerShape shape = MarkerShape::kCircle;

  bool operator==(const ClassMark&) const = default;
};

/// The number of marks that differ: eight colours times eight shapes.
constexpr std::size_t kClassMarks = 64;

/// The mark of class number `class_number`. The first eight differ in colour and in shape, so that
/// they can be distinguished without colour; the first kClassMarks differ in one of them; then they
/// repeat. The colours are those of Okabe and Ito (2008), which can be distinguished with colour
/// blindness.
ClassMark class_mark(std::size_t class_number);

}  // namespace somato
