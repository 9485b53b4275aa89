#pragma once

#include <cstddef>
#include <vector>

#include "somato/maps/neuron_graph.h"

namespace somato {

/// The cells of NeuronGraph::cells(): `parts` has the part of each neuron, numbered from 0.
std::vector<NeuronGraph::Cell> cells_of_graph(
    const std::vector<std::vector<std::size_t>>& neighbours, const std::vector<std::size_t>& parts);

}  // namespace somato
