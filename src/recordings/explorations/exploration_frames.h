#pragma once

#include <string>

#include "base/files/file_system.h"
#include "somato/core/result.h"
#include "somato/recording/frame_sink.h"

namespace somato {

/// Hands `exploration`, which validate() accepts, to `to`: all frames in the order of time, those
/// of the same time in the order of channels. Frames of unknown times follow each other from the
/// earliest known time, or 0 s, at 100 Hz, so that viewers show them in order.
Result<void> hand_frames(const Exploration& exploration, FrameSink& to);

/// Hands all explorations of the recording file at `path` to `to`. Errors: those of RecordingReader
/// and of `to`.
Result<void> hand_file(FileSystem& files, const std::string& path, FrameSink& to);

}  // namespace somato
