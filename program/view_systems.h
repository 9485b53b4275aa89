#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/live/view_source.h"

namespace somato::program {

/// A trained system from its file.
Result<ViewSystem> trained_system(const std::string& path);

/// The systems that travel with the program and fit the recording: its channels, and the label that
/// they are to tell.
Result<std::vector<ViewSystem>> systems_for(const Recording& recording);

/// Those for a body, by what their files say that explores.
Result<std::vector<ViewSystem>> systems_for_body(const std::string& body);

}  // namespace somato::program
