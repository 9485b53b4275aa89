#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"

namespace somato::program {

/// Checks all outputs of a command line before any input is read, so that an hour of training does
/// not end at a missing folder. Errors: those of check_output(path) for each output file;
/// kUsage if writing would replace an input, a file in a folder that is read, or another output.
Result<void> check_outputs(const Command& command, const Arguments& arguments);

/// Fails (kUsage) if writing `output` would replace one of the files or a file of the folders in
/// `read`, which a command has found automatically.
Result<void> check_not_read(const std::string& output, const std::vector<std::string>& read);

/// Fails (kSystem) if a file clearly cannot be saved: its folder is missing, or its path is a
/// folder.
Result<void> check_output(const std::string& path);

}  // namespace somato::program
