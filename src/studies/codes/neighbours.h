#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/samples.h"

namespace somato {

/// The squared Euclidean distance of every sample from every other, count x count, symmetric; the
/// same for any number of threads.
Matrix<float> squared_distances(const Samples& samples, std::size_t threads);

/// The sum of the magnitudes of the differences of all elements, likewise.
Matrix<float> manhattan_distances(const Samples& samples, std::size_t threads);

/// The mean squared distance of the samples from their mean: half the mean of all squared
/// distances, those from themselves included. Throws InvalidArgument without samples.
double spread_of(const Matrix<float>& squared_distances);

/// The nearest other sample of each sample, the first in a tie. Throws InvalidArgument for fewer
/// than two samples.
std::vector<std::uint32_t> nearest_others(const Matrix<float>& squared_distances);

/// Adds to `ranks` the rank of every sample j among all others by its distance from sample i, 1 for
/// the nearest; tied samples share their mean rank. The diagonal is unchanged.
void add_ranks(const Matrix<float>& squared_distances, std::size_t threads, Matrix<float>& ranks);

/// The information imbalance (Glielmo and others, 2022): 2 / N times the mean rank of the nearest
/// neighbours; about 1 if neighbours and ranks are unrelated, 2 / N if each has rank 1.
double information_imbalance(std::span<const std::uint32_t> nearest, const Matrix<float>& ranks);

}  // namespace somato
