#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// The layers in TOML, one list for each of their fields; empty without layers.
std::string layers_to_toml(const std::vector<Layer>& layers);

/// The layers that layers_to_toml() wrote into an archive, for inputs of so many elements; none if
/// the archive has none. Errors (kData, at `where`): damaged, or not possible.
Result<std::vector<Layer>> layers_from(const Archive& archive, const std::string& name,
                                       std::size_t elements, const std::string& where);

}  // namespace somato
