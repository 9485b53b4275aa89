#pragma once

#include <string>
#include <vector>

#include "command_line.h"

namespace somato::program {

/// Checks all outputs of a command line before anything is read: an hour of training should not end
/// at a missing folder. Errors: those of check_output(path) for each file that is to be written;
/// kUsage where writing would replace an input, a file in a folder that is read, or another output.
Result<void> check_outputs(const Command& command, const Arguments& arguments);

/// Fails (kUsage) where writing `output` would replace one of the files or a file of the folders in
/// `read`, which a command has found by itself.
Result<void> check_not_read(const std::string& output, const std::vector<std::string>& read);

/// Fails (kSystem) when a file can evidently not be saved: its folder is missing, or a folder
/// stands in its place.
Result<void> check_output(const std::string& path);

}  // namespace somato::program
