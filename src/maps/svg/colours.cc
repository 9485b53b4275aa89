#include "maps/svg/colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/core/elementary.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Nine colours along a curve through CIELAB, lightness 13 to 94 in even steps of about 10: the
// sines and powers that shape the curve are worked out beforehand, so that every machine draws the
// same.
constexpr std::array<Colour, 9> kSequence{{{0x0f, 0x1c, 0x54},
                                           {0x17, 0x38, 0x61},
                                           {0x23, 0x53, 0x6b},
                                           {0x36, 0x6f, 0x73},
                                           {0x52, 0x8a, 0x7a},
                                           {0x76, 0xa5, 0x80},
                                           {0xa0, 0xbf, 0x85},
                                           {0xd0, 0xd7, 0x89},
                                           {0xff, 0xef, 0x8c}}};

// Okabe and Ito's colours; yellow, the faintest on white, and black come last.
constexpr std::array<Colour, 8> kClassColours{{{0x00, 0x72, 0xb2},
                                               {0xe6, 0x9f, 0x00},
                                               {0x00, 0x9e, 0x73},
                                               {0xd5, 0x5e, 0x00},
                                               {0x56, 0xb4, 0xe9},
                                               {0xcc, 0x79, 0xa7},
                                               {0xf0, 0xe4, 0x42},
                                               {0x00, 0x00, 0x00}}};

constexpr std::size_t kShapes = 8;
static_assert(kClassColours.size() * kShapes == kClassMarks);

std::uint8_t between(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

Colour between(const Colour& from, const Colour& to, double share) {
  return {between(from.red, to.red, share), between(from.green, to.green, share),
          between(from.blue, to.blue, share)};
}

double linear(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : power((value + 0.055) / 1.055, 2.4);
}

}  // namespace

std::string to_string(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Colour sequential_colour(double value) {
  require(!std::isnan(value), "a colour needs a number");
  constexpr std::size_t kSteps = kSequence.size() - 1;
  const double place = std::clamp(value, 0.0, 1.0) * kSteps;
  const auto step = std::min(static_cast<std::size_t>(place), kSteps - 1);
  return between(kSequence[step], kSequence[step + 1], place - static_cast<double>(step));
}

double luminance(const Colour& colour) {
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

Colour readable_on(const Colour& background) {
  // Contrast is (lighter + 0.05) / (darker + 0.05): equal for black and white at sqrt(1.05 x 0.05).
  constexpr double kEqualContrast = 0.1791;
  return luminance(background) > kEqualContrast ? Colour{0, 0, 0} : Colour{255, 255, 255};
}

Colour tint(const Colour& colour, double strength) {
  require(strength >= 0.0 && strength <= 1.0, "a tint's strength is between 0 and 1");
  return between(Colour{255, 255, 255}, colour, strength);
}

ClassMark class_mark(std::size_t class_number) {
  const std::size_t round = class_number / kClassColours.size();
  return {kClassColours[class_number % kClassColours.size()],
          static_cast<MarkerShape>((class_number + round) % kShapes)};
}

}  // namespace somato
