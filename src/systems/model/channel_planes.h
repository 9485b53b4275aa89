#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/graph/system.h"

namespace somato {

/// The weights of a map's neurons, projected to the elements of one channel or module.
struct ChannelPlanes {
  std::string name;  ///< Name of the channel, or of the module where the projection ends.
  std::string unit;  ///< Unit of the channel's values; empty: none.
  std::vector<std::size_t> shape;     ///< Shape of the elements, row-major.
  std::vector<std::string> elements;  ///< Their names; "1", "2", ... if there are none.
  std::string value_unit;             ///< Unit of `values`; empty for weights without one.
  Matrix<double> values;  ///< Neurons x elements; NaN if the weights are not informative.
};

/// The component planes of the map with the number `map` in a trained system, projected back along
/// the graph to the channels.
///
/// - `tensor_product`: the weights of an element are summed over the other inputs.
/// - `one_hot`: an element's value is the mean of its bins' centres, weighted by their weights
///   (those below 0 count as 0).
/// - `t_mpsom`: a neuron's weight is distributed over the elements of each input in proportion
///   to arbor times weight.
/// - `concatenation`: each input receives its elements.
/// - `standardization`, `scale` and `logarithm` are undone, unless values were summed.
/// - `normalization`, memories, `first`, `last` and `change` pass weights on.
///
/// The projection ends at any other module (a spectrum, a number code, another map, a loop): the
/// plane then has the elements of this module, or for more than 256 elements at most 128 means of
/// neighbours. A map with a short input (up to 64 elements) that does not only consist of channels
/// has first a plane of all elements of this input.
///
/// Throws InvalidArgument if the module is not a map, or is not trained.
std::vector<ChannelPlanes> channel_planes(const System& system, std::size_t map);

}  // namespace somato
