#pragma once

#include <string>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/som.h"

namespace somato {

/// Adds a map to an archive: the text `PREFIXparameters` (TOML, every parameter) and the array
/// `PREFIXweights` (float32, neurons x stored elements); if not all elements are stored, also the
/// arrays `PREFIXinput_size` (int64, a single number) and `PREFIXelements` (int64, their numbers).
void add_som(Archive& archive, const std::string& prefix, const Som& som);

/// Reads the map written by add_som, bit by bit. Errors (kData, at `where`): parts that are missing
/// or of another type; parameters that are unknown, out of range or not resolved; weights that do
/// not fit the grid or are not finite; elements that are not ascending, do not fit the weights or
/// are outside the input.
Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where);

}  // namespace somato
