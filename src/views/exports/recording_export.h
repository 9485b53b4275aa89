#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recordings/explorations/collected_explorations.h"
#include "somato/bodies/scene.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/frame_sink.h"

namespace somato {

/// A recording in the format of another program, written frame by frame. All explorations have the
/// channels and labels of the first one. Nothing is at its path before finish(); without it nothing
/// is left behind. Errors: kSystem with the system's reason; kData for what the format cannot
/// represent.
class RecordingExport : public FrameSink {
 public:
  /// Completes the files and moves them to the path. Errors: kSystem with the system's reason.
  virtual Result<void> finish() = 0;
};

/// A format that is written in complete explorations: memory is bounded by one exploration.
class WholeExport : public RecordingExport {
 public:
  Result<void> begin_exploration(const ExplorationStart& start) final {
    return collected_.begin_exploration(start);
  }
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) final {
    return collected_.frame(channel, values, time, valid);
  }
  Result<void> end_exploration() final { return collected_.end_exploration(); }

 protected:
  WholeExport() : collected_([this](const Exploration& exploration) { return add(exploration); }) {}

 private:
  virtual Result<void> add(const Exploration& exploration) = 0;

  CollectedExplorations collected_;
};

/// The formats; docs/your-data.md describes them.
enum class ExportFormat {
  kCsv,       ///< A folder with a table and a description for each channel.
  kNpz,       ///< A file with arrays for numpy.
  kBag,       ///< A bag of ROS 2: a folder with an MCAP file and metadata.yaml.
  kFoxglove,  ///< The same with the scene of known bodies and a layout for Foxglove.
};

template <>
struct Choices<ExportFormat> {
  static const std::vector<std::pair<ExportFormat, std::string>>& all();
};

/// Begins to write; `scenes` finds what kFoxglove shows. Errors: kSystem with the system's reason,
/// also if a folder exists at the path.
Result<std::unique_ptr<RecordingExport>> begin_export(ExportFormat format, const std::string& path,
                                                      SceneFinder scenes);

/// The format of a path that ends with its name, such as grasps.npz, grasps_csv or
/// grasps_bag.
/// Errors: kUsage for other paths.
Result<ExportFormat> export_format_of(const std::string& path);

/// `name`, followed by as many underscores as it takes not to be in `taken`, to which it is added.
std::string free_name(std::string name, std::set<std::string>& taken);

/// `name` with an underscore for every byte that is neither an ASCII letter or digit nor in
/// `others`.
std::string plain_name(std::string name, std::string_view others);

}  // namespace somato
