#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/samples.h"
#include "somato/maps/grid.h"
#include "somato/maps/size_order.h"
#include "somato/studies/most_similar.h"
#include "studies/rank_order.h"

namespace somato {

// Sentences of the papers as numbers, beside those of somato/maps/winner_measures.h:
// docs/reference/results.md says which sentence each stands for. `winners[i]` is the neuron of
// sample i. All throw InvalidArgument where the sizes do not fit.

/// How many samples share their neuron with another sample of their own class, whoever else is
/// there: 0 to the number of samples, never 1. P06 2.3.
std::size_t samples_sharing_with_own(const std::vector<std::size_t>& winners,
                                     const std::vector<std::size_t>& classes);

/// How many samples lie with an individual of another group whose size class is their own: the
/// surroundings of the sample (see classes_of_surroundings()) stand for such an individual, and
/// both are large ones of their groups or both are small ones (see is_large()). `individuals[i]` is
/// that of sample i, `things` has one entry an individual. P11 III-B: the three outliers.
std::size_t samples_with_size_in_other_group(const Grid& grid,
                                             const std::vector<std::size_t>& winners,
                                             const std::vector<std::size_t>& individuals,
                                             const std::vector<SizedThing>& things);

/// How well individuals follow their numbers along a line: for each group the absolute Spearman
/// correlation of the number and the place along the direction in which the group's positions
/// differ most (the first principal component of the positions), averaged over the groups with at
/// least three different numbers; beside it the same with shuffled numbers. All 0, with a share of
/// 1, without such a group. Places that differ by rounding are equal. Where no direction is the
/// longest, as at the corners of a square, it is that of the position furthest from the mean.
RankOrder order_along(const std::vector<MappedIndividual>& individuals, std::size_t shuffles,
                      std::uint64_t seed);

/// The mean cosine of the angle between two samples, over all pairs of different classes: -1 to 1,
/// and 0 to 1 for samples without negative elements. The cosine with a sample that is 0 is 0. Looks
/// at the first `classes.size()` samples, dense or sparse; throws InvalidArgument unless there are
/// that many, and two classes. P06 2.3.
double cosine_between_classes(const Samples& samples, const std::vector<std::size_t>& classes);

}  // namespace somato
