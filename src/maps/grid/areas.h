#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// The areas of samples' winners on a map. Created once for the winners, and used for any number of
/// classifications of the samples.
class WinnerAreas {
 public:
  /// `winners[i]` is the neuron of sample i; throws InvalidArgument when there is none or one is
  /// not on the grid.
  WinnerAreas(const Grid& grid, const std::vector<std::size_t>& winners);

  /// The class of every neuron: that of the winner nearest to it on the grid. Among winners equally
  /// near, the class with most samples at them; then the lowest class number. `classes[i]` belongs
  /// to sample i; throws InvalidArgument when their number is not the samples'.
  std::vector<std::size_t> classes_of_neurons(const std::vector<std::size_t>& classes) const;

  /// Whether each class that has samples has an area, and that area is one region connected through
  /// shared edges. A class whose winners are all shared with more frequent ones has none.
  bool connected(const std::vector<std::size_t>& classes) const;

 private:
  bool regions_connected(const std::vector<std::size_t>& class_of_neuron) const;

  std::vector<std::vector<std::size_t>> nearest_samples_;  // of each neuron
  std::vector<std::vector<std::size_t>> neighbours_;
  std::size_t samples_;
};

/// Whether no neuron is the winner for samples of two classes.
bool individuals_apart(const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& classes);

}  // namespace somato
