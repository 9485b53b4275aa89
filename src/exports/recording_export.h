#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A recording in the format of another program, written exploration by exploration. Nothing is at
/// its path before finish(); without it nothing is left behind.
class RecordingExport {
 public:
  RecordingExport() = default;
  RecordingExport(const RecordingExport&) = delete;
  RecordingExport(RecordingExport&&) = delete;
  RecordingExport& operator=(const RecordingExport&) = delete;
  RecordingExport& operator=(RecordingExport&&) = delete;
  virtual ~RecordingExport() = default;

  /// Writes an exploration that validate() accepts, with the channels and labels of the first one.
  /// Errors: kSystem with the system's reason; kData for what the format cannot represent.
  virtual Result<void> add(const Exploration& exploration) = 0;

  /// Completes the files and moves them to the path. Errors: kSystem with the system's reason.
  virtual Result<void> finish() = 0;
};

/// The formats; docs/your-data.md describes them.
enum class ExportFormat {
  kCsv,  ///< A folder with a table and a description for each channel.
  kNpz,  ///< A file with arrays for numpy.
  kBag,  ///< A bag of ROS 2: a folder with an MCAP file and metadata.yaml.
};

template <>
struct Choices<ExportFormat> {
  static const std::vector<std::pair<ExportFormat, std::string>>& all();
};

/// Begins to write. Errors: kSystem with the system's reason, also if a folder exists at the path.
Result<std::unique_ptr<RecordingExport>> begin_export(ExportFormat format, const std::string& path);

/// The format of a path that ends with its name, such as grasps.npz, grasps_csv or grasps_bag.
/// Errors: kUsage for other paths.
Result<ExportFormat> export_format_of(const std::string& path);

/// `name`, followed by as many underscores as it takes not to be in `taken`, to which it is added.
std::string free_name(std::string name, std::set<std::string>& taken);

/// `name` with an underscore for every byte that is neither an ASCII letter or digit nor in
/// `others`.
std::string plain_name(std::string name, std::string_view others);

}  // namespace somato
