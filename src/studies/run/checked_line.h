#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace somato {

/// Data stored as one line: a checksum, a space, JSON, and a line end.
std::string checked_line(const nlohmann::json& content);

/// The content of such a line, without its line end; nothing if it is truncated or damaged.
std::optional<nlohmann::json> checked_content(std::string_view line);

}  // namespace somato
