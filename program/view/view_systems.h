#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::program {

/// A trained system from its file.
Result<ViewSystem> trained_system(const std::string& path);

/// The built-in systems that fit the recording: its channels, and the label to be predicted.
Result<std::vector<ViewSystem>> systems_for(const Recording& recording);

/// The systems for a body, according to the exploration in their files.
Result<std::vector<ViewSystem>> systems_for_body(const std::string& body);

/// The systems whose inputs are all among the channels of that name, and which predict one of the
/// labels of that name.
Result<std::vector<ViewSystem>> systems_for_channels(const std::vector<std::string>& channels,
                                                     const std::vector<std::string>& labels);

}  // namespace somato::program
