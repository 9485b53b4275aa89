#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato::detail {

/// Reads the text of an inference.json, from the file `path`: the fields that a report shows, as
/// "InferenceReport" of web/schema/report.json. All of them are validated. Errors (kData, with the
/// field): those of parse_results().
Result<nlohmann::ordered_json> parse_inference(std::string_view text, const std::string& path);

}  // namespace somato::detail
