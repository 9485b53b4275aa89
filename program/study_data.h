#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"

namespace somato::program {

/// The recording at `path`, a recording's file or a folder of original files in `format`, checked.
/// Errors name the path.
Result<Recording> read_study_data(RecordingFormat format, const std::string& path);

/// A TOML file; where there is none at that path, the program's own file of that name or path, so
/// that commands work outside of the source tree too. Errors: those of read_toml(name).
Result<Table> read_file_or_own(const std::string& name);

/// What a recording as a whole lacks is told with its path.
Error with_place(Error error, const std::string& path);

/// An interruption with what to do next, where what is done is kept in a journal; other errors as
/// they are.
Error how_to_go_on(Error error);

}  // namespace somato::program
