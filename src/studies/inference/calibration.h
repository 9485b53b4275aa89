#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/matrix.h"
#include "studies/inference/acceptance.h"

namespace somato {

/// The ranks of known truths in the posteriors that are inferred from them.
struct Calibration {
  Matrix<double> ranks;  ///< One row for each truth, one column for each unknown: its rank in the
                         ///< posterior, 0 to 1.
  std::vector<double> covered;  ///< For each unknown: the share of the truths with ranks from 0.05
                                ///< to 0.95, inside their central 90 % intervals.
  /// For each unknown: how likely ranks of uniform distribution are to deviate at least as much
  /// (Kolmogorov-Smirnov).
  std::vector<double> uniform_p;
  /// For each unknown: root mean square of the differences of the posterior's mean places from the
  /// true ones.
  std::vector<double> errors;
};

/// Takes simulations of `truths` different draws, selected at random with `seed`, as observations
/// in turn, and infers each from the simulations of the other draws (of other groups, if there are
/// groups) with the same scales and rule.
/// All draws, if there are fewer. Truths without finite statistics are not selected. A random part
/// of the weight of equal values is below a truth, so that ranks are uniform for unknowns with few
/// values, too.
///
/// Source: S. Talts et al., "Validating Bayesian inference algorithms with simulation-based
/// calibration", arXiv:1804.06788 (2018).
Calibration calibrate(const Simulations& simulations, const std::vector<double>& scales,
                      const AcceptanceRule& rule, std::size_t truths, std::uint64_t seed);

/// The probability that the greatest difference between the distribution of `count` uniform numbers
/// and the uniform distribution is at least `difference` (asymptotic, with the correction of
/// Stephens 1970 for small counts).
double kolmogorov_p(double difference, std::size_t count);

}  // namespace somato
