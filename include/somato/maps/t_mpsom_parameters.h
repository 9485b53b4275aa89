#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/maps/schedule.h"

namespace somato {

/// How the partial activations of a neuron, one an input, make its activity.
enum class TMpsomCombination {
  kMultiplied,  ///< Their product (P06 model 3, P07 and P11 model 2).
  kAdded,       ///< Their sum (P07 and P11 model 3).
};

template <>
struct Choices<TMpsomCombination> {
  static const std::vector<std::pair<TMpsomCombination, std::string>>& all();
};

/// What a vector is divided by before it is used.
enum class TMpsomNorm {
  kL2,    ///< Its Euclidean length; a vector of zeros stays as it is.
  kNone,  ///< Nothing.
};

template <>
struct Choices<TMpsomNorm> {
  static const std::vector<std::pair<TMpsomNorm, std::string>>& all();
};

/// The parameters of a T-MPSOM with any number of inputs.
///
/// Neurons stand on a rectangular grid of any number of axes. Every input is spread along one of
/// them: each neuron looks at the part of the input that corresponds to its place on that axis. The
/// papers have two inputs on two axes. More inputs may have an axis each (a grid of more axes), or
/// share axes (`input_axes` names an axis more than once); every axis needs at least one input.
struct TMpsomParameters {
  std::vector<std::size_t> shape;
  std::vector<std::size_t> input_sizes;
  std::vector<std::size_t> input_axes;
  TMpsomCombination combination = TMpsomCombination::kMultiplied;
  double arbor_sigma = 1.0;
  double neighbourhood_sigma = 1.0;
  ScheduleShape learning_rate_schedule = ScheduleShape::kLinear;
  double learning_rate_start = 0.1;
  double learning_rate_end = 0.0;
  std::optional<std::uint64_t> learning_rate_reached_at;
  TMpsomNorm input_norm = TMpsomNorm::kL2;
  TMpsomNorm weight_norm = TMpsomNorm::kL2;
  std::uint64_t iterations = 5000;
  std::uint64_t seed = 1;

  static const Declarations<TMpsomParameters>& declarations();

  /// Whether shape, inputs, axes and rates fit together and every number is in its declared range;
  /// errors (kUsage) name the parameters.
  Result<void> validate() const;

  /// alpha(t) over the iterations, counted from 0. P06 and P11 ask for 0 <= alpha(t) <= 1 and
  /// alpha(t) -> 0; the values are not given in the paper.
  Schedule learning_rate() const {
    return {learning_rate_schedule, learning_rate_start, learning_rate_end,
            learning_rate_reached_at.value_or(iterations)};
  }

  /// The axis each input is spread along, the default written out.
  std::vector<std::size_t> axes() const;

  /// The number of neurons: the product of `shape`, which must be valid.
  std::size_t neurons() const;

  /// The place along `axis`, counted from 0, of neuron `neuron` in row-major order.
  std::size_t place(std::size_t neuron, std::size_t axis) const;

  bool operator==(const TMpsomParameters&) const = default;
};

}  // namespace somato
