#pragma once

#include <string>
#include <string_view>

#include "flags/command_line.h"

namespace somato::program {

/// The text of `--quiet`, a flag of every command.
inline constexpr std::string_view kQuietText = "Suppress progress and summaries";

/// "somato som train DATA -o ... [FLAGS]".
std::string usage_of(const Command& command);

/// The text of a parameter with its unit, range, choices and default.
std::string parameter_description(const ParameterInfo& info);

}  // namespace somato::program
