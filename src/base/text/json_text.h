#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// Maximum nesting of lists, objects and tables of a file, in JSON and in TOML. Parsers and copies
/// of their results recurse once per level.
inline constexpr int kDeepestNesting = 16;

/// The JSON in a text that comes from elsewhere, as nlohmann::json or nlohmann::ordered_json.
/// Errors (kData, at `where` with line and column): it is not valid JSON, it is nested too deeply,
/// or a number is too large.
template <typename Json>
Result<Json> parse_json(std::string_view text, const std::string& where, const std::string& advice);

}  // namespace somato
