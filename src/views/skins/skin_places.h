#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "maps/svg/svg.h"

namespace somato {

/// Elements of a skin that are outlined together.
struct SkinGroup {
  std::string name;
  std::vector<std::size_t> elements;

  bool operator==(const SkinGroup&) const = default;
};

/// A picture behind the elements, such as a photograph of the skin. Lengths are in mm.
struct SkinBackground {
  std::string image;  ///< "data:image/png;base64,...".
  Point corner;       ///< The upper left one.
  double width = 0.0;
  double height = 0.0;
};

/// The places of the elements of a skin in mm; x grows to the right and y downwards.
struct SkinPlaces {
  std::vector<Point> places;
  std::vector<SkinGroup> groups;
  std::optional<SkinBackground> background;
};

/// The distance between neighbours in mm: the median distance of an element from its nearest one; 1
/// for a single element.
double spacing_of(const std::vector<Point>& places);

/// The corners of the smallest rectangle around elements and background: least x and y, greatest x
/// and y.
std::pair<Point, Point> bounds_of(const std::vector<Point>& places,
                                  const std::optional<SkinBackground>& background);

}  // namespace somato
