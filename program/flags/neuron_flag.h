#pragma once

#include <cstddef>
#include <string>

#include "somato/core/result.h"
#include "somato/maps/grid.h"

namespace somato::program {

/// The neuron that the value of `--neuron` names: ROW,COLUMN from 1, or the number of a neuron of a
/// graph from 1. Errors: kUsage.
Result<std::size_t> chosen_neuron(const std::string& text, const Grid& grid);

}  // namespace somato::program
