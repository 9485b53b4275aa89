#pragma once

#include <string>

#include "command_line.h"

namespace somato::program {

/// Fails (kSystem) when the file that the flag `name` asks for can evidently not be saved: its
/// folder is missing, or a folder stands in its place; and (kUsage) when it is another file of the
/// same command line. Asked before the work begins: an hour of
/// training should not end at a missing folder.
Result<void> check_output(const Arguments& arguments, const std::string& name);

/// The same for a path.
Result<void> check_output(const std::string& path);

}  // namespace somato::program
