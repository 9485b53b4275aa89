#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/signal.h"
#include "somato/maps/som.h"

namespace somato {

/// The class number of each neuron of a map, or none.
class NeuronLabels {
 public:
  NeuronLabels() = default;
  explicit NeuronLabels(std::vector<std::optional<std::size_t>> class_of_neuron);

  /// Labels each winner with the class that most of its samples have; in a tie, with the lowest
  /// class number among them. `winners[i]` and `classes[i]` belong to sample i; throws
  /// InvalidArgument if their numbers differ or a winner is not on the map.
  static NeuronLabels by_majority(const std::vector<std::size_t>& winners,
                                  const std::vector<std::size_t>& classes, std::size_t neurons);

  std::size_t neurons() const { return class_of_neuron_.size(); }
  std::optional<std::size_t> operator[](std::size_t neuron) const {
    return class_of_neuron_[neuron];
  }

  /// The neurons that have a label, ascending.
  const std::vector<std::size_t>& labelled() const { return labelled_; }

  /// The class of the labelled neuron most similar to `input`. Throws InvalidArgument if no neuron
  /// has a label.
  std::size_t classify(const Som& som, const SignalView& input, SomWorkspace& workspace) const;

  bool operator==(const NeuronLabels&) const = default;

 private:
  std::vector<std::optional<std::size_t>> class_of_neuron_;
  std::vector<std::size_t> labelled_;
};

/// Converts names to class numbers, in the order of first appearance.
struct Classes {
  std::vector<std::string> names;
  std::vector<std::size_t> of_sample;

  static Classes from_names(const std::vector<std::string>& name_of_sample);
};

}  // namespace somato
