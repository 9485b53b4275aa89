#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "somato/core/value.h"
#include "studies/sweep/sweep.h"

namespace somato {

/// The value of an unknown at a point.
struct SweepPlace {
  Value value;
  std::size_t cell = 0;  ///< Number of the one of sweep_cells() that it lies in.
};

/// The value of every unknown at a point; nothing: that of the system.
using SweepPoint = std::vector<std::optional<SweepPlace>>;

/// A value of an unknown, or a part of its range that the results show as one.
struct SweepCell {
  Value from;
  Value to;  ///< The same for a single value.
};

/// Whether the design takes the values of each unknown, and of a range a number of levels.
bool has_levels(SweepDesign design);

/// The number of points; kMostSweepPoints + 1 if there are too many.
std::size_t point_count(const SweepDescription& sweep);

/// The points of a sweep that was read, in their order.
std::vector<SweepPoint> sweep_points(const SweepDescription& sweep);

/// An unknown of the sweep at this place in its range or among its values, from 0 to 1.
SweepPlace place_at(const SweepDescription& sweep, const Unknown& unknown, double place);

/// The point of a sweep whose unknowns all vary at once at these places in their ranges or among
/// their values, each from 0 to 1. The places of increasing unknowns are sorted.
SweepPoint point_at(const SweepDescription& sweep, const std::vector<double>& places);

/// The values of an unknown of the sweep, or the parts of its range, ascending.
std::vector<SweepCell> sweep_cells(const SweepDescription& sweep, const Unknown& unknown);

/// The position of a number in the range of an unknown, 0 at low and 1 at high, on its scale;
/// nothing outside of it.
std::optional<double> place_in_range(const UnknownParameters& range, double number);

}  // namespace somato
