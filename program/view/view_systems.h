#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "views/session/view_source.h"

namespace somato::program {

/// A trained system from its file.
Result<ViewSystem> trained_system(const std::string& path);

/// The recording at `path`; a table is read like that of the training of `--model`. Errors: those
/// of read_study_data() and load_system().
Result<Recording> read_as_for_model(const Arguments& arguments, const std::string& path);

/// The built-in systems that fit the recording: its channels, and the label to be predicted.
Result<std::vector<ViewSystem>> systems_for(const Recording& recording);

/// The systems for a body, according to the exploration in their files.
Result<std::vector<ViewSystem>> systems_for_body(const std::string& body);

/// The systems whose inputs are all among the channels of that name, and which predict one of the
/// labels of that name.
Result<std::vector<ViewSystem>> systems_for_channels(const std::vector<std::string>& channels,
                                                     const std::vector<std::string>& labels);

}  // namespace somato::program
