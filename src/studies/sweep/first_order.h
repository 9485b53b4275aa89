#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace somato {

/// The share of the variance of a measure that one unknown explains by itself.
struct FirstOrder {
  double index = 0.0;      ///< Variance of the conditional means over the total variance, 0 to 1.
  double by_chance = 0.0;  ///< The index to expect when the unknown decides nothing.
};

/// The first-order index Var(E[Y|X]) / Var(Y) of points with the measure `values[i]` and the
/// unknown in cell `cells[i]`: E[Y|X] is the mean of the points of a cell, weighted by their
/// number. Source: Saltelli et al., "Global Sensitivity Analysis: The Primer" (2008), chapter 1;
/// for cells of any kind it is Pearson's correlation ratio. It increases with the number of cells:
/// `by_chance` is its mean over all permutations of the values, (cells - 1) / (points - 1).
/// Interactions with other unknowns are not included.
///
/// Empty without variance: all values are equal, or all points are in one cell. Throws
/// InvalidArgument if the lengths differ.
std::optional<FirstOrder> first_order(const std::vector<double>& values,
                                      const std::vector<std::size_t>& cells);

}  // namespace somato
