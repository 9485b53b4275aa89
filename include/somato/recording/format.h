#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"
#include "somato/recording/csv_import.h"
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

/// How the data of a study are read: the table [recording]. All settings but `format` are those of
/// a table of numbers, whose rows are explorations.
struct RecordingParameters {
  RecordingFormat format = RecordingFormat::kAutomatic;
  std::string label_column = {};
  std::string labels = {};
  std::vector<std::string> columns_to_use = {};
  std::vector<std::string> skip = {};
  std::string variable = {};
  MissingValues missing = MissingValues::kRefuse;
  DecimalMark decimal = DecimalMark::kPoint;
  std::optional<bool> header = {};
  /// Whether the table is for a trained system, which needs its features only: labels are not
  /// required. Not a key.
  bool for_system = false;
  /// Names of these features, which are then selected in this order from a table with names; not a
  /// key. Empty: they have no names.
  std::vector<std::string> features = {};

  static const Declarations<RecordingParameters>& declarations();

  bool operator==(const RecordingParameters&) const = default;
};

/// Whether the data at `path` are a table of numbers (CSV, NPY, NPZ, MAT): a file that is neither
/// in MCAP nor named as a recording.
bool is_table(const std::filesystem::path& path);

/// The format of the data in `folder`, detected by the names of the files in it and its subfolders;
/// never kAutomatic. Errors: kSystem for a folder that cannot be read; kData, with the known
/// formats, if none or more than one matches.
Result<RecordingFormat> recognize_format(const std::filesystem::path& folder);

/// Reads the recording at `path`: a file in MCAP, regardless of the format; a folder of data in
/// that format; or a table of numbers. Each row of a table is an exploration with one frame of the
/// channel "columns", whose elements are the features, and with two labels: the name of the label
/// column ("label" without names or from a file), and "row", its number from 1. Missing values are
/// marked as invalid if `missing` is "mask". Errors: those of read_recording(), recognize_format(),
/// the importer of the format and parse_csv(); kUsage for a setting of tables with other data.
Result<Recording> load_recording(const RecordingParameters& parameters,
                                 const std::filesystem::path& path);

/// The same with the default settings of tables.
Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path);

}  // namespace somato
