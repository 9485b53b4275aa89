#pragma once

#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/system_contributions.h"
#include "somato/recording/recording.h"

namespace somato::program {

/// Saves the contributions to the answer for each exploration as a CSV file: a row for each element
/// of a channel, and for each element of a module that contributes. `inputs` are those of the map
/// that answers. After Ctrl-C (kInterrupted) and other errors the file is unchanged.
Result<void> save_contributions(const std::string& path,
                                const std::shared_ptr<const SystemModel>& model,
                                const Recording& recording, const Samples& inputs,
                                std::size_t threads);

}  // namespace somato::program
