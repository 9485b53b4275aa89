#pragma once

#include <vector>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"
#include "somato/studies/study_parameters.h"

namespace somato::program {

/// The flags for data that are a table, as of `somato som`.
std::vector<Flag> table_data_flags();

/// Replaces the settings of a table that flags give; whether that changes any. Errors: kUsage.
Result<bool> read_table_data(const Arguments& arguments, RecordingParameters& parameters);

/// Whether flags give the labels.
bool gives_labels(const Arguments& arguments);

/// The name of the labels that a column or a file gives to `table`, or `otherwise` without them.
std::string label_of_table(const RecordingParameters& parameters, const Recording& table,
                           const std::string& otherwise);

}  // namespace somato::program
