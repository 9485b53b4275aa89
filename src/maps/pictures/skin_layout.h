#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "maps/svg/svg.h"

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

  double width = 0.0;
  double height = 0.0;
  std::vector<Point> elements;
  std::vector<Segment> segments;  ///< Empty unless it is a hand.
  std::vector<Finger> fingers;    ///< Empty unless it is a hand.

  bool is_hand() const { return !fingers.empty(); }
};

/// The layout of `count` elements, at least one: an unfolded hand if all names (none, or one per
/// element) are those of elements of fingers, such as "finger1_proximal_3", "taxel_thumb_tip_1" or
/// "thumb_12"; otherwise a grid by the last axis of the shape that is longer than 1. The pages have
/// the same layout where the names contain segments (web/src/parts/hands/hand_layout.ts).
SkinLayout skin_layout(const std::vector<std::string>& names, std::size_t count,
                       const std::vector<std::size_t>& shape);

}  // namespace somato
