#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/samples.h"
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

  /// The same for each sample, on `threads` threads, in much less time than one by one.
  std::vector<std::size_t> classify(const Som& som, const Samples& samples,
                                    std::size_t threads = 1) const;

  bool operator==(const NeuronLabels&) const = default;

 private:
  std::vector<std::size_t> classes_of(const std::vector<std::size_t>& labelled) const;
  void require_labels() const;

  std::vector<std::optional<std::size_t>> class_of_neuron_;
  std::vector<std::size_t> labelled_;
};

/// For each neuron of a map that has learned further, its number before; none for a new neuron.
using NeuronOrigins = std::vector<std::optional<std::size_t>>;

/// The number of samples of each class that each neuron of a map won when they were learned. They
/// name the neurons of a map that learns further: samples are not needed again, and a name stays
/// with its neuron when others are added or removed.
class NeuronVotes {
 public:
  NeuronVotes() = default;
  explicit NeuronVotes(std::size_t neurons) : votes_(neurons) {}

  std::size_t neurons() const { return votes_.size(); }

  /// The highest class number with a vote plus 1.
  std::size_t classes() const;

  /// The number of votes of a neuron for a class.
  std::size_t of(std::size_t neuron, std::size_t the_class) const;

  /// Throws InvalidArgument if the neuron is not on the map.
  void add(std::size_t neuron, std::size_t the_class, std::size_t votes = 1);

  /// Adds a vote of each sample for its class; `winners[i]` and `classes[i]` belong to sample i.
  /// Throws InvalidArgument if their numbers differ or a winner is not on the map.
  void add_all(const std::vector<std::size_t>& winners, const std::vector<std::size_t>& classes);

  /// The votes of the same neurons with other numbers; new neurons have none. Throws
  /// InvalidArgument if an origin is not on the map.
  NeuronVotes moved_to(const NeuronOrigins& origins) const;

  /// Labels each neuron with the class of most votes; in a tie, with the lowest class number.
  NeuronLabels labels() const;

  bool operator==(const NeuronVotes&) const = default;

 private:
  std::vector<std::map<std::size_t, std::size_t>> votes_;  // of each neuron by class
};

/// Converts names to class numbers, in the order of first appearance.
struct Classes {
  std::vector<std::string> names;
  std::vector<std::size_t> of_sample;

  static Classes from_names(const std::vector<std::string>& name_of_sample);
};

}  // namespace somato
