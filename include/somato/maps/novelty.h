#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"

namespace somato {

/// The name of what a system reads if an input is too far from all that it has learned.
inline constexpr std::string_view kUnknownAnswer = "unknown";

/// When an input is too far from the nearest labelled neuron of a map to be an example of the
/// neuron's class (open-set recognition). Distances are divided by the scale of the class, because
/// classes differ in their spread.
struct Novelty {
  double false_alarm_rate = 0.05;  ///< Share of known explorations that may be refused, 0 to 1.
  std::size_t samples = 0;         ///< Held-out training explorations behind the threshold.
  double threshold = 1.0;          ///< In units of the scale of a class, above 0.
  std::vector<double> scales;      ///< One for each class, above 0, in the unit of the map's input.

  /// Elements x elements of the map's input, lower triangular: distances are those between vectors
  /// multiplied by it, so that directions in which explorations of one class differ count less. No
  /// rows: distances are those of the map. Not in the papers; docs/mathematics/unknown.md.
  Matrix<double> whitening = {};

  /// The novelty of an input whose nearest labelled neuron has the class `label`, at `distance`:
  /// from 0; above 1 the input is unknown.
  double of(std::size_t label, double distance) const {
    return distance / (scales[label] * threshold);
  }

  /// Gives classes that were learned after the threshold was found the mean of the other scales, up
  /// to `count` classes.
  void add_classes(std::size_t count);

  bool operator==(const Novelty&) const = default;
};

/// Whether an input with that novelty is unknown.
inline bool is_unknown(double novelty) {
  return novelty > 1.0;
}

/// The scale of each of `count` classes: the mean of the distances of its samples and of the mean
/// over all samples, which counts as one more sample and keeps the scale of a class with few
/// samples above 0. The only sample of a class is left out: its distance from other classes does
/// not show how much the class spreads. `classes[i]` and `distances[i]` belong to sample i. Errors
/// (kData): no class has two samples, or all distances are 0. Throws InvalidArgument without
/// samples, for unequal numbers or a class that is not below `count`.
Result<std::vector<double>> class_scales(const std::vector<std::size_t>& classes,
                                         const std::vector<double>& distances, std::size_t count);

/// Whether so many scores define a threshold (see conformal_threshold()), or the error (kData).
Result<void> check_scores(std::size_t count, double rate);

/// The central 95 % interval of a rate of false alarms.
struct FalseAlarmInterval {
  double low = 0.0;
  double high = 1.0;
};

/// The least and the greatest false-alarm rate, 0 to 1, of a threshold of conformal_threshold()
/// from `samples` scores with `rate`, outside of which it is with a probability of 2.5 % each: with
/// other scores of the same distribution, the threshold would be another one. With a = floor(rate
/// (samples + 1)), the rate has a beta distribution with the parameters a and samples + 1 - a (Vovk
/// 2012, Conditional validity of inductive conformal predictors). Throws InvalidArgument if
/// check_scores() refuses them.
FalseAlarmInterval false_alarm_interval(std::size_t samples, double rate);

/// The threshold that a further score from the same distribution exceeds with a probability of at
/// most `rate`, above 0 and below 1: of n scores the one with rank n + 1 - floor(rate (n + 1)), as
/// in conformal prediction (Vovk, Gammerman and Shafer 2005, Algorithmic Learning in a Random
/// World, section 2.2). Errors (kData): fewer than 1 / rate - 1 scores or
/// fewer than two, or a threshold of 0.
Result<double> conformal_threshold(std::vector<double> scores, double rate);

}  // namespace somato
