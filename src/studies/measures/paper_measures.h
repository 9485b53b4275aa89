#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "maps/grid/size_order.h"
#include "somato/core/samples.h"
#include "somato/maps/grid.h"
#include "studies/measures/most_similar.h"
#include "studies/measures/rank_order.h"

namespace somato {

// Measures for statements of the papers, in addition to those of somato/maps/winner_measures.h:
// docs/reference/results.md defines the statements. `winners[i]` is the neuron of sample i. All
// throw InvalidArgument if the sizes do not fit.

/// Number of samples that share their winner with another sample of their class, regardless of
/// other classes: 0 to the number of samples, never 1. P06 2.3.
std::size_t samples_sharing_within_class(const std::vector<std::size_t>& winners,
                                         const std::vector<std::size_t>& classes);

/// Number of samples whose surroundings (see classes_of_surroundings()) are those of an individual
/// of another group with the same size class: both are large ones of their groups or both are small
/// ones (see is_large()). `individuals[i]` is that of sample i, `things` has one entry per
/// individual. P11 III-B: the three outliers.
std::size_t samples_with_size_in_other_group(const Grid& grid,
                                             const std::vector<std::size_t>& winners,
                                             const std::vector<std::size_t>& individuals,
                                             const std::vector<SizedThing>& things);

/// The best values of CircularOrder that the individuals' numbers permit if each group has one
/// connected area and no two individuals have the same angle: P11 III-B reports both an order
/// around the map and connected groups, which sizes that overlap can exclude.
struct OrderLimits {
  double around = 0.0;                ///< The greatest.
  double within = 0.0;                ///< The greatest; 0 without a group of three numbers.
  std::size_t exceptions_around = 0;  ///< The least.
};

/// Over all arrangements, exactly. Nothing for more than five groups, whose arrangements are too
/// many, and for individuals that all have the same number. Throws InvalidArgument without
/// individuals, with a number that is not finite, or if the sizes differ.
std::optional<OrderLimits> order_limits(const std::vector<double>& numbers,
                                        const std::vector<std::size_t>& groups);

/// How well the order of individuals along a line follows their numbers: for each group the
/// absolute Spearman correlation of the number and the place along the direction of greatest
/// variance of the group's positions (their first principal component), averaged over the groups
/// with at least three different numbers; together with the same for shuffled numbers. All 0, with
/// a share of 1, without such a group. Places that differ by rounding are equal. If the variance is
/// equal in all directions, as at the corners of a square, the direction is that of the position
/// furthest from the mean.
RankOrder order_along(const std::vector<MappedIndividual>& individuals, std::size_t shuffles,
                      std::uint64_t seed);

/// The mean cosine of the angle between two samples, over all pairs of different classes: -1 to 1,
/// and 0 to 1 for samples without negative elements. The cosine with a zero sample is 0. Uses the
/// first `classes.size()` samples, dense or sparse; throws InvalidArgument unless there are that
/// many, and two classes. P06 2.3.
double cosine_between_classes(const Samples& samples, const std::vector<std::size_t>& classes);

}  // namespace somato
