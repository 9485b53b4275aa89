#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "studies/inference/acceptance.h"

namespace somato {

/// The weighted distribution of one unknown's places.
struct PlaceSummary {
  double mean = 0.0;
  double deviation = 0.0;  ///< Standard deviation.
  double low = 0.0;        ///< Weighted quantile of 0.05.
  double median = 0.0;
  double high = 0.0;  ///< Weighted quantile of 0.95.
};

/// The smallest of the values at which the weights of all values up to it reach `share` of their
/// sum. Throws InvalidArgument without values.
double weighted_quantile(std::span<const double> values, std::span<const double> weights,
                         double share);

/// The rank of `value`, from 0 to 1: the share of the weights of smaller values, and `of_equal`
/// times that of equal ones.
double weighted_rank(std::span<const double> values, std::span<const double> weights, double value,
                     double of_equal);

/// The summary of column `unknown` of a posterior's places.
PlaceSummary summary_of(const Posterior& posterior, std::size_t unknown);

/// The summary of column `unknown` of all simulations, weighted equally.
PlaceSummary prior_summary_of(const Simulations& simulations, std::size_t unknown);

/// The correlations of the places of each pair of unknowns; 0 where one does not vary.
Matrix<double> correlations_of(const Posterior& posterior);

}  // namespace somato
