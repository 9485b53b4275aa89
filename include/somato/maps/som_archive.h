#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/files/archive.h"
#include "somato/maps/som.h"

namespace somato {

/// Puts a map into an archive: the text `PREFIXparameters` (TOML, every parameter) and the array
/// `PREFIXweights` (float32, neurons x stored elements); where not all elements are stored, also
/// the arrays `PREFIXinput_size` (int64, a single number) and `PREFIXelements` (int64, their
/// numbers).
void add_som(Archive& archive, const std::string& prefix, const Som& som);

/// The map that add_som put there, bit by bit. Errors (kData, at `where`): parts missing or of
/// another type, parameters that are unknown, out of range or not all decided, weights that do not
/// fit the grid or are not finite, elements that do not ascend, do not fit the weights or are not
/// of the input.
Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where);

}  // namespace somato
