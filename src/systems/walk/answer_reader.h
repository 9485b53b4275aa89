#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "maps/reading/novelty_reader.h"
#include "somato/core/samples.h"
#include "somato/graph/answers.h"
#include "somato/graph/system_model.h"
#include "somato/maps/som.h"

namespace somato {

/// A class and the most similar of its neurons.
struct NearestOfClass {
  std::size_t number = 0;  ///< The number of the class.
  double distance = 0.0;   ///< The distance of the neuron.
  std::size_t neuron = 0;
};

/// Answers inputs of the output map of a model: those of whole explorations, of names that are
/// taught, and of explorations in progress. All const functions can be used by several threads.
class AnswerReader {
 public:
  /// The model must outlive it and not change. Throws InvalidArgument if the model has no answer.
  explicit AnswerReader(const SystemModel& model);

  /// Throws InvalidArgument if no neuron has a name.
  InputAnswer answer(const SignalView& input) const;

  /// The same without an allocation, once the memory of `workspace` is large enough.
  InputAnswer answer(const SignalView& input, SomWorkspace& workspace) const;

  /// The same for each of the inputs, in their order.
  std::vector<InputAnswer> answers(const Samples& inputs, std::size_t threads) const;

  /// The classes that name a neuron: that of the answer first, the others by distance, then by
  /// number. Empty if no neuron has a name.
  std::vector<NearestOfClass> classes(const SignalView& input) const;

  /// The novelty of an input of which `nearest` is the first of classes(), if the model has a
  /// threshold.
  std::optional<double> novelty(const SignalView& input, const NearestOfClass& nearest) const;

 private:
  InputAnswer answer(const SignalView& input, std::size_t winner, double winner_distance,
                     std::size_t named, SomWorkspace& workspace) const;

  const SystemAnswer& answer_;
  const Som& som_;
  std::vector<std::vector<std::size_t>> neurons_of_class_;
  std::optional<NoveltyReader> novelty_;
};

}  // namespace somato
