#pragma once

#include <vector>

namespace somato {

/// Places from 1 in ascending order; equal values share the mean of theirs.
std::vector<double> ranks_of(const std::vector<double>& values);

/// The ranks less their mean: they sum to 0, and their products are exact.
std::vector<double> centred_ranks(const std::vector<double>& values);

/// Spearman's rank correlation: the correlation of the ranks, -1 to 1; 0 when the values of a side
/// are all equal. Throws InvalidArgument when the sides differ in length.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// The same from the centred ranks of either side, for comparing one side with many others.
double correlation_of_centred_ranks(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace somato
