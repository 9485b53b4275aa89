#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/graph/system.h"

namespace somato {

/// What the weights of a map's neurons stand for at the elements of one thing that comes in.
struct ChannelPlanes {
  std::string name;                   ///< Of the channel, or of the module that it ends at.
  std::string unit;                   ///< Of the channel's values; empty: none.
  std::vector<std::size_t> shape;     ///< Of the elements, row-major.
  std::vector<std::string> elements;  ///< Their names; "1", "2", ... where nobody named them.
  std::string value_unit;             ///< Of `values`; empty for weights without one.
  Matrix<double> values;              ///< Neurons x elements; NaN where weights say nothing.
};

/// The component planes of the map that is number `map` of a trained system, folded back along the
/// graph: weights go the way that values came, to the channels.
///
/// - `tensor_product`: the weights of an element are summed over everything that it is crossed
/// with.
/// - `one_hot`: an element's value is the mean of its bins' centres, weighted by their weights
///   (those below 0 count as 0).
/// - `t_mpsom`: a neuron's weight is dealt to the elements of each input as they are heard, in
///   proportion to arbor times weight.
/// - `concatenation`: each input gets its own elements.
/// - `standardization` and `scale` are undone, as long as nothing was summed.
/// - `normalization`, memories, `first`, `last` and `change` pass weights on.
///
/// At any other module (a spectrum, a number code, another map, a loop) it ends: its own elements
/// are the plane's, more than 256 of them as at most 128 means of as many neighbours each. A map
/// of a short input (up to 64 elements) that is not just channels as they are has first the plane
/// of all elements of this input.
///
/// Throws InvalidArgument when the module is no map, or has not learned.
std::vector<ChannelPlanes> channel_planes(const System& system, std::size_t map);

}  // namespace somato
