#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// Every parameter of a map as a JSON object; reading it gives the same bits.
std::string parameters_to_json(const SomParameters& parameters);

/// The parameters in a JSON object, which has the names of TOML. Errors (kData, at `where`): no
/// valid JSON, and unknown or invalid parameters.
Result<SomParameters> som_parameters_from_json(std::string_view text, const std::string& where);

}  // namespace somato
