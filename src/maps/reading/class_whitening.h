#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"

namespace somato {

/// The share of the mean variance in the covariance within classes where it is automatic. Of 0.05,
/// 0.1, 0.3 and 0.5, all of which gave similar figures, one in the middle (docs/continual.md).
inline constexpr double kWhiteningShrinkage = 0.3;

/// The most elements of an input that is whitened: a model file has the square of it.
inline constexpr std::size_t kMostWhitenedElements = 1024;

/// Whether distances of a map can be measured between whitened vectors: it is Euclidean, has a
/// weight for every element as it is, without layers, and at most kMostWhitenedElements of them.
bool can_be_whitened(const Som& som);

/// The error (kUsage) for a map that cannot.
tl::unexpected<Error> not_to_be_whitened();

/// A lower triangular matrix B, such that |B (x - y)| is a Mahalanobis distance of x and y within
/// classes: with the covariance S of the samples at `places` around the means of their classes,
///
///     B' B = shrinkage m ((1 - shrinkage) S + shrinkage m I)^-1,
///
/// where m is the mean variance of the elements that vary within classes. Directions in which
/// samples of one class differ count less; without variance within classes, B is I. The factor
/// makes B independent of the unit. `classes[i]` is the class of the sample at `places[i]`. Throws
/// InvalidArgument without samples, for unequal numbers, for more than kMostWhitenedElements, or
/// unless the shrinkage is above 0 and at most 1.
Matrix<double> whitening_within_classes(const Samples& samples, std::span<const std::size_t> places,
                                        std::span<const std::size_t> classes, double shrinkage);

/// Neurons of a map, whose distances from inputs are measured after both were multiplied by a
/// matrix of whitening_within_classes(). All const functions can be used by several threads.
class WhitenedNeurons {
 public:
  struct Nearest {
    std::size_t neuron = 0;
    double distance = 0.0;
  };

  /// The whitening must outlive it. Throws InvalidArgument without neurons, or if the whitening has
  /// another size than the inputs of the map.
  WhitenedNeurons(const Matrix<double>& whitening, const Som& som,
                  std::vector<std::size_t> neurons);

  /// The neuron nearest to an input, the first in a tie; not `except`, if there is another one.
  Nearest nearest(const SignalView& input, std::optional<std::size_t> except = {}) const;

 private:
  const Matrix<double>* whitening_;
  std::vector<std::size_t> neurons_;
  Matrix<double> rows_;  // of the neurons
};

}  // namespace somato
