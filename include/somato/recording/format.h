#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// The formats of recorded data that can be read without a description.
enum class RecordingFormat {
  kAutomatic,         ///< Found out from the names of the files.
  kIcubGrasp,         ///< See recording/icub_grasp.h.
  kFabricslide,       ///< See recording/fabricslide.h.
  kHkustPressSlide,   ///< See recording/hkust_press_slide.h.
  kAcousticHardness,  ///< See recording/acoustic_hardness.h.
};

template <>
struct Choices<RecordingFormat> {
  static const std::vector<std::pair<RecordingFormat, std::string>>& all();
};

/// The format of the data in `folder`, by the names of the files in it and below; never kAutomatic.
/// Errors: kSystem for a folder that cannot be read; kData, telling what was looked for, when no
/// format fits or more than one does.
Result<RecordingFormat> recognize_format(const std::filesystem::path& folder);

/// Reads the recording at `path`: a file is one in MCAP, whatever the format; a folder holds data
/// in that format. Errors as read_recording(), recognize_format() and the format's importer.
Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path);

}  // namespace somato
