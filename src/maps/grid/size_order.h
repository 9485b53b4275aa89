#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// Individuals on a map, such as objects: a number each, such as their size, the group they belong
/// to, such as their shape, and where the map has them, the mean of their samples' positions.
struct MappedIndividual {
  double number = 0.0;
  std::size_t group = 0;
  Position position;
};

/// The mean position of each individual's winners, in the plane of the grid (a torus is cut open at
/// its edges). `individuals[i]` is that of sample i, numbered from 0 without gaps; `numbers` and
/// `groups` have one value an individual. Throws InvalidArgument when the sizes do not fit, a
/// winner is not on the grid, or an individual has no sample.
std::vector<MappedIndividual> mapped_individuals(const Grid& grid,
                                                 const std::vector<std::size_t>& winners,
                                                 const std::vector<std::size_t>& individuals,
                                                 const std::vector<double>& numbers,
                                                 const std::vector<std::size_t>& groups);

/// How well the order of individuals around the map follows their numbers: P11's "ordered in a
/// clockwise manner according to size" (III-B). An individual's angle is that of its position
/// around the mean of all positions; equal angles share their place, and an individual at the mean
/// itself, which has no angle, gets the middle place. A map may be mirrored and has no first angle,
/// so the best of both directions and all starting points is used; values by chance are computed in
/// the same way.
struct CircularOrder {
  /// Spearman's rank correlation of number and place around the map, 0 to 1.
  double around = 0.0;
  /// The same within each group, averaged over the groups with at least three different numbers;
  /// one direction for all groups, with separate starting points. 0 without such a group. Three at
  /// three angles are always in order in one direction, so groups of three provide little
  /// information.
  double within = 0.0;
  /// The number of individuals to take away until the others are in order around the map: P11's
  /// "exception". An individual at the mean of all positions is an exception (one on its own is
  /// not), and of several at one angle only those with equal numbers are in order.
  std::size_t exceptions_around = 0;
  /// The same within each group, the sum over the groups with at least three different numbers; one
  /// direction for all groups, with separate starting points.
  std::size_t exceptions_within = 0;
};

/// Throws InvalidArgument without individuals, or with a number or position that is not finite.
CircularOrder circular_order(const std::vector<MappedIndividual>& individuals);

/// A value for each of the two correlations of CircularOrder.
struct OrderFigures {
  double around = 0.0;
  double within = 0.0;
};

/// Values by chance: the means over `shuffles` shuffles of the numbers, for `within` within their
/// groups (0 for none), and the shares of shuffles with a value at least as high as that of the
/// true order, which is counted as one of them: never 0. Throws like circular_order().
struct CircularOrderByChance {
  OrderFigures mean;
  OrderFigures share_as_high;
  std::vector<CircularOrder> of_each;  ///< One for each shuffling.
};

CircularOrderByChance circular_order_chance(const std::vector<MappedIndividual>& individuals,
                                            std::size_t shuffles, std::uint64_t seed);

}  // namespace somato
