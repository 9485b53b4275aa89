#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/graph/som_model.h"

namespace somato {

/// Saves a map as an NPZ archive, which numpy.load() opens without pickle, atomically.
/// docs/formats/map-npz.md describes its arrays. Errors: kData for a map whose weights need 4 GiB
/// or more, and for a name that ends with U+0000; kSystem for too little memory and those of
/// FileWriter. Throws InvalidArgument if features, standardization, labels or means do not fit the
/// map.
Result<void> save_map_npz(const std::string& path, const SomModel& model);

}  // namespace somato
