#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"

namespace somato {

/// The answer of a system to an input of its output map.
struct InputAnswer {
  std::size_t winner = 0;              ///< The neuron of the map that is most similar.
  double winner_distance = 0.0;        ///< Its distance.
  std::size_t nearest = 0;             ///< The class of the most similar named neuron.
  double distance = 0.0;               ///< The distance of that neuron.
  std::optional<double> novelty = {};  ///< If the system has a threshold.

  /// Whether the system has a threshold and the input is beyond it.
  bool is_unknown() const;

  /// The name of the nearest class, or "unknown" if the input is too far from it.
  std::string name(const std::vector<std::string>& classes) const;
};

/// The answer of a model to an input of its output map. Throws InvalidArgument if the model has no
/// answer, or if none of its neurons has a name.
InputAnswer answer_to(const SystemModel& model, const SignalView& input);

/// The answers to many inputs, on `threads` threads, in their order.
std::vector<InputAnswer> answers_to(const SystemModel& model, const Samples& inputs,
                                    std::size_t threads = 1);

/// The module whose map answers. Errors (kData): the model has no answer, or its map has an input
/// for each frame.
Result<std::size_t> answering_map(const SystemModel& model);

/// The inputs of the map that answers, for all explorations of a recording that fits the model (see
/// check_layout); the same for any number of threads. Errors: those of answering_map(), those of
/// evaluate(), and kData for values that are too large for the map.
Result<Samples> inputs_to_answer(const SystemModel& model, const Recording& recording,
                                 std::size_t threads = 1);

/// The answers of a model for all explorations of a recording that fits it (see check_layout). The
/// result is the same for any number of threads. Errors: those of inputs_to_answer().
Result<std::vector<InputAnswer>> answers(const SystemModel& model, const Recording& recording,
                                         std::size_t threads = 1);

}  // namespace somato
