#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"
#include "somato/studies/reproduction.h"

namespace somato::program {

/// The recording at `path`, a recording's file, a folder of original files or a table, checked.
/// Errors name the path.
Result<Recording> read_study_data(const RecordingParameters& parameters, const std::string& path);

/// A TOML file; if there is none at that path, the built-in file of that name or path, so that
/// commands also work outside the source tree. Errors: those of read_toml(name).
Result<NamedFile> read_file_or_own(const std::string& name);

/// Adds the path to errors about a recording as a whole.
Error with_place(Error error, const std::string& path);

/// Adds advice to an interruption if completed work is kept in a journal; other errors are
/// unchanged.
Error how_to_go_on(Error error);

}  // namespace somato::program
