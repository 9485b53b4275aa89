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
  kAutomatic,         ///< Detected by the names of the files.
  kIcubGrasp,         ///< See recordings/imports/icub_grasp.h.
  kFabricslide,       ///< See recordings/imports/fabricslide.h.
  kHkustPressSlide,   ///< See recordings/imports/hkust_press_slide.h.
  kAcousticHardness,  ///< See recordings/imports/acoustic_hardness.h.
};

template <>
struct Choices<RecordingFormat> {
  static const std::vector<std::pair<RecordingFormat, std::string>>& all();
};

/// The format of the data in `folder`, detected by the names of the files in it and its subfolders;
/// never kAutomatic. Errors: kSystem for a folder that cannot be read; kData, with the known
/// formats, if none or more than one matches.
Result<RecordingFormat> recognize_format(const std::filesystem::path& folder);

/// Reads the recording at `path`: a file is in MCAP, regardless of the format; a folder contains
/// data in that format. Errors: those of read_recording(), recognize_format() and the importer of
/// the format.
Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path);

}  // namespace somato
