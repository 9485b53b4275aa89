#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "maps/svg/svg.h"
#include "views/skins/skin_places.h"

namespace somato {

/// The positions of a channel's elements; lengths are in distances between elements.
struct SkinLayout {
  struct Segment {
    Point corner;
    double width = 0.0;
    double height = 0.0;
  };
  struct Finger {
    std::string name;
    Point foot;  ///< The middle of its lower end.
  };
  struct Background {
    std::string image;  ///< "data:...".
    Segment box;
  };

  double width = 0.0;
  double height = 0.0;
  std::vector<Point> elements;
  std::vector<Segment> segments;  ///< Segments of a hand, or the groups of given places.
  std::vector<Finger> fingers;    ///< Likewise, with their names.
  std::optional<Background> background = {};
  bool is_grid = false;  ///< Whether the elements fill the cells of a grid.
};

/// The layout of `count` elements, at least one: an unfolded hand if all names (none, or one per
/// element) are those of elements of fingers, such as "finger1_proximal_3", "taxel_thumb_tip_1" or
/// "thumb_12"; otherwise a grid: with the last axis of a shape with two axes longer than 1 as
/// columns; with the rows and columns of the names, if all end in two indices that fill a grid
/// ("t00", "taxel_0_3", "r1c2"); else as square as possible without holes, or for numbers without
/// such divisors in rows of which the last is shorter. The pages have the same layout where the
/// names contain segments (web/src/parts/hands/hand_layout.ts, grid_layout.ts).
SkinLayout skin_layout(const std::vector<std::string>& names, std::size_t count,
                       const std::vector<std::size_t>& shape);

/// The layout of given places, of which there is at least one: groups are segments with names.
SkinLayout skin_layout(const SkinPlaces& skin);

}  // namespace somato
