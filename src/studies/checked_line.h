#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace somato {

/// What is kept for later as one line: a checksum, a space, JSON, and a line end.
std::string checked_line(const nlohmann::json& content);

/// What such a line, without its line end, holds; nothing where it is cut or damaged.
std::optional<nlohmann::json> checked_content(std::string_view line);

}  // namespace somato
