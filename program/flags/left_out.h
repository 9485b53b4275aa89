#pragma once

#include <optional>
#include <string>

#include "flags/command_line.h"
#include "somato/core/result.h"

namespace somato::program {

/// The error (kUsage) for a command, such as "report" or "som plot", or a flag, such as "--body",
/// of a part of the program that this build lacks; it says which part, and which build has it.
/// Nothing for other words.
std::optional<Error> left_out_command(const std::string& words);
std::optional<Error> left_out_flag(const std::string& flag, const std::string& command);

/// The error (kUsage) for a file that only importers read, in a program without them.
Error without_importers(const std::string& path);

/// Removes the flags of parts that this build lacks.
void remove_left_out_flags(Command& command);

}  // namespace somato::program
