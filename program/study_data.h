#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/recording/format.h"
#include "somato/recording/recording.h"

namespace somato::program {

/// The recording at `path`, a recording's file or a folder of original files in `format`, checked.
/// Errors name the path.
Result<Recording> read_study_data(RecordingFormat format, const std::string& path);

/// What a recording as a whole lacks is told with its path.
Error with_place(Error error, const std::string& path);

/// An interruption with what to do next, where what is done is kept in a journal; other errors as
/// they are.
Error how_to_go_on(Error error);

}  // namespace somato::program
