#pragma once

#include <cmath>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom.h"

namespace somato::testing {

/// A T-MPSOM of 2 x 2 neurons and two inputs of 2 elements, worked out on paper.
///
/// Both sigmas are 1 / sqrt(2 ln 2), so that a Gaussian is 1/2 at distance 1 and 1/4 across the
/// diagonal. As many elements as neurons on each axis: A is 1 where u = k, else 1/2. Neurons in the
/// order 11, 12, 21, 22; the first index goes with input a, the second with input b.
///
/// Inputs: a = (3, 4), of length 5, normalized (0.6, 0.8); b = (2, 0), normalized (1, 0).
///
///     neuron  w^a         P^a                                  w^b         P^b
///     11      (1, 0)      1 * 1 * 0.6 = 0.6                    (1, 0)      1 * 1 * 1 = 1
///     12      (0, 1)      1/2 * 1 * 0.8 = 0.4                  (0, 1)      1 * 1 * 0 = 0
///     21      (1, 0)      1/2 * 1 * 0.6 = 0.3                  (0.8, 0.6)  1 * 0.8 * 1 = 0.8
///     22      (0.6, 0.8)  1/2 * 0.6 * 0.6 + 0.8 * 0.8 = 0.82   (0, 1)      1/2 * 0 * 1 = 0
///
/// Multiplied: y = 0.6, 0, 0.24, 0, and with weights 1, 1/2, 1/4 by distance
///
///     N'_11 = 0.6 + 0.24 / 2     = 0.72      N = 1
///     N'_12 = 0.6 / 2 + 0.24 / 4 = 0.36      N = 0.5
///     N'_21 = 0.6 / 2 + 0.24     = 0.54      N = 0.75
///     N'_22 = 0.6 / 4 + 0.24 / 2 = 0.27      N = 0.375
///
/// One step with alpha = 1/2, so with gains 0.5, 0.25, 0.375, 0.1875:
///
///     neuron  w^a moved      length^2   w^b moved           length^2, as a multiple
///     11      (0.8, 0.4)     0.8        (1, 0)              1
///     12      (0.15, 0.95)   0.925      (0.25, 0.75)        (1, 3): 10
///     21      (0.85, 0.3)    0.8125     (0.875, 0.375)      (7, 3): 58
///     22      (0.6, 0.8)     1          (0.1875, 0.8125)    (3, 13): 178
///
/// Added: y = 1.6, 0.4, 1.1, 0.82 and
///
///     N'_11 = 1.6 + 0.4 / 2 + 1.1 / 2 + 0.82 / 4 = 2.555
///     N'_12 = 0.4 + 1.6 / 2 + 1.1 / 4 + 0.82 / 2 = 1.885
///     N'_21 = 1.1 + 1.6 / 2 + 0.4 / 4 + 0.82 / 2 = 2.41
///     N'_22 = 0.82 + 1.6 / 4 + 0.4 / 2 + 1.1 / 2 = 1.97
struct ByHand {
  static TMpsomParameters parameters(TMpsomCombination combination) {
    TMpsomParameters parameters;
    parameters.shape = {2, 2};
    parameters.input_sizes = {2, 2};
    parameters.combination = combination;
    parameters.arbor_sigma = 1.0 / std::sqrt(2.0 * std::log(2.0));
    parameters.neighbourhood_sigma = parameters.arbor_sigma;
    return parameters;
  }

  template <typename Real>
  static std::vector<Matrix<Real>> weights() {
    const auto real = [](double value) { return static_cast<Real>(value); };
    return {{4, 2, {1, 0, 0, 1, 1, 0, real(0.6), real(0.8)}},
            {4, 2, {1, 0, 0, 1, real(0.8), real(0.6), 0, 1}}};
  }

  template <typename Real>
  static std::vector<std::vector<Real>> inputs() {
    return {{3, 4}, {2, 0}};
  }

  static constexpr double kAlpha = 0.5;

  static std::vector<double> multiplied_activity() { return {0.6, 0.0, 0.24, 0.0}; }
  static std::vector<double> multiplied_neighbourhood() { return {1.0, 0.5, 0.75, 0.375}; }
  static std::vector<double> added_activity() { return {1.6, 0.4, 1.1, 0.82}; }
  static std::vector<double> added_neighbourhood() {
    return {1.0, 1.885 / 2.555, 2.41 / 2.555, 1.97 / 2.555};
  }

  /// The weights of both inputs after one step of the multiplied map, row after row.
  static std::vector<std::vector<double>> multiplied_weights() {
    const auto root = [](double x) { return std::sqrt(x); };
    return {{0.8 / root(0.8), 0.4 / root(0.8), 0.15 / root(0.925), 0.95 / root(0.925),
             0.85 / root(0.8125), 0.3 / root(0.8125), 0.6, 0.8},
            {1.0, 0.0, 1 / root(10), 3 / root(10), 7 / root(58), 3 / root(58), 3 / root(178),
             13 / root(178)}};
  }
};

}  // namespace somato::testing
